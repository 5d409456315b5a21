#include "fem/shaft_constraints.h"

#include <algorithm>

#include <Eigen/Cholesky>

namespace bodkin {

ShaftConstraints::ShaftConstraints(const Eigen::MatrixXd& compliance, std::size_t most_nodes,
                                   const std::optional<NeedleBeam>& beam)
    : bends_(beam.has_value()),
      factor_(compliance, most_nodes + 1, beam),
      all_held_(compliance, most_nodes + 1, beam),
      names_(2 * most_nodes + 2),
      held_(2 * most_nodes + 2, 0),
      nodes_(most_nodes + 1),
      depths_(most_nodes + 1),
      values_(factor_.stride()),
      modes_(beam ? 4 * factor_.stride() : 0) {
  begin(Mat3::Identity());
}

void ShaftConstraints::begin(const Mat3& frame) noexcept {
  along_ = frame.leftCols<1>();
  across_ = frame.rightCols<2>();
  factor_.clear();
  all_held_.clear();
  std::fill(held_.begin(), held_.end(), std::uint8_t{0});
  count_ = 0;
  last_softness_ = -1.0;
  modes_known_ = false;
}

std::size_t ShaftConstraints::place(Name name) const noexcept {
  const auto end = names_.begin() + static_cast<std::ptrdiff_t>(factor_.constraints());
  return static_cast<std::size_t>(std::find(names_.begin(), end, name) - names_.begin());
}

bool ShaftConstraints::append(Name name, std::uint32_t node, double softness) noexcept {
  modes_known_ = false;
  const bool is_along = name % 2 == 0;
  if (!factor_.append(node, is_along ? along_ : across_, softness, is_along ? -1.0 : depths_[name / 2])) return false;
  names_[factor_.constraints() - 1] = name;
  held_[name] = 1;
  return true;
}

void ShaftConstraints::remove(Name name) noexcept {
  if (held_[name] == 0) return;
  held_[name] = 0;
  modes_known_ = false;
  const std::size_t at = place(name);
  std::copy(names_.begin() + static_cast<std::ptrdiff_t>(at) + 1,
            names_.begin() + static_cast<std::ptrdiff_t>(factor_.constraints()),
            names_.begin() + static_cast<std::ptrdiff_t>(at));
  factor_.remove(at);
}

bool ShaftConstraints::push(std::uint32_t node, double depth) noexcept {
  if (count_ + 1 >= nodes_.size()) return false;
  if (count_ > 0) {
    if (last_softness_ != 0.0 && !hold_last_across(0.0)) return false;
    if (!all_held_.append(nodes_[count_ - 1], along_)) return false;
    if (!all_held_.append(nodes_[count_ - 1], across_, 0.0, depths_[count_ - 1])) {
      all_held_.remove_last();
      return false;
    }
  }
  depths_[count_] = depth;
  nodes_[count_++] = node;
  last_softness_ = -1.0;
  return true;
}

void ShaftConstraints::pop() noexcept {
  if (count_ == 0) return;
  remove(along(count_));  // the node before the tip
  remove(across(count_ - 1));
  remove(along(count_ - 1));
  --count_;
  last_softness_ = count_ > 0 ? 0.0 : -1.0;
  all_held_.remove_last();
  all_held_.remove_last();
}

bool ShaftConstraints::hold_along(std::size_t index) noexcept {
  return !held_along(index) && append(along(index), nodes_[index], 0.0);
}

bool ShaftConstraints::hold_before_tip(std::uint32_t node) noexcept {
  nodes_[count_] = node;
  return hold_along(count_);
}

void ShaftConstraints::let_slide(std::size_t index) noexcept {
  remove(along(index));
}

void ShaftConstraints::hold_all_along() noexcept {
  if (count_ == 0) return;
  const bool before_tip = held_along(count_);
  modes_known_ = false;
  factor_.copy(all_held_);
  for (std::size_t i = 0; i + 1 < count_; ++i) {
    names_[2 * i] = along(i);
    names_[2 * i + 1] = across(i);
  }
  std::fill(held_.begin(), held_.end(), std::uint8_t{0});
  std::fill_n(held_.begin(), 2 * count_ - 2, std::uint8_t{1});
  append(along(count_ - 1), nodes_[count_ - 1], 0.0);
  if (last_softness_ >= 0.0) append(across(count_ - 1), nodes_[count_ - 1], last_softness_);
  if (before_tip) append(along(count_), nodes_[count_], 0.0);
}

bool ShaftConstraints::hold_last_across(double softness) noexcept {
  if (count_ == 0) return false;
  const Name name = across(count_ - 1);
  const std::size_t held = factor_.constraints();
  const bool is_last = last_softness_ >= 0.0 && held > 0 && names_[held - 1] == name;
  if (is_last && factor_.soften_last(softness)) {
    modes_known_ = false;
    last_softness_ = softness;
    return true;
  }
  if (last_softness_ >= 0.0) remove(name);
  const bool done = append(name, nodes_[count_ - 1], softness);
  last_softness_ = done ? softness : -1.0;
  return done;
}

void ShaftConstraints::release_last_across() noexcept {
  if (count_ > 0 && last_softness_ >= 0.0) remove(across(count_ - 1));
  last_softness_ = -1.0;
}

std::size_t ShaftConstraints::release_cost(std::size_t index) const noexcept {
  return factor_.removal_cost(place(along(index)));
}

// How each constraint is moved when the shaft, as if rigid, is moved across or turned at the surface.
void ShaftConstraints::find_rigid_modes() noexcept {
  const std::size_t stride = factor_.stride();
  std::fill(modes_.begin(), modes_.end(), 0.0);
  std::size_t row = 0;
  for (std::size_t i = 0; i < factor_.constraints(); ++i) {
    if (names_[i] % 2 == 0) {
      ++row;
      continue;
    }
    for (std::size_t plane = 0; plane < 2; ++plane, ++row) {
      modes_[2 * plane * stride + row] = 1.0;
      modes_[(2 * plane + 1) * stride + row] = depths_[names_[i] / 2];
    }
  }
  factor_.forward(modes_.data(), 4);
  modes_known_ = true;
}

// The factor is that of a beam clamped at the surface, A_0. With P the rigid modes, A = A_0 + (P R) (P R)^T, R R^T
// the flexibility of the piece outside: two or three columns a plane. `values_` holds U^-T d; what is added to it
// makes U^-1 of it the solution for A (Woodbury), and the matrix to be solved for that, 1 + R^T P^T A_0^-1 P R, is
// never worse than the unit matrix.
Eigen::Vector2d ShaftConstraints::bend_outside(const ShaftRoot& root) noexcept {
  if (!modes_known_) find_rigid_modes();
  const auto rows = static_cast<Eigen::Index>(factor_.rows());
  const auto stride = static_cast<Eigen::Index>(factor_.stride());
  const auto mode = [&](Eigen::Index i) {
    return Eigen::Map<const Eigen::VectorXd>(modes_.data() + i * stride, rows);
  };
  Eigen::Map<Eigen::VectorXd> values(values_.data(), rows);
  Eigen::Matrix4d stiffness;  // P^T A_0^-1 P
  Eigen::Vector4d load;       // P^T A_0^-1 d
  for (Eigen::Index i = 0; i < 4; ++i) {
    load(i) = mode(i).dot(values);
    for (Eigen::Index j = 0; j <= i; ++j) stiffness(i, j) = stiffness(j, i) = mode(i).dot(mode(j));
  }
  Eigen::Matrix<double, 4, 6> roots = Eigen::Matrix<double, 4, 6>::Zero();
  roots.topLeftCorner<2, 3>() = roots.bottomRightCorner<2, 3>() = root.root;
  const Eigen::Matrix<double, 4, 6> pulled = stiffness * roots;
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Identity();
  matrix += roots.transpose() * pulled;
  Eigen::Matrix<double, 6, 1> strain = roots.transpose() * load;
  Eigen::LLT<Eigen::Ref<Eigen::Matrix<double, 6, 6>>>(matrix).solveInPlace(strain);
  const Eigen::Vector4d moved = roots * strain;
  for (Eigen::Index i = 0; i < 4; ++i) values -= mode(i) * moved(i);
  return {-root.root(1, 2) * strain(2), -root.root(1, 2) * strain(5)};
}

Eigen::Vector2d ShaftConstraints::solve(std::span<const double> displacements, std::span<double> forces,
                                        const ShaftRoot& root) noexcept {
  double* value = values_.data();
  const std::size_t held = factor_.constraints();
  for (std::size_t i = 0; i < held; ++i) {
    const double* at = displacements.data() + 3 * (names_[i] / 2);
    if (names_[i] % 2 == 0) {
      *value++ = at[0];
    } else {
      *value++ = at[1];
      *value++ = at[2];
    }
  }
  factor_.forward(values_.data(), 1);
  Eigen::Vector2d turn = bends_ ? bend_outside(root) : Eigen::Vector2d(0.0, 0.0);
  factor_.backward(values_.data());
  value = values_.data();
  for (std::size_t i = 0; i < held; ++i) {
    double* at = forces.data() + 3 * (names_[i] / 2);
    if (names_[i] % 2 == 0) {
      at[0] = *value++;
    } else {
      at[1] = *value++;
      at[2] = *value++;
    }
  }
  return turn;
}

}  // namespace bodkin
