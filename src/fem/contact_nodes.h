#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "anatomy/condensed_body.h"
#include "fem/contact_tissues.h"

namespace bodkin::fem {

// A contact point on the path of a needle.
struct ContactNode {
  std::uint32_t index = 0;  // index in the body
  anatomy::TissueId tissue = anatomy::tissue::air;
  double depth = 0.0;    // mm along the line, at rest; 0 for the first point, which represents the surface
  double length = 0.0;   // mm of the line that it represents, from its depth on; infinite for the last point
  bool resists = false;  // first point of a tissue whose puncture force is higher than that of the tissue before
};

// The contact points that a needle meets along a frozen line. They were computed for a line, in the order of their
// depth: each is met at its depth along the needle's own line, if that runs within 5 mm of it.
class ContactNodes {
 public:
  // Allocates memory for all points of the body.
  explicit ContactNodes(const anatomy::CondensedBody& body);

  // Finds the points along a line; the cost is linear in their number. Never throws or allocates.
  void begin(const Vec3& entry, const Vec3& direction, const ContactTissues& tissues) noexcept;
  // As begin(), for the contact points of exactly this line, which grow() appends as they become known; none at
  // first.
  void begin_growing(const Vec3& entry, const Vec3& direction) noexcept;
  // The first `known` points of the body are complete. Returns whether some of them are new.
  bool grow(std::size_t known, const ContactTissues& tissues) noexcept;
  // Removes the points after the first `count` of a line that grow() appended to.
  void keep_first(std::size_t count) noexcept;
  void clear() noexcept { count_ = 0; }

  std::span<const ContactNode> along() const noexcept { return {nodes_.data(), count_}; }

 private:
  void append(std::uint32_t point, double depth, const ContactTissues& tissues) noexcept;

  const anatomy::CondensedBody& body_;
  std::vector<ContactNode> nodes_;  // size: points of the body
  std::size_t count_ = 0;
  std::size_t grown_ = 0;  // points that grow() has appended
  Vec3 entry_ = Vec3::Zero(), direction_ = Vec3::UnitZ();
};

}  // namespace bodkin::fem
