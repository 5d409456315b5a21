#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/force_options.h"
#include "cli/json_values.h"
#include "cli/settings_json.h"
#include "core/error.h"
#include "core/files.h"
#include "imaging/slice_picture.h"
#include "io/case_folder.h"
#include "io/force_choice.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

constexpr double cubic_mm_per_ml = 1000.0;
constexpr double png_zoom = 1.5;  // pixels per px of the picture

constexpr const char* case_show_footer = R"(Examples:
  bodkin case show patient                      text, and a picture named after the case
  bodkin case show patient -o out/patient.svg   the picture as SVG
  bodkin --json case show patient               everything as JSON)";

struct TissueShare {
  anatomy::TissueId id;
  double millilitres;
};

std::vector<TissueShare> tissue_shares(const anatomy::TissueVolume& tissues) {
  std::array<std::size_t, 256> voxels{};
  for (const anatomy::TissueId id : tissues.voxels) ++voxels[id];
  const double millilitres = tissues.grid.spacing.prod() / cubic_mm_per_ml;
  std::vector<TissueShare> shares;
  for (std::size_t id = 0; id < voxels.size(); ++id) {
    if (id == anatomy::tissue::air || voxels[id] == 0) continue;
    shares.push_back({static_cast<anatomy::TissueId>(id), millilitres * static_cast<double>(voxels[id])});
  }
  return shares;
}

std::string point_text(const Vec3& point) {
  return fmt::format("{:.1f}, {:.1f}, {:.1f}", point.x(), point.y(), point.z());
}

std::string lattice_text(const anatomy::Grid& grid) {
  return fmt::format("{} x {} x {} voxels of {:.3g} x {:.3g} x {:.3g} mm, axes {}", grid.size[0], grid.size[1],
                     grid.size[2], grid.spacing.x(), grid.spacing.y(), grid.spacing.z(), grid.axes());
}

nlohmann::json json_of(const anatomy::Grid& grid) {
  return {{"size", grid.size},
          {"spacing_mm", json_point(grid.spacing)},
          {"axes", grid.axes()},
          {"origin_mm", json_point(grid.origin)}};
}

// A case's name as a file name.
std::string file_name_of(const std::string& name) {
  std::string safe;
  for (const char c : name) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    safe += plain ? c : '_';
  }
  return safe.empty() ? "case" : safe;
}

void print(const Console& console, const anatomy::Case& patient) {
  const anatomy::CaseDescription& about = patient.description;
  console.line(about.name);
  if (!about.description.empty()) console.line(about.description);
  const auto [low, high] = std::minmax_element(patient.ct.voxels.begin(), patient.ct.voxels.end());
  console.line("");
  console.line(fmt::format("CT          {}", lattice_text(patient.ct.grid)));
  console.line(fmt::format("            {} to {} HU", *low, *high));
  console.line(fmt::format("tissues     {}", lattice_text(patient.tissues.grid)));
  for (const TissueShare& share : tissue_shares(patient.tissues)) {
    console.line(fmt::format("            {:<26} {:>10.1f} mL", patient.library.title(share.id), share.millilitres));
  }
  if (!about.structures.empty()) {
    std::string names;
    std::array<std::size_t, 65536> voxels{};
    for (const std::uint16_t label : patient.structures.voxels) ++voxels[label];
    std::size_t present = 0;
    for (const anatomy::Structure& structure : about.structures) {
      if (voxels[structure.label] == 0) continue;
      ++present;
      names +=
          fmt::format("{}{}{}", names.empty() ? "" : ", ", structure.name, structure.critical ? " (critical)" : "");
    }
    console.line(fmt::format("structures  {}: {}", present, names));
  }
  for (std::size_t i = 0; i < about.landmarks.size(); ++i) {
    console.line(fmt::format("{:<11} {:<26} {}", i == 0 ? "landmarks" : "", about.landmarks[i].name,
                             point_text(about.landmarks[i].position)));
  }
  console.line(fmt::format("needle      {} G {}, {:.2f} mm thick, {:.0f} mm long", about.needle.gauge,
                           anatomy::to_string(about.needle.tip), about.needle.outer_diameter, about.needle.length));
  console.line(fmt::format("device      {}: {:g} N peak, {:g} N lasting, {:g} N/mm, at {:g} Hz", about.device.profile,
                           about.device.peak_force, about.device.continuous_force, about.device.stiffness,
                           about.haptics.rate));
  console.line(fmt::format("forces      {}", force_names(about.haptics)));
  console.line(fmt::format("procedure   {}", about.procedure.name));
  if (const auto& path = about.procedure.path) {
    console.line(fmt::format("path        {:.1f} mm from {} to {} (LPS mm)", path->length(), point_text(path->entry),
                             point_text(path->target)));
  } else {
    console.line("path        none planned");
  }
  if (!about.procedure.target_tissue.empty())
    console.line(fmt::format("target      {}", about.procedure.target_tissue));
  for (const std::string& note : about.notes) console.line(fmt::format("note        {}", note));
}

