#include "views/slice_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bodkin::views {

namespace {

// The continuous index of a pixel is affine in its column and row: three vectors instead of a rotation per pixel.
struct IndexSteps {
  Vec3 first, column, row, depth;

  IndexSteps(const imaging::SlicePlane& plane, const anatomy::Grid& grid)
      : first(grid.to_index(plane.corner)),
        column(grid.to_index(plane.corner + plane.pixel * plane.right) - first),
        row(grid.to_index(plane.corner + plane.pixel * plane.down) - first),
        depth(grid.to_index(plane.corner + plane.normal()) - first) {}
};

// Trilinear at a continuous index; at the border and beyond as anatomy::linear_at_index. Most pixels lie inside,
// where eight neighbours exist and no axis needs a check.
double value_at(const anatomy::CtVolume& ct, const Vec3& index) {
  const std::array<int, 3>& size = ct.grid.size;
  const double x = index.x(), y = index.y(), z = index.z();
  const bool inside = x >= 0.0 && y >= 0.0 && z >= 0.0 && x < size[0] - 1 && y < size[1] - 1 && z < size[2] - 1;
  if (!inside) return anatomy::linear_at_index(ct, index, std::numeric_limits<double>::quiet_NaN());
  const int i = static_cast<int>(x), j = static_cast<int>(y), k = static_cast<int>(z);
  const auto u = static_cast<float>(x - i), v = static_cast<float>(y - j), w = static_cast<float>(z - k);
  const std::size_t row = static_cast<std::size_t>(size[0]), layer = row * static_cast<std::size_t>(size[1]);
  const std::int16_t* first = ct.voxels.data() + ct.grid.offset(i, j, k);
  const auto along = [&](const std::int16_t* at) {
    const auto a = static_cast<float>(at[0]);
    return a + u * (static_cast<float>(at[1]) - a);
  };
  const auto across = [&](const std::int16_t* at) {
    const float a = along(at);
    return a + v * (along(at + row) - a);
  };
  const float a = across(first);
  return static_cast<double>(a + w * (across(first + layer) - a));
}

bool shows_itself(anatomy::TissueId id) {
  namespace t = anatomy::tissue;
  return id == t::air || id == t::skin || id == t::fat || id == t::muscle || id == t::soft ||
         id == t::cortical_bone || id == t::cancellous_bone || id == t::lung || id == t::gas || id == t::metal;
}

// `within`: 0 to 1 between the eight voxels, which are in the order of memory.
Tint weighted_mean(const std::array<anatomy::TissueId, 8>& ids, const std::array<Tint, 256>& tints,
                   const Vec3& within) {
  std::array<double, 4> channels{};
  for (std::size_t corner = 0; corner < ids.size(); ++corner) {
    const Tint tint = tints[ids[corner]];
    if (tint == 0U) continue;
    const double weight = ((corner & 1U) != 0 ? within.x() : 1.0 - within.x()) *
                          ((corner & 2U) != 0 ? within.y() : 1.0 - within.y()) *
                          ((corner & 4U) != 0 ? within.z() : 1.0 - within.z());
    for (unsigned channel = 0; channel < 4; ++channel) channels[channel] += weight * (tint >> 8 * channel & 0xFF);
  }
  Tint mean = 0;
  for (unsigned channel = 0; channel < 4; ++channel) {
    mean |= static_cast<Tint>(channels[channel] + 0.5) << 8 * channel;
  }
  return mean;
}

}  // namespace

void sample_hounsfield(const imaging::SlicePlane& plane, const anatomy::CtVolume& ct, const Slab& slab,
                       std::vector<float>& hounsfield) {
  constexpr float outside = std::numeric_limits<float>::quiet_NaN();
  const IndexSteps steps(plane, ct.grid);
  const int samples = 1 + static_cast<int>(std::ceil(std::max(0.0, slab.thickness)));
  hounsfield.resize(static_cast<std::size_t>(plane.width) * static_cast<std::size_t>(plane.height));
  float* pixel = hounsfield.data();
  for (int row = 0; row < plane.height; ++row) {
    for (int column = 0; column < plane.width; ++column, ++pixel) {
      const Vec3 middle = steps.first + column * steps.column + row * steps.row;
      if (samples == 1) {
        *pixel = static_cast<float>(value_at(ct, middle));
        continue;
      }
      double sum = 0.0, most = -std::numeric_limits<double>::infinity();
      int inside = 0;
      for (int sample = 0; sample < samples; ++sample) {
        const double along = slab.thickness * (static_cast<double>(sample) / (samples - 1) - 0.5);
        const double value = value_at(ct, Vec3(middle + along * steps.depth));
        if (std::isnan(value)) continue;
        sum += value;
        most = std::max(most, value);
        ++inside;
      }
      *pixel = inside == 0 ? outside : static_cast<float>(slab.kind == SlabKind::mean ? sum / inside : most);
    }
  }
}

