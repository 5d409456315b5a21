#pragma once

// A hand that moves and tilts a needle in a body, and the account of its work.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

#include "core/shortest_turn.h"
#include "fem/embedded_needle.h"

namespace bodkin::checks {

using namespace bodkin::anatomy;
using namespace bodkin::fem;

// Two accounts of a tick's work, N mm. While a needle goes from pose to pose its contact forces turn with it, and act
// where its axis is by then. `turning`: the forces of the end of the tick along this whole way, exactly, however it
// turns and is rolled between the fingers. `at_end`: the wrench of the end of the tick times the whole way, the same
// without a turn; where tilts and rolls go together it is right to the first order in the tick alone.
struct HandWork {
  double turning = 0.0, at_end = 0.0;
};

class WorkingHand {
 public:
  // `line` begins on the skin. `points` must outlive this.
  WorkingHand(const CondensedBody& points, const ContactTissues& tissues, const NeedlePath& line)
      : points_(points), entry_(line.entry), needle_(points, tissues, {}, 1e-3) {
    frame_.col(2) = line.direction();
    frame_.col(0) = frame_.col(2).unitOrthogonal();
    frame_.col(1) = frame_.col(2).cross(frame_.col(0));
    needle_.begin(entry_, frame_.col(2));
    last_ = pose_at(place_, lean_);
    needle_.step(last_);
  }

  // At `speed` mm/s, of the tip and of a hub 100 mm from the skin. `goal`: mm aside, mm aside and mm deep; `lean`: of
  // the axis, its tangent; `roll`: rad a tick, between the fingers.
  void move(const Vec3& goal, const Eigen::Vector2d& lean, double speed, double roll = 0.0) {
    const Vec3 start = place_;
    const Eigen::Vector2d leant = lean_;
    constexpr double hub = 100.0;
    const double time = std::max((goal - start).norm(), hub * (lean - leant).norm()) / speed;
    const int ticks = std::max(1, static_cast<int>(std::ceil(time * 1e3)));
    for (int tick = 1; tick <= ticks; ++tick) {
      const double share = static_cast<double>(tick) / ticks;
      place_ = start + share * (goal - start);
      lean_ = leant + share * (lean - leant);
      rolled_ += roll;
      to(pose_at(place_, lean_));
    }
  }
  // N mm: largest fall of work minus stored energy below an earlier value.
  const HandWork& greatest_fall() const { return fall_; }
  // N mm, of all of it, that is not stored.
  HandWork lost() const {
    const double stored = needle_.stored_energy();
    return {work_.turning - stored, work_.at_end - stored};
  }
  const Eigen::Vector2d& lean() const { return lean_; }
  double greatest_force() const { return greatest_force_; }  // N
  // N: largest difference of the hand's force from the contact forces whose work is `turning`.
  double greatest_difference() const { return greatest_difference_; }

 private:
  Pose pose_at(const Vec3& place, const Eigen::Vector2d& lean) const {
    Pose pose = Pose::Identity();
    const Vec3 axis(lean.x(), lean.y(), 1.0);
    pose.linear() = frame_ * shortest_turn(Vec3::UnitZ(), axis).toRotationMatrix() *
                    Eigen::AngleAxisd(rolled_, Vec3::UnitZ()).toRotationMatrix();
    pose.translation() = entry_ + frame_ * place;
    return pose;
  }
  // Where the axis crosses the plane across the line in which a point lay at rest.
  Vec3 crossing(const Pose& pose, const Vec3& point) const {
    const Vec3 axis = pose.linear().col(2), along = frame_.col(2);
    return pose.translation() + along.dot(point - pose.translation()) / along.dot(axis) * axis;
  }

  void to(const Pose& now) {
    const Wrench force = needle_.step(now).on_hand;
    const Vec3 along = frame_.col(2), moved = now.translation() - last_.translation();
    const Eigen::AngleAxisd turn(now.linear() * last_.linear().transpose());
    work_.at_end -= force.force.dot(moved) + turn.angle() * force.torque.dot(turn.axis());
    Vec3 of_contacts = Vec3::Zero();
    const NodeForces& contacts = needle_.node_forces();
    for (std::size_t i = 0; i < contacts.count; ++i) {
      const Vec3 on_tissue =
          Eigen::Map<const Eigen::Vector3f>(contacts.nodes[i].force.data()).template cast<double>();
      const Vec3 push = along.dot(on_tissue) * along, across = on_tissue - push;
      const Vec3& point = points_.nodes[contacts.nodes[i].node];
      work_.turning += push.dot(moved) + across.dot(crossing(now, point) - crossing(last_, point));
      // A lateral force acts perpendicular to the needle.
      const Vec3 axis = now.linear().col(2);
      of_contacts -= push + across - across.dot(axis) / along.dot(axis) * along;
    }
    greatest_difference_ = std::max(greatest_difference_, (force.force - of_contacts).norm());
    greatest_force_ = std::max(greatest_force_, force.force.norm());
    last_ = now;
    const HandWork left = lost();
    follow(left.turning, most_.turning, fall_.turning);
    follow(left.at_end, most_.at_end, fall_.at_end);
  }
  static void follow(double now, double& most, double& fall) {
    most = std::max(most, now);
    fall = std::max(fall, most - now);
  }

  const CondensedBody& points_;
  Vec3 entry_;
  Mat3 frame_;  // columns: across, across, along the line
  EmbeddedNeedle needle_;
  Pose last_;
  Vec3 place_ = Vec3(0.0, 0.0, -1.0);
  Eigen::Vector2d lean_ = Eigen::Vector2d::Zero();
  double rolled_ = 0.0;  // rad
  HandWork work_, most_, fall_;
  double greatest_force_ = 0.0, greatest_difference_ = 0.0;
};

}  // namespace bodkin::checks
