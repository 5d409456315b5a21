#pragma once

namespace bodkin {

inline constexpr double one_tick = 0.001;  // s, of a loop at 1 kHz

}  // namespace bodkin
