#pragma once

#include <cstddef>
#include <string>

namespace bodkin::link {

// What a STRING holds, bytes.
inline constexpr std::size_t longest_string = 65535;

// A JSON object as text of at most `most` bytes: of its longest members arrays lose their last half, others go, until
// it fits; `left_out` then names them. What is no object comes back as it is.
std::string fitting_json(const std::string& object, std::size_t most = longest_string);

}  // namespace bodkin::link
