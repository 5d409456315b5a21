#pragma once

namespace bodkin {

// Whether a sanitizer watches this program: it takes up to thirty times as long, and does not look for rare numbers.
#if defined(BODKIN_ADDRESS_SANITIZER) || defined(BODKIN_THREAD_SANITIZER)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace bodkin
