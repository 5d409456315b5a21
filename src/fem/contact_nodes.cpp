#include "fem/contact_nodes.h"

#include <algorithm>
#include <limits>

namespace bodkin::fem {

namespace {

constexpr double contact_point_reach = 5.0;   // mm, between the line of contact points and the needle's
constexpr double contact_point_before = 1.5;  // mm, before the entry
constexpr double least_step = 1e-3;           // mm between the points of a line that has turned aside

}  // namespace

ContactNodes::ContactNodes(const anatomy::CondensedBody& body) : body_(body), nodes_(body.nodes.size()) {}

void ContactNodes::append(std::uint32_t point, double depth, const ContactTissues& tissues) noexcept {
  if (count_ == nodes_.size()) return;
  const anatomy::TissueId at = body_.tissues[point];
  const double before = count_ == 0 ? 0.0 : tissues[nodes_[count_ - 1].tissue].puncture_force;
  if (count_ > 0) nodes_[count_ - 1].length = depth - nodes_[count_ - 1].depth;
  nodes_[count_] = {.index = point,
                    .tissue = at,
                    .depth = count_ == 0 ? 0.0 : depth,
                    .length = std::numeric_limits<double>::infinity(),
                    .resists = tissues[at].puncture_force > before};
  ++count_;
}

void ContactNodes::begin(const Vec3& entry, const Vec3& direction, const ContactTissues& tissues) noexcept {
  begin_growing(entry, direction);
  for (std::uint32_t point = 0; point < body_.nodes.size(); ++point) {
    const Vec3 from_entry = body_.nodes[point] - entry;
    const double depth = from_entry.dot(direction);
    const double distance = (from_entry - depth * direction).squaredNorm();
    if (distance <= contact_point_reach * contact_point_reach && depth > -contact_point_before)
      append(point, std::max(depth, 0.0), tissues);
  }
}

void ContactNodes::begin_growing(const Vec3& entry, const Vec3& direction) noexcept {
  entry_ = entry;
  direction_ = direction;
  count_ = grown_ = 0;
}

bool ContactNodes::grow(std::size_t known, const ContactTissues& tissues) noexcept {
  const std::size_t end = std::min(known, body_.nodes.size()), before = grown_;
  for (; grown_ < end; ++grown_) {
    const double depth = std::max(0.0, (body_.nodes[grown_] - entry_).dot(direction_));
    const double last = count_ == 0 ? 0.0 : nodes_[count_ - 1].depth;
    append(static_cast<std::uint32_t>(grown_), depth < last ? last + least_step : depth, tissues);
  }
  return grown_ > before;
}

void ContactNodes::keep_first(std::size_t count) noexcept {
  if (count >= count_) return;
  count_ = grown_ = count;
  if (count_ > 0) nodes_[count_ - 1].length = std::numeric_limits<double>::infinity();
}

}  // namespace bodkin::fem
