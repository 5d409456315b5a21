#include "fem/solid/factor_layout.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::fem {

namespace {

bool is_permutation(std::span<const std::uint32_t> position) {
  std::vector<bool> met(position.size(), false);
  for (const std::uint32_t at : position) {
    if (at >= met.size() || met[at]) return false;
    met[at] = true;
  }
  return true;
}

// Every supernode has columns, together all nodes, and as many rows as are stored.
bool sizes_fit(std::span<const FactorLayout::Size> sizes, std::size_t nodes, std::size_t rows) {
  std::uint64_t all_columns = 0, all_rows = 0;
  for (const FactorLayout::Size& size : sizes) {
    if (size.columns == 0) return false;
    all_columns += size.columns;
    all_rows += size.rows;
  }
  return all_columns == nodes && all_rows == rows;
}

// The rows that a supernode changes lie below it, ascending, and are all columns or rows of its parent.
bool passes_all_on(const FactorLayout& layout, const FactorLayout::Part& part) {
  const std::span<const std::uint32_t> rows(layout.rows.data() + part.rows_at, part.rows);
  if (rows.empty()) return true;
  if (rows.front() < part.first + part.columns || rows.back() >= layout.position.size()) return false;
  if (std::adjacent_find(rows.begin(), rows.end(), std::greater_equal<>()) != rows.end()) return false;
  const FactorLayout::Part& parent = layout.parts[part.parent];
  const auto after = std::lower_bound(rows.begin(), rows.end(), parent.first + parent.columns);
  const std::span<const std::uint32_t> higher(layout.rows.data() + parent.rows_at, parent.rows);
  return std::includes(higher.begin(), higher.end(), after, rows.end());
}

}  // namespace

// A supernode with its rows in place; its parent is known only when all are.
void FactorLayout::add(Size size) {
  Part part;
  if (!parts.empty()) {
    part.first = parts.back().first + parts.back().columns;
    part.rows_at = parts.back().rows_at + parts.back().rows;
  }
  part.columns = size.columns;
  part.rows = size.rows;
  const std::size_t width = 3 * std::size_t{size.columns};
  part.own_at = numbers;
  part.below_at = part.own_at + triangle_size(width);
  numbers = part.below_at + strip_rows * strips_of(3 * std::size_t{size.rows}) * width;
  part.parent = static_cast<std::uint32_t>(parts.size());
  part_of.insert(part_of.end(), size.columns, part.parent);
  parts.push_back(part);
}

FactorLayout::FactorLayout(const SymbolicFactor& symbolic) : position(symbolic.position), rows(symbolic.rows) {
  for (const Supernode& supernode : symbolic.supernodes) add({supernode.columns, supernode.rows});
  for (Part& part : parts)
    if (part.rows > 0) part.parent = part_of[rows[part.rows_at]];
}

FactorLayout::FactorLayout(std::vector<std::uint32_t> positions, std::span<const Size> sizes,
                           std::vector<std::uint32_t> below)
    : position(std::move(positions)), rows(std::move(below)) {
  if (!is_permutation(position)) throw InputError("its order of elimination does not name each node once");
  if (!sizes_fit(sizes, position.size(), rows.size()))
    throw InputError("the sizes of its supernodes do not fit the number of nodes");
  for (const Size& size : sizes) add(size);
  for (Part& part : parts) {
    if (part.rows == 0) continue;
    if (rows[part.rows_at] >= position.size()) throw InputError("one of its rows is beyond the last node");
    part.parent = part_of[rows[part.rows_at]];
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].rows > 0 && (parts[i].parent <= i || !passes_all_on(*this, parts[i])))
      throw InputError(fmt::format("its supernode {} changes what its parent does not know", i));
  }
}

std::size_t FactorLayout::bytes() const noexcept {
  return sizeof(Part) * parts.size() + sizeof(std::uint32_t) * (position.size() + part_of.size() + rows.size());
}

}  // namespace bodkin::fem
