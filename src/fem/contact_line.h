#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "anatomy/condensed_body.h"
#include "core/latest_value.h"

namespace bodkin::fem {

// A contact point as it is computed, one after another from the entry on.
struct ContactPoint {
  Vec3 place = Vec3::Zero();  // mm, LPS, at rest
  anatomy::TissueId tissue = anatomy::tissue::air;
  anatomy::PlaceInElement in_mesh;
  std::span<const Mat3> between;  // mm/N: each point before it and, last, itself by forces on this one
};

// The contact points of a needle's line, which one thread computes (ContactStream) while the tick's thread uses those
// that are there already. The needle enters anywhere: the tick asks for the points of the line on which it touches
// the body, and neither waits nor allocates. One line at a time; asking for another one abandons it.
class ContactLine {
 public:
  static constexpr std::size_t most_points = 160;

  // `spring`: mm/N, compliance of a spring on which the whole body stands, added between every two points.
  // `most_held`: how many nodes of the body's mesh something may hold (ask()).
  explicit ContactLine(double spring = 0.0, std::size_t most_held = 0);

  // The tick's thread.

  // From now on the points are those of a line that touches the body at `entry` and goes along the unit vector
  // `direction`; there are none yet. Their compliance is that of a body of which these nodes are held.
  void ask(const Vec3& entry, const Vec3& direction, std::span<const std::uint32_t> held = {}) noexcept;
  struct Progress {
    std::size_t points = 0;
    bool complete = false;  // no more will come
  };
  Progress progress() const noexcept;
  // The first progress().points are there, and stay as they are until the next ask(). Room for most_points.
  const anatomy::CondensedBody& body() const noexcept { return body_; }
  // For programs without a clock: waits until there are `points` of them, or the line is complete.
  Progress wait_for(std::size_t points) const noexcept;

  // The thread that computes points.

  struct Line {
    std::uint32_t number = 0;
    Vec3 entry = Vec3::Zero(), direction = Vec3::UnitZ();
    std::vector<std::uint32_t> held = {};  // the first `held_count` are nodes that are held
    std::size_t held_count = 0;
  };
  // Waits until another line is asked for; nothing after close().
  std::optional<Line> next_line() noexcept;
  // False when the line has been abandoned or there is no room for more.
  bool append(const Line& line, const ContactPoint& point) noexcept;
  void complete(const Line& line) noexcept;

  // Any thread: lets next_line() and wait_for() return.
  void close() noexcept;

 private:
  static constexpr std::uint64_t closed = ~std::uint64_t{0};

  double spring_;
  anatomy::CondensedBody body_;
  Line newest_;  // of the tick's thread
  LatestValue<Line> wanted_;
  std::atomic<std::uint64_t> asked_{0};     // number of the line asked for, or `closed`
  std::atomic<std::uint64_t> progress_{0};  // number of the line, 32 bits; complete, 1 bit; points, 31 bits
  std::uint64_t served_ = 0;                // of the thread that computes points
};

}  // namespace bodkin::fem
