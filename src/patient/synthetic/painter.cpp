#include "patient/synthetic/painter.h"

#include <array>
#include <cmath>

#include "core/error.h"
#include "core/parallel_for.h"
#include "core/random.h"

namespace bodkin::patient {
namespace {

constexpr double kPointSpread = 0.7;    // mm, standard deviation
constexpr double kTextureShare = 0.55;  // of a tissue's standard deviation; the rest is noise

// e^-x for x >= 0 by its series after halving: exact arithmetic only (see shapes.h).
double decay(double x) {
  double sum = 1.0, term = 1.0;
  for (int n = 1; n < 16; ++n) sum += term *= -(x / 64.0) / n;
  for (int i = 0; i < 6; ++i) sum *= sum;
  return sum;
}

std::vector<float> point_spread(double spacing) {
  const int reach = static_cast<int>(std::ceil(2.2 * kPointSpread / spacing));
  std::vector<float> weights;
  double sum = 0.0;
  for (int i = -reach; i <= reach; ++i) {
    const double x = i * spacing / kPointSpread;
    weights.push_back(static_cast<float>(decay(0.5 * x * x)));
    sum += static_cast<double>(weights.back());
  }
  for (float& weight : weights) weight = static_cast<float>(static_cast<double>(weight) / sum);
  return weights;
}

// Approximately normal with standard deviation 1, from the four 16-bit parts of a hash.
double normal_noise(std::uint64_t bits) {
  const auto part = [&](int shift) { return static_cast<double>(bits >> shift & 0xFFFFu); };
  return (part(0) + part(16) + part(32) + part(48) - 131070.0) * (1.0 / 37837.2);
}

// Smooth noise of about standard deviation 1 whose features are some mm wide: random values at the corners of a
// lattice, blended between them. One row of voxels at a time, because neighbours share corners.
class Texture {
 public:
  Texture(std::uint64_t seed, double feature) : seed_(seed), feature_(feature) {}

  void add_row(double y, double z, double x0, double spacing, double weight, std::vector<float>& row) const {
    const double v = y / feature_ + 4096.0, w = z / feature_ + 4096.0;
    const auto j = static_cast<std::int64_t>(v), k = static_cast<std::int64_t>(w);
    const double fv = smooth(v - static_cast<double>(j)), fw = smooth(w - static_cast<double>(k));
    std::int64_t column = -1;
    double left = 0.0, right = 0.0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const double u = (x0 + static_cast<double>(i) * spacing) / feature_ + 4096.0;
      const auto cell = static_cast<std::int64_t>(u);
      if (cell != column) {
        left = edge(cell, j, k, fv, fw);
        right = edge(cell + 1, j, k, fv, fw);
        column = cell;
      }
      const double fu = smooth(u - static_cast<double>(cell));
      row[i] += static_cast<float>(weight * (left + fu * (right - left)));
    }
  }

 private:
  static double smooth(double t) { return t * t * (3.0 - 2.0 * t); }
  double corner(std::int64_t i, std::int64_t j, std::int64_t k) const {
    return 2.6 * hash_noise(seed_, i + (j << 20) + (k << 40));
  }
  double edge(std::int64_t i, std::int64_t j, std::int64_t k, double fv, double fw) const {
    const double near = corner(i, j, k) + fv * (corner(i, j + 1, k) - corner(i, j, k));
    const double far = corner(i, j, k + 1) + fv * (corner(i, j + 1, k + 1) - corner(i, j, k + 1));
    return near + fw * (far - near);
  }
  std::uint64_t seed_;
  double feature_;
};

struct Palette {
  std::array<float, 256> value{};
  std::array<float, 256> deviation{};
};

Palette make_palette(const anatomy::TissueVolume& tissues, const anatomy::TissueLibrary& library,
                     const LumbarSizes& sizes) {
  std::array<bool, 256> used{};
  for (const anatomy::TissueId id : tissues.voxels) used[id] = true;
  Palette palette;
  for (std::size_t id = 0; id < used.size(); ++id) {
    if (!used[id]) continue;
    const anatomy::TissueProperties* properties = library.find(static_cast<anatomy::TissueId>(id));
    if (properties == nullptr)
      throw InputError("synthetic patient: the tissue library has no tissue with id " + std::to_string(id) +
                       ", which the patient is made of; add it to the library");
    double value = properties->hounsfield;
    if (id == anatomy::tissue::cancellous_bone) value *= sizes.cancellous_factor;
    if (id == anatomy::tissue::cortical_bone) value *= sizes.cortical_factor;
    // Fatty change lowers the HU of aging muscles: 25 HU over a lifetime, our choice.
    if (id == anatomy::tissue::muscle) value -= 25.0 * sizes.torso.muscle_fat;
    palette.value[id] = static_cast<float>(value);
    palette.deviation[id] = static_cast<float>(properties->hounsfield_noise);
  }
  return palette;
}

}  // namespace

