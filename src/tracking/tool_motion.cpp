#include "tracking/tool_motion.h"

#include <algorithm>
#include <cmath>

namespace bodkin::tracking {

namespace {

constexpr double fastest = 900.0, fastest_turn = 30.0;   // mm/s and rad/s; below the 1000 at which the guard ends
constexpr double catch_up = 300.0, catch_up_turn = 5.0;  // mm/s and rad/s of a hand that was not seen
constexpr double longest_gap = 0.5;  // s between two pictures; in a longer one the tool may have been anywhere
constexpr double most_late = 0.25;   // s by which a live picture may be missing
constexpr double clock_slip = 0.05;  // share by which the shown time runs faster or slower to be as late as it shall
constexpr double clock_jump = 0.5;   // s, more is not slipped
constexpr double reached_mm = 0.05;  // half of a tracked tip's noise
constexpr double reached_rad = 2e-3;

// Moves at most so far towards the goal. True on arrival.
bool approach(Pose& pose, const Pose& goal, double way, double turn) noexcept {
  const Vec3 offset = goal.translation() - pose.translation();
  const double distance = offset.norm();
  const double share = distance > way ? way / distance : 1.0;
  const Eigen::Quaterniond from(pose.linear()), to(goal.linear());
  const double angle = from.angularDistance(to);
  const double turned = angle > turn ? turn / angle : 1.0;
  pose.translation() = share < 1.0 ? Vec3(pose.translation() + share * offset) : Vec3(goal.translation());
  pose.linear() = turned < 1.0 ? from.slerp(turned, to).normalized().toRotationMatrix() : Mat3(goal.linear());
  return distance * (1.0 - share) <= reached_mm && angle * (1.0 - turned) <= reached_rad;
}

}  // namespace

void ToolMotion::start(const Pose& pose, double begin) noexcept {
  *this = ToolMotion();
  place_.pose = pose;
  time_ = begin;
}

void ToolMotion::advance_clock(const ToolFeed& feed, double now, double elapsed) noexcept {
  if (!feed.live()) {
    time_ = std::max(time_, std::min(time_ + elapsed, feed.newest()));
    return;
  }
  due_ = now - feed.delay();
  const double off = due_ - (time_ + elapsed);
  const double next = std::abs(off) > clock_jump || !began_
                          ? due_
                          : time_ + elapsed + std::clamp(off, -clock_slip * elapsed, clock_slip * elapsed);
  time_ = std::max(std::min(time_, next), std::min(next, feed.newest()));  // a late picture is waited for
}

// The place known for now. False: that was the last one, and the tool may be elsewhere.
bool ToolMotion::aim(const ToolFeed& feed, Pose& goal) const noexcept {
  if (before_.unseen != UnknownPlace::no) return false;
  goal = before_.pose;
  if (!has_after_) return !feed.live() || due_ - before_.time < most_late;
  const double span = after_.time - before_.time;
  if (after_.unseen != UnknownPlace::no || span > longest_gap) return false;
  const double share = span > 0.0 ? std::clamp((time_ - before_.time) / span, 0.0, 1.0) : 1.0;
  goal.translation() += share * (after_.pose.translation() - before_.pose.translation());
  goal.linear() = Eigen::Quaterniond(before_.pose.linear())
                      .slerp(share, Eigen::Quaterniond(after_.pose.linear()))
                      .normalized()
                      .toRotationMatrix();
  return true;
}

const ToolMotion::Place& ToolMotion::step(ToolFeed& feed, double now, double elapsed) noexcept {
  const bool ended = feed.ended();  // before the last picture is looked for
  advance_clock(feed, now, elapsed);
  while (true) {
    if (!has_after_) has_after_ = feed.next(after_);
    if (!has_after_ || after_.time > time_) break;
    before_ = after_;
    has_after_ = false;
    began_ = true;
  }
  place_.over = ended && !has_after_ && !feed.failed();
  Pose goal = place_.pose;
  const bool known = aim(feed, goal);
  const double speed = lost_ ? catch_up : fastest, turning = lost_ ? catch_up_turn : fastest_turn;
  const bool reached = approach(place_.pose, goal, speed * elapsed, turning * elapsed);
  lost_ = !known || (lost_ && !reached);
  place_.seen = !lost_;
  return place_;
}

}  // namespace bodkin::tracking
