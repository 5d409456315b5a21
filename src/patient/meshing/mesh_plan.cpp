#include "patient/meshing/mesh_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "anatomy/label_distance.h"
#include "core/error.h"

namespace bodkin::patient {
namespace {

// [D] Growth of edges with the distance from the fine region.
constexpr double growth_from_corridor = 0.30;  // mm of edge per mm, inside a tissue
constexpr double border_growth = 0.20;         // the same at a border between tissues
constexpr double voxels_per_edge = 2.5;        // the lattice need not be finer
constexpr std::size_t most_voxels = 40'000'000;
constexpr double layer_step = 0.05;       // mm, along the path
constexpr double corner_of_voxel = 0.5;   // of a voxel: a shorter crossing of the path is not a layer
constexpr double preserved_radius = 4.0;  // [D] mm around the path in which a layer is preserved
constexpr double edge_growth = 0.3;       // [D] mm of edge per mm farther away
// [D] mm around the path in which a stiff skin is preserved: a skin of 2 mm, 25 times as stiff as fat, then dimples 2
// % more than one that covers everything.
constexpr double preserved_skin_radius = 12.0;
constexpr double stiff = 2.0;                // skin over fat
constexpr double layer_surroundings = 25.0;  // mm

struct Box {
  std::array<int, 3> low, high;  // voxels, both included
};

Box whole(const anatomy::Grid& grid) {
  return {{0, 0, 0}, {grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1}};
}

// The voxels within `reach` of the corridor; nothing when it misses the lattice.
std::optional<Box> around(const anatomy::Grid& grid, const anatomy::NeedlePath& path, const MeshSettings& settings) {
  const double reach = settings.corridor_radius + settings.reach;
  const Vec3 end = path.target + settings.corridor_beyond * path.direction();
  Box box = whole(grid);
  const Vec3 a = grid.to_index(path.entry), b = grid.to_index(end);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    const double room = reach / grid.spacing[i];
    const double low = std::floor(std::min(a[i], b[i]) - room), high = std::ceil(std::max(a[i], b[i]) + room);
    if (high < 0.0 || low > box.high[axis]) return std::nullopt;
    box.low[axis] = static_cast<int>(std::clamp<double>(low, 0, box.high[axis]));
    box.high[axis] = static_cast<int>(std::clamp<double>(high, 0, box.high[axis]));
  }
  return box;
}

// The part of a box that contains tissue; nothing if it contains none.
std::optional<Box> with_tissue(const anatomy::TissueVolume& tissues, const Box& box) {
  Box found{box.high, box.low};
  bool any = false;
  for (int k = box.low[2]; k <= box.high[2]; ++k) {
    for (int j = box.low[1]; j <= box.high[1]; ++j) {
      for (int i = box.low[0]; i <= box.high[0]; ++i) {
        if (tissues.at(i, j, k) == anatomy::tissue::air) continue;
        any = true;
        const std::array<int, 3> voxel = {i, j, k};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          found.low[axis] = std::min(found.low[axis], voxel[axis]);
          found.high[axis] = std::max(found.high[axis], voxel[axis]);
        }
      }
    }
  }
  if (!any) return std::nullopt;
  return found;
}

std::array<int, 3> stride_of(const anatomy::Grid& grid, const Box& box, double fine) {
  std::array<int, 3> stride{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double spacing = grid.spacing[static_cast<Eigen::Index>(axis)];
    stride[axis] = std::max(1, static_cast<int>(fine / voxels_per_edge / spacing));
  }
  const auto count = [&] {
    double voxels = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      voxels *= static_cast<double>(box.high[axis] - box.low[axis] + 1) / stride[axis];
    return voxels;
  };
  while (count() > static_cast<double>(most_voxels)) {
    std::size_t finest = 0;
    const auto length = [&](std::size_t axis) {
      return stride[axis] * grid.spacing[static_cast<Eigen::Index>(axis)];
    };
    for (std::size_t axis = 1; axis < 3; ++axis) finest = length(axis) < length(finest) ? axis : finest;
    ++stride[finest];
  }
  return stride;
}

// Every `stride`-th voxel of a box, in one layer of air.
anatomy::TissueVolume take_out(const anatomy::TissueVolume& tissues, const Box& box,
                               const std::array<int, 3>& stride) {
  anatomy::Grid grid = tissues.grid;
  Vec3 first;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    grid.size[axis] = (box.high[axis] - box.low[axis]) / stride[axis] + 3;
    grid.spacing[i] *= stride[axis];
    first[i] = box.low[axis] - stride[axis];
  }
  grid.origin = tissues.grid.to_patient(first);
  anatomy::TissueVolume part(grid, anatomy::tissue::air);
  for (int k = 1; k + 1 < grid.size[2]; ++k) {
    for (int j = 1; j + 1 < grid.size[1]; ++j) {
      for (int i = 1; i + 1 < grid.size[0]; ++i) {
        part.at(i, j, k) = tissues.at(box.low[0] + (i - 1) * stride[0], box.low[1] + (j - 1) * stride[1],
                                      box.low[2] + (k - 1) * stride[2]);
      }
    }
  }
  return part;
}

