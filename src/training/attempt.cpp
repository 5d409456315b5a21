#include "training/attempt.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "session/material_tip.h"
#include <fmt/format.h>

#include "core/error.h"
#include "core/geometry.h"
#include "io/case_xml.h"
#include "io/xml_document.h"

namespace bodkin::training {

namespace {

constexpr double rest_half = 0.2;   // s; the speed of a rest is between the means of two such stretches of time
constexpr double usual_tick = 1.5;  // ticks apart; more means that some were lost

}  // namespace

Attempt::Attempt(const session::Session& session, const anatomy::CaseDescription& description,
                 const Thresholds& thresholds)
    : session_(session), description_(description), thresholds_(thresholds) {
  if (session.ticks.empty()) throw InputError("the session holds no tick, so that there is nothing to judge");
  const std::size_t count = session.ticks.size();
  time.reserve(count), hand.reserve(count), tip.reserve(count), axis.reserve(count), depth.reserve(count),
      resistance.reserve(count);
  force.reserve(count), tissue.reserve(count), inside.reserve(count);
  const std::uint64_t first = session.ticks.front().tick;
  session::MaterialTip material(description.breathing, dt());
  for (const simulation::TickRecord& record : session.ticks) {
    const simulation::TickOutput& output = record.output;
    time.push_back(static_cast<double>(record.tick - first) * dt());
    hand.push_back(record.input.needle.translation());
    tip.push_back(material.place_of(record));
    if (description.breathing) drawn_in_.push_back(material.drawn_in());
    axis.push_back(needle_axis(record.input.needle));
    depth.push_back(output.depth);
    resistance.push_back(output.resistance);
    force.push_back(output.applied.force);
    tissue.push_back(output.tissue);
    inside.push_back(output.in_contact ? 1 : 0);
    const std::size_t last = time.size() - 1;
    if (last > 0 && inside[last] + inside[last - 1] > 0 && time[last] - time[last - 1] > usual_tick * dt())
      missing += time[last] - time[last - 1] - dt();
  }
  find_insertions();
  if (insertions.empty()) return;
  find_rests();
  find_final_tip();
}

void Attempt::find_insertions() {
  double distance_outside = 0.0;  // mm outside since the last contact
  for (std::size_t i = 0; i < size(); ++i) {
    if (inside[i] == 0) {
      if (!insertions.empty())
        distance_outside = std::max(distance_outside, (tip[i] - tip[insertions.back().last]).norm());
      continue;
    }
    const bool is_new = insertions.empty() || (insertions.back().last + 1 < i &&
                                               (distance_outside > thresholds_.outside_distance ||
                                                time[i] - time[insertions.back().last] > thresholds_.outside_time));
    if (is_new) insertions.push_back({i, i, 0.0});
    insertions.back().last = i;
    insertions.back().deepest = std::max(insertions.back().deepest, depth[i]);
    distance_outside = 0.0;
  }
}

void Attempt::find_rests() {
  const Insertion& insertion = insertions.back();
  const auto half = static_cast<std::size_t>(std::max(1.0, std::round(rest_half / dt())));
  const std::size_t count = insertion.last - insertion.first + 1;
  std::vector<Vec3> sums = {Vec3::Zero()};  // positions before each tick of the insertion
  std::vector<std::size_t> outside = {0};   // ticks out of contact before each
  for (std::size_t i = insertion.first; i <= insertion.last; ++i) {
    sums.push_back(sums.back() + hand[i]);
    outside.push_back(outside.back() + (inside[i] == 0 ? 1 : 0));
  }
  const auto close = [&](std::size_t from, std::size_t to) {  // middles of windows
    if (static_cast<double>(to - from) * dt() < thresholds_.rest_time - 2.0 * rest_half - 0.5 * dt()) return;
    Rest rest{.first = insertion.first + from, .last = insertion.first + to, .tip = Vec3::Zero(), .depth = 0.0};
    for (std::size_t i = rest.first; i <= rest.last; ++i) {
      rest.tip += tip[i] / static_cast<double>(to - from + 1);
      rest.depth += depth[i] / static_cast<double>(to - from + 1);
    }
    rests.push_back(rest);
  };
  std::optional<std::size_t> since;
  for (std::size_t middle = half; middle + half <= count; ++middle) {
    const Vec3 before = (sums[middle] - sums[middle - half]) / static_cast<double>(half);
    const Vec3 after = (sums[middle + half] - sums[middle]) / static_cast<double>(half);
    const bool resting = outside[middle + half] == outside[middle - half] &&
                         (after - before).norm() < thresholds_.rest_speed * static_cast<double>(half) * dt();
    if (resting && !since) since = middle;
    if (!resting && since) {
      close(*since, middle - 1);
      since.reset();
    }
  }
  if (since) close(*since, count - half);
}

void Attempt::find_final_tip() {
  FinalPosition found;
  if (!rests.empty()) {
    const auto deeper = [](const Rest& a, const Rest& b) { return a.depth < b.depth; };
    const double deepest = std::max_element(rests.begin(), rests.end(), deeper)->depth;
    const auto last = std::find_if(rests.rbegin(), rests.rend(),
                                   [&](const Rest& rest) { return rest.depth >= deepest - thresholds_.same_rest; });
    found = {true, last->last, last->tip, last->depth, tissue_of(*last)};
  } else {
    const Insertion& insertion = insertions.back();
    std::size_t deepest = insertion.first;
    for (std::size_t i = insertion.first; i <= insertion.last; ++i)
      if (inside[i] != 0 && depth[i] > depth[deepest]) deepest = i;
    found = {false, deepest, tip[deepest], depth[deepest], tissue[deepest]};
  }
  final_tip = found;
}

anatomy::TissueId Attempt::tissue_of(const Rest& rest) const {
  std::array<std::size_t, 256> ticks{};
  for (std::size_t i = rest.first; i <= rest.last; ++i) ++ticks[tissue[i]];
  return static_cast<anatomy::TissueId>(std::max_element(ticks.begin(), ticks.end()) - ticks.begin());
}

Vec3 Attempt::now(const Vec3& material, std::size_t index) const {
  if (!description_.breathing) return material;
  return material + anatomy::BreathField(*description_.breathing).moved(material, drawn_in_[index]);
}

std::size_t Attempt::index_of(const session::SessionEvent& event) const {
  const auto& ticks = session_.ticks;
  const auto found =
      std::lower_bound(ticks.begin(), ticks.end(), event.tick,
                       [](const simulation::TickRecord& record, std::uint64_t tick) { return record.tick < tick; });
  return found == ticks.end() ? size() - 1 : static_cast<std::size_t>(found - ticks.begin());
}

std::optional<anatomy::TissueId> Attempt::find_tissue(const std::string& name) const {
  for (const session::TissueName& each : session_.header.tissues)
    if (each.name == name) return each.id;
  return std::nullopt;
}

std::string Attempt::title_of(anatomy::TissueId id) const {
  for (const session::TissueName& each : session_.header.tissues)
    if (each.id == id) return each.title;
  return fmt::format("tissue {}", id);
}

anatomy::CaseDescription description_of(const session::Session& session) {
  std::vector<anatomy::TissueProperties> tissues;
  for (const session::TissueName& each : session.header.tissues) {
    tissues.emplace_back();
    tissues.back().id = each.id;
    tissues.back().name = each.name;
    tissues.back().title = each.title;
  }
  anatomy::TissueLibrary library(std::move(tissues));
  static const io::XmlSchema schema("case.xsd");
  return io::parse_case_xml(session.header.case_xml, "the case.xml that the session keeps", schema,
                            [&](const std::string&) { return library; });
}

}  // namespace bodkin::training