void sample_typical_hounsfield(const imaging::SlicePlane& plane, const anatomy::TissueVolume& tissues,
                               const anatomy::TissueLibrary& library, std::vector<float>& hounsfield) {
  const std::array<double, 256> typical = library.by_id(&anatomy::TissueProperties::hounsfield, -1000.0);
  const IndexSteps steps(plane, tissues.grid);
  hounsfield.resize(static_cast<std::size_t>(plane.width) * static_cast<std::size_t>(plane.height));
  float* pixel = hounsfield.data();
  for (int row = 0; row < plane.height; ++row) {
    for (int column = 0; column < plane.width; ++column, ++pixel) {
      const Vec3 index = steps.first + column * steps.column + row * steps.row;
      const anatomy::TissueId id = anatomy::nearest_at_index(tissues, index, imaging::Slice::outside);
      *pixel =
          id == imaging::Slice::outside ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(typical[id]);
    }
  }
}

std::array<Tint, 256> tissue_tints(const std::array<std::uint32_t, 256>& colours, double opacity) {
  std::array<Tint, 256> tints{};
  const auto alpha = static_cast<std::uint32_t>(std::lround(255.0 * std::clamp(opacity, 0.0, 1.0)));
  for (std::size_t id = 0; id < tints.size(); ++id) {
    if (shows_itself(static_cast<anatomy::TissueId>(id)) || id == imaging::Slice::outside) continue;
    const auto channel = [&](unsigned shift) { return ((colours[id] >> shift & 0xFF) * alpha + 127) / 255 << shift; };
    tints[id] = alpha << 24 | channel(16) | channel(8) | channel(0);
  }
  return tints;
}

void sample_tints(const imaging::SlicePlane& plane, const anatomy::TissueVolume& tissues,
                  const std::array<Tint, 256>& tints, std::vector<Tint>& pixels) {
  const IndexSteps steps(plane, tissues.grid);
  const std::array<int, 3>& size = tissues.grid.size;
  const std::size_t row_step = static_cast<std::size_t>(size[0]),
                    layer_step = row_step * static_cast<std::size_t>(size[1]);
  pixels.assign(static_cast<std::size_t>(plane.width) * static_cast<std::size_t>(plane.height), 0U);
  Tint* pixel = pixels.data();
  for (int row = 0; row < plane.height; ++row) {
    for (int column = 0; column < plane.width; ++column, ++pixel) {
      const Vec3 index = steps.first + column * steps.column + row * steps.row;
      const int i = static_cast<int>(std::floor(index.x())), j = static_cast<int>(std::floor(index.y())),
                k = static_cast<int>(std::floor(index.z()));
      if (i < 0 || j < 0 || k < 0 || i + 1 >= size[0] || j + 1 >= size[1] || k + 1 >= size[2]) continue;
      const anatomy::TissueId* first = tissues.voxels.data() + tissues.grid.offset(i, j, k);
      const std::array<anatomy::TissueId, 8> ids = {first[0],
                                                    first[1],
                                                    first[row_step],
                                                    first[row_step + 1],
                                                    first[layer_step],
                                                    first[layer_step + 1],
                                                    first[layer_step + row_step],
                                                    first[layer_step + row_step + 1]};
      if (std::all_of(ids.begin() + 1, ids.end(), [&](anatomy::TissueId id) { return id == ids[0]; })) {
        *pixel = tints[ids[0]];  // within a tissue, as most are
        continue;
      }
      *pixel = weighted_mean(ids, tints, index - Vec3(i, j, k));
    }
  }
}

ForbiddenPlaces::ForbiddenPlaces(const anatomy::Case& patient) : patient_(patient) {
  for (const anatomy::Structure& structure : patient.description.structures) {
    if (!structure.critical) continue;
    if (critical_.size() <= structure.label) critical_.resize(structure.label + std::size_t{1});
    critical_[structure.label] = true;
  }
}

bool ForbiddenPlaces::holds(const Vec3& point) const {
  const anatomy::TissueId tissue = anatomy::nearest(patient_.tissues, point, imaging::Slice::outside);
  namespace t = anatomy::tissue;
  if (tissue == t::nerve || tissue == t::spinal_cord || tissue == t::vessel) return true;
  if (critical_.empty() || patient_.structures.empty()) return false;
  const std::uint16_t label = anatomy::nearest(patient_.structures, point, std::uint16_t{0});
  return label < critical_.size() && critical_[label];
}

void sample_forbidden(const imaging::SlicePlane& plane, const ForbiddenPlaces& places,
                      std::vector<std::uint8_t>& forbidden) {
  const auto wide = static_cast<std::size_t>(plane.width);
  forbidden.resize(wide * static_cast<std::size_t>(plane.height));
  for (int row = 0; row < plane.height; ++row) {
    std::uint8_t* line = forbidden.data() + static_cast<std::size_t>(row) * wide;
    if (row % 2 != 0) {
      std::copy_n(line - wide, wide, line);
      continue;
    }
    for (int column = 0; column < plane.width; ++column) {
      line[column] = column % 2 != 0 ? line[column - 1]
                     : places.holds(plane.point(std::min(column + 0.5, plane.width - 1.0),
                                                std::min(row + 0.5, plane.height - 1.0)))
                         ? 1
                         : 0;
    }
  }
}

std::uint8_t grey_of(double hounsfield, double window, double level) {
  if (std::isnan(hounsfield)) return 0;
  const double share = (hounsfield - level) / std::max(window, 1.0) + 0.5;
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

}  // namespace bodkin::views
