#include <algorithm>
#include <cmath>

#include "training/interspace.h"
#include "training/metric_groups.h"

namespace bodkin::training {

namespace {

// Ticks before the first insertion.
std::size_t ticks_before(const Attempt& attempt) {
  return attempt.insertions.empty() ? attempt.size() : attempt.first_contact();
}

bool has_finger(const Attempt& attempt) {
  return attempt.session().header.haptics.parts.fingertip.has_value();
}

std::optional<double> felt_places(const Measured& measured) {
  if (!has_finger(measured.attempt)) return std::nullopt;
  return static_cast<double>(felt_before_entry(measured.attempt).size());
}

std::optional<double> palpation_time(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  if (!has_finger(attempt)) return std::nullopt;
  double time = 0.0;
  for (std::size_t i = 0; i < ticks_before(attempt); ++i) {
    const simulation::TickRecord& record = attempt.session().ticks[i];
    if (record.input.other.finger && record.output.tissue != anatomy::tissue::air) time += attempt.dt();
  }
  return time;
}

std::optional<double> felt_to_entry(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  const std::vector<Vec3> felt = felt_before_entry(attempt);
  if (attempt.insertions.empty() || felt.empty()) return std::nullopt;
  double least = unbounded;
  const Vec3 along = attempt.path().direction();
  for (const Vec3& place : felt) {
    const Vec3 way = place - attempt.tip[attempt.first_contact()];
    least = std::min(least, (way - way.dot(along) * along).norm());  // a finger presses the skin in
  }
  return least;
}

std::optional<SkinPlace> last_entry(const Attempt& attempt) {
  if (attempt.insertions.empty()) return std::nullopt;
  return skin_place(attempt.tip[attempt.insertions.back().first], attempt.description());
}

std::optional<double> entry_to_midline(const Measured& measured) {
  const auto place = last_entry(measured.attempt);
  return place ? std::optional(place->midline) : std::nullopt;
}

std::optional<double> entry_to_interspace(const Measured& measured) {
  const auto place = last_entry(measured.attempt);
  return place ? std::optional(std::abs(place->along)) : std::nullopt;
}

}  // namespace

std::vector<Vec3> felt_before_entry(const Attempt& attempt) {
  std::vector<Vec3> places;
  for (const session::SessionEvent& each : attempt.session().events) {
    if (each.event.kind != forces::EventKind::palpated) continue;
    const std::size_t index = attempt.index_of(each);
    if (index < ticks_before(attempt)) places.push_back(attempt.tip[index]);
  }
  return places;
}

std::vector<Metric> metrics_of_palpation() {
  return {{"felt_places", "", "places felt with a finger before the first insertion",
           "events palpated before it, where the patient has the part fingertip", "Bodkin", felt_places},
          {"palpation_s", "s", "time with a finger on the skin before the first insertion",
           "ticks of the finger on the skin times dt", "Bodkin", palpation_time},
          {"felt_to_entry_mm", "mm", "distance of the first entry from the nearest place that was felt",
           "between the tip at the first contact and the fingertip when it felt the place, across the planned path",
           "Bodkin", felt_to_entry},
          {"entry_to_midline_mm", "mm", "distance of the entry from the middle of the back",
           "across the line through the case's landmarks of the interspaces on the skin, last insertion", "Bodkin",
           entry_to_midline},
          {"entry_to_interspace_mm", "mm", "distance of the entry from the middle of the interspace",
           "along that line, from the nearest of these landmarks, last insertion", "Bodkin", entry_to_interspace}};
}

}  // namespace bodkin::training
