#include "app/models/plan_work.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace bodkin::app {

namespace {

constexpr double publish_after = 0.15;  // s between two states of the map
constexpr double other_skin = 6.0;      // mm: a way that leaves the body further off leaves it elsewhere
constexpr double shared_end = 10.0;     // mm before the target that count as the same for every way in
constexpr double midline = 5.0;         // degrees

// "L3_L4" as people write it.
std::string written(std::string level) {
  std::replace(level.begin(), level.end(), '_', '/');
  return level;
}

// The needle's direction in words: "from behind on the left".
std::string way_of(const patient::PathReport& report, const std::string& level) {
  const Vec3 from = -report.path.direction();
  if (!level.empty()) {
    if (std::abs(report.lateral) < midline) return fmt::format("{}, in the midline", written(level));
    return fmt::format("{}, {} of the midline", written(level), from.x() > 0.0 ? "left" : "right");
  }
  const double aside = std::abs(from.x()), along = std::abs(from.y()), up = std::abs(from.z());
  if (up > aside && up > along) return from.z() > 0.0 ? "from above" : "from below";
  std::string first = from.y() > 0.0 ? "from behind" : "from the front";
  const std::string side = from.x() > 0.0 ? "left" : "right";
  if (aside < 0.27 * along) return first;
  if (along < 0.27 * aside) return fmt::format("from the {}", side);
  return fmt::format("{} on the {}", first, side);
}

ProposedPath proposed(patient::PathReport report, const patient::Obstacles& obstacles, const std::string& level) {
  ProposedPath path;
  path.way = way_of(report, level);
  const auto least = std::min_element(report.near.begin(), report.near.end(),
                                      [](const auto& a, const auto& b) { return a.distance < b.distance; });
  if (least != report.near.end()) path.nearest = obstacles.kinds[least->kind].title;
  path.report = std::move(report);
  return path;
}

}  // namespace

EntrySuitability entry_suitability(const patient::PatientView& patient, const patient::Obstacles& obstacles,
                                   const Vec3& skin, const Vec3& target, const patient::PathCriteria& criteria) {
  using Kind = EntrySuitability::Kind;
  const Vec3 way = skin - target;
  const double length = way.norm();
  if (length < 1.0 || length > criteria.longest) return {Kind::out_of_reach, 0.0F};
  const Vec3 outwards = way / length;
  const std::optional<Vec3> entry =
      patient::find_skin_exit(patient.tissues, target, outwards, std::min(criteria.longest, length + other_skin));
  if (!entry || (*entry - skin).norm() > other_skin) return {Kind::out_of_reach, 0.0F};
  const std::optional<Vec3> normal = patient::skin_normal(patient.tissues, *entry);
  if (!normal || normal->dot(outwards) < std::cos(criteria.flattest * degree)) return {Kind::out_of_reach, 0.0F};
  const double most = map_top;
  const patient::Room whole = patient::clearance_along(obstacles, {*entry, target}, most);
  if (whole.blocked || whole.spare < 0.0) return {Kind::blocked, 0.0F};
  // All paths share their end: structures near the target would hide the differences between entries.
  const Vec3 before_end = target + std::min(shared_end, 0.5 * length) * outwards;
  return {Kind::open, static_cast<float>(patient::clearance_along(obstacles, {*entry, before_end}, most).clearance)};
}

std::uint32_t tint_of(const EntrySuitability& room) {
  constexpr std::uint32_t strong = 0xD8000000U, faint = 0x90000000U, grey = 0x8A8F96U;
  switch (room.kind) {
    case EntrySuitability::Kind::unknown:
      return faint | grey;
    case EntrySuitability::Kind::out_of_reach:
      return 0;
    case EntrySuitability::Kind::blocked:
      return strong | clearance_colour(0.0F);
    case EntrySuitability::Kind::open:
      return strong | clearance_colour(room.clearance);
  }
  return 0;
}

