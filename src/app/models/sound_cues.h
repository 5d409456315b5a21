#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "views/frame.h"

namespace bodkin::app {

using namespace views;

// What is heard: each is seen as well.
enum class Sound : std::uint8_t {
  give,     // a layer gave way
  bone,     // the tip knocks on bone
  warning,  // the tip is where it must not be
  target    // the aim is reached
};
inline constexpr int sound_count = 4;

// Which sound a moment asks for; at most one every 250 ms, a warning again each 2 s while it lasts.
class SoundCues {
 public:
  std::optional<Sound> hear(const Frame& frame);

 private:
  double last_ = -1.0, last_warning_ = -1.0;  // s of the clock
  bool warned_ = false, reached_ = false;
};

// Samples of a sound, -1 to 1, `rate` a second: give a click of 12 ms, bone a knock of 80 ms at 120 Hz, warning two
// tones of 880 and 660 Hz, target two rising tones of 660 and 880 Hz.
std::vector<float> samples_of(Sound sound, double rate);

// The same as the bytes of a WAV file, 16 bits, one channel, 44.1 kHz.
std::vector<char> wav_of(Sound sound);

}  // namespace bodkin::app
