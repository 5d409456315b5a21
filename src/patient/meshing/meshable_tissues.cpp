#include "patient/meshing/meshable_tissues.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "anatomy/label_distance.h"

namespace bodkin::patient {
namespace {

constexpr double thinnest = 0.8;            // [D] of the local edge: a thinner tissue is merged
constexpr double growth_from_border = 0.6;  // [D] mm of edge per mm away from a border
constexpr double nodes_per_cube = 1.25;     // nodes in a cube of one edge; measured on lumbar patients
constexpr anatomy::TissueId unknown = 255;  // a voxel taken over from another family

using Voxels = std::vector<anatomy::TissueId>;

// The family of a tissue, named after one of its members.
anatomy::TissueId family_of(anatomy::TissueId id) {
  switch (id) {
    case anatomy::tissue::skin:
      return anatomy::tissue::fat;
    case anatomy::tissue::cancellous_bone:
    case anatomy::tissue::cartilage:
      return anatomy::tissue::cortical_bone;
    case anatomy::tissue::supraspinous_ligament:
    case anatomy::tissue::ligamentum_flavum:
      return anatomy::tissue::interspinous_ligament;
    case anatomy::tissue::epidural_fat:
    case anatomy::tissue::dura:
    case anatomy::tissue::nerve:
    case anatomy::tissue::spinal_cord:
      return anatomy::tissue::cerebrospinal_fluid;
    default:
      return id;
  }
}

// Steps to the six neighbours of a voxel inside the outermost layer, which is air.
std::array<std::ptrdiff_t, 6> neighbour_steps(const anatomy::Grid& grid) {
  const std::ptrdiff_t row = grid.size[0], layer = row * grid.size[1];
  return {-layer, -row, -1, 1, row, layer};
}

// Spreads the values of `given` (0 = none) from voxel to voxel as far as `may` allows, nearest first.
template <typename Allowed>
void spread(const anatomy::Grid& grid, Voxels& given, const Allowed& may) {
  const auto steps = neighbour_steps(grid);
  const auto takes = [&](std::size_t i, std::size_t j) { return given[j] == anatomy::tissue::air && may(i, j); };
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const auto spreads = [&](std::ptrdiff_t step) { return takes(i, i + static_cast<std::size_t>(step)); };
    if (given[i] != anatomy::tissue::air && std::ranges::any_of(steps, spreads)) front.push_back(i);
  }
  while (!front.empty()) {
    std::vector<std::size_t> next;
    for (const std::size_t i : front) {
      for (const std::ptrdiff_t step : steps) {
        const std::size_t j = i + static_cast<std::size_t>(step);
        if (!takes(i, j)) continue;
        given[j] = given[i];
        next.push_back(j);
      }
    }
    front = std::move(next);
  }
}

// Calls `visit` with the voxels of each part connected through faces, where `inside` voxels are joined if `same`; it
// may take them.
template <typename Inside, typename Same, typename Visit>
void for_parts(const anatomy::Grid& grid, const Inside& inside, const Same& same, const Visit& visit) {
  std::vector<bool> seen(grid.voxel_count(), false);
  std::vector<std::size_t> part;
  const auto steps = neighbour_steps(grid);
  for (std::size_t start = 0; start < seen.size(); ++start) {
    if (seen[start] || !inside(start)) continue;
    part.assign(1, start);
    seen[start] = true;
    for (std::size_t at = 0; at < part.size(); ++at) {
      for (const std::ptrdiff_t step : steps) {
        const std::size_t j = part[at] + static_cast<std::size_t>(step);
        if (seen[j] || !inside(j) || !same(part[at], j)) continue;
        seen[j] = true;
        part.push_back(j);
      }
    }
    visit(part);
  }
}

// Keeps part of `labels`; the rest becomes 0.
Voxels thick_parts(const anatomy::Volume<anatomy::TissueId>& labels, const std::vector<float>& radius) {
  constexpr std::array left_out = {anatomy::tissue::air, unknown};
  const std::vector<std::uint8_t> kept =
      anatomy::thick_enough(labels, anatomy::distance_to_other_label(labels, left_out), radius, left_out);
  Voxels thick(labels.voxels.size(), anatomy::tissue::air);
  for (std::size_t i = 0; i < thick.size(); ++i) {
    if (kept[i] != 0) thick[i] = labels.voxels[i];
  }
  return thick;
}

// Families of the voxels, thin parts given to their neighbours; 0 outside and where no part is thick.
Voxels merge_families(const anatomy::TissueVolume& tissues, const std::vector<float>& radius) {
  anatomy::Volume<anatomy::TissueId> families(tissues.grid);
  std::transform(tissues.voxels.begin(), tissues.voxels.end(), families.voxels.begin(), family_of);
  Voxels merged = thick_parts(families, radius);
  spread(tissues.grid, merged,
         [&](std::size_t, std::size_t j) { return families.voxels[j] != anatomy::tissue::air; });
  return merged;
}

// The tissues of each family, thin parts given to others of the family.
void merge_tissues(const Voxels& families, const std::vector<float>& radius, anatomy::TissueVolume& tissues) {
  for (std::size_t i = 0; i < families.size(); ++i) {
    anatomy::TissueId& id = tissues.voxels[i];
    if (family_of(id) != families[i]) id = families[i] == anatomy::tissue::air ? anatomy::tissue::air : unknown;
  }
  const auto same = [&](std::size_t i, std::size_t j) { return families[i] == families[j]; };
  Voxels merged = thick_parts(tissues, radius);
  spread(tissues.grid, merged, same);
  const auto left = [&](std::size_t i) {
    return families[i] != anatomy::tissue::air && merged[i] == anatomy::tissue::air;
  };
  for_parts(tissues.grid, left, same, [&](const std::vector<std::size_t>& part) {
    std::array<std::size_t, 256> voxels{};
    for (const std::size_t i : part) ++voxels[tissues.voxels[i]];
    voxels[unknown] = 0;
    const auto most = std::max_element(voxels.begin(), voxels.end());
    const anatomy::TissueId id =
        *most == 0 ? families[part.front()] : static_cast<anatomy::TissueId>(most - voxels.begin());
    for (const std::size_t i : part) merged[i] = id;
  });
  tissues.voxels = std::move(merged);
}

void keep_largest(anatomy::TissueVolume& tissues) {
  std::vector<std::size_t> largest;
  for_parts(
      tissues.grid, [&](std::size_t i) { return tissues.voxels[i] != anatomy::tissue::air; },
      [](std::size_t, std::size_t) { return true; },
      [&](std::vector<std::size_t>& part) {
        if (part.size() > largest.size()) std::swap(part, largest);
      });
  Voxels kept(tissues.voxels.size(), anatomy::tissue::air);
  for (const std::size_t i : largest) kept[i] = tissues.voxels[i];
  tissues.voxels = std::move(kept);
}

}  // namespace

