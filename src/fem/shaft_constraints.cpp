#include "fem/shaft_constraints.h"

#include <algorithm>

namespace bodkin {

ShaftConstraints::ShaftConstraints(const Eigen::MatrixXd& compliance, std::size_t most_nodes)
    : factor_(compliance, most_nodes + 1),
      all_held_(compliance, most_nodes + 1),
      names_(2 * most_nodes + 2),
      held_(2 * most_nodes + 2, 0),
      nodes_(most_nodes + 1),
      values_(3 * most_nodes + 3) {
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
}

std::size_t ShaftConstraints::place(Name name) const noexcept {
  const auto end = names_.begin() + static_cast<std::ptrdiff_t>(factor_.constraints());
  return static_cast<std::size_t>(std::find(names_.begin(), end, name) - names_.begin());
}

bool ShaftConstraints::append(Name name, std::uint32_t node, double softness) noexcept {
  if (!factor_.append(node, name % 2 == 0 ? along_ : across_, softness)) return false;
  names_[factor_.constraints() - 1] = name;
  held_[name] = 1;
  return true;
}

void ShaftConstraints::remove(Name name) noexcept {
  if (held_[name] == 0) return;
  held_[name] = 0;
  const std::size_t at = place(name);
  std::copy(names_.begin() + static_cast<std::ptrdiff_t>(at) + 1,
            names_.begin() + static_cast<std::ptrdiff_t>(factor_.constraints()),
            names_.begin() + static_cast<std::ptrdiff_t>(at));
  factor_.remove(at);
}

bool ShaftConstraints::push(std::uint32_t node) noexcept {
  if (count_ + 1 >= nodes_.size()) return false;
  if (count_ > 0) {
    if (last_softness_ != 0.0 && !hold_last_across(0.0)) return false;
    if (!all_held_.append(nodes_[count_ - 1], along_)) return false;
    if (!all_held_.append(nodes_[count_ - 1], across_)) {
      all_held_.remove_last();
      return false;
    }
  }
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

void ShaftConstraints::solve(std::span<const double> displacements, std::span<double> forces) noexcept {
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
  factor_.solve({values_.data(), factor_.rows()});
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
}

}  // namespace bodkin
