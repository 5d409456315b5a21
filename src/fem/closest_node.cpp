#include "fem/closest_node.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/LU>

#include "core/error.h"

namespace bodkin::fem {

namespace {

constexpr double farthest_tip = 1e4;       // mm; farther, a sensor failed
constexpr double same_channel = 1.0;       // mm between entries of one channel ...
constexpr double same_direction = 0.9986;  // ... and cosine of 3 degrees
constexpr double nearer = 0.9;             // of the distance to the tip's node, at which another takes over

}  // namespace

ClosestNodeContact::ClosestNodeContact(const anatomy::CondensedBody& body, const ContactTissues& tissues,
                                       const anatomy::ClosestNodeSettings& settings, double dt)
    : body_(body), tissues_(tissues), settings_(settings), dt_(dt), punctured_(body.nodes.size(), 0) {
  check_contact_tissues(tissues);
  check(settings, "closest_node");
  check_tick("closest_node", dt);
  const auto rows = static_cast<Eigen::Index>(3 * body.nodes.size());
  if (body.nodes.empty() || body.tissues.size() != body.nodes.size() || body.compliance.rows() != rows ||
      body.compliance.cols() != rows) {
    throw InputError("closest node: the corridor's nodes, tissues and compliance do not fit together; expected a " +
                     std::string("tissue and 3 rows for each of its ") + std::to_string(body.nodes.size()) +
                     " nodes");
  }
  limits_.resize(static_cast<std::size_t>(std::ceil(settings.longest / settings.layer)) + 1);
  line_.resize(static_cast<std::size_t>(std::ceil(settings.longest / layer_step)) + 1);
}

ContactNumbers ClosestNodeContact::numbers() const noexcept {
  return {tissues_, settings_.capture_radius, settings_.relaxation, settings_.presliding};
}

void ClosestNodeContact::set_numbers(const ContactNumbers& numbers) noexcept {
  tissues_ = numbers.tissues;
  settings_.capture_radius = numbers.capture_radius;
  settings_.relaxation = numbers.time;
  settings_.presliding = numbers.presliding;
  known_ = 0;  // the friction of the layers is summed anew
}

void ClosestNodeContact::reset() noexcept {
  std::fill(punctured_.begin(), punctured_.end(), std::uint8_t{0});
  begin(Vec3::Zero(), Vec3::UnitZ());
  begun_ = false;
  passed_ = deepest_ = 0.0;
}

void ClosestNodeContact::begin(const Vec3& entry, const Vec3& direction,
                               std::span<const anatomy::TissueId> line) noexcept {
  const bool is_same_way =
      begun_ && (entry - entry_).norm() < same_channel && direction.dot(direction_) > same_direction;
  if (!is_same_way) passed_ = deepest_ = 0.0;
  entry_ = entry;
  tissues_along_ = std::min(line.size(), line_.size());
  std::copy_n(line.begin(), tissues_along_, line_.begin());
  direction_ = direction;
  begun_ = fresh_ = true;
  known_ = 0;
  node_ = relaxing_ = none;
  force_.setZero();
  friction_ = 0.0;
}

std::uint32_t ClosestNodeContact::closest(const Vec3& place, double within, bool unpunctured) const noexcept {
  std::uint32_t found = none;
  double least = within * within;
  for (std::size_t node = 0; node < body_.nodes.size(); ++node) {
    const double distance = (body_.nodes[node] - place).squaredNorm();
    if (distance > least || (unpunctured && punctured_[node] != 0)) continue;
    if (unpunctured && is_passed(static_cast<std::uint32_t>(node))) continue;
    least = distance;
    found = static_cast<std::uint32_t>(node);
  }
  return found;
}

Mat3 ClosestNodeContact::own_compliance(std::uint32_t node) const noexcept {
  const auto at = static_cast<Eigen::Index>(3) * static_cast<Eigen::Index>(node);
  return body_.compliance.block<3, 3>(at, at);
}

double ClosestNodeContact::stiffness_scale(std::uint32_t node) const noexcept {
  const double target = tissues_[body_.tissues[node]].stiffness;
  return target > 0.0 ? target / direction_.dot(own_compliance(node).inverse() * direction_) : 1.0;
}

Vec3 ClosestNodeContact::push(const Vec3& tip) const noexcept {
  return stiffness_scale(node_) * (own_compliance(node_).inverse() * (tip - body_.nodes[node_] - offset_));
}

// Of the closed tissues on the line before `depth`, the one with the greatest force; air when none is known.
anatomy::TissueId ClosestNodeContact::firmest_before(double depth) const noexcept {
  anatomy::TissueId firmest = anatomy::tissue::air;
  for (auto i = static_cast<std::size_t>(std::max(0.0, passed_) / layer_step); i < tissues_along_; ++i) {
    if (layer_step * static_cast<double>(i) > depth) break;
    if (tissues_[line_[i]].puncture_force > tissues_[firmest].puncture_force) firmest = line_[i];
  }
  return firmest;
}

// Opens the line to `depth`, and to the end of the layer of `tissue` there.
void ClosestNodeContact::pass(double depth, anatomy::TissueId tissue) noexcept {
  deepest_ = std::max(deepest_, depth + layer_step);
  passed_ = std::max(passed_, depth + layer_step);
  for (auto i = static_cast<std::size_t>(std::max(0.0, passed_) / layer_step); i < tissues_along_; ++i) {
    if (line_[i] != tissue) return;
    passed_ = layer_step * static_cast<double>(i + 1);
  }
}

// The node that the tip pushes, and the tip's position, as seen by the node, when they met.
void ClosestNodeContact::follow(const Vec3& tip) noexcept {
  const std::uint32_t best = closest(tip, settings_.capture_radius, true);
  if (node_ == none) {
    node_ = best;
    if (node_ != none) offset_ = tip - body_.nodes[node_];
  } else if (best != none && best != node_ &&
             (body_.nodes[best] - tip).norm() < nearer * (body_.nodes[node_] - tip).norm() &&
             !(depth_of(best) > depth_of(node_) + layer_step &&
               tissues_[body_.tissues[best]].puncture_force < tissues_[body_.tissues[node_]].puncture_force)) {
    const Vec3 force = push(tip);
    node_ = best;
    offset_ = tip - body_.nodes[node_] - own_compliance(node_) * force / stiffness_scale(node_);
  }
}

// N that friction can exert on the shaft when the tip is at `depth`; looks up tissues newly reached by the tip.
double ClosestNodeContact::shaft_limit(double depth) noexcept {
  const double layer = settings_.layer;
  const double place = std::clamp(depth / layer, 0.0, static_cast<double>(limits_.size() - 1));
  const auto whole = static_cast<std::size_t>(place);
  for (; known_ <= std::min(whole, limits_.size() - 1); ++known_) {
    const Vec3 middle = entry_ + (static_cast<double>(known_) + 0.5) * layer * direction_;
    const std::uint32_t node = closest(middle, farthest_tip, false);
    const double here = node == none ? 0.0 : tissues_[body_.tissues[node]].friction * layer;
    limits_[known_] = (known_ == 0 ? 0.0 : limits_[known_ - 1]) + here;
  }
  const double before = whole == 0 ? 0.0 : limits_[whole - 1];
  return before + (place - static_cast<double>(whole)) * (limits_[whole] - before);
}

ClosestNodeForce ClosestNodeContact::step(const Vec3& tip) noexcept {
  ClosestNodeForce out;
  const Vec3 from_entry = tip - entry_;
  if (!(from_entry.squaredNorm() <= farthest_tip * farthest_tip)) {
    out.fault = true;
    return out;
  }
  if (!begun_) return out;
  relaxed_ = std::min(1.0, relaxed_ + dt_ / settings_.relaxation);
  const double depth = from_entry.dot(direction_);
  if (fresh_) last_depth_ = depth;
  fresh_ = false;

  follow(tip);
  force_.setZero();
  if (node_ != none) {
    force_ = push(tip);
    out.tip_force = std::max(0.0, force_.dot(direction_));
    anatomy::TissueId holds = body_.tissues[node_];
    const anatomy::TissueId between = firmest_before(depth_of(node_));
    if (tissues_[between].puncture_force > tissues_[holds].puncture_force) holds = between;
    const double strength = tissues_[holds].puncture_force;
    if (force_.dot(direction_) < 0.0) {
      node_ = none;  // it lets go; the next contact begins without force
      force_.setZero();
    } else if (out.tip_force >= strength) {
      if (strength > 0.0) out.puncture = TissuePuncture{holds, depth, out.tip_force};
      punctured_[node_] = 1;
      pass(depth_of(node_), holds);
      relaxing_ = node_;
      relaxing_force_ = force_ / stiffness_scale(node_);
      relaxed_ = 0.0;
      node_ = none;
      force_.setZero();
    }
  }
  // A spring between shaft and tissue that slides at the limit (Prandtl).
  const double limit = shaft_limit(depth);
  friction_ = std::clamp(friction_ + settings_.presliding * (depth - last_depth_), -limit, limit);
  last_depth_ = depth;
  out.friction = friction_;
  out.resistance = out.tip_force + out.friction;
  if (node_ != none) out.node = node_;
  return out;
}

NodeForces ClosestNodeContact::node_forces() const noexcept {
  NodeForces forces;
  const auto add = [&forces](std::uint32_t node, const Vec3& force) {
    forces.nodes[forces.count++] = {
        node, {static_cast<float>(force.x()), static_cast<float>(force.y()), static_cast<float>(force.z())}};
  };
  if (node_ != none) add(node_, force_ / stiffness_scale(node_));
  if (relaxing_ != none && relaxed_ < 1.0) add(relaxing_, (1.0 - relaxed_) * relaxing_force_);
  return forces;
}

}  // namespace bodkin::fem
