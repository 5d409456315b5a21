#include "patient/from_ct/label_filters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <itkBinaryThresholdImageFilter.h>
#include <itkConnectedThresholdImageFilter.h>
#include <itkImage.h>
#include <itkSignedMaurerDistanceMapImageFilter.h>
#include <itkSmoothingRecursiveGaussianImageFilter.h>

#include "core/error.h"

namespace bodkin::patient {
namespace {

using CtImage3 = itk::Image<std::int16_t, 3>;
using ByteImage3 = itk::Image<std::uint8_t, 3>;
using FloatImage3 = itk::Image<float, 3>;
using ByteImage2 = itk::Image<std::uint8_t, 2>;
using FloatImage2 = itk::Image<float, 2>;

template <typename Image>
typename Image::Pointer blank_image(const std::array<int, 3>& size, const Vec3& spacing) {
  auto image = Image::New();
  typename Image::SizeType sizes;
  typename Image::SpacingType spacings;
  for (unsigned axis = 0; axis < 3; ++axis) {
    sizes[axis] = static_cast<itk::SizeValueType>(size[axis]);
    spacings[axis] = spacing[static_cast<int>(axis)];
  }
  image->SetRegions(typename Image::RegionType(sizes));
  image->SetSpacing(spacings);
  image->Allocate();
  return image;
}

void require_range(const anatomy::Grid& grid, int low, int high, const SegmentReach& within) {
  if (low > high)
    throw InputError(
        fmt::format("the range begins at {} HU and ends at {} HU; expected the lower one first", low, high));
  if (!grid.contains(within.seed[0], within.seed[1], within.seed[2]))
    throw InputError("the place that was chosen lies outside of the image; choose one inside");
}

// Voxels beyond the reach contribute nothing.
template <typename Visit>
void for_each_outside(const anatomy::Grid& grid, const SegmentReach& within, const Visit& visit) {
  if (!(within.reach > 0.0)) return;
  std::size_t offset = 0;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i, ++offset) {
        const Vec3 away = grid.spacing.cwiseProduct(
            Vec3(i - within.seed[0], j - within.seed[1], k - within.seed[2]));  // the axes are orthonormal
        if (away.squaredNorm() > within.reach * within.reach) visit(offset);
      }
    }
  }
}

MaskVolume mask_from(const ByteImage3& image, const anatomy::Grid& grid) {
  MaskVolume mask;
  mask.grid = grid;
  mask.voxels.assign(image.GetBufferPointer(), image.GetBufferPointer() + grid.voxel_count());
  return mask;
}

CtImage3::Pointer image_of(const anatomy::CtVolume& ct) {
  auto image = blank_image<CtImage3>(ct.grid.size, ct.grid.spacing);
  std::copy(ct.voxels.begin(), ct.voxels.end(), image->GetBufferPointer());
  return image;
}

// First and last set voxel along each axis; low above high if none is set.
struct MaskBox {
  std::array<int, 3> low = {std::numeric_limits<int>::max(), std::numeric_limits<int>::max(),
                            std::numeric_limits<int>::max()};
  std::array<int, 3> high = {-1, -1, -1};
  bool empty() const { return high[0] < 0; }
};

MaskBox box_of(const MaskVolume& mask) {
  MaskBox box;
  std::size_t offset = 0;
  for (int k = 0; k < mask.grid.size[2]; ++k) {
    for (int j = 0; j < mask.grid.size[1]; ++j) {
      for (int i = 0; i < mask.grid.size[0]; ++i, ++offset) {
        if (mask.voxels[offset] == 0) continue;
        const std::array<int, 3> at = {i, j, k};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          box.low[axis] = std::min(box.low[axis], at[axis]);
          box.high[axis] = std::max(box.high[axis], at[axis]);
        }
      }
    }
  }
  return box;
}

// One slice of a mask across an axis, cropped to its contents with a voxel of margin.
class SliceDistances {
 public:
  SliceDistances(const MaskVolume& mask, int axis, const MaskBox& box)
      : mask_(mask), axis_(axis), u_((axis + 1) % 3), v_((axis + 2) % 3) {
    for (const int each : {u_, v_}) {
      const auto i = static_cast<std::size_t>(each);
      from_[i] = std::max(0, box.low[i] - 1);
      to_[i] = std::min(mask.grid.size[i] - 1, box.high[i] + 1);
    }
    columns_ = to_[static_cast<std::size_t>(u_)] - from_[static_cast<std::size_t>(u_)] + 1;
    rows_ = to_[static_cast<std::size_t>(v_)] - from_[static_cast<std::size_t>(v_)] + 1;
  }

