#include "fem/shaft_constraints.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "fem/upper_triangular.h"

namespace bodkin::fem {

namespace {

constexpr double least_corner = 1e-10;  // of a node's own compliance, as in ContactFactor

// (L L^T)^-1 x, in place.
void solve_by_lower(const Eigen::Matrix2d& lower, Eigen::Vector2d& x) {
  lower.triangularView<Eigen::Lower>().solveInPlace(x);
  lower.transpose().triangularView<Eigen::Upper>().solveInPlace(x);
}

}  // namespace

ShaftConstraints::ShaftConstraints(const Eigen::MatrixXd& compliance, std::size_t most_nodes,
                                   const std::optional<NeedleBeam>& beam)
    : bends_(beam.has_value()),
      beam_(beam),
      compliance_(compliance, most_nodes + 1),
      across_(compliance, (2 * most_nodes + 2) / 3 + 1, beam),  // two rows per node, not three
      along_(most_nodes + 1, bends_ ? 4 : 0),
      nodes_(most_nodes + 1),
      depths_(most_nodes + 1),
      lasts_(most_nodes + 1),
      above_(2 * (most_nodes + 1) * across_.stride(), 0.0),
      left_(2 * (most_nodes + 1) * along_.stride(), 0.0),
      across_values_(across_.stride(), 0.0),
      products_(across_.stride(), 0.0),
      given_(most_nodes + 1, 0.0),
      carried_(along_.stride(), 0.0),
      moved_(along_.stride(), 0.0),
      loads_(along_.stride(), 0.0),
      found_(along_.stride(), 0.0),
      unknowns_(along_.stride(), 0.0),
      border_(6 * along_.stride(), 0.0) {
  begin(Mat3::Identity());
}

void ShaftConstraints::begin(const Mat3& frame) noexcept {
  across_directions_ = frame.rightCols<2>();
  compliance_.begin(frame);
  across_.clear();
  along_.begin();
  std::fill(moved_.begin(), moved_.end(), 0.0);
  count_ = 0;
  last_compliance_ = -1.0;
  border_valid_ = false;
}

bool ShaftConstraints::add_before_tip(std::uint32_t node) noexcept {
  const std::size_t index = known();
  if (index != count_ || !compliance_.push(node)) return false;
  nodes_[index] = node;
  const double* const row = compliance_.row(index, 0);
  double* const column = across_values_.data();
  for (std::size_t i = 0; i < rigid_count(); ++i) {
    column[2 * i] = row[3 * i + 1];
    column[2 * i + 1] = row[3 * i + 2];
  }
  across_.forward(column, 1);
  double* const own = loads_.data();
  for (std::size_t i = 0; i <= index; ++i) own[i] = row[3 * i];
  along_.push_node({column, 2 * rigid_count()}, {own, index + 1});
  for (std::size_t c = 0; c < 2 && count_ > 0; ++c) {
    left(count_ - 1, c)[always() + index] =
        row[3 * (count_ - 1) + 1 + c] - upper_triangular::product(above(count_ - 1, c), column, 2 * rigid_count());
  }
  border_valid_ = false;
  return true;
}

// Makes the lateral constraint of the last node rigid.
bool ShaftConstraints::make_rigid(std::size_t index) noexcept {
  if (!across_.append_solved(nodes_[index], across_directions_, above(index, 0), 0.0, depths_[index])) return false;
  const double a = across_.entry(2 * index, 2 * index), b = across_.entry(2 * index, 2 * index + 1);
  const double c = across_.entry(2 * index + 1, 2 * index + 1);
  double* const first = loads_.data();
  double* const second = moved_.data();
  for (std::size_t i = 0; i < along_.columns(); ++i) {
    first[i] = left(index, 0)[i] / a;
    second[i] = (left(index, 1)[i] - b * first[i]) / c;
  }
  along_.push_rows({first, along_.columns()}, {second, along_.columns()});
  return true;
}

// Computes the coupling of a new last node with the nodes before it.
void ShaftConstraints::begin_last(std::size_t index) noexcept {
  Last& last = lasts_[index];
  const std::size_t before = 2 * rigid_count();
  for (std::size_t d = 0; d < 2; ++d) {
    const double* const row = compliance_.row(index, 1 + d);
    double* const column = above(index, d);
    for (std::size_t i = 0; i < rigid_count(); ++i) {
      column[2 * i] = row[3 * i + 1];
      column[2 * i + 1] = row[3 * i + 2];
      if (bends_) column[2 * i + d] += beam_->flexibility(depths_[i], depths_[index]);
    }
  }
  across_.forward(above(index, 0), 2);
  for (std::size_t d = 0; d < 2; ++d) {
    const double* const row = compliance_.row(index, 1 + d);
    const double* const column = above(index, d);
    double* const coupled = left(index, d);
    std::fill_n(coupled, along_.stride(), 0.0);
    along_.add_transposed(column, coupled);
    for (std::size_t i = 0; i < along_.columns(); ++i) coupled[i] = -coupled[i];
    for (std::size_t i = 0; i <= index; ++i) coupled[always() + i] += row[3 * i];
    if (bends_) {
      coupled[2 * d] += 1.0;
      coupled[2 * d + 1] += depths_[index];
    }
    const auto here = static_cast<Eigen::Index>(d);
    last.own(here) = row[3 * index + 1 + d];
    for (std::size_t c = 0; c <= d; ++c) {
      const auto there = static_cast<Eigen::Index>(c);
      const double own =
          row[3 * index + 1 + c] + (bends_ && c == d ? beam_->flexibility(depths_[index], depths_[index]) : 0.0);
      last.corner(here, there) = last.corner(there, here) =
          own - upper_triangular::product(column, above(index, c), before);
    }
  }
}

bool ShaftConstraints::push(std::uint32_t node, double depth) noexcept {
  if (count_ + 1 >= nodes_.size() || (known() > count_ && nodes_[count_] != node)) return false;
  if (count_ > 0) {
    if (last_compliance_ != 0.0 && !constrain_last_across(0.0)) return false;
    if (known() == count_ && !add_before_tip(node)) return false;
    if (!make_rigid(count_ - 1)) return false;
  } else if (known() == 0 && !add_before_tip(node)) {
    return false;
  }
  depths_[count_++] = depth;
  last_compliance_ = -1.0;
  border_valid_ = false;
  begin_last(count_ - 1);
  return true;
}

void ShaftConstraints::pop() noexcept {
  if (count_ == 0) return;
  if (known() > count_) {
    along_.pop_node();
    compliance_.pop();
  }
  along_.release(count_ - 1);
  if (count_ > 1) {  // last: released rows need not be updated
    along_.pop_rows();
    across_.remove_last();
  }
  --count_;
  last_compliance_ = count_ > 0 ? 0.0 : -1.0;
  border_valid_ = false;
}

void ShaftConstraints::constrain_all_along() noexcept {
  const bool before_tip = known() > count_ && constrained_along(count_);
  along_.stick_first(count_ + (before_tip ? 1 : 0));
}

bool ShaftConstraints::constrain_last_across(double compliance) noexcept {
  if (count_ == 0 || !(compliance >= 0.0)) return false;
  const Last& last = lasts_[count_ - 1];
  const double first = last.corner(0, 0) + compliance;
  const double second = last.corner(1, 1) + compliance - last.corner(1, 0) * last.corner(1, 0) / first;
  const bool valid = first > least_corner * last.own(0) && second > least_corner * last.own(1);
  if (compliance != last_compliance_) border_valid_ = false;
  last_compliance_ = valid ? compliance : -1.0;
  return valid;
}

// Computes the border of T: columns of the last node's lateral constraint and of the bending modes outside the body.
void ShaftConstraints::find_border() noexcept {
  if (along_.refresh()) border_valid_ = false;
  if (border_valid_) return;
  border_valid_ = true;
  const auto sticking = along_.sticking();
  const auto rows = static_cast<Eigen::Index>(sticking.size()), stride = static_cast<Eigen::Index>(along_.stride());
  last_valid_ = last_constrained();
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t k = 0; k < sticking.size(); ++k)
      border_[c * along_.stride() + k] = last_valid_ ? left(count_ - 1, c)[always() + sticking[k]] : 0.0;
  }
  for (std::size_t m = 0; m < always(); ++m) {
    for (std::size_t k = 0; k < sticking.size(); ++k)
      border_[(2 + m) * along_.stride() + k] = along_.sigma(always() + sticking[k], m);
  }
  if (last_valid_ || bends_) along_.forward(border_.data(), 2 + always());
  const auto vector = [&](Eigen::Index i) {
    return Eigen::Map<const Eigen::VectorXd>(border_.data() + i * stride, rows);
  };
  if (last_valid_) {
    const Last& last = lasts_[count_ - 1];
    Eigen::Matrix2d corner = last.corner + last_compliance_ * Eigen::Matrix2d::Identity();
    for (Eigen::Index i = 0; i < 2; ++i) {
      for (Eigen::Index j = 0; j <= i; ++j) {
        corner(i, j) -= vector(i).dot(vector(j));
      }
    }
    const double rest = corner(1, 1) - corner(1, 0) * corner(1, 0) / corner(0, 0);
    last_valid_ = corner(0, 0) > least_corner * last.own(0) && rest > least_corner * last.own(1);
    last_factor_ << std::sqrt(corner(0, 0)), 0.0, corner(1, 0) / std::sqrt(corner(0, 0)), std::sqrt(rest);
  }
  if (!bends_) return;
  last_bends_.setZero();
  for (Eigen::Index m = 0; m < 4; ++m) {
    for (Eigen::Index n = 0; n < 4; ++n) {
      stiffness_(m, n) =
          vector(2 + m).dot(vector(2 + n)) - along_.sigma(static_cast<std::size_t>(m), static_cast<std::size_t>(n));
    }
    for (Eigen::Index c = 0; c < 2 && last_valid_; ++c) {
      last_bends_(c, m) = left(count_ - 1, static_cast<std::size_t>(c))[m] - vector(c).dot(vector(2 + m));
    }
  }
  if (!last_valid_) return;
  const Eigen::Matrix<double, 2, 4> turned = last_factor_.triangularView<Eigen::Lower>().solve(last_bends_);
  stiffness_ += turned.transpose() * turned;
}

