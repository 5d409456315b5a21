#include "training/measured.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bodkin::training {

namespace {

constexpr double speed_span = 0.02;         // s over which a speed is taken
constexpr double advance_afterwards = 1.0;  // mm

// Counts redirections inside one insertion.
int redirections_in(const Attempt& attempt, const Insertion& insertion) {
  int count = 0;
  double deepest = attempt.depth[insertion.first], shallowest = deepest;
  Vec3 axis_at_deepest = attempt.axis[insertion.first];
  bool retreated = false;
  for (std::size_t i = insertion.first; i <= insertion.last; ++i) {
    const double depth = attempt.depth[i];
    const Vec3& axis = attempt.axis[i];
    if (!retreated) {
      if (depth >= deepest) {
        deepest = depth;
        axis_at_deepest = axis;
      } else if (deepest - depth > attempt.thresholds().retreat) {
        retreated = true;
        shallowest = depth;
      }
      continue;
    }
    shallowest = std::min(shallowest, depth);
    if (depth - shallowest < advance_afterwards) continue;
    const double turn = std::atan2(axis.cross(axis_at_deepest).norm(), axis.dot(axis_at_deepest)) / degree;
    if (turn > attempt.thresholds().redirection) ++count;
    retreated = false;
    deepest = depth;
    axis_at_deepest = axis;
  }
  return count;
}

void follow(const Attempt& attempt, std::size_t index, Puncture& puncture) {
  const auto span = static_cast<std::size_t>(std::max(1.0, std::round(speed_span / attempt.dt())));
  const double from = attempt.depth[index];
  double deepest = from;
  std::size_t i = index;
  for (; i < attempt.size(); ++i) {
    deepest = std::max(deepest, attempt.depth[i]);
    const std::size_t before = i >= span ? i - span : 0;
    if (before == i) continue;
    const double speed = (attempt.depth[i] - attempt.depth[before]) / (attempt.time[i] - attempt.time[before]);
    if (i >= index) puncture.speed = std::max(puncture.speed, speed);
    if (speed < attempt.thresholds().stop_speed || attempt.inside[i] == 0) break;
  }
  const std::size_t stop = std::min(i, attempt.size() - 1);
  puncture.overshoot = deepest - from;
  puncture.reaction = attempt.time[stop] - attempt.time[index];
}

// The greatest inward speed in the second before, over a span in which tremor cancels.
double approach_speed(const Attempt& attempt, std::size_t index) {
  constexpr double looked_back = 1.0, span_of_approach = 0.1;  // s
  const auto span = static_cast<std::size_t>(std::max(1.0, std::round(span_of_approach / attempt.dt())));
  double fastest = 0.0;
  for (std::size_t i = index; i >= span; --i) {
    const std::size_t before = i - span;
    if (attempt.time[index] - attempt.time[before] > looked_back || attempt.inside[before] == 0) break;
    const double time = attempt.time[i] - attempt.time[before];
    if (time > 0.0) fastest = std::max(fastest, (attempt.depth[i] - attempt.depth[before]) / time);
  }
  return fastest;
}

std::vector<Puncture> find_punctures(const Attempt& attempt) {
  std::vector<Puncture> found;
  for (const session::SessionEvent& each : attempt.session().events) {
    const forces::Event& event = each.event;
    const bool counts = event.kind == forces::EventKind::puncture ||
                        event.kind == forces::EventKind::loss_of_resistance ||
                        event.kind == forces::EventKind::pressure_lost;
    if (!counts) continue;
    const std::size_t index = attempt.index_of(each);
    Puncture puncture{.kind = event.kind, .tissue = event.tissue, .time = attempt.time[index], .depth = event.depth};
    puncture.force = std::max(event.value, event.felt);
    follow(attempt, index, puncture);
    puncture.approach = approach_speed(attempt, index == 0 ? 0 : index - 1);
    found.push_back(puncture);
  }
  return found;
}

}  // namespace

TargetError target_error(const Vec3& tip, const anatomy::NeedlePath& path) {
  const Vec3 miss = tip - path.target;
  TargetError error;
  error.distance = miss.norm();
  error.axial = path.length() > 0.0 ? miss.dot(path.direction()) : 0.0;
  error.lateral = std::sqrt(std::max(0.0, miss.squaredNorm() - error.axial * error.axial));
  return error;
}

Measured::Measured(const Attempt& its_attempt, const std::vector<std::string>& named)
    : attempt(its_attempt),
      motion(filtered_motion(attempt)),
      active(needle_in_action(attempt, motion)),
      path_length(training::path_length(motion)),
      tremor(training::tremor(attempt)),
      punctures(find_punctures(attempt)) {
  for (const session::ScannedPart& part : attempt.session().scanned)
    if (std::find(named.begin(), named.end(), part.name) != named.end()) scanned.push_back(part);
  std::map<anatomy::TissueId, TissueTotal> totals;
  std::size_t peak_index = 0;
  for (std::size_t i = 0; i < attempt.size(); ++i) {
    double step_work = 0.0;
    if (i > 0) {
      step_work = -0.5 * (attempt.force[i] + attempt.force[i - 1]).dot(attempt.hand[i] - attempt.hand[i - 1]);
      work += step_work;
    }
    if (attempt.inside[i] == 0) continue;
    const double depth = attempt.depth[i], resistance = attempt.resistance[i];
    if (resistance > peak_force) {
      peak_force = resistance;
      peak_depth = depth;
      peak_tissue = attempt.tissue[i];
      peak_index = i;
    }
    if (attempt.tissue[i] == anatomy::tissue::air) continue;
    const auto [place, is_new] = totals.try_emplace(attempt.tissue[i]);
    TissueTotal& total = place->second;
    if (is_new) total = {attempt.tissue[i], depth, depth, 0.0, 0.0, depth, 0.0};
    total.from = std::min(total.from, depth);
    total.to = std::max(total.to, depth);
    total.time += attempt.dt();
    total.work += step_work;
    if (resistance > total.peak_force) {
      total.peak_force = resistance;
      total.peak_depth = depth;
    }
  }
  // The tissue that gave way had been pushed by a tip still before it: the force was that tissue's.
  for (const session::SessionEvent& each : attempt.session().events) {
    const forces::Event& event = each.event;
    if (event.kind != forces::EventKind::puncture || event.felt == 0.0) continue;
    const std::size_t index = attempt.index_of(each);
    if (index >= peak_index && index <= peak_index + 2) peak_tissue = event.tissue;
    const auto place = totals.find(event.tissue);
    if (place == totals.end() || event.felt <= place->second.peak_force) continue;
    place->second.peak_force = event.felt;
    place->second.peak_depth = event.depth;
  }
  for (const auto& [id, total] : totals) tissues.push_back(total);
  std::stable_sort(tissues.begin(), tissues.end(),
                   [](const TissueTotal& a, const TissueTotal& b) { return a.from < b.from; });
  for (const Insertion& insertion : attempt.insertions) redirections += redirections_in(attempt, insertion);
}

const Puncture* Measured::loss() const {
  for (const forces::EventKind kind : {forces::EventKind::loss_of_resistance, forces::EventKind::pressure_lost}) {
    for (const Puncture& puncture : punctures)
      if (puncture.kind == kind) return &puncture;
  }
  return nullptr;
}

}  // namespace bodkin::training