PlanWork::PlanWork(Request request)
    : request_(std::move(request)),
      criteria_(patient::criteria_for(request_.patient->description().needle, request_.rules)),
      mapping_([this](const std::stop_token& stop) {
        try {
          const auto obstacles = std::make_shared<const patient::Obstacles>(
              patient::find_obstacles(patient::view_of(request_.patient->patient), request_.rules, request_.target));
          {
            const std::scoped_lock lock(mutex_);
            result_.obstacles = obstacles;
            ++result_.version;
            searching_ = std::jthread(
                [this, obstacles](const std::stop_token& stopped) { make_proposals(stopped, obstacles); });
          }
          make_map(stop, *obstacles);
        } catch (const std::exception& error) {
          const std::scoped_lock lock(mutex_);
          result_.failure = error.what();
          result_.map_done = result_.proposals_done = true;
          ++result_.version;
        }
      }) {}

PlanWork::~PlanWork() {
  mapping_.request_stop();
  mapping_.join();  // from here on nobody starts the other one
  searching_.request_stop();
}

bool PlanWork::poll(int version, Result& result) const {
  const std::scoped_lock lock(mutex_);
  if (result_.version == version) return false;
  result = result_;
  return true;
}

void PlanWork::make_map(const std::stop_token& stop, const patient::Obstacles& obstacles) {
  using Clock = std::chrono::steady_clock;
  const std::size_t count = request_.skin ? request_.skin->size() : 0;
  const patient::PatientView view = patient::view_of(request_.patient->patient);
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto point = [&](std::size_t i) { return Vec3((*request_.skin)[i].cast<double>()); };
  std::vector<double> away(count);
  for (std::size_t i = 0; i < count; ++i) away[i] = (point(i) - request_.around).squaredNorm();
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return away[a] < away[b]; });
  // Points that the needle cannot reach need no computation.
  std::vector<EntrySuitability> map(count);
  for (std::size_t i = 0; i < count; ++i)
    if ((point(i) - request_.target).norm() > criteria_.longest) map[i].kind = EntrySuitability::Kind::out_of_reach;
  const auto publish = [&](bool done) {
    const std::scoped_lock lock(mutex_);
    result_.map = map;
    result_.map_done = done;
    ++result_.version;
  };
  auto published = Clock::now();
  for (const std::size_t i : order) {
    if (stop.stop_requested()) return;
    if (map[i].kind != EntrySuitability::Kind::unknown) continue;
    map[i] = entry_suitability(view, obstacles, point(i), request_.target, criteria_);
    if (std::chrono::duration<double>(Clock::now() - published).count() < publish_after) continue;
    publish(false);
    published = Clock::now();
  }
  publish(true);
}

void PlanWork::make_proposals(const std::stop_token& stop,
                              const std::shared_ptr<const patient::Obstacles>& obstacles) {
  std::vector<ProposedPath> found;
  std::string why_none, failure;
  const auto publish = [&](bool done) {
    const std::scoped_lock lock(mutex_);
    result_.proposals = found;
    result_.why_none = why_none;
    result_.failure = failure;
    result_.proposals_done = done;
    ++result_.version;
  };
  try {
    const patient::PatientView view = patient::view_of(request_.patient->patient);
    const std::string level = request_.rules.levels.empty() ? "" : patient::level_at(view, request_.target);
    if (const auto problem = patient::level_problem(view, request_.rules, request_.target)) {
      why_none = fmt::format("Nothing is proposed here: {}.", *problem);
    } else {
      patient::PathSearch search = patient::search_paths(view, *obstacles, request_.target, criteria_, stop);
      why_none = search.why_not;
      for (patient::PathReport& each : search.proposals)
        found.push_back(proposed(std::move(each), *obstacles, level));
      constexpr std::size_t at_this_level = 3;
      if (!level.empty() && found.size() > at_this_level) found.resize(at_this_level);
    }
    publish(false);
    // The best path at each other level.
    for (const anatomy::Landmark& other : patient::allowed_levels(view, request_.rules)) {
      if (other.name == level || stop.stop_requested()) continue;
      const patient::Obstacles there = patient::find_obstacles(view, request_.rules, other.position);
      patient::PathCriteria one = criteria_;
      one.count = 1;
      for (patient::PathReport& each : patient::search_paths(view, there, other.position, one, stop).proposals)
        found.push_back(proposed(std::move(each), there, other.name));
      publish(false);
    }
  } catch (const std::exception& error) {
    failure = error.what();
  }
  if (!found.empty()) why_none.clear();
  if (!stop.stop_requested()) publish(true);
}

}  // namespace bodkin::app
