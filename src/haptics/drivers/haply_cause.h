#pragma once

namespace bodkin::haptics {

// Reasons why an Inverse3 renders no force.
enum class HaplyCause {
  none,
  silent,
  unplugged,
  without_position,
  damaged,
  uncalibrated,
  unpowered,
  braked,
  moved,
  refused
};

// As a BODKIN_ code.
int result_of(HaplyCause cause) noexcept;

// One sentence: what was found and what to do about it; "" for none.
const char* words_of(HaplyCause cause) noexcept;

}  // namespace bodkin::haptics
