#pragma once

#include <span>

#include "imaging/ultrasound/echo_lines.h"

namespace bodkin::imaging {

// The amplitude reflected by a probe's face from an echo that returns to it.
inline constexpr double face_reflects = 0.25;

// Adds the echoes of sound that runs repeatedly between the face and each line's first strong surface: the n-th echo
// appears n times as deep, and is face_reflects^(n-1) E^n strong when the first is E. Behind gas, where hardly
// anything else is visible, scattered sound adds a haze that fades with depth. `strong_at` (sample, < 0: none) and
// `strong_echo` by line.
void add_reverberation(const EchoLines& rows, std::span<const float> strong_at, std::span<const float> strong_echo,
                       double spacing) noexcept;

}  // namespace bodkin::imaging
