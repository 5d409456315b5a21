#pragma once

#include <string>

namespace bodkin {

// 128 bits of the system's randomness as 32 hexadecimal digits, unique across calls and machines. For names and
// secrets; for reproducible numbers use core/random.h.
std::string random_id();

}  // namespace bodkin
