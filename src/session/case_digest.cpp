#include "session/case_digest.h"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <string_view>

#include "patient/meshing/mesh_record.h"
#include "session/session_schema.h"
#include <fmt/format.h>

#include "fem/solid/body_digests.h"
#include "io/digest.h"
#include "io/resources.h"

namespace bodkin::session {

namespace {

constexpr std::string_view second_kind = "2:";  // before tissues had a physical description
constexpr std::string_view third_kind = "3:";
constexpr std::size_t largest_mesh = std::size_t{4} << 30;  // bytes

// Later parameters: at zero, the default of a library without them, they leave the digests of earlier sessions
// unchanged.
constexpr std::array<std::string_view, 5> later_parameters = {"fibres", "young_along_MPa", "shear_along_MPa",
                                                              "cutting_force_N", "cutting_share"};

// Every parameter, whether or not the chosen alternative uses it, except those in the element `without`.
template <Parameterized Settings>
void add_parameters(const Settings& settings, std::string& text, std::string_view without = {}) {
  for_each_entry(
      [&](const auto& entry, const auto& value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (parameter_detail::is_alternatives<std::remove_cvref_t<decltype(entry)>>) {
          text += "kind=" + value_text(value) + '\n';
        } else if constexpr (Parameterized<Value>) {
          if (entry.name == without) return;
          text += std::string(entry.name) + '\n';
          add_parameters(value, text);
        } else {
          const bool later =
              std::find(later_parameters.begin(), later_parameters.end(), entry.name) != later_parameters.end();
          if (later && value == Value{}) return;
          text += std::string(entry.name) + '=' + value_text(value) + '\n';
        }
      },
      settings);
}

// The contents of a case digest in Bodkin 0.1. Its sessions must stay comparable: never change them.
void add_tissue_of_first_kind(const anatomy::TissueProperties& tissue, std::string& text) {
  const anatomy::LayeredTissue& p = tissue.layered;
  text += fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {}\n", tissue.id, tissue.name,
                      static_cast<int>(p.kind), p.stiffness, p.viscosity, p.element_spacing, p.break_force,
                      p.break_force_rate, p.shaft_stiffness, p.shaft_viscosity, p.shaft_spacing, p.static_friction,
                      p.dynamic_friction, p.roughness, p.drag, p.contact_stiffness, tissue.title);
  const anatomy::ProxyProperties& proxy = tissue.volume_proxy.properties;
  const anatomy::ShaftFrictionTissue& friction = tissue.shaft_friction;
  text += fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {}\n", tissue.tracking_wall.stiffness,
                      tissue.tracking_wall.force, static_cast<int>(tissue.depth_profile.kind),
                      tissue.depth_profile.stiffness, tissue.depth_profile.slope, proxy.penetrability, proxy.friction,
                      proxy.drag, proxy.viscosity, tissue.volume_proxy.field_value, friction.coulomb,
                      friction.static_force, friction.stiffness, friction.viscous, tissue.syringe.resistance,
                      tissue.syringe.pressure);
}

}  // namespace

std::string case_digest(const anatomy::Case& patient, const std::string& case_xml, const std::string& mesh) {
  std::string all = case_xml + '\n' + io::volume_digest(patient.tissues) + '\n' + mesh + '\n';
  for (const anatomy::TissueProperties& tissue : patient.library.tissues()) add_parameters(tissue, all);
  return std::string(third_kind) + text_checksum(all);
}

std::string second_case_digest(const anatomy::Case& patient, const std::string& case_xml, const std::string& mesh) {
  std::string all = case_xml + '\n' + io::volume_digest(patient.tissues) + '\n' + mesh + '\n';
  for (const anatomy::TissueProperties& tissue : patient.library.tissues()) add_parameters(tissue, all, "physical");
  return std::string(second_kind) + text_checksum(all);
}

std::string case_parts(const anatomy::Case& patient, const std::string& mesh) {
  std::string tissues;
  for (const anatomy::TissueProperties& tissue : patient.library.tissues()) add_parameters(tissue, tissues);
  std::string text = fmt::format("voxels {}\ntissues {}\n", text_checksum(io::volume_digest(patient.tissues)),
                                 text_checksum(tissues));
  if (!mesh.empty()) text += fmt::format("mesh {}\n", text_checksum(mesh));
  return text;
}

std::string changed_parts(const std::string& recorded, const anatomy::Case& patient, const std::string& mesh) {
  const auto lines_of_text = [](const std::string& text) {
    std::map<std::string, std::string> found;
    std::istringstream stream(text);
    for (std::string name, digest; stream >> name >> digest;) found[name] = digest;
    return found;
  };
  auto before = lines_of_text(recorded), now = lines_of_text(case_parts(patient, mesh));
  std::string changed;
  for (const char* name : {"voxels", "tissues", "mesh"}) {
    if (before[name] == now[name]) continue;
    if (!changed.empty()) changed += " and ";
    changed += name;
  }
  return changed;
}

std::string digest_of_body(const anatomy::Case& patient) {
  if (patient.prepared.body == nullptr) return "";
  return fmt::format("{:016x}", fem::digest_of(*patient.prepared.body));
}

std::string digest_of_points(const anatomy::Case& patient) {
  if (patient.prepared.body == nullptr) return "";
  return fmt::format("{:016x}", fem::points_digest_of(*patient.prepared.body));
}

std::string first_case_digest(const anatomy::Case& patient, const std::string& case_xml) {
  std::string all = case_xml + '\n' + io::volume_digest(patient.tissues) + '\n';
  for (const anatomy::TissueProperties& tissue : patient.library.tissues()) add_tissue_of_first_kind(tissue, all);
  return text_checksum(all);
}

std::string mesh_digest(const std::filesystem::path& case_folder, const anatomy::ResistanceSettings& resistance) {
  const std::filesystem::path file = case_folder / patient::mesh_file_name;
  if (anatomy::body_of(resistance) == nullptr || !std::filesystem::exists(file)) return "";
  return io::bytes_digest(io::read_text_file(file, largest_mesh));
}

bool is_digest_of_case(const std::string& digest, const anatomy::Case& patient, const std::string& case_xml,
                       const std::string& mesh) {
  if (digest.starts_with(third_kind)) return digest == case_digest(patient, case_xml, mesh);
  if (digest.starts_with(second_kind)) return digest == second_case_digest(patient, case_xml, mesh);
  return digest == first_case_digest(patient, case_xml);
}

}  // namespace bodkin::session
