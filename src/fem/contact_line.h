#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "anatomy/condensed_body.h"
#include "core/geometry.h"
#include "core/latest_value.h"
#include "fem/node_forces.h"

namespace bodkin::fem {

// What a force on a point of a body does to whatever holds nodes of it, a probe: how the force on that, and its
// torque about the middle of these nodes at rest (mm), follow from it.
struct HeldShare {
  Mat3 force = Mat3::Zero(), torque = Mat3::Zero();
};

// A contact point as it is computed, one after another from the entry on.
struct ContactPoint {
  Vec3 place = Vec3::Zero();  // mm, LPS, at rest
  anatomy::TissueId tissue = anatomy::tissue::air;
  anatomy::PlaceInElement in_mesh;
  std::span<const Mat3> between;  // mm/N: each point before it and, last, itself by forces on this one
  HeldShare on_held;              // of a force on it
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
  // The same of the planned line, whose points are known.
  void ask_planned(const Vec3& entry, const Vec3& direction) noexcept;
  // The needle has turned: the first `kept` points, one at least, stay as they are, and those ahead are from now on
  // those of a line from `place`, at rest, along the unit vector `direction`.
  void lead_on(const Vec3& place, const Vec3& direction, std::size_t kept) noexcept;
  // A line that is complete, with a needle in it: what holds nodes of the mesh holds these now. The compliance of the
  // first `points` points with these held is computed besides; is_coupled() says when it is there, in other(). No
  // line is led on until take_coupled(); ask() abandons it.
  void couple(std::span<const std::uint32_t> held, std::size_t points) noexcept;
  bool is_coupled() const noexcept;
  // mm/N. Where no nodes are held, of zero size.
  const Eigen::MatrixXd& other() const noexcept { return other_; }
  // The points have that compliance from now on, and so have those that are added.
  void take_coupled() noexcept;
  struct Progress {
    std::size_t points = 0;
    bool complete = false;  // no more will come
  };
  Progress progress() const noexcept;
  // The first progress().points are there, and stay as they are until the next ask(). Room for most_points. Its
  // compliance and other() take turns: take_coupled() makes the points those of the one that they were not of.
  const anatomy::CondensedBody& body() const noexcept { return body_; }
  // By forces on the points (NodeForces by point) on what holds the nodes of ask(): N, and N mm about the middle of
  // these nodes at rest. Of points that are there.
  Wrench on_held(const NodeForces& forces) const noexcept;
  // For programs without a clock: waits until there are `points` of them, or the line is complete.
  Progress wait_for(std::size_t points) const noexcept;
  // The same until is_coupled(); false where that will not be.
  bool wait_until_coupled() const noexcept;

  // The thread that computes points.

  struct Line {
    std::uint32_t number = 0;
    Vec3 entry = Vec3::Zero(), direction = Vec3::UnitZ();
    std::size_t kept = 0;  // points of the line before, after which it goes on at `entry`; 0: it is a new one
    bool is_planned = false;
    bool is_coupling = false;              // its first `kept` points anew, with other nodes held
    std::uint32_t turn = 0;                // where their compliance goes: 0 body(), 1 other()
    std::vector<std::uint32_t> held = {};  // the first `held_count` are nodes that are held
    std::size_t held_count = 0;
  };
  // Waits until another line is asked for; nothing after close().
  std::optional<Line> next_line() noexcept;
  // False when the line has been abandoned or there is no room for more.
  bool append(const Line& line, const ContactPoint& point) noexcept;
  void complete(const Line& line) noexcept;
  // Of a line that is coupling: point number `at` of it. False when it has been abandoned.
  bool put(const Line& line, std::size_t at, const ContactPoint& point) noexcept;
  // All of them are there, or will not be.
  void end_coupling(const Line& line, bool done) noexcept;

  // Any thread: lets next_line() and wait_for() return.
  void close() noexcept;

 private:
  static constexpr std::uint64_t closed = ~std::uint64_t{0};

  void ask_newest() noexcept;
  void write(const Line& line, std::size_t at, const ContactPoint& point) noexcept;

  double spring_;
  anatomy::CondensedBody body_;
  Eigen::MatrixXd other_;
  std::array<std::vector<HeldShare>, 2> on_held_;  // by turn and point
  Line newest_;                                    // of the tick's thread, and so is the next
  std::uint32_t turn_ = 0;                         // of the points that there are
  LatestValue<Line> wanted_;
  std::atomic<std::uint64_t> asked_{0};     // number of the line asked for, or `closed`
  std::atomic<std::uint64_t> progress_{0};  // number of the line, 32 bits; complete, 1 bit; points, 31 bits
  std::atomic<std::uint64_t> coupled_{0};   // twice the number of the last line that was coupling; 1 more: not done
  std::uint64_t served_ = 0;                // of the thread that computes points
};

}  // namespace bodkin::fem
