#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/json_values.h"
#include "core/error.h"
#include "io/case_folder.h"

namespace bodkin::cli {

namespace {

using nlohmann::json;

constexpr const char* breathe_examples =
    R"(Makes the patient breathe: tissue around a centre moves to and fro, as the organs below the diaphragm do, and so do
the needle in it, the ultrasound and the images. Prints how far target, entry and structures move.

Examples:
  bodkin case breathe patient                              about the target, 10 mm to the feet and 3 to the front
  bodkin case breathe patient --centre kidney_left --motion 0,-4,-15
  bodkin case breathe patient --rate 20 --radius 60        faster, and less of the patient
  bodkin case breathe patient --off                        the patient no longer breathes

Exit code: 0, or 2 for bad input, which leaves the case unchanged.)";

constexpr double moves = 0.1;           // mm, what is worth a line
constexpr double bone_stands_by = 1.0;  // mm, by which bones may move unremarked

struct BreatheOptions {
  std::string folder, centre, motion;
  anatomy::Breathing breathing;
  std::int64_t pause = 2;
  bool off = false;
};

// Mean of a structure's voxels, LPS mm.
Vec3 middle_of(const anatomy::Case& patient, const std::string& name) {
  std::string names;
  for (const anatomy::Structure& each : patient.description.structures) {
    names += (names.empty() ? "" : ", ") + each.name;
    if (each.name != name) continue;
    Vec3 sum = Vec3::Zero();
    double count = 0.0;
    const anatomy::Grid& grid = patient.structures.grid;
    for (int k = 0; k < grid.size[2]; ++k)
      for (int j = 0; j < grid.size[1]; ++j)
        for (int i = 0; i < grid.size[0]; ++i)
          if (patient.structures.at(i, j, k) == each.label) sum += Vec3(i, j, k), count += 1.0;
    if (count == 0.0) throw InputError(fmt::format("the structure {} has no voxel", name));
    return grid.to_patient(sum / count);
  }
  throw InputError(fmt::format("--centre is '{}', which is not a structure of {}; it has {}", name,
                               patient.description.name, names.empty() ? "none" : names));
}

Vec3 centre_of(const BreatheOptions& options, const anatomy::Case& patient) {
  if (options.centre.empty()) {
    if (patient.description.procedure.path) return patient.description.procedure.path->target;
    throw InputError(
        fmt::format("{} has no target to centre the motion on; give a place with --centre", options.folder));
  }
  if (options.centre.find(',') != std::string::npos) return parse_point(options.centre, "--centre");
  return middle_of(patient, options.centre);
}

// Maximum motion of the voxels of each structure, and of bone, mm.
struct Motions {
  std::map<std::string, double> structures;
  double bone = 0.0;
};

Motions motions_of(const anatomy::Case& patient, const anatomy::Breathing& breathing) {
  const anatomy::BreathField field(breathing);
  const double most = breathing.motion.norm();
  Motions found;
  std::map<std::uint16_t, double> by_label;
  const auto go = [&](const anatomy::Grid& grid, const auto& take) {
    for (int k = 0; k < grid.size[2]; ++k)
      for (int j = 0; j < grid.size[1]; ++j)
        for (int i = 0; i < grid.size[0]; ++i)
          if (const double weight = field.weight(grid.to_patient(Vec3(i, j, k))); weight > 0.0)
            take(i, j, k, weight * most);
  };
  if (!patient.structures.empty()) {
    go(patient.structures.grid, [&](int i, int j, int k, double here) {
      double& known = by_label[patient.structures.at(i, j, k)];
      known = std::max(known, here);
    });
  }
  go(patient.tissues.grid, [&](int i, int j, int k, double here) {
    const anatomy::TissueId id = patient.tissues.at(i, j, k);
    if (id == anatomy::tissue::cortical_bone || id == anatomy::tissue::cancellous_bone)
      found.bone = std::max(found.bone, here);
  });
  for (const anatomy::Structure& each : patient.description.structures) {
    const auto label = by_label.find(each.label);
    if (label != by_label.end() && label->second >= moves) found.structures[each.name] = label->second;
  }
  return found;
}

void breathe(const BreatheOptions& options, CommandContext& context) {
  Console console(context);
  if (options.off) {
    anatomy::CaseDescription description = io::read_case_description(options.folder);
    description.breathing.reset();
    io::write_case_description(description, options.folder);
    console.json(json{{"case", options.folder}, {"breathes", false}}.dump(2));
    console.line(fmt::format("{} holds the breath.", options.folder));
    return;
  }
  anatomy::Case patient = io::load_case(options.folder, console.progress());
  console.clear_bar();
  anatomy::Breathing breathing = options.breathing;
  breathing.pause = static_cast<int>(options.pause);
  breathing.centre = centre_of(options, patient);
  if (!options.motion.empty()) breathing.motion = parse_point(options.motion, "--motion");
  check(breathing, "breathing");
  patient.description.breathing = breathing;
  const Motions found = motions_of(patient, breathing);
  io::write_case_description(patient.description, options.folder);
  const anatomy::BreathField field(breathing);
  json structures = json::object();
  for (const auto& [name, most] : found.structures) structures[name] = most;
  json result = {{"case", options.folder},         {"breathes", true},
                 {"rate_per_min", breathing.rate}, {"centre_mm", json_point(breathing.centre)},
                 {"structures_mm", structures},    {"bone_mm", found.bone}};
  const Vec3& c = breathing.centre;
  console.line(fmt::format("{} breathes {:g} times a minute; tissue at ({:.1f}, {:.1f}, {:.1f}) moves by {:.1f} mm.",
                           options.folder, breathing.rate, c.x(), c.y(), c.z(), breathing.motion.norm()));
  if (const auto& path = patient.description.procedure.path) {
    const double target = field.moved(path->target, 1.0).norm(), entry = field.moved(path->entry, 1.0).norm();
    result["target_mm"] = target;
    result["entry_mm"] = entry;
    console.line(fmt::format("The target moves by {:.1f} mm, the skin at the entry by {:.1f} mm.", target, entry));
  }
  for (const auto& [name, most] : found.structures) console.line(fmt::format("{:<28} up to {:4.1f} mm", name, most));
  console.json(result.dump(2, ' ', false, json::error_handler_t::replace));
  if (found.bone > bone_stands_by) {
    console.note(fmt::format(
        "bone moves too, by up to {:.1f} mm; a smaller --radius or another --centre keeps it still", found.bone));
  }
}

}  // namespace

