#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "views/frame.h"

namespace bodkin::app {

using namespace views;

// Audible signals; each has a visible counterpart.
enum class Sound : std::uint8_t {
  give,     // a layer was punctured
  bone,     // the tip touches bone
  warning,  // the tip is in a forbidden place
  target    // the target is reached
};
inline constexpr int sound_count = 4;

// Selects the sound of a frame; at most one every 250 ms, a warning again every 2 s while it lasts.
class SoundCues {
 public:
  std::optional<Sound> cue_for(const Frame& frame);

 private:
  double last_ = -1.0, last_warning_ = -1.0;  // s of the clock
  bool warned_ = false, reached_ = false;
};

// Samples of a sound, -1 to 1, `rate` a second: give is a click of 12 ms, bone a knock of 80 ms at 120 Hz, warning
// two tones of 880 and 660 Hz, target two rising tones of 660 and 880 Hz.
std::vector<float> samples_of(Sound sound, double rate);

// The same as the bytes of a WAV file, 16 bits, one channel, 44.1 kHz.
std::vector<char> wav_of(Sound sound);

}  // namespace bodkin::app
