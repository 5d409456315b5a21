#include "forces/bevel_tip.h"

#include <algorithm>
#include <cmath>

#include "anatomy/part_settings.h"
#include "core/repeatable.h"
#include "forces/model_input.h"

namespace bodkin::forces {
namespace {

// exp of the twist (w, v) on SE(3).
Pose exponential(const Vec3& w, const Vec3& v) {
  const double angle = w.norm();
  Pose pose = Pose::Identity();
  if (angle < 1e-9) {
    pose.linear() = Eigen::Quaterniond(1.0, 0.5 * w.x(), 0.5 * w.y(), 0.5 * w.z()).normalized().toRotationMatrix();
    pose.translation() = v + 0.5 * w.cross(v);
    return pose;
  }
  const Vec3 axis = w / angle;
  const double s = repeatable::sin(0.5 * angle), c = repeatable::cos(0.5 * angle);
  const double sine = 2.0 * s * c, one_less_cosine = 2.0 * s * s;
  pose.linear() = Eigen::Quaterniond(c, s * axis.x(), s * axis.y(), s * axis.z()).toRotationMatrix();
  pose.translation() =
      v * (sine / angle) + axis.cross(v) * (one_less_cosine / angle) + axis * (axis.dot(v) * (1.0 - sine / angle));
  return pose;
}

Pose rolled(const Pose& pose, double angle) {
  const double sine = repeatable::sin(angle), cosine = repeatable::cos(angle);
  Pose turned = pose;
  turned.linear().col(0) = cosine * pose.linear().col(0) + sine * pose.linear().col(1);
  turned.linear().col(1) = cosine * pose.linear().col(1) - sine * pose.linear().col(0);
  return turned;
}

}  // namespace

double bevel_curvature(double angle, double base) {
  return repeatable::tan(angle) / base;
}

WinklerTip winkler_tip(double rigidity, double foundation, double load) {
  const double beta = repeatable::pow(foundation / (4.0 * rigidity), 0.25);
  return {beta, 2.0 * load * beta / foundation};
}

BevelTip::BevelTip(double curvature, double longest) : curvature_(curvature), longest_(longest) {
  constexpr auto model = "bevel_tip";
  check_range(model, "curvature", curvature, declaration_of(&anatomy::BevelTipSettings::curvature).range, "1/mm");
  check_range(model, "longest path", longest, {1.0, 1000.0}, "mm");
  nodes_.resize(static_cast<std::size_t>(std::ceil(longest / spacing)) + 2);
  begin(Pose::Identity());
}

void BevelTip::begin(const Pose& start) noexcept {
  tip_ = start;
  end_ = nodes_[0] = {start, 0.0};
  known_ = 1;
  segment_after_ = none;
  roll_ = length_ = cut_ = 0.0;
}

BevelTip::Segment BevelTip::segment_after(std::size_t node) const noexcept {
  const Node& a = nodes_[node];
  const bool last = node + 1 >= known_;
  const Node& b = last ? end_ : nodes_[node + 1];
  return {
      a.pose.translation(), b.pose.translation() - a.pose.translation(),
      Arc(Eigen::Quaterniond(rolled(a.pose, -a.roll).linear()), Eigen::Quaterniond(rolled(b.pose, -b.roll).linear())),
      last ? cut_ / spacing - static_cast<double>(node) : 1.0};
}

Pose BevelTip::on_path(double length) noexcept {
  const double place = length / spacing;
  const std::size_t below = std::min(static_cast<std::size_t>(std::max(0.0, place)), known_ - 1);
  if (below != segment_after_) {
    segment_ = segment_after(below);
    segment_after_ = below;
  }
  const double along = place - static_cast<double>(below), whole = segment_.length;
  const double part = whole > 1e-9 ? std::clamp(along / whole, 0.0, 1.0) : 0.0;
  Pose pose = Pose::Identity();
  pose.translation() = segment_.from + segment_.way * part;
  pose.linear() = segment_.turn.at(part).toRotationMatrix();
  return rolled(pose, roll_);
}

const Pose& BevelTip::step(double advance, double roll) noexcept {
  if (!(std::abs(advance) <= farthest_depth) || !(std::abs(roll) <= 1e3)) return tip_;
  const double target = std::clamp(length_ + advance, 0.0, longest_);
  if (target <= cut_) {
    roll_ += roll;
    length_ = target;
    if (target == cut_ && advance == 0.0) {
      tip_ = rolled(end_.pose, roll_ - end_.roll);
    } else {
      tip_ = on_path(target);
    }
    return tip_;
  }
  // Free to the end of the cut path, then through uncut tissue, from one node of the memory to the next.
  if (length_ < cut_) tip_ = rolled(end_.pose, roll_ - end_.roll);
  const double turn = roll / (target - cut_);  // rad/mm
  segment_after_ = none;                       // the last one gets a new end
  while (cut_ < target) {
    const double node = static_cast<double>(known_) * spacing;
    const double next = node > cut_ ? std::min(node, target) : target;
    const double ds = next - cut_;
    tip_ = tip_ * exponential(Vec3(curvature_ * ds, 0.0, turn * ds), Vec3(0.0, 0.0, ds));
    roll_ += turn * ds;
    cut_ = length_ = next;
    end_ = {tip_, roll_};
    if (next == node && known_ < nodes_.size()) nodes_[known_++] = end_;
  }
  return tip_;
}

}  // namespace bodkin::forces
