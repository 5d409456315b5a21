#include "tracking/bead_centres.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bodkin::tracking {

std::vector<Bead> find_beads(const anatomy::CtVolume& ct, const BeadSearch& search) {
  std::vector<Bead> beads;
  if (ct.empty()) return beads;
  const anatomy::Grid& grid = ct.grid;
  const double voxel = grid.spacing.prod();
  const double most_volume = 4.0 / 3.0 * std::numbers::pi * std::pow(search.most_radius, 3);
  std::vector<std::uint8_t> seen(ct.voxels.size(), 0);
  std::vector<std::array<int, 3>> part;
  const auto bright = [&](int i, int j, int k) { return ct.at(i, j, k) > search.threshold; };
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        if (seen[grid.offset(i, j, k)] != 0 || !bright(i, j, k)) continue;
        part.assign(1, {i, j, k});
        seen[grid.offset(i, j, k)] = 1;
        for (std::size_t n = 0; n < part.size(); ++n) {
          for (int side = 0; side < 6; ++side) {
            std::array<int, 3> next = part[n];
            const auto axis = static_cast<std::size_t>(side / 2);
            next[axis] += side % 2 == 0 ? 1 : -1;
            if (next[axis] < 0 || next[axis] >= grid.size[axis]) continue;
            std::uint8_t& mark = seen[grid.offset(next[0], next[1], next[2])];
            if (mark != 0 || !bright(next[0], next[1], next[2])) continue;
            mark = 1;
            part.push_back(next);
          }
        }
        const double volume = static_cast<double>(part.size()) * voxel;
        const double radius = std::cbrt(0.75 * volume / std::numbers::pi);
        if (volume > most_volume || radius < search.least_radius) continue;
        std::array<int, 3> low = part.front(), high = low;
        for (const auto& at : part) {
          for (std::size_t a = 0; a < 3; ++a) {
            low[a] = std::min(low[a], at[a]);
            high[a] = std::max(high[a], at[a]);
          }
        }
        Vec3 extent;
        for (int a = 0; a < 3; ++a) {
          const auto n = static_cast<std::size_t>(a);
          extent[a] = (high[n] - low[n] + 1) * grid.spacing[a];
        }
        // A voxel more or less is an effect of the lattice.
        if (extent.maxCoeff() - extent.minCoeff() > 1.5 * grid.spacing.maxCoeff() + 0.25 * extent.maxCoeff())
          continue;
        // The rim, whose voxels the bead fills in part, belongs to the centroid: one voxel around, by its share.
        double inside = -1e9, outside = 1e9;
        for (const auto& at : part) inside = std::max(inside, static_cast<double>(ct.at(at[0], at[1], at[2])));
        std::vector<double> around;
        const auto each_around = [&](const auto& visit) {
          for (int c = std::max(low[2] - 2, 0); c <= std::min(high[2] + 2, grid.size[2] - 1); ++c)
            for (int b = std::max(low[1] - 2, 0); b <= std::min(high[1] + 2, grid.size[1] - 1); ++b)
              for (int a = std::max(low[0] - 2, 0); a <= std::min(high[0] + 2, grid.size[0] - 1); ++a) visit(a, b, c);
        };
        each_around([&](int a, int b, int c) {
          if (!bright(a, b, c)) around.push_back(ct.at(a, b, c));
        });
        if (!around.empty()) {
          std::nth_element(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2),
                           around.end());
          outside = around[around.size() / 2];
        } else {
          outside = search.threshold;
        }
        // A tenth of the step is noise or tissue beside the bead.
        const double floor = std::min(outside + 0.1 * (inside - outside), search.threshold);
        Vec3 sum = Vec3::Zero();
        double weights = 0.0;
        each_around([&](int a, int b, int c) {
          const double weight = ct.at(a, b, c) - floor;
          if (weight <= 0.0) return;
          sum += weight * Vec3(a, b, c);
          weights += weight;
        });
        beads.push_back({grid.to_patient(sum / weights), radius});
      }
    }
  }
  std::sort(beads.begin(), beads.end(), [](const Bead& a, const Bead& b) { return a.radius > b.radius; });
  return beads;
}

}  // namespace bodkin::tracking