MeshableTissues meshable_tissues(const MeshPlan& plan, double scale) {
  MeshableTissues result;
  result.tissues = plan.tissues;
  anatomy::TissueVolume& tissues = result.tissues;
  const auto held = [&plan](std::size_t i, double edge) {
    return plan.preserving_edges.empty() ? edge : std::min(edge, static_cast<double>(plan.preserving_edges[i]));
  };
  std::vector<float> radius(plan.border_edges.size());
  for (std::size_t i = 0; i < radius.size(); ++i) {
    const double edge = held(i, scale * static_cast<double>(plan.border_edges[i]));
    radius[i] = static_cast<float>(0.5 * thinnest * edge);
  }
  merge_tissues(merge_families(tissues, radius), radius, tissues);
  keep_largest(tissues);
  result.edges = anatomy::distance_to_other_label(tissues);
  for (std::size_t i = 0; i < result.edges.size(); ++i) {
    const double border =
        static_cast<double>(plan.border_edges[i]) * scale + growth_from_border * static_cast<double>(result.edges[i]);
    const double inner = scale * static_cast<double>(plan.inner_edges[i]);
    result.edges[i] = static_cast<float>(held(i, std::min(inner, border)));
    const anatomy::TissueId was = plan.tissues.voxels[i], is = tissues.voxels[i];
    if (was == anatomy::tissue::air) continue;
    ++result.before[was];
    is == anatomy::tissue::air ? ++result.dropped : ++result.after[is];
  }
  return result;
}

std::vector<PathLayer> lost_layers(const MeshPlan& plan, const MeshableTissues& meshable) {
  std::vector<PathLayer> lost;
  for (const PathLayer& layer : plan.layers) {
    if (anatomy::nearest<anatomy::TissueId>(meshable.tissues, layer.widest, anatomy::tissue::air) != layer.tissue)
      lost.push_back(layer);
  }
  return lost;
}

double expected_nodes(const MeshableTissues& meshable) {
  double cubes = 0.0;
  for (std::size_t i = 0; i < meshable.edges.size(); ++i) {
    if (meshable.tissues.voxels[i] == anatomy::tissue::air) continue;
    const double edge = static_cast<double>(meshable.edges[i]);
    cubes += 1.0 / (edge * edge * edge);
  }
  return nodes_per_cube * cubes * meshable.tissues.grid.spacing.prod();
}

}  // namespace bodkin::patient
