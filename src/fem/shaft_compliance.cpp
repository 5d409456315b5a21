#include "fem/shaft_compliance.h"

#include <array>

#include "fem/upper_triangular.h"

namespace bodkin::fem {

namespace {

constexpr std::size_t nodes_ahead = 8;  // whose blocks are requested while earlier ones are turned

}  // namespace

ShaftCompliance::ShaftCompliance(const Eigen::MatrixXd& compliance, std::size_t most_nodes)
    : compliance_(&compliance),
      most_nodes_(most_nodes),
      stride_(upper_triangular::padded(3 * most_nodes)),
      rows_(3 * most_nodes * stride_, 0.0),
      nodes_(most_nodes, 0) {}

void ShaftCompliance::begin(const Mat3& frame) noexcept {
  count_ = 0;
  frame_ = frame;
}

bool ShaftCompliance::push(std::uint32_t node) noexcept {
  const auto place = static_cast<Eigen::Index>(3) * static_cast<Eigen::Index>(node);
  if (count_ == most_nodes_ || place + 3 > compliance_->rows()) return false;
  const std::size_t added = count_++;
  nodes_[added] = node;
  const auto at = [this](std::size_t i) {
    return static_cast<Eigen::Index>(3) * static_cast<Eigen::Index>(nodes_[i]);
  };
  for (std::size_t i = 0; i <= added; ++i) {
    if (i + nodes_ahead <= added) {
      for (Eigen::Index a = 0; a < 3; ++a) __builtin_prefetch(&(*compliance_)(at(i + nodes_ahead), place + a));
    }
    // Of i by forces at `added`; transposed, of `added` by forces at i.
    const Mat3 between = frame_.transpose() * compliance_->block<3, 3>(at(i), place) * frame_;
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t d = 0; d < 3; ++d) {
        rows_[(3 * added + c) * stride_ + 3 * i + d] =
            between(static_cast<Eigen::Index>(d), static_cast<Eigen::Index>(c));
      }
    }
  }
  return true;
}

Vec3 ShaftCompliance::displacement(std::size_t index, std::span<const double> forces) const noexcept {
  Vec3 sum;
  for (std::size_t c = 0; c < 3; ++c) {
    sum(static_cast<Eigen::Index>(c)) = upper_triangular::product(row(index, c), forces.data(), 3 * index + 3);
  }
  for (std::size_t j = index + 1; j < count_; ++j) {
    for (std::size_t d = 0; d < 3; ++d) {
      const double force = forces[3 * j + d];
      for (std::size_t c = 0; c < 3; ++c) sum(static_cast<Eigen::Index>(c)) += row(j, d)[3 * index + c] * force;
    }
  }
  return sum;
}

// Each row is traversed once: below the diagonal as it is, above it transposed.
void ShaftCompliance::displace(std::span<const double> forces, std::span<double> displacements) const noexcept {
  double* const sum = displacements.data();
  for (std::size_t i = 0; i < count_; ++i) {
    // Up to seven numbers behind the diagonal are added too, and overwritten below.
    const std::array<const double*, 3> rows{row(i, 0), row(i, 1), row(i, 2)};
    upper_triangular::add_rows(rows.data(), forces.data() + 3 * i, 3, sum, 3 * i);
    for (std::size_t c = 0; c < 3; ++c) sum[3 * i + c] = upper_triangular::product(rows[c], forces.data(), 3 * i + 3);
  }
}

}  // namespace bodkin::fem
