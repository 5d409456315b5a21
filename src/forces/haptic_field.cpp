#include "forces/haptic_field.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/repeatable.h"
#include "forces/model_input.h"

namespace bodkin::forces {
namespace {

// Convolves the lines of `values` along one axis with `kernel` (odd length); the border value continues outwards.
void convolve(std::vector<float>& values, const std::array<int, 3>& size, int axis,
              const std::vector<float>& kernel) {
  const std::size_t stride[3] = {1, static_cast<std::size_t>(size[0]),
                                 static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1])};
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  const auto at = [&](int i) { return static_cast<std::size_t>(i); };
  const int length = size[at(axis)], radius = static_cast<int>(kernel.size() / 2);
  std::vector<float> line(at(length + 2 * radius));
  for (int ib = 0; ib < size[at(b)]; ++ib) {
    for (int ia = 0; ia < size[at(a)]; ++ia) {
      float* const first = values.data() + at(ia) * stride[a] + at(ib) * stride[b];
      for (int i = -radius; i < length + radius; ++i) {
        line[at(i + radius)] = first[at(std::clamp(i, 0, length - 1)) * stride[axis]];
      }
      for (int i = 0; i < length; ++i) {
        float sum = 0.0F;
        for (std::size_t tap = 0; tap < kernel.size(); ++tap) sum += kernel[tap] * line[at(i) + tap];
        first[at(i) * stride[axis]] = sum;
      }
    }
  }
}

}  // namespace

HapticField::HapticField(const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues,
                         const anatomy::TissueLibrary& library, const anatomy::HapticFieldSettings& settings)
    : tissues_(&tissues) {
  constexpr auto model = "volume_proxy";
  const auto value_of = library.by_id(&anatomy::TissueProperties::volume_proxy);
  check_tissues(library, &anatomy::TissueProperties::volume_proxy, model);
  check(settings, model);
  if (ct.empty() || tissues.empty()) {
    throw InputError("volume_proxy: the case has no CT or no tissues; this model needs both");
  }
  const anatomy::Grid& grid = tissues.grid;
  to_index_ = grid.spacing.cwiseInverse().asDiagonal() * grid.direction.transpose();
  to_patient_gradient_ = grid.direction * grid.spacing.cwiseInverse().asDiagonal();

  values_.resize(grid.voxel_count());
  std::transform(tissues.voxels.begin(), tissues.voxels.end(), values_.begin(),
                 [&](anatomy::TissueId id) { return static_cast<float>(value_of[id].field_value); });
  if (settings.smoothing > 0.0) smooth(settings.smoothing);

  const double low = settings.lowest_hounsfield, scale = settings.ct_range / (settings.highest_hounsfield - low);
  const auto add = [&](std::size_t voxel, double hounsfield) {
    values_[voxel] += static_cast<float>((std::clamp(hounsfield, low, settings.highest_hounsfield) - low) * scale);
  };
  if (anatomy::same_lattice(ct.grid, grid)) {
    for (std::size_t voxel = 0; voxel < values_.size(); ++voxel) add(voxel, ct.voxels[voxel]);
    return;
  }
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        add(grid.offset(i, j, k), anatomy::linear(ct, grid.to_patient(Vec3(i, j, k)), low));
      }
    }
  }
}

void HapticField::smooth(double sigma) {
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  std::vector<float> kernel;
  float sum = 0.0F;
  for (int i = -radius; i <= radius; ++i) {
    kernel.push_back(static_cast<float>(repeatable::exp(-0.5 * i * i / (sigma * sigma))));
    sum += kernel.back();
  }
  for (float& tap : kernel) tap /= sum;
  for (int axis = 0; axis < 3; ++axis) convolve(values_, tissues_->grid.size, axis, kernel);
}

FieldSample HapticField::sample(const Vec3& point) const noexcept {
  const anatomy::Grid& grid = tissues_->grid;
  const Vec3 index = to_index_ * (point - grid.origin);
  // Four neighbours along each axis, with the weights of the value (the inner two) and of the slope (central
  // differences at the inner two, interpolated between them).
  std::size_t offset[3][4];
  double value_weight[3][4], slope_weight[3][4];
  std::size_t stride = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const int size = grid.size[static_cast<std::size_t>(axis)], last = size - 1;
    const double x = index[axis];
    if (!(x >= -0.5 && x <= last + 0.5)) return {};
    const double clamped = std::clamp(x, 0.0, static_cast<double>(last));
    const int base = std::min(static_cast<int>(clamped), std::max(0, last - 1));
    const double f = clamped - base;
    for (int n = 0; n < 4; ++n) {
      offset[axis][n] = static_cast<std::size_t>(std::clamp(base + n - 1, 0, last)) * stride;
    }
    value_weight[axis][0] = value_weight[axis][3] = 0.0;
    value_weight[axis][1] = 1.0 - f;
    value_weight[axis][2] = f;
    slope_weight[axis][0] = -0.5 * (1.0 - f);
    slope_weight[axis][1] = -0.5 * f;
    slope_weight[axis][2] = 0.5 * (1.0 - f);
    slope_weight[axis][3] = 0.5 * f;
    stride *= static_cast<std::size_t>(size);
  }
  double value = 0.0, slope_i = 0.0, slope_j = 0.0, slope_k = 0.0;
  const double *wi = value_weight[0], *si = slope_weight[0];
  for (int k = 0; k < 4; ++k) {
    const bool inner_k = k == 1 || k == 2;
    for (int j = inner_k ? 0 : 1; j < (inner_k ? 4 : 3); ++j) {
      const float* const row = values_.data() + offset[2][k] + offset[1][j];
      const double one = static_cast<double>(row[offset[0][1]]), two = static_cast<double>(row[offset[0][2]]);
      const double mean = wi[1] * one + wi[2] * two;
      slope_j += slope_weight[1][j] * value_weight[2][k] * mean;
      slope_k += value_weight[1][j] * slope_weight[2][k] * mean;
      const double weight = value_weight[1][j] * value_weight[2][k];
      if (weight == 0.0) continue;
      value += weight * mean;
      slope_i += weight * (si[0] * static_cast<double>(row[offset[0][0]]) + si[1] * one + si[2] * two +
                           si[3] * static_cast<double>(row[offset[0][3]]));
    }
  }
  return {value, to_patient_gradient_ * Vec3(slope_i, slope_j, slope_k), true};
}

}  // namespace bodkin::forces
