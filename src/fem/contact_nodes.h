#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "anatomy/condensed_body.h"
#include "fem/contact_tissues.h"

namespace bodkin::fem {

// A node of the corridor on the path of a needle.
struct ContactNode {
  std::uint32_t index = 0;  // in the corridor
  anatomy::TissueId tissue = anatomy::tissue::air;
  double depth = 0.0;    // mm along the line, at rest; 0 for the first node, which represents the surface
  double length = 0.0;   // mm of the line that it represents, from its depth on; infinite for the last node
  bool resists = false;  // first node of a tissue whose puncture force is higher than that of the tissue before
};

// The nodes that a needle passes along a frozen line, in the order of their depth: from each `spacing` mm the one
// closest to the line, if there is one within `radius`. Contact points (CondensedBody::has_contact_points) were made
// for a line: each of them is met, at its depth along the needle's own, if that runs within 5 mm of it.
class ContactNodes {
 public:
  // `radius`, `spacing`: mm, > 0. Allocates memory for all nodes of the corridor.
  ContactNodes(const anatomy::CondensedBody& body, double radius, double spacing);

  // Finds the nodes along a line; the cost is linear in the nodes of the corridor. Never throws or allocates.
  void begin(const Vec3& entry, const Vec3& direction, const ContactTissues& tissues) noexcept;
  // The same for the contact points of exactly this line, which grow() appends as they become known; none at first.
  void begin_growing(const Vec3& entry, const Vec3& direction) noexcept;
  // The first `known` points of the body are there now. True when some of them are new.
  bool grow(std::size_t known, const ContactTissues& tissues) noexcept;
  void clear() noexcept { count_ = 0; }
  // Adds a node after the others; false at full capacity.
  bool add(const ContactNode& node) noexcept;
  // Finds the candidates along a line for continue_from(); does not change along().
  void find_candidates(const Vec3& entry, const Vec3& direction) noexcept;
  // Keeps the first `kept` nodes (at least 1) and appends the candidates after them that are deeper than `depth`.
  void continue_from(std::size_t kept, double depth, const ContactTissues& tissues) noexcept;

  std::span<const ContactNode> along() const noexcept { return {nodes_.data(), count_}; }

 private:
  void append(std::size_t found, const ContactTissues& tissues) noexcept;

  struct Candidate {
    std::uint32_t node;
    std::int64_t cell;  // of the line, `spacing` long
    double distance;    // squared, mm^2, from the line
    double depth;       // mm
  };

  const anatomy::CondensedBody& body_;
  double radius_, spacing_;
  std::vector<Candidate> candidates_;  // size: nodes of the corridor
  std::vector<ContactNode> nodes_;     // size: nodes of the corridor
  std::size_t count_ = 0, found_ = 0;
  std::size_t grown_ = 0;                                  // points that grow() has appended
  Vec3 entry_ = Vec3::Zero(), direction_ = Vec3::UnitZ();  // of the last find_candidates()
};

}  // namespace bodkin::fem