void ShaftConstraints::place(std::span<const double> displacements, const ShaftRoot& root) noexcept {
  root_ = root;
  double* const value = across_values_.data();
  for (std::size_t i = 0; i < rigid_count(); ++i) {
    value[2 * i] = displacements[3 * i + 1];
    value[2 * i + 1] = displacements[3 * i + 2];
  }
  across_.forward(value, 1);
  std::fill(carried_.begin(), carried_.end(), 0.0);
  along_.add_transposed(value, carried_.data());
  for (std::size_t i = 0; i < known(); ++i) given_[i] = displacements[3 * i];
  if (!last_constrained()) return;
  for (std::size_t c = 0; c < 2; ++c) {
    last_wanted_(static_cast<Eigen::Index>(c)) =
        displacements[3 * count_ - 2 + c] - upper_triangular::product(above(count_ - 1, c), value, 2 * rigid_count());
  }
}

// Bending of the piece outside the body. With P the rigid modes of the lateral constraints and A_0 all other
// equations, A = A_0 + (P R) (P R)^T, where R R^T is the flexibility of the piece outside: two or three columns in
// each plane. The matrix of the Woodbury formula, 1 + R^T P^T A_0^-1 P R, is at least as well conditioned as the unit
// matrix. `mode_displacements`: of the modes by all other forces.
Eigen::Vector4d ShaftConstraints::bend_outside(const Eigen::Vector4d& mode_displacements) noexcept {
  Eigen::Matrix<double, 4, 6> roots = Eigen::Matrix<double, 4, 6>::Zero();
  roots.topLeftCorner<2, 3>() = roots.bottomRightCorner<2, 3>() = root_.root;
  const Eigen::Matrix<double, 4, 6> stiff = stiffness_ * roots;
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Identity();
  matrix += roots.transpose() * stiff;
  Eigen::Matrix<double, 6, 1> strain = roots.transpose() * mode_displacements;
  Eigen::LLT<Eigen::Ref<Eigen::Matrix<double, 6, 6>>>(matrix).solveInPlace(strain);
  turn_ = {-root_.root(1, 2) * strain(2), -root_.root(1, 2) * strain(5)};
  return roots * strain;
}

