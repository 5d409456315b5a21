#include "io/images/image_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::io {
namespace {

constexpr std::int16_t highest = 32767;
constexpr std::int16_t darkest_of_soft_tissue = -50;  // HU; fat is darker (-120 to -60), air and lung far darker

template <typename Voxel>
anatomy::Volume<Voxel> on_grid(const anatomy::Grid& grid, std::vector<Voxel>&& voxels) {
  anatomy::Volume<Voxel> volume;
  volume.grid = grid;
  volume.voxels = std::move(voxels);
  return volume;
}

// Applies `convert` to each voxel of `source`, on the same grid.
template <typename Target, typename Convert>
anatomy::Volume<Target> converted(ImageFile&& image, const Convert& convert) {
  anatomy::Volume<Target> result;
  result.grid = image.grid;
  std::visit(
      [&](auto& source) {
        result.voxels.resize(source.size());
        std::transform(source.begin(), source.end(), result.voxels.begin(), convert);
        source = {};
      },
      image.voxels);
  return result;
}

// In floating-point labels and tissues NaN can only mean "none", so it becomes 0.
template <typename Target>
anatomy::Volume<Target> whole_numbers(ImageFile&& image, const std::string& name, const char* what) {
  if (auto* same = std::get_if<std::vector<Target>>(&image.voxels)) return on_grid(image.grid, std::move(*same));
  constexpr double largest = std::numeric_limits<Target>::max();
  return converted<Target>(std::move(image), [&](auto value) {
    const auto number = static_cast<double>(value);
    if (std::isnan(number)) return Target{0};
    if (!(number >= 0.0 && number <= largest) || number != std::floor(number)) {
      throw InputError(
          fmt::format("{}: a voxel holds {}; expected {}, whole numbers from 0 to {}", name, number, what, largest));
    }
    return static_cast<Target>(number);
  });
}

}  // namespace

std::vector<std::string> HounsfieldLosses::notes() const {
  std::vector<std::string> result;
  if (largest_rounding > 0.0) {
    result.push_back(
        fmt::format("The CT's values were rounded to whole HU, by at most {:.2g} HU.", largest_rounding));
  }
  if (padded > 0) {
    result.push_back(fmt::format(
        "Values below -1024 HU (padding outside the scanned field; voxels: {}) were set to -1024 HU.", padded));
  }
  if (too_high > 0) {
    result.push_back(fmt::format("Values above 32767 HU (voxels: {}) were set to 32767 HU.", too_high));
  }
  if (not_numbers > 0) {
    result.push_back(fmt::format(
        "Values that were not a number (NaN, voxels: {}) are padding and were set to -1024 HU.", not_numbers));
  }
  return result;
}

std::int16_t to_hounsfield(double value, HounsfieldLosses& losses) {
  if (!std::isfinite(value)) {
    ++losses.not_numbers;
    return anatomy::lowest_hounsfield;
  }
  if (value < anatomy::lowest_hounsfield) {
    ++losses.padded;
    return anatomy::lowest_hounsfield;
  }
  if (value > highest) {
    ++losses.too_high;
    return highest;
  }
  const double whole = std::round(value);
  losses.largest_rounding = std::max(losses.largest_rounding, std::abs(value - whole));
  return static_cast<std::int16_t>(whole);
}

anatomy::CtVolume to_ct(ImageFile&& image, std::vector<std::string>& notes) {
  HounsfieldLosses losses;
  anatomy::CtVolume ct;
  if (auto* same = std::get_if<std::vector<std::int16_t>>(&image.voxels)) {
    ct = on_grid(image.grid, std::move(*same));
    for (std::int16_t& value : ct.voxels) {
      if (value < anatomy::lowest_hounsfield) value = to_hounsfield(value, losses);
    }
  } else {
    ct = converted<std::int16_t>(std::move(image),
                                 [&](auto value) { return to_hounsfield(static_cast<double>(value), losses); });
  }
  const std::vector<std::string> lost = losses.notes();
  notes.insert(notes.end(), lost.begin(), lost.end());
  return ct;
}

anatomy::LabelVolume to_labels(ImageFile&& image, const std::string& name) {
  return whole_numbers<std::uint16_t>(std::move(image), name, "labels");
}

anatomy::LabelVolume to_labels(anatomy::CtVolume&& image, const std::string& name) {
  return to_labels(ImageFile{image.grid, std::move(image.voxels)}, name);
}

anatomy::TissueVolume to_tissues(ImageFile&& image, const std::string& name) {
  return whole_numbers<std::uint8_t>(std::move(image), name, "tissue numbers");
}

void require_hounsfield(const anatomy::CtVolume& ct, const std::string& name) {
  const auto [least, most] = std::minmax_element(ct.voxels.begin(), ct.voxels.end());
  if (least == ct.voxels.end() || *least < darkest_of_soft_tissue) return;
  throw InputError(
      fmt::format("{}: the values run from {} to {} and are not HU, in which air is -1000 and fat about -100; "
                  "give the original CT, or say --assume-hu to take them as they are",
                  name, *least, *most));
}

}  // namespace bodkin::io
