#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/geometry.h"

namespace bodkin {

// Finite numbers separated by commas or single blanks; empty when `text` is anything else.
std::vector<double> numbers_in(const std::string& text);

// Exactly `count` numbers; throws InputError naming `origin`.
std::vector<double> parse_numbers(const std::string& text, std::size_t count, const std::string& origin);

// "x,y,z" in LPS mm; throws InputError naming `origin` when `text` is not three finite numbers.
Vec3 parse_point(const std::string& text, const std::string& origin);

}  // namespace bodkin
