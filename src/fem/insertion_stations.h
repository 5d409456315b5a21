#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "anatomy/condensed_body.h"
#include "fem/contact_tissues.h"

namespace bodkin {

// A node of the corridor on the way of a needle.
struct InsertionStation {
  std::uint32_t node = 0;  // of the corridor
  TissueId tissue = tissue::air;
  double depth = 0.0;    // mm along the line at rest; 0 for the first, which stands for the surface
  double length = 0.0;   // mm of line that it stands for, from its depth on; infinite for the last
  bool resists = false;  // it is the first of a tissue that takes more force to puncture than the one before
};

// The nodes that a needle will meet along a frozen line, in the order in which it meets them: of every `spacing` mm
// the one closest to the line, if any is within `radius`.
class InsertionStations {
 public:
  // `radius`, `spacing`: mm, > 0. Takes memory for the whole corridor.
  InsertionStations(const CondensedBody& body, double radius, double spacing);

  // Goes through the whole corridor. Never throws or allocates.
  void begin(const Vec3& entry, const Vec3& direction, const ContactTissues& tissues) noexcept;
  void clear() noexcept { count_ = 0; }
  // One more, behind the others; false when there is no room.
  bool add(const InsertionStation& station) noexcept;
  // Looks for what lies along a line, which go_on() will use; changes no station.
  void look_along(const Vec3& entry, const Vec3& direction) noexcept;
  // Keeps the first `kept` (1 at least) and takes what lies behind them and deeper than `depth` along that line.
  void go_on(std::size_t kept, double depth, const ContactTissues& tissues) noexcept;

  std::span<const InsertionStation> along() const noexcept { return {stations_.data(), count_}; }

 private:
  void append(std::size_t found, const ContactTissues& tissues) noexcept;

  struct Candidate {
    std::uint32_t node;
    std::int64_t cell;  // of the line, `spacing` long
    double distance;    // squared, mm^2, from the line
    double depth;       // mm
  };

  const CondensedBody& body_;
  double radius_, spacing_;
  std::vector<Candidate> candidates_;       // as many as the corridor has nodes
  std::vector<InsertionStation> stations_;  // likewise
  std::size_t count_ = 0, found_ = 0;
  Vec3 entry_ = Vec3::Zero(), direction_ = Vec3::UnitZ();  // of the line that was looked along last
};

}  // namespace bodkin