void ShaftConstraints::solve_along(std::span<double> forces) noexcept {
  find_border();
  const auto sticking = along_.sticking();
  const std::size_t rows = sticking.size(), stride = along_.stride();
  std::fill(loads_.begin(), loads_.end(), 0.0);
  std::fill(moved_.begin(), moved_.end(), 0.0);
  for (std::size_t i = 0; i < known(); ++i) {
    if (!constrained_along(i)) loads_[always() + i] = forces[3 * i];
  }
  along_.add_displacements(loads_.data(), moved_.data());
  double* const unknowns = unknowns_.data();
  for (std::size_t k = 0; k < rows; ++k) {
    const std::size_t column = always() + sticking[k];
    unknowns[k] = given_[sticking[k]] - carried_[column] - moved_[column];
  }
  along_.forward(unknowns, 1);
  last_force_.setZero();
  turn_.setZero();
  Eigen::Vector4d outside_modes = Eigen::Vector4d::Zero();
  if (last_valid_) {
    for (std::size_t c = 0; c < 2; ++c) {
      last_force_(static_cast<Eigen::Index>(c)) =
          last_wanted_(static_cast<Eigen::Index>(c)) -
          upper_triangular::product(left(count_ - 1, c), loads_.data(), along_.columns()) -
          upper_triangular::product(border_.data() + c * stride, unknowns, rows);
    }
    solve_by_lower(last_factor_, last_force_);
  }
  if (bends_) {
    Eigen::Vector4d mode_displacements = last_bends_.transpose() * last_force_;
    for (std::size_t m = 0; m < 4; ++m) {
      mode_displacements(static_cast<Eigen::Index>(m)) +=
          carried_[m] + moved_[m] + upper_triangular::product(border_.data() + (2 + m) * stride, unknowns, rows);
    }
    outside_modes = bend_outside(mode_displacements);
    if (last_valid_) {
      Eigen::Vector2d less = last_bends_ * outside_modes;
      solve_by_lower(last_factor_, less);
      last_force_ -= less;
    }
  }
  const std::array<double, 6> border{-last_force_(0),   -last_force_(1),   -outside_modes(0),
                                     -outside_modes(1), -outside_modes(2), -outside_modes(3)};
  std::array<const double*, 6> vectors{};
  for (std::size_t i = 0; i < 6; ++i) vectors[i] = border_.data() + i * stride;
  upper_triangular::add_rows(vectors.data(), border.data(), bends_ ? 6 : 2, unknowns, rows);
  along_.backward(unknowns);
  finish_along(forces, outside_modes);
}