anatomy::CtVolume paint_ct(const anatomy::TissueVolume& tissues, const anatomy::TissueLibrary& library,
                           const LumbarSizes& sizes, std::uint64_t seed, const Progress& progress) {
  const anatomy::Grid& grid = tissues.grid;
  const Palette palette = make_palette(tissues, library, sizes);
  const std::vector<float> spread = point_spread(grid.spacing.x());
  const int reach = static_cast<int>(spread.size()) / 2;
  const auto tap = [&spread, reach](int offset) {
    const int n = offset + reach;
    return spread[static_cast<std::size_t>(n)];
  };
  const Texture coarse(mix64(seed ^ 11u), 7.0), fine(mix64(seed ^ 12u), 2.6);
  const std::uint64_t noise_seed = mix64(seed ^ 13u);
  const double noise_share = std::sqrt(1.0 - kTextureShare * kTextureShare);
  const int nx = grid.size[0], ny = grid.size[1], nz = grid.size[2];
  const auto columns = static_cast<std::size_t>(nx);
  const std::size_t plane = columns * static_cast<std::size_t>(ny);

  anatomy::CtVolume ct(grid);
  parallel_for(nz, "Hounsfield units", progress, [&](int k) {
    // The point spread is separable: along z, then y, then x.
    std::vector<float> along_z(plane, 0.0f), row(columns), texture(columns);
    for (int dk = -reach; dk <= reach; ++dk) {
      const float weight = tap(dk);
      const anatomy::TissueId* slice = &tissues.voxels[grid.offset(0, 0, std::clamp(k + dk, 0, nz - 1))];
      for (std::size_t n = 0; n < plane; ++n) along_z[n] += weight * palette.value[slice[n]];
    }
    for (int j = 0; j < ny; ++j) {
      std::fill(row.begin(), row.end(), 0.0f);
      for (int dj = -reach; dj <= reach; ++dj) {
        const float weight = tap(dj);
        const float* line = &along_z[static_cast<std::size_t>(std::clamp(j + dj, 0, ny - 1)) * columns];
        for (std::size_t i = 0; i < columns; ++i) row[i] += weight * line[i];
      }
      const Vec3 start = grid.to_patient(Vec3(0.0, j, k));
      std::fill(texture.begin(), texture.end(), 0.0f);
      coarse.add_row(start.y(), start.z(), start.x(), grid.spacing.x(), 0.7, texture);
      fine.add_row(start.y(), start.z(), start.x(), grid.spacing.x(), 0.7, texture);
      const std::size_t first = grid.offset(0, j, k);
      for (int i = 0; i < nx; ++i) {
        float value = 0.0f;
        for (int di = -reach; di <= reach; ++di)
          value += tap(di) * row[static_cast<std::size_t>(std::clamp(i + di, 0, nx - 1))];
        const std::size_t at = first + static_cast<std::size_t>(i);
        const double noise = normal_noise(mix64(noise_seed ^ mix64(at)));
        const double spread_of_tissue = static_cast<double>(palette.deviation[tissues.voxels[at]]);
        const double hu =
            static_cast<double>(value) +
            spread_of_tissue *
                (kTextureShare * static_cast<double>(texture[static_cast<std::size_t>(i)]) + noise_share * noise);
        ct.voxels[at] = static_cast<std::int16_t>(std::clamp(std::floor(hu + 0.5), -1024.0, 3071.0));
      }
    }
  });
  return ct;
}

}  // namespace bodkin::patient
