// EmbeddedNeedle: the force on the hand, the shape of the needle and the stored energy.
#include <algorithm>

#include "fem/embedded_needle.h"

namespace bodkin::fem {

namespace {

constexpr double inside_border = 1e-6;  // mm before an intact boundary

}  // namespace

// The tissue behind the tip has moved with its last contact node; intact tissue lies before the tip however far the
// tip has advanced.
double EmbeddedNeedle::material_depth() const noexcept {
  if (captured_ == 0) return provisional_ > 0.0 || blocked() ? 0.0 : tip_ - (line().empty() ? 0.0 : carried(0)(0));
  const double here = tip_ - contacts_[captured_ - 1].moved;
  return is_before_next() ? std::min(here, line()[captured_].depth) : here;
}

// The tissue at the tip has moved sideways with the needle as much as at the last point of the shaft.
EmbeddedNeedle::Continuation EmbeddedNeedle::continuation() const noexcept {
  Eigen::Vector2d slope = slope_, place = axis_offset(tip_);
  if (beam_) {
    const Eigen::Vector2d bent = beam_deflection(root_.outside + tip_);
    place += bent;
    slope += bent - beam_deflection(root_.outside + tip_ - 1.0);
  }
  const Vec3 direction = (frame_ * Vec3(1.0, slope(0), slope(1))).normalized();
  if (constraints_.known() > captured_) return {body_.nodes[line()[captured_].index], direction};
  if (captured_ > 0) place -= displacement(captured_ - 1).tail<2>();
  return {entry_ + frame_ * Vec3(material_depth(), place(0), place(1)), direction};
}

double EmbeddedNeedle::opened_depth() const noexcept {
  for (std::size_t i = captured_; i > 0; --i)
    if (line()[i - 1].resists) return line()[i - 1].depth;
  return -1.0;
}

// The layers of the contact points; the first one is the skin, even before its puncture.
anatomy::TissueId EmbeddedNeedle::tissue_at(double depth) const noexcept {
  std::size_t here = 0;
  while (here + 1 < line().size() && line()[here + 1].depth <= depth) ++here;
  return line()[here].tissue;
}

void EmbeddedNeedle::publish(NodeForces& all, std::size_t node, const Vec3& force) const noexcept {
  const Vec3 there = frame_ * force;
  all.nodes[all.count++] = {
      line()[node].index,
      {static_cast<float>(there.x()), static_cast<float>(there.y()), static_cast<float>(there.z())}};
}

void EmbeddedNeedle::report() noexcept {
  const std::size_t known = constraints_.known();
  Vec3 pushed = Vec3::Zero(), torque = Vec3::Zero();  // of the tissue, about the tip, in the frame
  Eigen::Vector2d across = Eigen::Vector2d::Zero(), moment = Eigen::Vector2d::Zero();  // on the tissue; at the hub
  published_.count = elastic_.count = 0;
  force_.nodes = static_cast<std::uint32_t>(captured_);
  force_.sticking = 0;
  for (std::size_t i = 0; i < known; ++i) {
    const Vec3 force = Eigen::Map<const Vec3>(forces_.data() + 3 * i);
    if (i < captured_ && constraints_.constrained_along(i)) ++force_.sticking;
    // A force along the line acts on the line, a lateral one on the needle's axis and perpendicular to it: these are
    // the directions in which the constraints move with the needle.
    const double reach = depth_now(i) - tip_;
    const Vec3 at(reach, slope_(0) * reach, slope_(1) * reach);
    const Vec3 square(-(force(1) * slope_(0) + force(2) * slope_(1)), force(1), force(2));
    pushed += Vec3(force(0), 0.0, 0.0) + square;
    torque += at.cross(square);
    across += force.tail<2>();
    moment += (root_.outside + line()[i].depth) * force.tail<2>();
    if (force != Vec3::Zero()) publish(published_, i, force);
    const Vec3 faded = relaxing_.faded(i);
    if (relaxing_.relaxes() && force + faded != Vec3::Zero()) publish(elastic_, i, force + faded);
  }
  if (beam_) {
    for (int i = 0; i < 2; ++i) pushed(0) += beam_->push_back(root_, across(i), moment(i), turn_(i));
    force_.tip_deflection = shaft_deflection(0.0);
  }
  pushed(0) += provisional_;
  force_.resistance = pushed(0);
  force_.tip_force = (known > captured_ ? forces_[3 * captured_] : provisional_) + cutting_force();
  force_.material_depth = material_depth();
  force_.opened_depth = opened_depth();
  force_.inside = force_.pushed = anatomy::tissue::air;
  if (!line().empty()) {
    const double reached = std::max(force_.material_depth, force_.opened_depth);
    force_.inside =
        tissue_at(is_before_next() ? std::min(reached, line()[captured_].depth - inside_border) : reached);
    if (blocked()) force_.pushed = line()[captured_].tissue;
  }
  force_.on_hand = {-(frame_ * pushed), -(frame_ * torque)};
  force_.beyond = begun_ && (line().empty() || tip_ > depth_now(line().size() - 1) + 2.0 * settings_.capture_radius);
}

// mm, across: deflection of the shaft from the straight needle, a beam under -f on a hub that may have rotated.
Eigen::Vector2d EmbeddedNeedle::beam_deflection(double from_hub) const noexcept {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  if (!beam_) return sum;
  for (std::size_t i = 0; i < constraints_.known(); ++i) {
    const double by = beam_->flexibility(from_hub, root_.outside + line()[i].depth);
    sum -= by * Eigen::Vector2d(forces_[3 * i + 1], forces_[3 * i + 2]);
  }
  return sum + from_hub * turn_;
}

Vec3 EmbeddedNeedle::shaft_deflection(double from_tip) const noexcept {
  const Eigen::Vector2d across = beam_deflection(std::max(0.0, root_.outside + tip_ - from_tip));
  return frame_ * Vec3(0.0, across(0), across(1));
}

double EmbeddedNeedle::stored_energy() const noexcept {
  double sum = relaxing_.relaxes() ? relaxing_.stored_energy(constraints_.compliance(), forces_) : 0.0;
  for (std::size_t i = 0; i < constraints_.known(); ++i) {
    const Vec3 force = Eigen::Map<const Vec3>(forces_.data() + 3 * i);
    if (!relaxing_.relaxes()) sum += 0.5 * force.dot(constraints_.compliance().displacement(i, forces_));
    sum -= 0.5 * force.tail<2>().dot(beam_deflection(root_.outside + line()[i].depth));
    if (i < captured_ && contacts_[i].lateral_compliance > 0.0)
      sum += 0.5 * contacts_[i].lateral_compliance * force.tail<2>().squaredNorm();
  }
  return sum;
}

}  // namespace bodkin::fem
