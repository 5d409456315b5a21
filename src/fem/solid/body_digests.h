#pragma once

#include <cstdint>

#include "anatomy/condensed_body.h"
#include "fem/solid/packed_factor.h"

namespace bodkin::fem {

// Fingerprints (XXH3, 64 bits) of what a body was computed to, the same on every machine: of the Cholesky factor, and
// of the nodes or contact points, their tissues and the compliance between them.
std::uint64_t digest_of(const PackedFactor& factor) noexcept;
std::uint64_t digest_of(const anatomy::CondensedBody& body) noexcept;

}  // namespace bodkin::fem