  std::size_t pixels() const { return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_); }
  // Index in the mask of pixel `pixel` of slice `slice`.
  std::size_t offset(int slice, std::size_t pixel) const {
    std::array<int, 3> at{};
    at[static_cast<std::size_t>(axis_)] = slice;
    at[static_cast<std::size_t>(u_)] =
        from_[static_cast<std::size_t>(u_)] + static_cast<int>(pixel % static_cast<std::size_t>(columns_));
    at[static_cast<std::size_t>(v_)] =
        from_[static_cast<std::size_t>(v_)] + static_cast<int>(pixel / static_cast<std::size_t>(columns_));
    return mask_.grid.offset(at[0], at[1], at[2]);
  }
  bool holds(int slice) const {
    for (std::size_t pixel = 0; pixel < pixels(); ++pixel) {
      if (mask_.voxels[offset(slice, pixel)] != 0) return true;
    }
    return false;
  }
  // Signed distances, mm, negative inside.
  std::vector<float> distances(int slice) const {
    auto image = ByteImage2::New();
    ByteImage2::SizeType size;
    size[0] = static_cast<itk::SizeValueType>(columns_) + 2;  // so that an outline at the edge is closed
    size[1] = static_cast<itk::SizeValueType>(rows_) + 2;
    ByteImage2::SpacingType spacing;
    spacing[0] = mask_.grid.spacing[u_];
    spacing[1] = mask_.grid.spacing[v_];
    image->SetRegions(ByteImage2::RegionType(size));
    image->SetSpacing(spacing);
    image->Allocate(true);
    const auto place = [&](std::size_t pixel) {
      return (pixel / static_cast<std::size_t>(columns_) + 1) * size[0] + pixel % static_cast<std::size_t>(columns_) +
             1;
    };
    for (std::size_t pixel = 0; pixel < pixels(); ++pixel)
      image->GetBufferPointer()[place(pixel)] = mask_.voxels[offset(slice, pixel)];
    auto filter = itk::SignedMaurerDistanceMapImageFilter<ByteImage2, FloatImage2>::New();
    filter->SetInput(image);
    filter->SetUseImageSpacing(true);
    filter->SetSquaredDistance(false);
    filter->SetInsideIsPositive(false);
    filter->Update();
    std::vector<float> result(pixels());
    for (std::size_t pixel = 0; pixel < pixels(); ++pixel)
      result[pixel] = filter->GetOutput()->GetBufferPointer()[place(pixel)];
    return result;
  }

 private:
  const MaskVolume& mask_;
  int axis_, u_, v_;
  std::array<int, 3> from_{}, to_{};
  int columns_ = 0, rows_ = 0;
};

}  // namespace

MaskVolume threshold_region(const anatomy::CtVolume& ct, int low, int high, const SegmentReach& within) {
  require_range(ct.grid, low, high, within);
  auto filter = itk::BinaryThresholdImageFilter<CtImage3, ByteImage3>::New();
  filter->SetInput(image_of(ct));
  filter->SetLowerThreshold(static_cast<std::int16_t>(std::clamp(low, -32768, 32767)));
  filter->SetUpperThreshold(static_cast<std::int16_t>(std::clamp(high, -32768, 32767)));
  filter->SetInsideValue(1);
  filter->SetOutsideValue(0);
  filter->Update();
  MaskVolume mask = mask_from(*filter->GetOutput(), ct.grid);
  for_each_outside(ct.grid, within, [&mask](std::size_t offset) { mask.voxels[offset] = 0; });
  return mask;
}

