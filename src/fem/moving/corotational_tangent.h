#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "fem/solid/elastic_assembly.h"
#include "fem/solid/elastic_body.h"

namespace bodkin::fem {

// How an element that is turned and strained resists a further small displacement: the derivative of its force
// (CorotationalElements), with g_a the gradients of the shape functions turned by R, S = R^T F and Y = tr(S) 1 - S,
//
//   K_ab = stiffness_block(g_a, g_b) + V / 2 [g_a]x^T B [g_b]x,   B = R (2 mu 1 + 2 (lambda tr(S - 1) - 2 mu) Y^-1)
//   R^T
//
// The first term is the stiffness of the unstrained element, turned. The second is what stress adds: its principal
// values are (p_i + p_j) / (s_i + s_j), p the principal stresses: above 0 in tension, below in compression.
enum class StressStiffness {
  exact,     // both signs: positive definite as a whole wherever the body is at rest and would not buckle
  positive,  // principal values of B below 0 left out: positive definite always
};

// The stiffness of a whole body about a state, N/mm, into `system`, which must come from plan_body() of the body:
// derivatives of all forces by all free nodes at `places` (mm; a column a node of the mesh, more rows than 3 are
// passed over). Nodes with `held` not zero (by node of the mesh; empty: none) are held where they are, though not by
// fixed nodes leave the equations: a spring of tangent_holding times the stiffest node's takes the place of
// their stiffness. Places must be finite.
void assemble_tangent(const BodyDescription& body, const Eigen::Ref<const Eigen::MatrixXd>& places,
                      std::span<const std::uint8_t> held, StressStiffness stress, ElasticSystem& system);

inline constexpr double tangent_holding = 1000.0;

}  // namespace bodkin::fem
