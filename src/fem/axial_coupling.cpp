#include "fem/axial_coupling.h"

#include "fem/processor_clones.h"

namespace bodkin {

namespace {

BODKIN_PROCESSOR_CLONES
void add_scaled(const double* __restrict row, double factor, std::size_t count, double* __restrict sum) noexcept {
  for (std::size_t j = 0; j < count; ++j) sum[j] += row[j] * factor;
}

// Eight partial sums in a fixed order, whatever width the processor has.
BODKIN_PROCESSOR_CLONES
double product(const double* a, const double* b, std::size_t count) noexcept {
  using Lanes [[gnu::aligned(8), gnu::may_alias]] = double __attribute__((vector_size(32)));
  Lanes even = {}, odd = {};
  std::size_t j = 0;
  for (; j + 8 <= count; j += 8) {
    even += *reinterpret_cast<const Lanes*>(a + j) * *reinterpret_cast<const Lanes*>(b + j);
    odd += *reinterpret_cast<const Lanes*>(a + j + 4) * *reinterpret_cast<const Lanes*>(b + j + 4);
  }
  double rest = 0.0;
  for (; j < count; ++j) rest += a[j] * b[j];
  const Lanes sum = even + odd;
  return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + rest;
}

}  // namespace

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
  add_scaled(matrix_.data() + index * stride_, load, 3 * count_, displacements.data());
}

double AxialCoupling::displacement(std::size_t index, std::span<const double> forces) const noexcept {
  return product(matrix_.data() + index * stride_, forces.data(), 3 * count_);
}

}  // namespace bodkin