MaskVolume grown_region(const anatomy::CtVolume& ct, int low, int high, const SegmentReach& from) {
  require_range(ct.grid, low, high, from);
  const int value = ct.at(from.seed[0], from.seed[1], from.seed[2]);
  if (value < low || value > high) {
    throw InputError(
        fmt::format("the place that was clicked has {} HU, outside of the range from {} to {} HU; click "
                    "inside the structure, or widen the range",
                    value, low, high));
  }
  const std::int16_t lowest = static_cast<std::int16_t>(std::clamp(low, -32767, 32767));
  auto image = image_of(ct);
  for_each_outside(ct.grid, from, [&](std::size_t offset) {
    image->GetBufferPointer()[offset] = static_cast<std::int16_t>(lowest - 1);
  });
  auto filter = itk::ConnectedThresholdImageFilter<CtImage3, ByteImage3>::New();
  filter->SetInput(image);
  filter->SetLower(lowest);
  filter->SetUpper(static_cast<std::int16_t>(std::clamp(high, -32767, 32767)));
  filter->SetReplaceValue(1);
  CtImage3::IndexType seed;
  for (unsigned axis = 0; axis < 3; ++axis) seed[axis] = from.seed[axis];
  filter->AddSeed(seed);
  filter->Update();
  return mask_from(*filter->GetOutput(), ct.grid);
}

MaskVolume filled_between_slices(const MaskVolume& mask, int axis) {
  if (axis < 0 || axis > 2) throw InputError(fmt::format("the axis is {}; expected 0 to 2", axis));
  const MaskBox box = box_of(mask);
  MaskVolume filled = mask;
  int before = -1, known = 0;
  if (!box.empty()) {
    const SliceDistances slices(mask, axis, box);
    std::vector<float> distances_before;
    const auto a = static_cast<std::size_t>(axis);
    for (int slice = box.low[a]; slice <= box.high[a]; ++slice) {
      if (!slices.holds(slice)) continue;
      ++known;
      std::vector<float> here = slices.distances(slice);
      for (int between = before + 1; before >= 0 && between < slice; ++between) {
        const float share = static_cast<float>(between - before) / static_cast<float>(slice - before);
        for (std::size_t pixel = 0; pixel < slices.pixels(); ++pixel) {
          const float distance = (1.0F - share) * distances_before[pixel] + share * here[pixel];
          if (distance <= 0.0F) filled.voxels[slices.offset(between, pixel)] = 1;
        }
      }
      distances_before = std::move(here);
      before = slice;
    }
  }
  if (known < 2) throw InputError("there are no two slices to fill between; paint the structure in two slices first");
  return filled;
}

MaskVolume smoothed(const MaskVolume& mask, double radius) {
  if (!(radius > 0.0 && radius <= 50.0))
    throw InputError(fmt::format("the radius is {} mm; expected above 0, at most 50", radius));
  MaskBox box = box_of(mask);
  MaskVolume smooth(mask.grid);
  if (box.empty()) return smooth;
  std::array<int, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int margin =
        std::max(4, static_cast<int>(std::ceil(4.0 * radius / mask.grid.spacing[static_cast<int>(axis)])));
    box.low[axis] = std::max(0, box.low[axis] - margin);
    box.high[axis] = std::min(mask.grid.size[axis] - 1, box.high[axis] + margin);
    size[axis] = box.high[axis] - box.low[axis] + 1;
    if (size[axis] < 4) throw InputError("the image is thinner than four voxels and cannot be smoothed");
  }
  auto image = blank_image<FloatImage3>(size, mask.grid.spacing);
  const auto visit = [&](const auto& at_voxel) {
    std::size_t place = 0;
    for (int k = box.low[2]; k <= box.high[2]; ++k) {
      for (int j = box.low[1]; j <= box.high[1]; ++j) {
        for (int i = box.low[0]; i <= box.high[0]; ++i) at_voxel(place++, mask.grid.offset(i, j, k));
      }
    }
  };
  visit([&](std::size_t place, std::size_t offset) { image->GetBufferPointer()[place] = mask.voxels[offset]; });
  auto filter = itk::SmoothingRecursiveGaussianImageFilter<FloatImage3, FloatImage3>::New();
  filter->SetInput(image);
  filter->SetSigma(radius);
  filter->Update();
  const float* const blurred = filter->GetOutput()->GetBufferPointer();
  visit([&](std::size_t place, std::size_t offset) { smooth.voxels[offset] = blurred[place] >= 0.5F ? 1 : 0; });
  return smooth;
}

}  // namespace bodkin::patient
