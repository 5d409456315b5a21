#include <memory>
#include <optional>
#include <string>

#include "patient/warp/warped_case.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "core/error.h"
#include "core/files.h"
#include "io/case_folder.h"
#include "io/partial_folder.h"
#include "io/placement_file.h"

namespace bodkin::cli {

namespace {

struct CaseWarpOptions {
  std::string patient, mannequin, folder, registration, placed, name;
  patient::SkinFitSettings fit;
  bool overwrite = false;
};

constexpr const char* case_warp_footer =
    R"(Fits a patient into a mannequin, so that the patient's skin coincides with the mannequin's: the patient is first moved,
then warped, bone included.

Examples:
  bodkin register mannequin.csv patient.csv -o placed.json
  bodkin case warp patient mannequin warped --registration placed.json
  bodkin case warp patient mannequin warped --placed moved.json
  bodkin overlay patient footage --registration moved.json       the patient moved but not warped
  bodkin case warp patient mannequin warped --reach 200          more of the skin than 120 mm about the entry

MANNEQUIN is a case made from a CT of the mannequin (bodkin case new). Without --registration the planned entries of both
cases are superimposed, or the middles of both skins if a case has no planned entry. See docs/augmented-reality.md.)";

Vec3 middle_of(const patient::Skin& skin) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& vertex : skin.surface.vertices()) sum += vertex;
  return sum / static_cast<double>(skin.surface.vertices().size());
}

Pose start_of(const CaseWarpOptions& options, const anatomy::Case& of_patient, const patient::Skin& skin,
              const anatomy::CaseDescription& mannequin, const patient::Skin& body) {
  if (!options.registration.empty()) {
    return io::read_rigid_placement(options.registration, "register without --scale; the warping adapts the size");
  }
  Pose start = Pose::Identity();
  const auto& own = of_patient.description.procedure.path;
  const auto& other = mannequin.procedure.path;
  start.translation() = own && other ? Vec3(other->entry - own->entry) : Vec3(middle_of(body) - middle_of(skin));
  return start;
}

nlohmann::ordered_json json_of(const patient::SkinDistances& distances) {
  return {{"rms_mm", distances.rms}, {"p95_mm", distances.p95}, {"most_mm", distances.most}};
}

void run_case_warp(const CaseWarpOptions& options, const CommandContext& context) {
  patient::check(options.fit);
  if (!options.placed.empty()) require_writable(options.placed, "--placed", options.registration);
  Console console(context);
  io::PartialFolder folder(options.folder, options.overwrite);
  const anatomy::Case patient = io::load_case(options.patient, console.progress());
  const anatomy::CaseDescription mannequin = io::read_case_description(options.mannequin);
  const patient::Skin skin = patient::skin_of(patient.tissues);
  const patient::Skin body =
      patient::skin_of(io::load_case_tissues(options.mannequin, mannequin, console.progress()));
  const Vec3 middle =
      patient.description.procedure.path ? patient.description.procedure.path->entry : middle_of(skin);
  const patient::SkinFit fit(skin, body, start_of(options, patient, skin, mannequin, body), middle, options.fit);
  anatomy::Case made = patient::warped_case(patient, fit, console.progress());
  if (!options.name.empty()) made.description.name = options.name;
  io::write_case(made.description, made.ct, made.tissues, made.structures, &made.library, folder.path());
  if (!options.placed.empty()) write_file(options.placed, io::placement_json({.pose = fit.moved()}));
  folder.finish();
  console.clear_bar();
  console.line(
      fmt::format("{} is ready: {} in the skin of {}", options.folder, patient.description.name, mannequin.name));
  for (const auto& [when, distances] :
       {std::pair{"before", fit.at_start()}, {"moved", fit.when_moved()}, {"bent", fit.when_bent()}}) {
    console.line(
        fmt::format("  skin to skin, {:<7} {:5.2f} mm RMS, {:5.2f} mm in 95 of 100 places, {:5.2f} mm at most", when,
                    distances.rms, distances.p95, distances.most));
  }
  console.line(fmt::format("Next: bodkin app {0}, bodkin overlay {0} FOOTAGE", options.folder));
  console.json(nlohmann::ordered_json{{"folder", options.folder},
                                      {"pairs", fit.pairs()},
                                      {"before", json_of(fit.at_start())},
                                      {"moved", json_of(fit.when_moved())},
                                      {"bent", json_of(fit.when_bent())}}
                   .dump(2));
}

}  // namespace

void add_case_warp_command(CLI::App& case_group, CommandContext& context) {
  add_command(case_group, "warp", "Warp a patient so that its skin fits that of a mannequin", case_warp_footer,
              [&context](CLI::App& command) {
                auto options = std::make_shared<CaseWarpOptions>();
                add_text(command, "PATIENT", options->patient, "Folder of the patient's case").required();
                add_text(command, "MANNEQUIN", options->mannequin, "Folder of the mannequin's case").required();
                add_text(command, "DIR", options->folder, "Folder of the new case; it must not exist yet").required();
                add_text(command, "--registration", options->registration,
                         "Where the patient lies in the mannequin, as 'bodkin register MANNEQUIN PATIENT' found it");
                add_text(
                    command, "--placed", options->placed,
                    "File for the placement of the patient without warping, a registration for 'bodkin overlay'");
                add_number(command, "--reach", options->fit.reach, 30.0, 500.0,
                           "mm of skin about the planned entry, 30 to 500");
                add_number(command, "--spacing", options->fit.spacing, 5.0, 60.0,
                           "mm between the points that are brought together, 5 to 60");
                add_text(command, "--name", options->name, "Name of the new case (default: the patient's)");
                add_switch(command, "--overwrite", options->overwrite, "Replace a case that is already there");
                on_run(command, [options, &context] { run_case_warp(*options, context); });
              });
}

}  // namespace bodkin::cli
