#include "cli/outcome.h"

#include <algorithm>
#include <utility>

#include "report/crossings.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/force_options.h"

namespace bodkin::cli {

namespace fs = std::filesystem;

namespace {

void print_events(const Console& console, const Outcome& outcome, const anatomy::Case& patient) {
  constexpr std::size_t most = 24;  // one screen
  std::size_t shown = 0, left = 0;
  console.line(fmt::format("\n{:>9} {:>9}   {}", "time s", "depth mm", "event"));
  for (const session::SessionEvent& event : outcome.session.events) {
    if (!report::is_notable(event.event.kind)) continue;
    if (shown == most) {
      ++left;
      continue;
    }
    ++shown;
    console.line(fmt::format("{:>9.2f} {:>9.1f}   {}", static_cast<double>(event.tick) * outcome.session.header.dt,
                             event.event.depth, report::event_text(event.event, patient.library)));
  }
  if (left > 0) console.line(fmt::format("{:>22} {} more", "", left));
}

}  // namespace

double Outcome::time() const {
  return static_cast<double>(run.ticks) * session.header.dt;
}

double Outcome::peak_applied() const {
  double peak = 0.0;
  for (const simulation::TickRecord& record : session.ticks)
    peak = std::max(peak, record.output.applied.force.norm());
  return peak;
}

double Outcome::speed() const {
  return run.wall_time > 0.0 ? time() / run.wall_time : 0.0;
}

Outcome read_outcome(const fs::path& file, const anatomy::Case& patient, session::RunResult run) {
  Outcome outcome;
  outcome.run = std::move(run);
  outcome.file = fs::absolute(file).lexically_normal();
  outcome.session = session::read_session(file);
  outcome.summary = report::summarise(outcome.session, patient);
  outcome.verdict = report::judge(outcome.summary, outcome.session, patient);
  return outcome;
}

nlohmann::ordered_json json_of(const Outcome& outcome, const anatomy::Case& patient) {
  const report::SessionSummary& summary = outcome.summary;
  const anatomy::TissueLibrary& library = patient.library;
  nlohmann::ordered_json json = {{"session", outcome.file.string()},
                                 {"operator", outcome.session.header.operator_name},
                                 {"seed", outcome.session.header.seed},
                                 {"resistance", anatomy::name_of(outcome.session.header.haptics.resistance)},
                                 {"constraint", anatomy::name_of(outcome.session.header.haptics.constraint)},
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
  if (const auto& timings = outcome.session.timings) {
    const auto spread = [](const std::vector<session::TimeBin>& bins) {
      return nlohmann::ordered_json{{"median_s", session::percentile(bins, 0.5)},
                                    {"p99_s", session::percentile(bins, 0.99)},
                                    {"longest_s", session::percentile(bins, 1.0)}};
    };
    json["timings"] = {{"overruns", timings->overruns},
                       {"rounds", session::count_of(timings->compute)},
                       {"lateness", spread(timings->lateness)},
                       {"compute", spread(timings->compute)}};
  }
  json["tissues"] = nlohmann::ordered_json::array();
  for (const report::TissueTotal& tissue : summary.tissues) {
    json["tissues"].push_back({{"tissue", library.title(tissue.tissue)},
                               {"from_mm", tissue.from},
                               {"to_mm", tissue.to},
                               {"peak_force_N", tissue.peak_force},
                               {"peak_depth_mm", tissue.peak_depth}});
  }
  json["events"] = nlohmann::ordered_json::array();
  for (const session::SessionEvent& event : outcome.session.events) {
    json["events"].push_back({{"time_s", static_cast<double>(event.tick) * outcome.session.header.dt},
                              {"depth_mm", event.event.depth},
                              {"text", report::event_text(event.event, library)}});
  }
  json["notes"] = outcome.run.notes;
  return json;
}

void print(const Console& console, const Outcome& outcome, const anatomy::Case& patient) {
  const report::SessionSummary& summary = outcome.summary;
  console.line(outcome.verdict.headline);
  for (const std::string& remark : outcome.verdict.remarks) console.line("  " + remark);
  console.line(fmt::format("\n{:<26} {:>8} {:>8} {:>10}", "tissue", "from mm", "to mm", "peak N"));
  for (const report::TissueTotal& tissue : summary.tissues) {
    console.line(fmt::format("{:<26} {:>8.1f} {:>8.1f} {:>10.2f}", patient.library.title(tissue.tissue), tissue.from,
                             tissue.to, tissue.peak_force));
  }
  print_events(console, outcome, patient);
  console.line(fmt::format("\n{:<14} {:.1f} s simulated in {:.2f} s, {:.0f} times real time", "time", outcome.time(),
                           outcome.run.wall_time, outcome.speed()));
  console.line(fmt::format("{:<14} {:.1f} mm from the target ({:+.1f} along the path, {:.1f} across it)", "tip",
                           summary.final_error.distance, summary.final_error.axial, summary.final_error.lateral));
  console.line(fmt::format("{:<14} {:.2f} N of resistance in {} at {:.1f} mm; at most {:.2f} N reached the hand",
                           "peak force", summary.peak_force, patient.library.title(summary.peak_tissue),
                           summary.peak_depth, outcome.peak_applied()));
  console.line(fmt::format("{:<14} {}", "bone contacts", summary.bone_contacts));
  console.line(fmt::format("{:<14} {}", "force models", force_names(outcome.session.header.haptics)));
  console.line(fmt::format("{:<14} {}", "session", outcome.file.string()));
}

}  // namespace bodkin::cli
