#include "io/tissue_library_file.h"

#include <map>

#include <fmt/format.h>

#include "core/error.h"
#include "io/resources.h"
#include "io/xml_document.h"

namespace bodkin {

namespace {

constexpr std::size_t library_limit = 4 << 20;  // bytes

LayeredTissue layered_from(const XmlElement& element, const std::string& origin) {
  LayeredTissue layered;
  const XmlElement& kind = element.children.front();
  if (kind.name == "viscous") {
    layered.kind = LayeredKind::viscous;
    layered.drag = kind.number("drag_N_s_per_mm2", 0.0);
  } else if (kind.name == "rigid") {
    layered.kind = LayeredKind::rigid;
    layered.contact_stiffness = kind.number("contact_stiffness_N_per_mm", 0.0);
  } else if (kind.name == "viscoelastic") {
    layered.kind = LayeredKind::viscoelastic;
    layered.stiffness = kind.number("stiffness_N_per_mm", 0.0);
    layered.viscosity = kind.number("viscosity_N_s_per_mm", 0.0);
    layered.element_spacing = kind.number("element_spacing_mm", 0.0);
    layered.break_force = kind.number("break_force_N", 0.0);
    layered.break_force_rate = kind.number("break_force_rate_N_mm_per_s", 0.0);
    layered.shaft_stiffness = kind.number("shaft_stiffness_N_per_mm2", 0.0);
    layered.shaft_viscosity = kind.number("shaft_viscosity_N_s_per_mm2", 0.0);
    layered.shaft_spacing = kind.number("shaft_spacing_mm", 0.0);
    layered.static_friction = kind.number("static_friction_N_per_mm", 0.0);
    layered.dynamic_friction = kind.number("dynamic_friction_N_per_mm", 0.0);
    layered.roughness = kind.number("roughness", 0.0);
    if (layered.static_friction < layered.dynamic_friction) {
      fail_at(origin, kind.line,
              fmt::format("static_friction_N_per_mm is {}, expected at least the dynamic_friction_N_per_mm of {}",
                          layered.static_friction, layered.dynamic_friction));
    }
  }
  return layered;
}

DepthProfileTissue depth_profile_from(const XmlElement& element) {
  DepthProfileTissue profile;
  const std::string kind = element.string("kind");
  profile.kind = kind == "bone"    ? DepthProfileKind::bone
                 : kind == "organ" ? DepthProfileKind::organ
                 : kind == "soft"  ? DepthProfileKind::soft
                                   : DepthProfileKind::nothing;
  profile.stiffness = element.number("stiffness_N_per_mm", profile.stiffness);
  profile.slope = element.number("slope_N_per_mm2", profile.slope);
  return profile;
}

ShaftFrictionTissue shaft_friction_from(const XmlElement& element, const std::string& origin) {
  ShaftFrictionTissue friction;
  friction.coulomb = element.number("coulomb_N_per_mm", friction.coulomb);
  friction.static_force = element.number("static_N_per_mm", friction.static_force);
  friction.stiffness = element.number("stiffness_N_per_mm2", friction.stiffness);
  friction.viscous = element.number("viscous_N_s_per_mm2", friction.viscous);
  if (friction.static_force < friction.coulomb) {
    fail_at(origin, element.line,
            fmt::format("shaft_friction static_N_per_mm is {}, expected at least the coulomb_N_per_mm of {}",
                        friction.static_force, friction.coulomb));
  }
  return friction;
}

}  // namespace

void read_tissue_forces(const XmlElement& element, const std::string& origin, TissueProperties& entry) {
  if (const XmlElement* layered = element.child("layered"); layered != nullptr)
    entry.layered = layered_from(*layered, origin);
  if (const XmlElement* wall = element.child("tracking_wall"); wall != nullptr) {
    entry.tracking_wall.stiffness = wall->number("stiffness_N_per_mm", 0.0);
    entry.tracking_wall.force = wall->number("force_N", 0.0);
  }
  if (const XmlElement* profile = element.child("depth_profile"); profile != nullptr)
    entry.depth_profile = depth_profile_from(*profile);
  if (const XmlElement* proxy = element.child("volume_proxy"); proxy != nullptr) {
    entry.volume_proxy.penetrability = proxy->number("penetrability_N", 0.0);
    entry.volume_proxy.friction = proxy->number("friction_N", 0.0);
    entry.volume_proxy.drag = proxy->number("drag_N", 0.0);
    entry.volume_proxy.viscosity = proxy->number("viscosity_N_s_per_mm", 0.0);
    entry.field_value = proxy->number("field_value", 0.0);
  }
  if (const XmlElement* friction = element.child("shaft_friction"); friction != nullptr)
    entry.shaft_friction = shaft_friction_from(*friction, origin);
  if (const XmlElement* syringe = element.child("syringe"); syringe != nullptr) {
    entry.syringe.resistance = syringe->number("resistance_MPa_s_per_mm3", 0.0);
    entry.syringe.pressure = syringe->number("pressure_MPa", entry.syringe.pressure);
  }
  if (const XmlElement* deformable = element.child("deformable"); deformable != nullptr) {
    entry.deformable.young = deformable->number("young_MPa", 0.0);
    entry.deformable.poisson = deformable->number("poisson", entry.deformable.poisson);
    entry.deformable.friction = deformable->number("friction_N_per_mm", 0.0);
    entry.deformable.puncture_force = deformable->number("puncture_force_N", 0.0);
    entry.deformable.stiffness = deformable->number("stiffness_N_per_mm", 0.0);
  }
}

namespace {

constexpr double least_impedance = 0.0001;  // MRayl, a quarter of air's; 0 leaves it to the HU

AcousticTissue acoustic_from(const XmlElement& element, const std::string& origin) {
  AcousticTissue acoustic;
  acoustic.impedance = element.number("impedance_MRayl", acoustic.impedance);
  acoustic.attenuation = element.number("attenuation_dB_per_cm_MHz", acoustic.attenuation);
  acoustic.power = element.number("attenuation_power", acoustic.power);
  acoustic.echo = element.number("echo_dB", acoustic.echo);
  acoustic.density = element.number("scatterer_density", acoustic.density);
  acoustic.variation = element.number("fibre_variation_dB", acoustic.variation);
  if (acoustic.impedance != 0.0 && acoustic.impedance < least_impedance) {
    fail_at(origin, element.line,
            fmt::format("acoustic impedance_MRayl is {}, expected {} to 100, or 0 to take it from the HU",
                        acoustic.impedance, least_impedance));
  }
  return acoustic;
}

TissueProperties tissue_from(const XmlElement& element, const std::string& origin) {
  TissueProperties entry;
  entry.id = static_cast<TissueId>(element.integer("id", 0));
  entry.name = element.string("name");
  entry.title = element.string("title");
  entry.colour = static_cast<std::uint32_t>(std::stoul(element.string("colour").substr(1), nullptr, 16));
  entry.hounsfield = element.number("hounsfield_HU", 0.0);
  entry.hounsfield_noise = element.number("hounsfield_noise_HU", 0.0);
  read_tissue_forces(element, origin, entry);
  if (const XmlElement* acoustic = element.child("acoustic"); acoustic != nullptr)
    entry.acoustic = acoustic_from(*acoustic, origin);
  entry.source = one_line(element.child("source")->text);
  return entry;
}

}  // namespace

TissueLibrary parse_tissue_library(std::string_view document, const std::string& origin, const XmlSchema& schema) {
  const XmlElement root = schema.read(document, origin);
  std::vector<TissueProperties> tissues;
  std::map<int, int> line_of_id;
  std::map<std::string, int> line_of_name;
  for (const XmlElement& element : root.children) {
    const TissueProperties entry = tissue_from(element, origin);
    if (const auto [first, fresh] = line_of_id.emplace(entry.id, element.line); !fresh) {
      fail_at(origin, element.line,
              fmt::format("tissue id is {}, which line {} uses already", entry.id, first->second));
    }
    if (const auto [first, fresh] = line_of_name.emplace(entry.name, element.line); !fresh) {
      fail_at(origin, element.line,
              fmt::format("tissue name is '{}', which line {} uses already", entry.name, first->second));
    }
    tissues.push_back(entry);
  }
  if (!line_of_id.contains(tissue::air)) {
    fail_at(origin, root.line, fmt::format("there is no tissue with id {}, expected one for air", tissue::air));
  }
  return TissueLibrary(std::move(tissues));
}

TissueLibrary read_tissue_library(const std::filesystem::path& file) {
  return parse_tissue_library(read_text_file(file, library_limit), file.string(), XmlSchema("tissues.xsd"));
}

TissueLibrary default_tissue_library() {
  return read_tissue_library(shared_file("tissues.xml"));
}

}  // namespace bodkin
