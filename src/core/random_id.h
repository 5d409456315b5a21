#pragma once

#include <string>

namespace bodkin {

// 128 bits of the system's randomness in 32 hexadecimal digits: no two calls return the same, on any machine. For
// names and secrets; numbers that must be drawn again come from core/random.h.
std::string random_id();

}  // namespace bodkin
