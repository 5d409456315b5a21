#include "fem/axial_coupling.h"

namespace bodkin {

AxialCoupling::AxialCoupling(const Eigen::MatrixXd& compliance, std::size_t most_nodes)
    : compliance_(compliance),
      stride_((3 * most_nodes + 7) / 8 * 8),
      matrix_(most_nodes * stride_, 0.0),
      nodes_(most_nodes, 0) {}

void AxialCoupling::begin(const Mat3& frame) noexcept {
  count_ = 0;
  frame_ = frame;
}

void AxialCoupling::push(std::uint32_t node) noexcept {
  const std::size_t added = count_++;
  nodes_[added] = node;
  const auto place = static_cast<Eigen::Index>(3) * static_cast<Eigen::Index>(node);
  for (std::size_t i = 0; i <= added; ++i) {
    const auto at = static_cast<Eigen::Index>(3) * static_cast<Eigen::Index>(nodes_[i]);
    const Mat3 between =
        frame_.transpose() * compliance_.block<3, 3>(at, place) * frame_;  // of i by forces at `added`
    for (std::size_t c = 0; c < 3; ++c) {
      const auto component = static_cast<Eigen::Index>(c);
      matrix_[added * stride_ + 3 * i + c] = between(component, 0);
      matrix_[i * stride_ + 3 * added + c] = between(0, component);
    }
  }
}

void AxialCoupling::add(std::size_t index, double load, std::span<double> displacements) const noexcept {
  const double* row = matrix_.data() + index * stride_;
  double* sum = displacements.data();
  for (std::size_t j = 0; j < 3 * count_; ++j) sum[j] += row[j] * load;
}

double AxialCoupling::displacement(std::size_t index, std::span<const double> forces) const noexcept {
  const double* row = matrix_.data() + index * stride_;
  constexpr std::size_t lanes = 8;  // a fixed order of summation, whatever width the processor has
  double sums[lanes] = {};
  const std::size_t count = 3 * count_, whole = count / lanes * lanes;
  for (std::size_t j = 0; j < whole; j += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) sums[lane] += row[j + lane] * forces[j + lane];
  }
  for (std::size_t j = whole; j < count; ++j) sums[j - whole] += row[j] * forces[j];
  return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

}  // namespace bodkin
