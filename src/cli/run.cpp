#include <cctype>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>

#include "patient/prepared_body.h"
#include "session/operator_file.h"
#include "session/session_run.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/end_on_signal.h"
#include "cli/force_options.h"
#include "cli/outcome.h"
#include "core/error.h"
#include "io/case_folder.h"
#include "training/planning_rules.h"
#include "training/procedure_file.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

struct RunArguments {
  std::string folder;
  std::string operator_name;
  std::string entry, target;
  std::string output;
  std::int64_t seed = 1;
  session::RunSettings settings;
  ForceOptions forces;
};

constexpr const char* run_footer = R"(Examples:
  bodkin run patient                                 an expert performs the procedure as planned
  bodkin run patient --operator novice --seed 7      a beginner; another seed, another attempt
  bodkin run patient --operator mine.xml --realtime  an operator of your own, in real time
  bodkin run patient --entry=-3,95,8 --target=0,45,12
  bodkin run patient --resistance "tracking_wall catch_up_s=0.3" --part "relaxation share=0.4 time_s=2"

The session is saved while it runs; 'bodkin report', 'replay' and 'export' read it.
docs/running.md explains operators and how to write one.)";

// "session-CASE-OPERATOR-SEED.bodkin" in the current folder, numbered if it exists already.
fs::path free_name(const std::string& case_name, const std::string& operator_name, std::uint64_t seed,
                   bool overwrite) {
  std::string base = fmt::format("session-{}-{}-{}", case_name, operator_name, seed);
  for (char& character : base) {
    const auto byte = static_cast<unsigned char>(character);
    if (byte < 128 && std::isalnum(byte) == 0 && character != '-' && character != '_' && character != '.')
      character = '_';
  }
  fs::path name = base + ".bodkin";
  for (int number = 2; !overwrite && fs::exists(name); ++number) name = fmt::format("{}-{}.bodkin", base, number);
  return name;
}

anatomy::NeedlePath path_of(const RunArguments& arguments, const anatomy::Case& patient) {
  const std::optional<anatomy::NeedlePath>& planned = patient.description.procedure.path;
  if (!planned && (arguments.entry.empty() || arguments.target.empty())) {
    throw InputError(
        fmt::format("{}: the case has no planned path, give --entry and --target in LPS mm", arguments.folder));
  }
  anatomy::NeedlePath path = planned.value_or(anatomy::NeedlePath{});
  if (!arguments.entry.empty()) path.entry = parse_point(arguments.entry, "--entry");
  if (!arguments.target.empty()) path.target = parse_point(arguments.target, "--target");
  return path;
}

const char* name_of_signal(int signal) {
  if (signal == SIGHUP) return "SIGHUP";
  return signal == SIGTERM ? "SIGTERM" : "SIGINT";
}

void run_scripted(RunArguments arguments, CommandContext& context) {
  Console console(context);
  session::RunSettings& settings = arguments.settings;
  settings.seed = static_cast<std::uint64_t>(arguments.seed);
  if (!arguments.output.empty()) require_writable(arguments.output, "--output");
  if (!arguments.operator_name.empty()) settings.script = session::load_operator(arguments.operator_name);
  anatomy::Case patient = io::load_case(arguments.folder, console.progress());
  const training::Procedure procedure = training::procedure_of_case(patient.description.procedure.name);
  if (arguments.operator_name.empty()) settings.script = session::load_operator(procedure.expert);
  apply(arguments.forces, patient.description.haptics);
  settings.path = path_of(arguments, patient);
  patient::prepare_body(
      patient, arguments.folder, settings.path, console.progress(),
      [&](const std::string& text) { console.note(text); }, &settings.whole_body);
  settings.ending = training::completing_id(procedure, patient.library);
  settings.output = arguments.output.empty()
                        ? free_name(patient.description.name, settings.script.name, settings.seed, settings.overwrite)
                        : fs::path(arguments.output);
  const session::SessionHeader header = session::session_header(patient, arguments.folder, settings);
  session::RunResult run;
  {
    const EndOnSignal signals;
    settings.cancelled = [] { return EndOnSignal::signal() != 0; };
    run = session::run_session(patient, header, settings, console.progress());
  }
  console.clear_bar();
  if (run.cancelled) {
    context.exit_code = 128 + EndOnSignal::signal();
    console.note(fmt::format("the run was ended by {}; the session is complete up to that moment",
                             name_of_signal(EndOnSignal::signal())));
  }
  const Outcome outcome = read_outcome(settings.output, patient, std::move(run));
  for (const std::string& note : outcome.run.notes) console.note(note);
  if (outcome.run.completed) {
    console.note(fmt::format("the tip touched the {} {:.1f} mm below the skin: the attempt is complete",
                             patient.library.title(*settings.ending), *outcome.run.completed));
  } else if (!outcome.run.operator_finished && !outcome.run.cancelled) {
    console.note(fmt::format("the run reached the longest time of {} s while the operator was in phase '{}'",
                             settings.longest, outcome.run.last_phase));
  }
  if (settings.realtime) {
    console.note(fmt::format("{} of {} ticks began late (by {:.2f} ms at worst)", outcome.run.missed_deadlines,
                             outcome.run.ticks, 1e3 * outcome.run.worst_lateness));
  }
  if (outcome.run.records_lost > 0) {
    console.note(
        fmt::format("{} ticks were not recorded because the disk was too slow; the session cannot be replayed",
                    outcome.run.records_lost));
  }
  print(console, outcome, patient);
  console.json(json_of(outcome, patient).dump(2));
}

}  // namespace

void add_run_command(CLI::App& app, CommandContext& context) {
  add_command(
      app, "run", "A simulated hand performs the procedure and is recorded", run_footer,
      [&context](CLI::App& command) {
        auto arguments = std::make_shared<RunArguments>();
        session::RunSettings& settings = arguments->settings;
        add_text(command, "CASE", arguments->folder, "Folder of the case").required();
        add_text(
            command, "--operator", arguments->operator_name,
            "expert, novice, expert_epidural, expert_lumbar_puncture, expert_to_target, expert_acupuncture, or an "
            "operator file (default: the expert of the case's procedure)");
        add_whole_number(command, "--seed", arguments->seed, 0, std::numeric_limits<std::int64_t>::max(),
                         "Seed of the random numbers: errors of aim, tremor, reaction times");
        add_switch(command, "--realtime", settings.realtime, "Run in real time instead of as fast as possible");
        add_text(command, "-o,--output", arguments->output,
                 "Session file (default: session-CASE-OPERATOR-SEED.bodkin)");
        add_switch(command, "--overwrite", settings.overwrite, "Replace the session file if it exists");
        add_text(command, "--entry", arguments->entry,
                 "Where the path begins, x,y,z in LPS mm (default: as planned)");
        add_text(command, "--target", arguments->target, "Where it ends, x,y,z in LPS mm (default: as planned)");
        add_force_options(command, arguments->forces);
        add_number(command, "--max-time", settings.longest, 1.0, 3600.0,
                   "s of simulated time after which the run ends, 1 to 3600");
        on_run(command, [arguments, &context] { run_scripted(*arguments, context); });
      });
}

}  // namespace bodkin::cli