// Adds the constraint forces and computes the displacements of the sliding nodes by all forces.
void ShaftConstraints::finish_along(std::span<double> forces, const Eigen::Vector4d& outside_modes) noexcept {
  const auto sticking = along_.sticking();
  double* const found = found_.data();
  std::fill(found_.begin(), found_.end(), 0.0);
  for (std::size_t m = 0; m < always(); ++m) found[m] = outside_modes(static_cast<Eigen::Index>(m));
  for (std::size_t k = 0; k < sticking.size(); ++k) {
    found[always() + sticking[k]] = forces[3 * std::size_t{sticking[k]}] = unknowns_[k];
  }
  along_.add_displacements(found, moved_.data());
  for (std::size_t i = 0; i < along_.columns(); ++i) {
    moved_[i] += carried_[i];
    loads_[i] += found[i];
  }
  if (count_ == 0) return;
  for (std::size_t c = 0; c < 2; ++c) {
    const double force = last_force_(static_cast<Eigen::Index>(c));
    forces[3 * count_ - 2 + c] = force;
    const double* const by_last = left(count_ - 1, c);
    for (std::size_t i = 0; i < along_.columns() && last_valid_; ++i) moved_[i] += by_last[i] * force;
  }
}

Eigen::Vector2d ShaftConstraints::solve_across(std::span<double> forces) noexcept {
  const std::size_t rows = 2 * rigid_count();
  double* const value = across_values_.data();
  along_.multiply(loads_.data(), products_.data());
  for (std::size_t r = 0; r < rows; ++r) value[r] -= products_[r];
  if (last_valid_) {
    for (std::size_t r = 0; r < rows; ++r) {
      value[r] -= above(count_ - 1, 0)[r] * last_force_(0) + above(count_ - 1, 1)[r] * last_force_(1);
    }
  }
  across_.backward(value);
  for (std::size_t i = 0; i < rigid_count(); ++i) {
    forces[3 * i + 1] = value[2 * i];
    forces[3 * i + 2] = value[2 * i + 1];
  }
  return turn_;
}

Eigen::Vector2d ShaftConstraints::solve(std::span<const double> displacements, std::span<double> forces,
                                        const ShaftRoot& root) noexcept {
  place(displacements, root);
  solve_along(forces);
  return solve_across(forces);
}

}  // namespace bodkin::fem
