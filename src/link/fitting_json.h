#pragma once

#include <cstddef>
#include <string>

namespace bodkin::link {

// Capacity of a STRING, bytes.
inline constexpr std::size_t longest_string = 65535;

// A JSON object as text of at most `most` bytes: its longest members are reduced, arrays by their last half, others
// entirely, until it fits; `left_out` then lists them. Any other text is returned unchanged.
std::string fitting_json(const std::string& object, std::size_t most = longest_string);

}  // namespace bodkin::link
