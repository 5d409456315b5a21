#include "imaging/volume_rendering/prepared_volume.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/parallel_for.h"

namespace bodkin::imaging {

namespace {

constexpr float half_of_byte = 60.0F;  // HU/mm, see gradient_byte()

anatomy::CtVolume typical_hounsfield(const anatomy::TissueVolume& tissues, const anatomy::TissueLibrary& library) {
  std::array<double, 256> typical = library.by_id(&anatomy::TissueProperties::hounsfield, -1000.0);
  typical[anatomy::tissue::air] = -1000.0;
  anatomy::CtVolume ct(tissues.grid);
  std::transform(tissues.voxels.begin(), tissues.voxels.end(), ct.voxels.begin(), [&](anatomy::TissueId id) {
    return static_cast<std::int16_t>(std::clamp(typical[id], -1024.0, 3071.0));
  });
  return ct;
}

// Means of `by` voxels along each axis.
anatomy::CtVolume coarser(const anatomy::CtVolume& ct, const std::array<int, 3>& by) {
  anatomy::Grid grid = ct.grid;
  Vec3 middle_of_first;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    grid.size[a] = std::max(ct.grid.size[a] / by[a], 1);
    grid.spacing[axis] = ct.grid.spacing[axis] * by[a];
    middle_of_first[axis] = 0.5 * (by[a] - 1);
  }
  grid.origin = ct.grid.to_patient(middle_of_first);
  anatomy::CtVolume made(grid);
  parallel_for(grid.size[2], [&](int k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        int sum = 0, count = 0;
        for (int c = k * by[2]; c < std::min((k + 1) * by[2], ct.grid.size[2]); ++c) {
          for (int b = j * by[1]; b < std::min((j + 1) * by[1], ct.grid.size[1]); ++b) {
            for (int a = i * by[0]; a < std::min((i + 1) * by[0], ct.grid.size[0]); ++a, ++count)
              sum += ct.at(a, b, c);
          }
        }
        made.at(i, j, k) = static_cast<std::int16_t>(std::lround(static_cast<double>(sum) / count));
      }
    }
  });
  return made;
}

std::array<int, 3> coarsening(const anatomy::Grid& grid, std::size_t most_voxels) {
  std::array<int, 3> by = {1, 1, 1};
  const auto count = [&] {
    double voxels = 1.0;
    for (std::size_t a = 0; a < 3; ++a) voxels *= std::max(grid.size[a] / by[a], 1);
    return voxels;
  };
  while (count() > static_cast<double>(most_voxels)) {
    std::size_t finest = 0;
    for (std::size_t a = 1; a < 3; ++a) {
      if (grid.spacing[static_cast<int>(a)] * by[a] < grid.spacing[static_cast<int>(finest)] * by[finest]) finest = a;
    }
    ++by[finest];
  }
  return by;
}

// HU with the border, row by row, limited to the scale. Tissues too.
std::vector<std::int16_t> fill_voxels(PreparedVolume& made, const anatomy::CtVolume& ct,
                                      const anatomy::TissueVolume& tissues) {
  const std::size_t all = static_cast<std::size_t>(made.size[0]) * static_cast<std::size_t>(made.size[1]) *
                          static_cast<std::size_t>(made.size[2]);
  std::vector<std::int16_t> hounsfield(all);
  made.tissues.resize(tissues.empty() ? 0 : all);
  // The tissue map has a separate lattice. Along i it is traversed in steps.
  const Vec3 step = tissues.empty() ? Vec3(Vec3::Zero())
                                    : Vec3(tissues.grid.to_index(made.grid.to_patient(Vec3::UnitX())) -
                                           tissues.grid.to_index(made.grid.to_patient(Vec3::Zero())));
  parallel_for(made.size[2], [&](int k) {
    const int from_k = std::clamp(k - 1, 0, made.grid.size[2] - 1);
    for (int j = 0; j < made.size[1]; ++j) {
      const int from_j = std::clamp(j - 1, 0, made.grid.size[1] - 1);
      const std::size_t row =
          static_cast<std::size_t>(made.size[0]) *
          (static_cast<std::size_t>(j) + static_cast<std::size_t>(made.size[1]) * static_cast<std::size_t>(k));
      const std::int16_t* const source = &ct.voxels[made.grid.offset(0, from_j, from_k)];
      for (int i = 0; i < made.size[0]; ++i) {
        hounsfield[row + static_cast<std::size_t>(i)] = std::clamp<std::int16_t>(
            source[std::clamp(i - 1, 0, made.grid.size[0] - 1)], anatomy::lowest_hounsfield, 3071);
      }
      if (tissues.empty()) continue;
      Vec3 index = tissues.grid.to_index(made.grid.to_patient(Vec3(0, from_j, from_k)));
      const Vec3 first = index;
      for (int i = 0; i < made.size[0]; ++i) {
        index = first + std::clamp(i - 1, 0, made.grid.size[0] - 1) * step;
        made.tissues[row + static_cast<std::size_t>(i)] =
            anatomy::nearest_at_index(tissues, index, anatomy::tissue::air);
      }
    }
  });
  return hounsfield;
}