void set_edges(const std::optional<anatomy::NeedlePath>& path, const MeshSettings& settings, MeshPlan& plan) {
  const anatomy::Grid& grid = plan.tissues.grid;
  plan.border_edges.reserve(grid.voxel_count());
  plan.inner_edges.reserve(grid.voxel_count());
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const double away = path ? distance_to_corridor(grid.to_patient(Vec3(i, j, k)), *path, settings) : 0.0;
        const double inner = path ? settings.fine + growth_from_corridor * away : settings.coarse;
        plan.border_edges.push_back(
            static_cast<float>(std::min(settings.fine + border_growth * away, settings.coarse)));
        plan.inner_edges.push_back(static_cast<float>(std::min(inner, settings.coarse)));
      }
    }
  }
}

double distance_to_layer(const Vec3& point, const PathLayer& layer) {
  const Vec3 along = layer.to - layer.from;
  const double share = std::clamp((point - layer.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - layer.from - share * along).norm();
}

// mm from `place` to the nearest voxel of another tissue than the layer's; at most `farthest`.
double distance_to_others(const Vec3& place, anatomy::TissueId tissue, double farthest,
                          const anatomy::TissueVolume& tissues) {
  const anatomy::Grid& grid = tissues.grid;
  const Vec3 centre = grid.to_index(place), reach = grid.spacing.cwiseInverse() * farthest;
  std::array<int, 3> low{}, high{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    low[axis] = std::max(0, static_cast<int>(std::floor(centre[i] - reach[i])));
    high[axis] = std::min(grid.size[axis] - 1, static_cast<int>(std::ceil(centre[i] + reach[i])));
  }
  double nearest = farthest;
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i)
        if (tissues.at(i, j, k) != tissue)
          nearest = std::min(nearest, (grid.to_patient(Vec3(i, j, k)) - place).norm());
  return nearest;
}

// The place on the path where a layer is widest, and its width there: a ligament along the path is thinner than the
// length of the path in it.
void find_widest(PathLayer& layer, const anatomy::TissueVolume& tissues) {
  const double voxel = tissues.grid.spacing.minCoeff(), farthest = 0.5 * (layer.thickness() + voxel);
  const int pieces = 2 * std::max(1, static_cast<int>(std::ceil(layer.thickness() / voxel)));
  for (int piece = 0; piece <= pieces; ++piece) {
    // From the middle outwards, so that of equal places the middle one is taken.
    const int aside = (piece + 1) / 2 * (piece % 2 == 0 ? 1 : -1);
    const Vec3 place = layer.middle() + static_cast<double>(aside) / pieces * (layer.to - layer.from);
    const double width = 2.0 * distance_to_others(place, layer.tissue, farthest, tissues) - voxel;
    if (piece > 0 && width <= layer.width) continue;
    layer.widest = place;
    layer.width = width;
  }
}

// mm; a layer of two voxels contains no ball of more than one.
double preserving_edge(const PathLayer& layer, const anatomy::Grid& grid) {
  const double voxel = grid.spacing.minCoeff();
  return std::max(layer.width - voxel, std::min(layer.thickness(), voxel));
}

// The box around the layers of the path, without the outermost voxels.
Box around(const std::vector<PathLayer>& layers, const anatomy::Grid& grid) {
  Box box{{grid.size[0] - 2, grid.size[1] - 2, grid.size[2] - 2}, {1, 1, 1}};
  for (const PathLayer& layer : layers) {
    for (const Vec3& end : {layer.from, layer.to}) {
      const Vec3 index = grid.to_index(end);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        const double room = layer_surroundings / grid.spacing[i], last = grid.size[axis] - 2;
        box.low[axis] = std::min(box.low[axis], static_cast<int>(std::clamp(index[i] - room, 1.0, last)));
        box.high[axis] = std::max(box.high[axis], static_cast<int>(std::clamp(index[i] + room, 1.0, last)));
      }
    }
  }
  return box;
}

// Edge lengths that preserve a layer, around its crossing by the path.
void preserve_layers(MeshPlan& plan) {
  const anatomy::Grid& grid = plan.tissues.grid;
  plan.preserving_edges.assign(grid.voxel_count(), std::numeric_limits<float>::infinity());
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 place = grid.to_patient(Vec3(i, j, k));
        float& edge = plan.preserving_edges[grid.offset(i, j, k)];
        for (const PathLayer& layer : plan.layers) {
          const double away = std::max(0.0, distance_to_layer(place, layer) - preserved_radius);
          edge = std::min(edge, static_cast<float>(preserving_edge(layer, grid) + edge_growth * away));
        }
      }
    }
  }
}

