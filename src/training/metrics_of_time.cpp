#include <algorithm>

#include <nlohmann/json.hpp>

#include "training/metric_groups.h"

namespace bodkin::training {

namespace {

std::optional<double> duration(const Measured& measured) {
  return measured.attempt.time.back();
}

std::optional<double> time_in_body(const Measured& measured) {
  return static_cast<double>(std::count(measured.attempt.inside.begin(), measured.attempt.inside.end(), 1)) *
         measured.attempt.dt();
}

std::optional<double> time_to_final_position(const Measured& measured) {
  return with_insertion(measured, [](const Attempt& attempt) {
    return attempt.time[attempt.final_tip->tick] - attempt.time[attempt.first_contact()];
  });
}

std::optional<double> insertions(const Measured& measured) {
  return static_cast<double>(measured.attempt.insertions.size());
}

std::optional<double> redirections(const Measured& measured) {
  return measured.redirections;
}

// For a needle seen by a camera; others are never out of sight.
bool is_tracked(const session::Session& session) {
  const nlohmann::json settings = nlohmann::json::parse(session.header.operator_settings, nullptr, false);
  return settings.is_object() && settings.value("driver", "") == "tracked";
}

std::optional<double> times_unseen(const Measured& measured) {
  const session::Session& session = measured.attempt.session();
  if (!is_tracked(session)) return std::nullopt;
  return static_cast<double>(std::count_if(session.events.begin(), session.events.end(), [](const auto& one) {
    return one.event.kind == forces::EventKind::hand_lost;
  }));
}

std::optional<double> time_unseen(const Measured& measured) {
  const session::Session& session = measured.attempt.session();
  if (!is_tracked(session)) return std::nullopt;
  double seconds = 0.0;
  std::optional<std::uint64_t> since;  // tick
  for (const session::SessionEvent& one : session.events) {
    if (one.event.kind == forces::EventKind::hand_lost) since = one.tick;
    if (one.event.kind != forces::EventKind::hand_seen) continue;
    seconds += one.event.value;
    since.reset();
  }
  if (since) seconds += static_cast<double>(session.ticks.back().tick + 1 - *since) * measured.attempt.dt();
  return seconds;
}

}  // namespace

std::vector<Metric> metrics_of_time() {
  return {
      {"duration_s", "s", "duration", "from the first to the last tick", "PerkTutor, Elapsed Time", duration},
      {"time_in_body_s", "s", "time in the body", "ticks in contact times dt", "PerkTutor, Time in Tissue",
       time_in_body},
      {"time_to_final_position_s", "s", "time to the final position",
       "from the first contact to the end of the rest that is the final position", "Kwon et al. 2001, total time",
       time_to_final_position},
      {"insertions", "", "insertions",
       "contacts with the body after the needle was outside for over 0.5 s or by over 5 mm",
       "Kwon et al. 2001, number of trials", insertions},
      {"redirections", "", "redirections",
       "retreats of over 5 mm in the body, then an advance of at least 1 mm with the axis turned by over 3 deg",
       "Bodkin", redirections},
      {"times_unseen", "", "times that the tracked needle was not seen",
       "events hand_lost: the camera saw needle or mannequin badly or not at all, and the needle rested", "Bodkin",
       times_unseen},
      {"unseen_s", "s", "time for which it was not seen",
       "sum of the values of the events hand_seen, and from the last hand_lost to the end", "Bodkin", time_unseen}};
}

}  // namespace bodkin::training
