#pragma once

#include <cstdint>
#include <vector>

namespace bodkin::imaging {

// The source of speckle: a block of cells, each with a scatterer of random strength and phase (complex, normal) and a
// number that determines whether a tissue of low density has it. The patient is tiled with it, so speckle stays with
// the patient when the probe moves. Any linear filter of it is again complex and normal, and its modulus has a
// Rayleigh distribution. The same on every machine.
struct Scatterers {
  std::vector<std::uint32_t> cells;  // scan::cells^3, see scan::March::scatterers; SD of each part 64 / sqrt(2)
  std::vector<std::int8_t> bundles;  // scan::bundles^3: muscle fibres brighter and darker than their mean, +-127
};

// The one block shared by all patients, created on first use.
const Scatterers& scatterers();

}  // namespace bodkin::imaging
