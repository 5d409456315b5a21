#pragma once

#include <cstdint>
#include <span>

#include "anatomy/condensed_body.h"
#include "fem/solid/packed_factor.h"

namespace bodkin::fem {

// Digests (XXH3, 64 bits) of the results computed for a body, equal on every machine: of the Cholesky factor; of the
// nodes or contact points, their tissues and the compliance between them; of the first two only; and of the
// displacements of a mesh.
std::uint64_t digest_of(const PackedFactor& factor) noexcept;
std::uint64_t digest_of(const anatomy::CondensedBody& body) noexcept;
std::uint64_t points_digest_of(const anatomy::CondensedBody& body) noexcept;
std::uint64_t digest_of(std::span<const float> moved) noexcept;

}  // namespace bodkin::fem
