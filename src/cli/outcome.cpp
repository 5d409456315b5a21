#include "cli/outcome.h"

#include <algorithm>
#include <utility>

#include "report/crossings.h"
#include "report/force_limits.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/force_options.h"
#include "training/case_score.h"

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
  outcome.score = training::score_on_case(outcome.session, patient);
  return outcome;
}

nlohmann::ordered_json json_of(const Outcome& outcome, const anatomy::Case& patient) {
  const training::Score& score = outcome.score;
  const anatomy::TissueLibrary& library = patient.library;
  const auto metric = [&score](const char* name) {
    const training::MetricResult* result = score.find(name);
    return result == nullptr ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(result->value);
  };
  nlohmann::ordered_json json = {
      {"session", outcome.file.string()},
      {"operator", outcome.session.header.operator_name},
      {"seed", outcome.session.header.seed},
      {"resistance", anatomy::name_of(outcome.session.header.haptics.resistance)},
      {"constraint", anatomy::name_of(outcome.session.header.haptics.constraint)},
      {"time_s", outcome.time()},
      {"wall_time_s", outcome.run.wall_time},
      {"speed_factor", outcome.speed()},
      {"operator_finished", outcome.run.operator_finished},
      {"completed_at_mm",
       outcome.run.completed ? nlohmann::ordered_json(*outcome.run.completed) : nlohmann::ordered_json(nullptr)},
      {"verdict", training::name_of(score.verdict)},
      {"headline", score.headline},
      {"reached", score.reached},
      {"reached_s",
       score.reached_time ? nlohmann::ordered_json(*score.reached_time) : nlohmann::ordered_json(nullptr)},
      {"final_distance_mm", metric("final_distance_mm")},
      {"final_axial_mm", metric("final_axial_mm")},
      {"final_lateral_mm", metric("final_lateral_mm")},
      {"deepest_mm", metric("deepest_mm")},
      {"peak_force_N", metric("peak_force_N")},
      {"peak_applied_force_N", outcome.peak_applied()},
      {"bone_contacts", metric("bone_contacts")},
      {"insertions", metric("insertions")},
      {"missed_deadlines", outcome.run.missed_deadlines},
      {"worst_lateness_s", outcome.run.worst_lateness},
      {"records_lost", outcome.run.records_lost}};
  json["findings"] = nlohmann::ordered_json::array();
  for (const training::Finding& each : score.findings) {
    json["findings"].push_back(
        {{"grade", training::name_of(each.grade)}, {"subject", each.subject}, {"sentence", each.sentence}});
  }
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
  for (const training::TissueTotal& tissue : outcome.score.tissues) {
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
  const training::Score& score = outcome.score;
  console.line(score.headline);
  for (const training::Finding& each : score.findings) console.line("  " + each.sentence);
  const std::string limits = report::force_limits(outcome.session).sentence(patient.description.device);
  if (!limits.empty()) console.line("  " + limits);
  console.line(fmt::format("\n{:<26} {:>8} {:>8} {:>10}", "tissue", "from mm", "to mm", "peak N"));
  for (const training::TissueTotal& tissue : outcome.score.tissues) {
    console.line(fmt::format("{:<26} {:>8.1f} {:>8.1f} {:>10.2f}", patient.library.title(tissue.tissue), tissue.from,
                             tissue.to, tissue.peak_force));
  }
  print_events(console, outcome, patient);
  console.line(fmt::format("\n{:<14} {:.1f} s simulated in {:.2f} s, {:.0f} times real time", "time", outcome.time(),
                           outcome.run.wall_time, outcome.speed()));
  if (const training::MetricResult* peak = score.find("peak_force_N")) {
    console.line(fmt::format("{:<14} {:.2f} N of resistance; at most {:.2f} N reached the hand", "peak force",
                             peak->value, outcome.peak_applied()));
  }
  console.line(fmt::format("{:<14} {:g}", "bone contacts", score.find("bone_contacts")->value));
  console.line(fmt::format("{:<14} {}", "force models", force_names(outcome.session.header.haptics)));
  console.line(fmt::format("{:<14} {}", "session", outcome.file.string()));
}

}  // namespace bodkin::cli
