#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/force_options.h"
#include "core/error.h"
#include "io/case_folder.h"
#include "training/crossings.h"
#include "training/operator_file.h"
#include "training/session_run.h"
#include "training/session_summary.h"

namespace bodkin {

namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string folder;
  std::string operator_name = "expert";
  std::string entry, target;
  std::string output;
  std::int64_t seed = 1;
  RunSettings settings;
  ForceOptions forces;
};

constexpr const char* footer = R"(Examples:
  bodkin run patient                                 an expert performs the procedure as planned
  bodkin run patient --operator novice --seed 7      a beginner; another seed, another attempt
  bodkin run patient --operator mine.xml --realtime  an operator of your own, on the clock
  bodkin run patient --entry=-3,95,8 --target=0,45,12
  bodkin run patient --resistance "tracking_wall catch_up_s=0.3" --part "relaxation share=0.4 time_s=2"

The session is saved while it runs; 'bodkin report', 'replay' and 'export' read it.
docs/running.md explains operators and how to write one.)";

// "session-CASE-OPERATOR-SEED.bodkin" in the current folder, numbered when there is one already.
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

NeedlePath path_of(const Arguments& arguments, const Case& patient) {
  const std::optional<NeedlePath>& planned = patient.description.procedure.path;
  if (!planned && (arguments.entry.empty() || arguments.target.empty())) {
    throw InputError(
        fmt::format("{}: the case has no planned path, give --entry and --target in LPS mm", arguments.folder));
  }
  NeedlePath path = planned.value_or(NeedlePath{});
  if (!arguments.entry.empty()) path.entry = parse_point(arguments.entry, "--entry");
  if (!arguments.target.empty()) path.target = parse_point(arguments.target, "--target");
  return path;
}

// What a person wants to know at the end.
struct Outcome {
  RunResult run;
  Session session;  // as it was saved
  SessionSummary summary;
  Verdict verdict;
  fs::path file;

  double time() const { return static_cast<double>(run.ticks) * session.header.dt; }
  // N, the greatest force that reached the hand.
  double peak_applied() const {
    double peak = 0.0;
    for (const TickRecord& record : session.ticks) peak = std::max(peak, record.output.applied.force.norm());
    return peak;
  }
  double speed() const { return run.wall_time > 0.0 ? time() / run.wall_time : 0.0; }
};

nlohmann::ordered_json json_of(const Outcome& outcome, const Case& patient) {
  const SessionSummary& summary = outcome.summary;
  const TissueLibrary& library = patient.library;
  nlohmann::ordered_json json = {{"session", outcome.file.string()},
                                 {"operator", outcome.session.header.operator_name},
                                 {"seed", outcome.session.header.seed},
                                 {"resistance", name_of(outcome.session.header.haptics.resistance)},
                                 {"constraint", name_of(outcome.session.header.haptics.constraint)},
                                 {"time_s", outcome.time()},
                                 {"wall_time_s", outcome.run.wall_time},
                                 {"speed_factor", outcome.speed()},
                                 {"operator_finished", outcome.run.operator_finished},
                                 {"reached", outcome.verdict.reached},
                                 {"verdict", outcome.verdict.headline},
                                 {"target_distance_mm", summary.final_error.distance},
                                 {"target_axial_mm", summary.final_error.axial},
                                 {"target_lateral_mm", summary.final_error.lateral},
                                 {"deepest_mm", summary.deepest},
                                 {"peak_force_N", summary.peak_force},
                                 {"peak_depth_mm", summary.peak_depth},
                                 {"peak_applied_force_N", outcome.peak_applied()},
                                 {"peak_tissue", library.title(summary.peak_tissue)},
                                 {"bone_contacts", summary.bone_contacts},
                                 {"insertions", summary.insertions},
                                 {"missed_deadlines", outcome.run.missed_deadlines},
                                 {"worst_lateness_s", outcome.run.worst_lateness},
                                 {"records_lost", outcome.run.records_lost}};
  json["target_tissue_time_s"] = summary.target_tissue_time ? nlohmann::ordered_json(*summary.target_tissue_time)
                                                            : nlohmann::ordered_json(nullptr);
  json["tissues"] = nlohmann::ordered_json::array();
  for (const TissueTotal& tissue : summary.tissues) {
    json["tissues"].push_back({{"tissue", library.title(tissue.tissue)},
                               {"from_mm", tissue.from},
                               {"to_mm", tissue.to},
                               {"peak_force_N", tissue.peak_force},
                               {"peak_depth_mm", tissue.peak_depth}});
  }
  json["events"] = nlohmann::ordered_json::array();
  for (const SessionEvent& event : outcome.session.events) {
    json["events"].push_back({{"time_s", static_cast<double>(event.tick) * outcome.session.header.dt},
                              {"depth_mm", event.event.depth},
                              {"text", event_text(event.event, library)}});
  }
  json["notes"] = outcome.run.notes;
  return json;
}