// From row by row to bricks; beyond the border the outermost voxels are repeated.
template <typename Value>
void fill_bricks(const PreparedVolume& made, const std::vector<Value>& rows, LargePageVector<Value>& bricks) {
  constexpr int side = PreparedVolume::brick_side, block = PreparedVolume::block;
  bricks.resize(made.ranges.size() * static_cast<std::size_t>(PreparedVolume::brick_size));
  parallel_for(made.blocks[2], [&](int c) {
    for (int b = 0; b < made.blocks[1]; ++b) {
      for (int a = 0; a < made.blocks[0]; ++a) {
        Value* to = bricks.data() + made.offset(a * block, b * block, c * block);
        for (int k = c * block; k < c * block + side; ++k) {
          for (int j = b * block; j < b * block + side; ++j) {
            const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(std::min(k, made.size[2] - 1)) * made.size[1] +
                                       std::min(j, made.size[1] - 1);
            const Value* const from = rows.data() + row * made.size[0];
            for (int i = a * block; i < a * block + side; ++i) *to++ = from[std::min(i, made.size[0] - 1)];
          }
        }
      }
    }
  });
}

// Gradients of the HU after smoothing by (1 2 1) / 4 along every axis, which removes most of a CT's noise.
void fill_gradients(PreparedVolume& made, std::vector<std::int16_t> smooth) {
  const std::ptrdiff_t nx = made.size[0], ny = made.size[1], nz = made.size[2];
  std::vector<std::int16_t> other(smooth.size());
  for (int axis = 0; axis < 3; ++axis) {
    const std::ptrdiff_t stride = axis == 0 ? 1 : axis == 1 ? nx : nx * ny;
    parallel_for(nz, [&](std::ptrdiff_t k) {
      for (std::ptrdiff_t j = 0; j < ny; ++j) {
        const std::ptrdiff_t along = axis == 1 ? j : k, last = (axis == 1 ? ny : nz) - 1;
        const std::int16_t* const in = smooth.data() + (k * ny + j) * nx;
        std::int16_t* const out = other.data() + (k * ny + j) * nx;
        if (axis == 0) {
          out[0] = in[0];
          out[nx - 1] = in[nx - 1];
          for (std::ptrdiff_t i = 1; i < nx - 1; ++i) {
            out[i] = static_cast<std::int16_t>((in[i - 1] + 2 * in[i] + in[i + 1]) / 4);
          }
        } else {
          const std::ptrdiff_t before = along > 0 ? -stride : 0, after = along < last ? stride : 0;
          for (std::ptrdiff_t i = 0; i < nx; ++i) {
            out[i] = static_cast<std::int16_t>((in[i + before] + 2 * in[i] + in[i + after]) / 4);
          }
        }
      }
    });
    smooth.swap(other);
  }
  std::vector<std::array<std::int8_t, 4>> gradients(smooth.size());
  const Eigen::Vector3f scale = (0.5 * made.grid.spacing.cwiseInverse()).cast<float>();
  parallel_for(nz, [&](std::ptrdiff_t k) {
    const std::ptrdiff_t below = k > 0 ? -nx * ny : 0, above = k < nz - 1 ? nx * ny : 0;
    for (std::ptrdiff_t j = 0; j < ny; ++j) {
      const std::ptrdiff_t before = j > 0 ? -nx : 0, after = j < ny - 1 ? nx : 0;
      const std::ptrdiff_t row = (k * ny + j) * nx;
      for (std::ptrdiff_t i = 0; i < nx; ++i) {
        const std::int16_t* const at = smooth.data() + row + i;
        const Eigen::Vector3f difference(static_cast<float>(at[i < nx - 1 ? 1 : 0] - at[i > 0 ? -1 : 0]),
                                         static_cast<float>(at[after] - at[before]),
                                         static_cast<float>(at[above] - at[below]));
        gradients[static_cast<std::size_t>(row + i)] = gradient_byte(difference.cwiseProduct(scale));
      }
    }
  });
  fill_bricks(made, gradients, made.gradients);
}