// Edge lengths that preserve the skin as far around the path as it bends, and grow from there inwards.
void preserve_skin(MeshPlan& plan) {
  const auto skin = std::ranges::find(plan.layers, anatomy::tissue::skin, &PathLayer::tissue);
  if (skin == plan.layers.end()) return;
  const anatomy::Grid& grid = plan.tissues.grid;
  anatomy::Volume<std::uint8_t> held(grid, 0);
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i)
        if (plan.tissues.at(i, j, k) == anatomy::tissue::skin &&
            distance_to_layer(grid.to_patient(Vec3(i, j, k)), *skin) <= preserved_skin_radius)
          held.at(i, j, k) = 1;
  const std::vector<float> away = anatomy::distance_to_other_label(held);
  const double edge = preserving_edge(*skin, grid);
  for (std::size_t voxel = 0; voxel < away.size(); ++voxel) {
    const double here = held.voxels[voxel] != 0 ? edge : edge + edge_growth * static_cast<double>(away[voxel]);
    plan.preserving_edges[voxel] = std::min(plan.preserving_edges[voxel], static_cast<float>(here));
  }
}

}  // namespace

std::vector<PathLayer> layers_on(const anatomy::NeedlePath& path, double beyond,
                                 const anatomy::TissueVolume& tissues) {
  std::vector<PathLayer> layers;
  const double length = path.length() + beyond;
  anatomy::TissueId before = anatomy::tissue::air;
  for (double depth = 0.0; depth <= length; depth += layer_step) {
    const Vec3 place = path.entry + depth * path.direction();
    const auto here = anatomy::nearest<anatomy::TissueId>(tissues, place, anatomy::tissue::air);
    if (here != anatomy::tissue::air) {
      if (here != before) layers.push_back({here, place, place, depth});
      layers.back().to = place + layer_step * path.direction();
    }
    before = here;
  }
  if (before != anatomy::tissue::air) layers.pop_back();  // it goes on
  const double thinnest = corner_of_voxel * tissues.grid.spacing.minCoeff();
  std::erase_if(layers, [thinnest](const PathLayer& layer) { return layer.thickness() < thinnest; });
  for (PathLayer& layer : layers) find_widest(layer, tissues);
  return layers;
}

double distance_to_corridor(const Vec3& point, const anatomy::NeedlePath& path, const MeshSettings& settings) {
  const Vec3 axis = path.direction();
  const double along = axis.dot(point - path.entry);
  const double across = (point - path.entry - along * axis).norm();
  const double lengthwise =
      std::max({-settings.corridor_radius - along, along - path.length() - settings.corridor_beyond, 0.0});
  return std::hypot(lengthwise, std::max(0.0, across - settings.corridor_radius));
}

bool has_stiff_skin(const anatomy::TissueLibrary& library) {
  const anatomy::TissueProperties *skin = library.find(anatomy::tissue::skin),
                                  *fat = library.find(anatomy::tissue::fat);
  return skin != nullptr && fat != nullptr && skin->deformable.young >= stiff * fat->deformable.young;
}

MeshPlan around_layers(const MeshPlan& plan) {
  if (plan.layers.empty()) return plan;
  const anatomy::Grid& whole_grid = plan.tissues.grid;
  const Box box = around(plan.layers, whole_grid);
  MeshPlan part;
  part.tissues = take_out(plan.tissues, box, {1, 1, 1});
  part.layers = plan.layers;
  part.boxed = true;
  const anatomy::Grid& grid = part.tissues.grid;
  const auto copied = [&](const std::vector<float>& edges) {
    std::vector<float> found;
    if (edges.empty()) return found;
    found.reserve(grid.voxel_count());
    for (int k = 0; k < grid.size[2]; ++k) {
      for (int j = 0; j < grid.size[1]; ++j) {
        const auto first = edges.begin() + static_cast<std::ptrdiff_t>(whole_grid.offset(
                                               box.low[0] - 1, box.low[1] - 1 + j, box.low[2] - 1 + k));
        found.insert(found.end(), first, first + grid.size[0]);
      }
    }
    return found;
  };
  part.border_edges = copied(plan.border_edges);
  part.inner_edges = copied(plan.inner_edges);
  part.preserving_edges = copied(plan.preserving_edges);
  return part;
}

MeshPlan plan_mesh(const anatomy::TissueVolume& tissues, const std::optional<anatomy::NeedlePath>& path,
                   const MeshSettings& settings) {
  const Box all = whole(tissues.grid);
  const std::optional<Box> box = path ? around(tissues.grid, *path, settings) : all;
  const std::optional<Box> body = box ? with_tissue(tissues, *box) : std::nullopt;
  if (!body) {
    throw InputError(
        path ? fmt::format("there is no tissue within {:g} mm of the planned path; plan it through the body",
                           settings.corridor_radius + settings.reach)
             : std::string("there is nothing but air in the tissue volume"));
  }
  MeshPlan plan;
  double finest = settings.fine;
  if (path) plan.layers = layers_on(*path, settings.corridor_beyond, tissues);
  if (settings.preserve_layers) {
    for (const PathLayer& layer : plan.layers) finest = std::min(finest, preserving_edge(layer, tissues.grid));
  }
  plan.tissues = take_out(tissues, *body, stride_of(tissues.grid, *body, finest));
  const std::optional<Box> everything = with_tissue(tissues, all);
  plan.boxed = everything->low != body->low || everything->high != body->high;
  set_edges(path, settings, plan);
  if (settings.preserve_layers && path) preserve_layers(plan);
  if (settings.preserve_layers && path && settings.stiff_skin) preserve_skin(plan);
  return plan;
}

}  // namespace bodkin::patient