void print_events(const Console& console, const Outcome& outcome, const Case& patient) {
  constexpr std::size_t most = 24;  // one screen
  std::size_t shown = 0, left = 0;
  console.line(fmt::format("\n{:>9} {:>9}   {}", "time s", "depth mm", "event"));
  for (const SessionEvent& event : outcome.session.events) {
    if (!is_notable(event.event.kind)) continue;
    if (shown == most) {
      ++left;
      continue;
    }
    ++shown;
    console.line(fmt::format("{:>9.2f} {:>9.1f}   {}", static_cast<double>(event.tick) * outcome.session.header.dt,
                             event.event.depth, event_text(event.event, patient.library)));
  }
  if (left > 0) console.line(fmt::format("{:>22} {} more", "", left));
}

void print(const Console& console, const Outcome& outcome, const Case& patient) {
  const SessionSummary& summary = outcome.summary;
  console.line(outcome.verdict.headline);
  for (const std::string& remark : outcome.verdict.remarks) console.line("  " + remark);
  console.line(fmt::format("\n{:<26} {:>8} {:>8} {:>10}", "tissue", "from mm", "to mm", "peak N"));
  for (const TissueTotal& tissue : summary.tissues) {
    console.line(fmt::format("{:<26} {:>8.1f} {:>8.1f} {:>10.2f}", patient.library.title(tissue.tissue), tissue.from,
                             tissue.to, tissue.peak_force));
  }
  print_events(console, outcome, patient);
  console.line(fmt::format("\n{:<14} {:.1f} s simulated in {:.2f} s, {:.0f} times real time", "time", outcome.time(),
                           outcome.run.wall_time, outcome.speed()));
  console.line(fmt::format("{:<14} {:.1f} mm from the target ({:+.1f} along the path, {:.1f} beside it)", "tip",
                           summary.final_error.distance, summary.final_error.axial, summary.final_error.lateral));
  console.line(fmt::format("{:<14} {:.2f} N of resistance in {} at {:.1f} mm; at most {:.2f} N reached the hand",
                           "peak force", summary.peak_force, patient.library.title(summary.peak_tissue),
                           summary.peak_depth, outcome.peak_applied()));
  console.line(fmt::format("{:<14} {}", "bone contacts", summary.bone_contacts));
  console.line(fmt::format("{:<14} {}", "force models", force_names(outcome.session.header.haptics)));
  console.line(fmt::format("{:<14} {}", "session", outcome.file.string()));
}

void run(Arguments arguments, const CommandContext& context) {
  Console console(context);
  RunSettings& settings = arguments.settings;
  settings.seed = static_cast<std::uint64_t>(arguments.seed);
  if (!arguments.output.empty()) require_writable(arguments.output, "--output");
  settings.script = load_operator(arguments.operator_name);
  Case patient = load_case(arguments.folder, console.progress());
  apply(arguments.forces, patient.description.haptics);
  settings.path = path_of(arguments, patient);
  settings.output = arguments.output.empty()
                        ? free_name(patient.description.name, settings.script.name, settings.seed, settings.overwrite)
                        : fs::path(arguments.output);
  const SessionHeader header = session_header(patient, arguments.folder, settings);
  Outcome outcome;
  outcome.run = run_session(patient, header, settings, console.progress());
  outcome.file = fs::absolute(settings.output).lexically_normal();
  outcome.session = read_session(settings.output);
  outcome.summary = summarise(outcome.session, patient);
  outcome.verdict = judge(outcome.summary, outcome.session, patient);
  console.clear_bar();
  for (const std::string& note : outcome.run.notes) console.note(note);
  if (!outcome.run.operator_finished) {
    console.note(fmt::format("the longest time of {} s was over while the operator was in phase '{}'",
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
  auto arguments = std::make_shared<Arguments>();
  RunSettings& settings = arguments->settings;
  CLI::App* command = add_command(app, "run", "A simulated hand performs the procedure and is recorded", footer);
  add_text(*command, "CASE", arguments->folder, "Folder of the case").required();
  add_text(*command, "--operator", arguments->operator_name, "expert, novice, or an operator file");
  add_whole_number(*command, "--seed", arguments->seed, 0, std::numeric_limits<std::int64_t>::max(),
                   "What chance is made from: errors of aim, tremor, reaction times");
  add_switch(*command, "--realtime", settings.realtime, "On the clock instead of as fast as it goes");
  add_text(*command, "-o,--output", arguments->output, "Session file (default: session-CASE-OPERATOR-SEED.bodkin)");
  add_switch(*command, "--overwrite", settings.overwrite, "Replace the session file if it exists");
  add_text(*command, "--entry", arguments->entry, "Where the path begins, x,y,z in LPS mm (default: as planned)");
  add_text(*command, "--target", arguments->target, "Where it ends, x,y,z in LPS mm (default: as planned)");
  add_force_options(*command, arguments->forces);
  add_number(*command, "--max-time", settings.longest, 1.0, 3600.0,
             "s of simulated time after which the run ends, 1 to 3600");
  on_run(*command, [arguments, &context] { run(*arguments, context); });
}

}  // namespace bodkin
