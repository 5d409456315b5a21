#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "anatomy/volume.h"

namespace bodkin::patient {

// Reads one image along the rows of another lattice with the same axes but other voxel edges: trilinear between voxel
// centres, border values beyond the outermost centres. A row costs four loads per source voxel and two per sample,
// which makes whole volumes of tissue affordable.
template <typename Voxel>
class RowSampler {
 public:
  // `target` must have the direction cosines of `source`.
  RowSampler(const anatomy::Volume<Voxel>& source, const anatomy::Grid& target) : source_(source) {
    const Vec3 first = source.grid.to_index(target.origin);
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      taps_[a].resize(static_cast<std::size_t>(target.size[a]));
      const double step = target.spacing[axis] / source.grid.spacing[axis];
      const int last = source.grid.size[a] - 1;
      for (std::size_t t = 0; t < taps_[a].size(); ++t) {
        const double x = std::clamp(first[axis] + step * static_cast<double>(t), 0.0, static_cast<double>(last));
        const int low = std::min(static_cast<int>(x + 1e-6), last);
        taps_[a][t] = {low, std::min(low + 1, last), std::max(0.0F, static_cast<float>(x - low))};
      }
    }
  }

  // Fills `row` with the samples of target row (j, k); `scratch` is working memory kept by a thread.
  void read(int j, int k, std::vector<float>& row, std::vector<float>& scratch) const {
    const Tap& tj = taps_[1][static_cast<std::size_t>(j)];
    const Tap& tk = taps_[2][static_cast<std::size_t>(k)];
    const auto width = static_cast<std::size_t>(source_.grid.size[0]);
    const Voxel* a = &source_.at(0, tj.low, tk.low);
    const Voxel* b = &source_.at(0, tj.high, tk.low);
    const Voxel* c = &source_.at(0, tj.low, tk.high);
    const Voxel* d = &source_.at(0, tj.high, tk.high);
    const float wa = (1 - tj.weight) * (1 - tk.weight), wb = tj.weight * (1 - tk.weight);
    const float wc = (1 - tj.weight) * tk.weight, wd = tj.weight * tk.weight;
    scratch.resize(width);
    for (std::size_t i = 0; i < width; ++i) {
      scratch[i] = wa * static_cast<float>(a[i]) + wb * static_cast<float>(b[i]) + wc * static_cast<float>(c[i]) +
                   wd * static_cast<float>(d[i]);
    }
    row.resize(taps_[0].size());
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Tap& t = taps_[0][i];
      const float low = scratch[static_cast<std::size_t>(t.low)];
      row[i] = low + t.weight * (scratch[static_cast<std::size_t>(t.high)] - low);
    }
  }

 private:
  struct Tap {
    int low, high;
    float weight;  // of `high`
  };
  const anatomy::Volume<Voxel>& source_;
  std::array<std::vector<Tap>, 3> taps_;
};

}  // namespace bodkin::patient
