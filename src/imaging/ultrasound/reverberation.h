#pragma once

#include <span>

#include "imaging/ultrasound/echo_rows.h"

namespace bodkin::imaging {

// What a probe's face throws back of an echo that returns to it, as an amplitude.
inline constexpr double face_reflects = 0.25;

// Adds what comes of sound that runs between the face and each line's first strong surface again and again: the n-th
// echo seems n times as deep, and is face_reflects^(n-1) E^n strong when the first is E. Behind gas, where hardly
// anything else is seen, sound that has been scattered about adds a haze that fades with depth. `strong_at` (sample,
// < 0: none) and `strong_echo` by line.
void add_reverberation(const EchoRows& rows, std::span<const float> strong_at, std::span<const float> strong_echo,
                       double spacing) noexcept;

}  // namespace bodkin::imaging
