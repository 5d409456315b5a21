#include "fem/contact_nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace bodkin::fem {

namespace {

constexpr double contact_point_reach = 5.0;   // mm, between the line of contact points and the needle's
constexpr double contact_point_before = 1.5;  // mm, before the entry

}  // namespace

ContactNodes::ContactNodes(const anatomy::CondensedBody& body, double radius, double spacing)
    : body_(body), radius_(radius), spacing_(spacing), candidates_(body.nodes.size()), nodes_(body.nodes.size()) {}

// Sorts the nodes near the line by cell, the closest of each cell first.
void ContactNodes::find_candidates(const Vec3& entry, const Vec3& direction) noexcept {
  entry_ = entry;
  direction_ = direction;
  std::size_t found = 0;
  for (std::size_t node = 0; node < body_.nodes.size(); ++node) {
    const Vec3 from_entry = body_.nodes[node] - entry;
    const double depth = from_entry.dot(direction);
    const double distance = (from_entry - depth * direction).squaredNorm();
    const double place = std::max(depth, 0.0);
    if (body_.has_contact_points()) {
      if (!(distance <= contact_point_reach * contact_point_reach) || !(depth > -contact_point_before)) continue;
      candidates_[found++] = {static_cast<std::uint32_t>(node), static_cast<std::int64_t>(node), distance, place};
      continue;
    }
    if (!(distance <= radius_ * radius_) || !(depth > -radius_)) continue;
    candidates_[found++] = {static_cast<std::uint32_t>(node), std::llround(std::floor(place / spacing_)), distance,
                            place};
  }
  const auto end = candidates_.begin() + static_cast<std::ptrdiff_t>(found);
  std::sort(candidates_.begin(), end, [](const Candidate& a, const Candidate& b) {
    return std::tie(a.cell, a.distance, a.node) < std::tie(b.cell, b.distance, b.node);
  });
  found_ = found;
}

void ContactNodes::append(std::size_t found, const ContactTissues& tissues) noexcept {
  for (std::size_t i = 0; i < found; ++i) {
    const Candidate& here = candidates_[i];
    if (i > 0 && here.cell == candidates_[i - 1].cell) continue;
    const anatomy::TissueId at = body_.tissues[here.node];
    const double before = count_ == 0 ? 0.0 : tissues[nodes_[count_ - 1].tissue].puncture_force;
    if (count_ > 0) nodes_[count_ - 1].length = here.depth - nodes_[count_ - 1].depth;
    if (!add({.index = here.node,
              .tissue = at,
              .depth = count_ == 0 ? 0.0 : here.depth,
              .length = std::numeric_limits<double>::infinity(),
              .resists = tissues[at].puncture_force > before}))
      return;
  }
}

void ContactNodes::begin(const Vec3& entry, const Vec3& direction, const ContactTissues& tissues) noexcept {
  find_candidates(entry, direction);
  count_ = 0;
  append(found_, tissues);
}

void ContactNodes::begin_growing(const Vec3& entry, const Vec3& direction) noexcept {
  entry_ = entry;
  direction_ = direction;
  count_ = found_ = grown_ = 0;
}

bool ContactNodes::grow(std::size_t known, const ContactTissues& tissues) noexcept {
  const std::size_t end = std::min(known, body_.nodes.size());
  std::size_t found = 0;
  for (; grown_ < end; ++grown_) {
    const double depth = std::max(0.0, (body_.nodes[grown_] - entry_).dot(direction_));
    candidates_[found++] = {static_cast<std::uint32_t>(grown_), static_cast<std::int64_t>(grown_), 0.0, depth};
  }
  append(found, tissues);
  return found > 0;
}

bool ContactNodes::add(const ContactNode& node) noexcept {
  if (count_ == nodes_.size()) return false;
  nodes_[count_++] = node;
  return true;
}

void ContactNodes::continue_from(std::size_t kept, double depth, const ContactTissues& tissues) noexcept {
  count_ = std::min(kept, count_);
  ContactNode& last = nodes_[count_ - 1];
  last.length = std::numeric_limits<double>::infinity();
  const double deepest = std::max(depth, last.depth);
  const double place = (body_.nodes[last.index] - entry_).dot(direction_);
  const auto begun = std::llround(std::floor(std::max(place, 0.0) / spacing_));  // this cell has its node
  const auto is_kept = [&](std::uint32_t node) {
    const auto end = nodes_.begin() + static_cast<std::ptrdiff_t>(count_);
    return std::any_of(nodes_.begin(), end, [node](const ContactNode& here) { return here.index == node; });
  };
  std::size_t left = 0;
  for (std::size_t i = 0; i < found_; ++i) {
    const Candidate here = candidates_[i];
    if (here.depth > deepest && here.cell > begun && !is_kept(here.node)) candidates_[left++] = here;
  }
  found_ = left;
  append(left, tissues);
}

}  // namespace bodkin::fem
