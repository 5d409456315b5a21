#pragma once

// A block whose layers lie one upon the other as the back's do, its skin one layer of elements thick.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "tests/fem/lattice_body.h"

namespace bodkin::checks {

using namespace bodkin::anatomy;
using namespace bodkin::fem;

struct BlockLayer {
  TissueId tissue = 0;
  double thickness = 0.0;  // mm
  double young = 0.0;      // MPa; Poisson's ratio is 0.3
};

// From the top down, 40 mm together.
inline std::vector<BlockLayer> back_with_stiff_skin() {
  return {{tissue::skin, 2.0, 0.5},
          {tissue::fat, 8.0, 0.02},
          {tissue::muscle, 12.0, 0.06},
          {tissue::ligamentum_flavum, 4.0, 0.7},
          {tissue::soft, 14.0, 0.06}};
}

inline std::vector<BlockLayer> back_of_one_tissue() {
  return {{tissue::soft, 40.0, 0.05}};
}

// 60 x 60 x 40 mm, its top at z = 40, its bottom held; about h mm between nodes, which inside the layers are moved by
// up to a fifth of that, and between them along them.
inline std::shared_ptr<const BodyDescription> layered_block(const std::vector<BlockLayer>& layers, double h,
                                                            std::uint64_t seed) {
  struct Plane {
    double z;
    const BlockLayer* above;
    bool border;
  };
  std::vector<Plane> planes;
  double z = 0.0;
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
    const int steps = std::max(1, static_cast<int>(std::lround(layer->thickness / h)));
    for (int i = 0; i < steps; ++i) planes.push_back({z + layer->thickness * i / steps, &*layer, i == 0});
    z += layer->thickness;
  }
  planes.push_back({z, nullptr, true});
  const auto across = static_cast<std::uint32_t>(std::lround(60.0 / h)) + 1;
  const auto deep = static_cast<std::uint32_t>(planes.size());
  BodyDescription body;
  body.mesh = kuhn_box({across, across, deep}, Vec3(60.0, 60.0, deep - 1.0), 0.2, seed);
  for (std::size_t element = 0; element < body.mesh.elements.size(); ++element) {
    double middle = 0.0;
    for (const std::uint32_t node : body.mesh.elements[element]) middle += 0.25 * body.mesh.nodes[node].z();
    body.mesh.tissues[element] = planes[static_cast<std::size_t>(middle)].above->tissue;
  }
  for (Vec3& node : body.mesh.nodes) {
    const auto nearest = static_cast<std::size_t>(std::lround(node.z()));
    const double at = planes[nearest].border ? static_cast<double>(nearest) : node.z();
    const std::size_t below = std::min(static_cast<std::size_t>(at), planes.size() - 2);
    node.z() = std::lerp(planes[below].z, planes[below + 1].z, at - static_cast<double>(below));
  }
  for (const BlockLayer& layer : layers) body.materials.set(layer.tissue, {layer.young, 0.3});
  body.fixed = nodes_beyond(body.mesh, Vec3::Zero(), Vec3(0.0, 0.0, -1.0));
  return std::make_shared<const BodyDescription>(std::move(body));
}

}  // namespace bodkin::checks
