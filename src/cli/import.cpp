#include <chrono>
#include <memory>
#include <optional>

#include "link/tracked_tool.h"
#include "patient/prepared_body.h"
#include "session/session_poses.h"
#include "session/session_run.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/force_options.h"
#include "cli/outcome.h"
#include "core/error.h"
#include "io/case_folder.h"
#include "io/pose_log.h"

namespace bodkin::cli {

namespace {

struct ImportArguments {
  std::string recording, folder;
  std::string axis = "z";
  std::string output = "session-imported.bodkin";
  session::PoseImport how;
  ForceOptions forces;
};

constexpr const char* import_footer = R"(Examples:
  bodkin import recording.igs.mha patient                          what PLUS recorded
  bodkin import log.xml patient -o mine.bodkin                     the log of 3D Slicer's Perk Tutor
  bodkin import log.xml patient --needle NeedleTipToRas --points=-z
  bodkin score mine.bodkin

The recorded needle is moved through the patient of the case, whose layers resist it where the case has them. The
frame after "To" must be the case's CT in RAS mm; a needle in the tracker's frame is converted with the recording's own
ReferenceToTracker. See docs/openigtlink.md.)";

Mat3 needle_in_tool(const std::string& axis) {
  if (const std::optional<Mat3> tool = link::tool_along(axis)) return *tool;
  throw InputError(
      fmt::format("--points is '{}', expected x, y, z, -x, -y or -z: the tool's axis from hub to tip", axis));
}

void run_import(const ImportArguments& arguments, const CommandContext& context) {
  Console console(context);
  require_writable(arguments.output, "--output");
  session::PoseImport how = arguments.how;
  how.output = arguments.output;
  how.tool = needle_in_tool(arguments.axis);
  const io::PoseLog log = io::read_pose_log(arguments.recording);
  anatomy::Case patient = io::load_case(arguments.folder, console.progress());
  apply(arguments.forces, patient.description.haptics);
  if (!patient.description.procedure.path) {
    throw InputError(fmt::format(
        "{}: the case has no planned path, so there is nothing to judge by; make the case with --entry and --target",
        arguments.folder));
  }
  const anatomy::NeedlePath path = *patient.description.procedure.path;
  patient::prepare_body(patient, arguments.folder, path, console.progress(),
                        [&](const std::string& text) { console.note(text); });
  const session::SessionHeader header = session::session_header(patient, arguments.folder, path);
  const auto begin = std::chrono::steady_clock::now();
  const session::PoseImportResult done = session::import_poses(patient, header, log, how, console.progress());
  console.clear_bar();
  constexpr double wide = 0.2;  // s
  if (done.longest_gap > wide) {
    console.note(fmt::format("for {:.2f} s the recording has no pose of {}; the needle moves straight on meanwhile",
                             done.longest_gap, how.needle));
  }
  session::RunResult run;
  run.ticks = done.ticks;
  run.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run.operator_finished = true;
  const Outcome outcome = read_outcome(arguments.output, patient, std::move(run));
  print(console, outcome, patient);
  nlohmann::ordered_json json = json_of(outcome, patient);
  json["poses"] = done.poses;
  json["probe_samples"] = done.samples;
  json["longest_gap_s"] = done.longest_gap;
  console.json(json.dump(2));
}

}  // namespace

void add_import_command(CLI::App& app, CommandContext& context) {
  add_command(
      app, "import", "Make a session from a needle motion that 3D Slicer or PLUS recorded", import_footer,
      [&context](CLI::App& command) {
        auto arguments = std::make_shared<ImportArguments>();
        add_text(command, "RECORDING", arguments->recording, "Sequence (.igs.mha, .igs.nrrd) or recorder log (.xml)")
            .required();
        add_text(command, "CASE", arguments->folder, "Folder of the case").required();
        add_text(command, "-o,--output", arguments->output, "Session file");
        add_switch(command, "--overwrite", arguments->how.overwrite, "Replace the session file if it exists");
        add_text(command, "--needle", arguments->how.needle,
                 "Transform of the needle's tip (default: NeedleTipToReference)");
        add_text(command, "--points", arguments->axis, "The needle's axis from hub to tip: x, y, z, -x, -y or -z");
        add_text(command, "--probe", arguments->how.probe,
                 "Transform of the probe, where there is one (default: ProbeToReference)");
        add_force_options(command, arguments->forces);
        on_run(command, [arguments, &context] { run_import(*arguments, context); });
      });
}

}  // namespace bodkin::cli
