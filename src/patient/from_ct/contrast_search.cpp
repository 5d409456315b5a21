#include "patient/from_ct/contrast_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Eigenvalues>

#include "core/parallel_for.h"

namespace bodkin::patient {
namespace {

constexpr float core_below = -45.0F;      // mm, signed distance to the skin
constexpr double brightest_core = 600.0;  // HU, mean
constexpr double core_spread = 0.12;      // standard deviation over mean
constexpr double like_neighbour = 0.2;    // difference of two blocks' means over their mean
constexpr double smallest_core = 2.0;     // mL
constexpr double least_elongation = 2.5;  // length over thickness
constexpr double shell_brighter = 1.25;   // than the mean of the core
constexpr double shell_share = 0.1;       // of the dense voxels around a core

using Place = std::array<int, 3>;

// The blocks of the body's lattice with unlabelled voxels as dense as bone.
class DenseBlocks {
 public:
  DenseBlocks(anatomy::TissueVolume& tissues, const anatomy::CtVolume& ct, const anatomy::LabelVolume& structures,
              const TissueLattice& lattice, const BodySurface& body)
      : tissues_(tissues), ct_(ct), structures_(structures), lattice_(lattice), body_(body) {
    for (std::size_t a = 0; a < 3; ++a) {
      const auto axis = static_cast<Eigen::Index>(a);
      edge_[a] = lattice.parts[a] *
                 std::max(1, static_cast<int>(std::lround(body.distance.grid.spacing[axis] / ct.grid.spacing[axis])));
    }
    count_.assign(body.distance.grid.voxel_count(), 0);
    sum_.assign(count_.size(), 0.0F);
    parallel_for(size()[2], [&](int k) {
      for (int j = 0; j < size()[1]; ++j) {
        for (int i = 0; i < size()[0]; ++i) {
          const std::size_t block = offset({i, j, k});
          if (body_.distance.voxels[block] > 0.0F) continue;  // outside
          each_dense({i, j, k}, [&](anatomy::TissueId&, float value) {
            ++count_[block];
            sum_[block] += value;
          });
        }
      }
    });
  }

  const Place& size() const { return body_.distance.grid.size; }
  std::size_t offset(const Place& at) const { return body_.distance.grid.offset(at[0], at[1], at[2]); }
  bool contains(const Place& at) const { return body_.distance.grid.contains(at[0], at[1], at[2]); }
  double mean(std::size_t block) const { return static_cast<double>(sum_[block]) / count_[block]; }
  std::uint32_t count(std::size_t block) const { return count_[block]; }

  // Calls `work` with the tissue and the HU of every unlabelled dense voxel of a block.
  template <typename Work>
  void each_dense(const Place& at, const Work& work) const {
    const auto& grid = tissues_.grid;
    Place low{}, high{};
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = at[a] * edge_[a];
      high[a] = std::min(low[a] + edge_[a], grid.size[a]);
    }
    for (int k = low[2]; k < high[2]; ++k) {
      for (int j = low[1]; j < high[1]; ++j) {
        anatomy::TissueId* row = &tissues_.at(0, j, k);
        for (int i = low[0]; i < high[0]; ++i) {
          if (row[i] != anatomy::tissue::cortical_bone && row[i] != anatomy::tissue::cancellous_bone) continue;
          const int x = i / lattice_.parts[0], y = j / lattice_.parts[1], z = k / lattice_.parts[2];
          if (!structures_.empty() && structures_.at(x, y, z) != 0) continue;
          work(row[i], static_cast<float>(ct_.at(x, y, z)));
        }
      }
    }
  }

  bool full(const Place& at) const {
    std::uint32_t all = 1;
    for (std::size_t a = 0; a < 3; ++a)
      all *= static_cast<std::uint32_t>(std::min(edge_[a], tissues_.grid.size[a] - at[a] * edge_[a]));
    return count_[offset(at)] == all;
  }

  // Full, deep, and full at all of its six faces within the image.
  bool core(const Place& at) const {
    if (count_[offset(at)] == 0 || body_.distance.voxels[offset(at)] > core_below || !full(at)) return false;
    for (std::size_t a = 0; a < 3; ++a) {
      for (const int step : {-1, 1}) {
        Place beside = at;
        beside[a] += step;
        if (contains(beside) && !full(beside)) return false;
      }
    }
    return true;
  }

  double millilitres(std::size_t voxels) const {
    return static_cast<double>(voxels) * tissues_.grid.spacing.prod() / 1e3;
  }
  Vec3 edges() const { return body_.distance.grid.spacing; }

