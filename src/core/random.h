#pragma once

#include <cstdint>

namespace bodkin {

// A 64-bit mix with good avalanche (SplitMix64 finaliser, Steele, Lea and Flood 2014): equal inputs give equal
// outputs on every machine, neighbouring inputs give unrelated ones. The base of all randomness in Bodkin.
constexpr std::uint64_t mix64(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

// A uniform number in [-1, 1) that depends only on the two arguments.
constexpr double hash_noise(std::uint64_t seed, std::int64_t cell) {
  const std::uint64_t bits = mix64(seed ^ mix64(static_cast<std::uint64_t>(cell)));
  return static_cast<double>(bits >> 11) * 0x1.0p-52 - 1.0;
}

// A seeded generator whose sequence is the same on every machine (std::normal_distribution's is not).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(mix64(seed)) {}

  // Uniform 64 bits.
  std::uint64_t next();
  // Uniform in [0, 1).
  double uniform();
  // Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  // Normal with mean 0 and standard deviation 1 (Box and Muller 1958, one number a call).
  double normal();

 private:
  std::uint64_t state_;
};

}  // namespace bodkin
