#pragma once

#include <cstdint>

#include "anatomy/condensed_body.h"

namespace bodkin::checks {

using namespace bodkin::anatomy;

// Uncoupled nodes on the z axis: Winkler's foundation of `foundation` N/mm^2. The first stands for half as much of
// the line as the others.
inline CondensedBody winkler_body(int count, double spacing, double foundation) {
  CondensedBody body;
  for (int i = 0; i < count; ++i) {
    body.mesh_nodes.push_back(static_cast<std::uint32_t>(i));
    body.nodes.emplace_back(0.0, 0.0, spacing * i);
    body.tissues.push_back(tissue::soft);
  }
  body.compliance = Eigen::MatrixXd::Identity(3 * count, 3 * count) / (foundation * spacing);
  body.compliance.topLeftCorner<3, 3>() *= 2.0;
  return body;
}

}  // namespace bodkin::checks