 private:
  anatomy::TissueVolume& tissues_;
  const anatomy::CtVolume& ct_;
  const anatomy::LabelVolume& structures_;
  const TissueLattice& lattice_;
  const BodySurface& body_;
  Place edge_{};                      // tissue voxels along a block
  std::vector<std::uint32_t> count_;  // dense voxels without a label
  std::vector<float> sum_;            // of their HU
};

// Calls `work` with every neighbouring block of `at` within the image.
template <typename Work>
void each_neighbour(const DenseBlocks& blocks, const Place& at, const Work& work) {
  for (std::size_t a = 0; a < 3; ++a) {
    for (const int step : {-1, 1}) {
      Place beside = at;
      beside[a] += step;
      if (blocks.contains(beside)) work(beside);
    }
  }
}

// The core around `seed`: connected blocks of nearly the same mean. Marks them in `taken`.
std::vector<Place> core_from(const Place& seed, const DenseBlocks& blocks, std::vector<std::uint8_t>& taken) {
  std::vector<Place> found = {seed};
  taken[blocks.offset(seed)] = 1;
  for (std::size_t next = 0; next < found.size(); ++next) {
    const Place at = found[next];
    const double here = blocks.mean(blocks.offset(at));
    each_neighbour(blocks, at, [&](const Place& beside) {
      const std::size_t block = blocks.offset(beside);
      if (taken[block] != 0 || !blocks.core(beside)) return;
      const double there = blocks.mean(block);
      if (std::abs(there - here) > like_neighbour * 0.5 * (there + here)) return;
      taken[block] = 1;
      found.push_back(beside);
    });
  }
  return found;
}

// The blocks at the faces of `inner` that are not in `marked`; adds them to it.
std::vector<Place> layer_around(const std::vector<Place>& inner, const DenseBlocks& blocks,
                                std::vector<std::uint8_t>& marked, bool with_full) {
  std::vector<Place> layer;
  for (const Place& at : inner) {
    each_neighbour(blocks, at, [&](const Place& beside) {
      std::uint8_t& mark = marked[blocks.offset(beside)];
      if (mark != 0 || blocks.count(blocks.offset(beside)) == 0 || (!with_full && blocks.full(beside))) return;
      mark = 1;
      layer.push_back(beside);
    });
  }
  return layer;
}

double volume_of(const std::vector<Place>& core, const DenseBlocks& blocks) {
  return static_cast<double>(core.size()) * blocks.edges().prod() / 1e3;
}

// Length over thickness of a core, including the block missing at its surface.
double elongation(const std::vector<Place>& core, const DenseBlocks& blocks) {
  Vec3 middle = Vec3::Zero();
  for (const Place& at : core) middle += Vec3(at[0], at[1], at[2]);
  middle /= static_cast<double>(core.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Place& at : core) {
    const Vec3 off = (Vec3(at[0], at[1], at[2]) - middle).cwiseProduct(blocks.edges());
    spread += off * off.transpose();
  }
  spread /= static_cast<double>(core.size());
  const Vec3 variance = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues().cwiseMax(0.0);
  // A box of length a has the variance a^2 / 12; a layer of a block's edge lies around it.
  const double around = 2.0 * blocks.edges().maxCoeff();
  const double length = std::sqrt(12.0 * variance[2]) + around, thickness = std::sqrt(12.0 * variance[1]) + around;
  return length / thickness;
}

struct Brightness {
  double count = 0.0, sum = 0.0, squares = 0.0;
  double mean() const { return sum / count; }
  double spread() const { return std::sqrt(std::max(0.0, squares / count - mean() * mean())); }
};

Brightness brightness_of(const std::vector<Place>& core, const DenseBlocks& blocks) {
  Brightness found;
  for (const Place& at : core) {
    blocks.each_dense(at, [&](anatomy::TissueId&, float value) {
      found.count += 1.0, found.sum += value, found.squares += static_cast<double>(value) * value;
    });
  }
  return found;
}

// Share of the dense voxels of `layers` that are brighter than `limit`.
double share_brighter(const std::vector<Place>& layers, const DenseBlocks& blocks, double limit) {
  double count = 0.0, brighter = 0.0;
  for (const Place& at : layers) {
    blocks.each_dense(at, [&](anatomy::TissueId&, float value) {
      count += 1.0;
      brighter += value > limit ? 1.0 : 0.0;
    });
  }
  return count > 0.0 ? brighter / count : 0.0;
}

}  // namespace

double take_out_contrast_on_bone(anatomy::TissueVolume& tissues, const anatomy::CtVolume& ct,
                                 const anatomy::LabelVolume& structures, const TissueLattice& lattice,
                                 const BodySurface& body) {
  if (!body.has_skin) return 0.0;
  const DenseBlocks blocks(tissues, ct, structures, lattice, body);
  std::vector<std::uint8_t> taken(body.distance.grid.voxel_count(), 0), marked;
  std::size_t voxels = 0;
  const Place& size = blocks.size();
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        const Place seed = {i, j, k};
        if (taken[blocks.offset(seed)] != 0 || !blocks.core(seed)) continue;
        const std::vector<Place> core = core_from(seed, blocks, taken);
        if (volume_of(core, blocks) < smallest_core || elongation(core, blocks) < least_elongation) continue;
        const Brightness own = brightness_of(core, blocks);
        if (own.mean() > brightest_core || own.spread() > core_spread * own.mean()) continue;
        if (marked.empty()) marked.assign(taken.size(), 0);
        for (const Place& at : core) marked[blocks.offset(at)] = 1;
        std::vector<Place> vessel = layer_around(core, blocks, marked, true);
        const std::vector<Place> outer = layer_around(vessel, blocks, marked, false);
        vessel.insert(vessel.end(), outer.begin(), outer.end());
        const double limit = shell_brighter * own.mean();
        const bool has_shell = share_brighter(vessel, blocks, limit) >= shell_share;
        vessel.insert(vessel.end(), core.begin(), core.end());
        for (const Place& at : vessel) {
          marked[blocks.offset(at)] = 0;
          if (has_shell) continue;
          blocks.each_dense(at, [&](anatomy::TissueId& tissue, float value) {
            if (value > limit) return;
            tissue = anatomy::tissue::vessel;
            ++voxels;
          });
        }
      }
    }
  }
  return blocks.millilitres(voxels);
}

}  // namespace bodkin::patient