void fill_blocks(PreparedVolume& made, const std::vector<std::int16_t>& hounsfield) {
  for (std::size_t a = 0; a < 3; ++a)
    made.blocks[a] = (made.size[a] + PreparedVolume::block - 1) / PreparedVolume::block;
  made.ranges.resize(static_cast<std::size_t>(made.blocks[0]) * static_cast<std::size_t>(made.blocks[1]) *
                     static_cast<std::size_t>(made.blocks[2]));
  parallel_for(made.blocks[2], [&](int c) {
    for (int b = 0; b < made.blocks[1]; ++b) {
      for (int a = 0; a < made.blocks[0]; ++a) {
        PreparedVolume::Range range{32767, -32768};
        const auto end = [&](int index, std::size_t axis) {
          return std::min((index + 1) * PreparedVolume::block, made.size[axis] - 1);
        };
        for (int k = c * PreparedVolume::block; k <= end(c, 2); ++k) {
          for (int j = b * PreparedVolume::block; j <= end(b, 1); ++j) {
            const std::int16_t* const row =
                hounsfield.data() + (static_cast<std::ptrdiff_t>(k) * made.size[1] + j) * made.size[0];
            for (int i = a * PreparedVolume::block; i <= end(a, 0); ++i) {
              range.least = std::min(range.least, row[i]);
              range.most = std::max(range.most, row[i]);
            }
          }
        }
        const int in_order = (c * made.blocks[1] + b) * made.blocks[0] + a;
        made.ranges[static_cast<std::size_t>(in_order)] = range;
      }
    }
  });
}

// Over voxels without the border: histogram, and sums of rays along i, j and k.
void measure(PreparedVolume& made, const std::vector<std::int16_t>& hounsfield) {
  const auto [ni, nj, nk] = made.grid.size;
  std::vector<float> along[3];
  along[0].resize(static_cast<std::size_t>(nj) * static_cast<std::size_t>(nk));
  along[1].resize(static_cast<std::size_t>(ni) * static_cast<std::size_t>(nk));
  along[2].resize(static_cast<std::size_t>(ni) * static_cast<std::size_t>(nj));
  for (int k = 0; k < nk; ++k) {
    for (int j = 0; j < nj; ++j) {
      const std::int16_t* const row =
          hounsfield.data() + (static_cast<std::ptrdiff_t>(k + 1) * made.size[1] + j + 1) * made.size[0] + 1;
      float* const over_j = along[1].data() + static_cast<std::ptrdiff_t>(k) * ni;
      float* const over_k = along[2].data() + static_cast<std::ptrdiff_t>(j) * ni;
      float sum = 0.0F;
      for (int i = 0; i < ni; ++i) {
        ++made.histogram[static_cast<std::size_t>(row[i] + 1024) / 16U];
        const float weight = row[i] < -900 ? 0.0F : 0.001F * static_cast<float>(row[i] + 1000);
        sum += weight;
        over_j[i] += weight;
        over_k[i] += weight;
      }
      along[0][static_cast<std::size_t>(k) * static_cast<std::size_t>(nj) + static_cast<std::size_t>(j)] = sum;
    }
  }
  std::array<double, 3> weights{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<float>& sums = along[axis];
    const auto most = sums.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sums.size() - 1));
    std::nth_element(sums.begin(), most, sums.end());
    weights[axis] = static_cast<double>(*most) * made.grid.spacing[static_cast<int>(axis)];
  }
  std::sort(weights.begin(), weights.end());
  made.thickest = std::max(weights[1], 1.0);  // views from head to foot are not used
}

}  // namespace

std::array<std::int8_t, 4> gradient_byte(const Eigen::Vector3f& gradient) {
  const float size = gradient.norm();
  const Eigen::Vector3f scaled = gradient * (127.0F / (size + half_of_byte));
  return {static_cast<std::int8_t>(std::lrint(scaled.x())), static_cast<std::int8_t>(std::lrint(scaled.y())),
          static_cast<std::int8_t>(std::lrint(scaled.z())), 0};
}

PreparedVolume prepare_volume(const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues,
                              const anatomy::TissueLibrary& library, std::size_t most_voxels,
                              const Progress& progress) {
  const auto report = [&](double fraction) {
    if (progress) progress("volume", fraction);
  };
  if (ct.empty() && tissues.empty()) {
    throw InputError("volume view: the patient has neither a CT nor tissues; open one that has");
  }
  report(0.0);
  anatomy::CtVolume own;
  const anatomy::CtVolume* used = &ct;
  if (ct.empty()) {
    own = typical_hounsfield(tissues, library);
    used = &own;
  }
  const std::array<int, 3> by = coarsening(used->grid, most_voxels);
  if (by != std::array<int, 3>{1, 1, 1}) {
    own = coarser(*used, by);
    used = &own;
  }
  PreparedVolume made;
  made.grid = used->grid;
  for (std::size_t a = 0; a < 3; ++a) made.size[a] = made.grid.size[a] + 2;
  report(0.1);
  std::vector<std::int16_t> hounsfield = fill_voxels(made, *used, tissues);
  report(0.4);
  fill_blocks(made, hounsfield);
  measure(made, hounsfield);
  fill_bricks(made, hounsfield, made.hounsfield);
  report(0.6);
  fill_gradients(made, std::move(hounsfield));
  report(1.0);
  return made;
}

}  // namespace bodkin::imaging
