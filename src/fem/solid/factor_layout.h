#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fem/solid/symbolic_factor.h"

namespace bodkin::fem {

// A factor is packed in strips of this many rows: for each column of the supernode, the strip's numbers in it.
inline constexpr std::size_t strip_rows = 8;

constexpr std::size_t strips_of(std::size_t rows) {
  return (rows + strip_rows - 1) / strip_rows;
}

// Numbers in a packed triangle: strip i has 8 (i + 1) columns.
constexpr std::size_t triangle_size(std::size_t width) {
  const std::size_t strips = strips_of(width);
  return strip_rows * strip_rows * strips * (strips + 1) / 2;
}

// The structure of a factor and the positions of its numbers: its supernodes in the order of elimination, each after
// those below it in the elimination tree.
struct FactorLayout {
  // The number of nodes of a supernode, and of nodes below it.
  struct Size {
    std::uint32_t columns = 0, rows = 0;
  };
  struct Part {
    std::uint32_t first = 0, columns = 0;  // nodes, in the order of elimination
    std::uint32_t rows = 0;                // nodes below
    std::size_t rows_at = 0;               // into FactorLayout::rows
    std::size_t own_at = 0, below_at = 0;  // into the numbers
    std::uint32_t parent = 0;              // a later part; itself: none
  };

  explicit FactorLayout(const SymbolicFactor& symbolic);
  // `position`: of each node in the order of elimination. `sizes`: of each supernode. `rows`: positions below each
  // supernode, one supernode after another. Throws InputError, one sentence, when no factor can have this structure.
  FactorLayout(std::vector<std::uint32_t> position, std::span<const Size> sizes, std::vector<std::uint32_t> rows);

  std::vector<std::uint32_t> position;  // of each node in the order of elimination
  std::vector<std::uint32_t> part_of;   // by position
  std::vector<std::uint32_t> rows;      // positions
  std::vector<Part> parts;              // one per supernode
  std::size_t numbers = 0;              // of all supernodes

  std::size_t bytes() const noexcept;  // without the numbers

 private:
  void add(Size size);
};

}  // namespace bodkin::fem
