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

// The effect of a force on a point of a body on the holder of some of its nodes, a probe: the force on the holder,
// and its torque about the middle of these nodes at rest (mm).
struct HeldFraction {
  Mat3 force = Mat3::Zero(), torque = Mat3::Zero();
};

// A contact point as computed, one after another from the entry.
struct ContactPoint {
  Vec3 place = Vec3::Zero();  // mm, LPS, at rest
  anatomy::TissueId tissue = anatomy::tissue::air;
  anatomy::PlaceInElement in_mesh;
  std::span<const Mat3> between;  // mm/N: each point before it and, last, itself by forces on this one
  HeldFraction on_held;           // of a force on this point
};

// The contact points of a needle's line, which one thread computes (ContactStream) while the tick's thread uses those
// that are complete. The needle enters anywhere: the tick requests the points of the line on which it touches the
// body, and neither waits nor allocates. One line at a time; requesting another one abandons it.
class ContactLine {
 public:
  static constexpr std::size_t most_points = 160;

  // `spring`: mm/N, compliance of a spring that supports the whole body, added between every two points. `most_held`:
  // the largest number of mesh nodes that something may hold (request()).
  explicit ContactLine(double spring = 0.0, std::size_t most_held = 0);

  // Functions of the tick's thread.

  // Requests the points of a line that touches the body at `entry` and runs along the unit vector `direction`; there
  // are none yet. Their compliance is that of a body in which the nodes `held` do not move.
  void request(const Vec3& entry, const Vec3& direction, std::span<const std::uint32_t> held = {}) noexcept;
  // As request(), for the planned line, whose points are known.
  void request_planned(const Vec3& entry, const Vec3& direction) noexcept;
  // The needle has turned: the first `kept` points, at least one, stay; the points ahead are from now on those of a
  // line from `place`, at rest, along the unit vector `direction`.
  void continue_from(const Vec3& place, const Vec3& direction, std::size_t kept) noexcept;
  // For a complete line with a needle in it: the nodes held by something have become `held`. The compliance of the
  // first `points` points with these nodes held is computed in addition; is_coupled() says when it is available, in
  // other(). No line is continued until apply_coupling(); request() abandons it.
  void couple(std::span<const std::uint32_t> held, std::size_t points) noexcept;
  bool is_coupled() const noexcept;
  // mm/N. Empty if no nodes are held.
  const Eigen::MatrixXd& other() const noexcept { return other_; }
  // From now on the points, and those added later, have that compliance.
  void apply_coupling() noexcept;
  struct Progress {
    std::size_t points = 0;
    bool complete = false;  // no more will follow
  };
  Progress progress() const noexcept;
  // The first progress().points are complete, and do not change until the next request(). Room for most_points. Its
  // compliance and other() alternate: apply_coupling() exchanges them.
  const anatomy::CondensedBody& body() const noexcept { return body_; }
  // The effect of forces on the points (NodeForces by point) on the holder of the nodes of request(): N, and N mm
  // about the middle of these nodes at rest. Only for complete points.
  Wrench on_held(const NodeForces& forces) const noexcept;
  // For programs without a clock: waits until `points` are complete, or the whole line is.
  Progress wait_for(std::size_t points) const noexcept;
  // As wait_for(), until is_coupled(); false if that will never happen.
  bool wait_until_coupled() const noexcept;

  // Functions of the thread that computes points.

  struct Line {
    std::uint32_t number = 0;
    Vec3 entry = Vec3::Zero(), direction = Vec3::UnitZ();
    std::size_t kept = 0;  // points of the previous line, after which this one continues at `entry`; 0: a new line
    bool is_planned = false;
    bool is_coupling = false;              // recomputes its first `kept` points with other nodes held
    std::uint32_t turn = 0;                // where their compliance is written: 0 body(), 1 other()
    std::vector<std::uint32_t> held = {};  // the first `held_count` are held nodes
    std::size_t held_count = 0;
  };
  // Waits until another line is requested; empty after close().
  std::optional<Line> next_line() noexcept;
  // False when the line has been abandoned or the capacity is reached.
  bool append(const Line& line, const ContactPoint& point) noexcept;
  void complete(const Line& line) noexcept;
  // For a coupling line: replaces its point number `at`. False when it has been abandoned.
  bool put(const Line& line, std::size_t at, const ContactPoint& point) noexcept;
  // All points are complete, or (`done` false) will never be.
  void end_coupling(const Line& line, bool done) noexcept;

  // Any thread: makes next_line() and wait_for() return.
  void close() noexcept;

 private:
  static constexpr std::uint64_t closed = ~std::uint64_t{0};

  void request_newest() noexcept;
  void write(const Line& line, std::size_t at, const ContactPoint& point) noexcept;

  double spring_;
  anatomy::CondensedBody body_;
  Eigen::MatrixXd other_;
  std::array<std::vector<HeldFraction>, 2> on_held_;  // by turn and point
  Line newest_;                                       // used by the tick's thread, as is turn_
  std::uint32_t turn_ = 0;                            // of the present points
  LatestValue<Line> wanted_;
  std::atomic<std::uint64_t> requested_{0};  // number of the requested line, or `closed`
  std::atomic<std::uint64_t> progress_{0};   // number of the line, 32 bits; complete, 1 bit; points, 31 bits
  std::atomic<std::uint64_t> coupled_{0};    // twice the number of the last coupling line; plus 1: failed
  std::uint64_t served_ = 0;                 // used by the thread that computes points
};

}  // namespace bodkin::fem