void add_case_breathe_command(CLI::App& case_group, CommandContext& context) {
  add_command(
      case_group, "breathe", "Make a patient breathe, or stop breathing", breathe_examples,
      [&context](CLI::App& command) {
        const auto options = std::make_shared<BreatheOptions>();
        anatomy::Breathing& breathing = options->breathing;
        add_text(command, "CASE", options->folder, "Folder of the case").required();
        add_text(
            command, "--centre", options->centre,
            "x,y,z in LPS mm, or the name of a structure: tissue there moves most (default: the target of the case)");
        add_text(command, "--motion", options->motion,
                 "x,y,z in mm: how the centre moves as breath is drawn in, LPS (default: 0,-3,-10)");
        add_number(command, "--radius", breathing.radius, 20.0, 500.0,
                   "mm about the centre, 20 to 500: tissue farther away stands still");
        add_number(command, "--rate", breathing.rate, 2.0, 60.0, "Breaths a minute, 2 to 60");
        add_whole_number(command, "--pause", options->pause, 1, 6,
                         "How long the patient pauses breathed out, 1 to 6");
        add_number(command, "--longest-hold", breathing.longest_hold, 1.0, 120.0,
                   "Longest time that the patient holds the breath when asked to, s, 1 to 120");
        add_switch(command, "--off", options->off, "The patient does not breathe");
        on_run(command, [options, &context] { breathe(*options, context); });
      });
}

}  // namespace bodkin::cli
