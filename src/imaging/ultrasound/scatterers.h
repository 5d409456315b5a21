#pragma once

#include <cstdint>
#include <vector>

namespace bodkin::imaging {

// What makes speckle: a block of cells, each with a scatterer of random strength and phase (complex, normal) and a
// number that decides whether a tissue of low density has it. The patient is filled with it, over and over; so
// speckle stays with the patient when the probe moves. Any linear filter of it is again complex and normal, and its
// modulus has Rayleigh's distribution. The same on every machine.
struct Scatterers {
  std::vector<std::uint32_t> cells;  // scan::cells^3, as scan::March::scatterers; SD of each part 64 / sqrt(2)
  std::vector<std::int8_t> bundles;  // scan::bundles^3: muscle fibres brighter and darker than their mean, +-127
};

// The one block that all patients share, made on first use.
const Scatterers& scatterers();

}  // namespace bodkin::imaging
