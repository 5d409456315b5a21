#include "fem/solid/body_digests.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace bodkin::fem {

namespace {

template <typename Value>
std::uint64_t chained(std::uint64_t before, const Value* values, std::size_t count) noexcept {
  return XXH3_64bits_withSeed(values, count * sizeof(Value), before);
}

}  // namespace

std::uint64_t digest_of(const PackedFactor& factor) noexcept {
  return chained(0, factor.numbers().data(), factor.numbers().size());
}

std::uint64_t points_digest_of(const anatomy::CondensedBody& body) noexcept {
  const std::uint64_t places = chained(0, body.nodes.data(), body.nodes.size());
  return chained(places, body.tissues.data(), body.tissues.size());
}

std::uint64_t digest_of(const anatomy::CondensedBody& body) noexcept {
  return chained(points_digest_of(body), body.compliance.data(), static_cast<std::size_t>(body.compliance.size()));
}

std::uint64_t digest_of(std::span<const float> moved) noexcept {
  return chained(0, moved.data(), moved.size());
}

}  // namespace bodkin::fem