nlohmann::json json_of(const anatomy::Case& patient) {
  const anatomy::CaseDescription& about = patient.description;
  nlohmann::json result;
  result["name"] = about.name;
  result["description"] = about.description;
  result["ct"] = json_of(patient.ct.grid);
  const auto [low, high] = std::minmax_element(patient.ct.voxels.begin(), patient.ct.voxels.end());
  result["hounsfield"] = {*low, *high};
  result["tissue_lattice"] = json_of(patient.tissues.grid);
  result["tissues"] = nlohmann::json::object();
  result["tissues_ml"] = nlohmann::json::object();
  for (const TissueShare& share : tissue_shares(patient.tissues)) {
    const anatomy::TissueProperties* properties = patient.library.find(share.id);
    result["tissues_ml"][properties != nullptr ? properties->name : std::to_string(share.id)] = share.millilitres;
    if (properties != nullptr) result["tissues"][properties->name] = settings_json(*properties);
  }
  result["structures"] = nlohmann::json::array();
  for (const anatomy::Structure& structure : about.structures) {
    result["structures"].push_back({{"label", structure.label},
                                    {"name", structure.name},
                                    {"tissue", structure.tissue},
                                    {"critical", structure.critical}});
  }
  result["landmarks"] = nlohmann::json::object();
  for (const anatomy::Landmark& landmark : about.landmarks)
    result["landmarks"][landmark.name] = json_point(landmark.position);
  result["needle"] = settings_json(about.needle);
  result["device"] = settings_json(about.device);
  const io::ForceTexts forces = io::force_texts(about.haptics);
  result["resistance"] = {{"model", anatomy::name_of(about.haptics.resistance)},
                          {"settings", forces.resistance},
                          {"values", settings_json(about.haptics.resistance)}};
  result["constraint"] = {{"model", anatomy::name_of(about.haptics.constraint)},
                          {"settings", forces.constraint},
                          {"values", settings_json(about.haptics.constraint)}};
  result["parts"] = forces.parts;
  result["procedure"] = {{"name", about.procedure.name}, {"target_tissue", about.procedure.target_tissue}};
  if (const auto& path = about.procedure.path) {
    result["procedure"]["path"] = {{"entry_mm", json_point(path->entry)},
                                   {"target_mm", json_point(path->target)},
                                   {"length_mm", path->length()}};
  }
  result["notes"] = about.notes;
  return result;
}

void run_case_show(const std::string& folder, const std::string& output, const CommandContext& context) {
  Console console(context);
  const fs::path given(output);
  if (!output.empty() && given.extension() != ".png" && given.extension() != ".svg") {
    throw InputError(
        fmt::format("the picture {} has the ending '{}', expected .png or .svg", output, given.extension().string()));
  }
  if (!output.empty()) require_writable(given, "--output");
  const anatomy::Case patient = io::load_case(folder, console.progress());
  const fs::path file = output.empty() ? fs::path(file_name_of(patient.description.name) + ".png") : given;
  const imaging::Canvas picture = imaging::case_picture(patient);
  write_file(file, file.extension() == ".svg" ? picture.svg() : picture.png(png_zoom));

  print(console, patient);
  console.line(fmt::format("\n{}", fs::absolute(file).string()));
  nlohmann::json result = json_of(patient);
  result["picture"] = fs::absolute(file).string();
  console.json(result.dump(2));
}

}  // namespace

void add_case_show_command(CLI::App& case_group, CommandContext& context) {
  add_command(case_group, "show", "Print what is in a case, and draw three slices of it", case_show_footer,
              [&context](CLI::App& command) {
                struct Arguments {
                  std::string folder;
                  std::string output;
                };
                auto arguments = std::make_shared<Arguments>();
                add_text(command, "CASE", arguments->folder, "Folder of the case").required();
                add_text(command, "-o,--output", arguments->output, "The picture, .png or .svg (default: NAME.png)");
                on_run(command,
                       [arguments, &context] { run_case_show(arguments->folder, arguments->output, context); });
              });
}

}  // namespace bodkin::cli
