#include "app/models/sound_cues.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace bodkin::app {

namespace {

constexpr double sounds_apart = 0.25, warning_again = 2.0;  // s
constexpr double soft_edge = 0.004;  // s in which a tone rises and falls, so that it does not click
constexpr double loudness = 0.5;

void add_tone(std::vector<float>& samples, double frequency, double seconds, double rate) {
  const auto count = static_cast<std::size_t>(std::lround(seconds * rate));
  for (std::size_t i = 0; i < count; ++i) {
    const double time = static_cast<double>(i) / rate;
    const double edge = std::min({1.0, time / soft_edge, (seconds - time) / soft_edge});
    samples.push_back(static_cast<float>(loudness * edge * std::sin(2.0 * std::numbers::pi * frequency * time)));
  }
}

// A tone that dies away: a knock.
void add_knock(std::vector<float>& samples, double frequency, double seconds, double rate) {
  const auto count = static_cast<std::size_t>(std::lround(seconds * rate));
  for (std::size_t i = 0; i < count; ++i) {
    const double time = static_cast<double>(i) / rate;
    const double fade = std::exp(-5.0 * time / seconds);
    samples.push_back(static_cast<float>(loudness * fade * std::sin(2.0 * std::numbers::pi * frequency * time)));
  }
}

template <typename Number>
void add_bytes(std::vector<char>& bytes, Number value, int count) {
  for (int i = 0; i < count; ++i)
    bytes.push_back(static_cast<char>((static_cast<std::uint32_t>(value) >> (8 * i)) & 255U));
}

}  // namespace

std::optional<Sound> SoundCues::cue_for(const Frame& frame) {
  const bool is_warning = frame.warning.has_value() && frame.state != State::paused;
  const bool is_bone = is_warning && frame.warning->kind == Warning::Kind::bone;
  std::optional<Sound> wanted;
  for (const session::SessionEvent& event : frame.events) {
    using forces::EventKind;
    if (event.event.kind == EventKind::puncture || event.event.kind == EventKind::loss_of_resistance)
      wanted = Sound::give;
  }
  if (frame.target_reached && !reached_) wanted = Sound::target;
  if (is_warning && !warned_) wanted = is_bone ? Sound::bone : Sound::warning;
  if (is_warning && warned_ && !is_bone && frame.clock - last_warning_ >= warning_again) wanted = Sound::warning;
  if (!wanted || (last_ >= 0.0 && frame.clock - last_ < sounds_apart)) {
    if (!is_warning) warned_ = false;
    if (!frame.target_reached) reached_ = false;
    return std::nullopt;  // sounds too early for this frame come with a later one
  }
  last_ = frame.clock;
  warned_ = is_warning;
  if (is_warning) last_warning_ = frame.clock;
  reached_ = frame.target_reached;
  return wanted;
}

std::vector<float> samples_of(Sound sound, double rate) {
  constexpr double note = 0.14;  // s
  std::vector<float> samples;
  switch (sound) {
    case Sound::give:
      add_knock(samples, 1200.0, 0.012, rate);
      break;
    case Sound::bone:
      add_knock(samples, 120.0, 0.08, rate);
      break;
    case Sound::warning:
      add_tone(samples, 880.0, note, rate);
      add_tone(samples, 660.0, note, rate);
      break;
    case Sound::target:
      add_tone(samples, 660.0, note, rate);
      add_tone(samples, 880.0, note, rate);
      break;
  }
  return samples;
}

std::vector<char> wav_of(Sound sound) {
  constexpr int rate = 44100, header = 36;
  const std::vector<float> samples = samples_of(sound, rate);
  const auto size = static_cast<std::uint32_t>(2 * samples.size());
  std::vector<char> bytes;
  const auto add_word = [&bytes](std::string_view word) { bytes.insert(bytes.end(), word.begin(), word.end()); };
  add_word("RIFF");
  add_bytes(bytes, header + size, 4);
  add_word("WAVEfmt ");
  add_bytes(bytes, 16, 4);        // bytes of the format
  add_bytes(bytes, 1, 2);         // PCM
  add_bytes(bytes, 1, 2);         // channels
  add_bytes(bytes, rate, 4);      // samples a second
  add_bytes(bytes, 2 * rate, 4);  // bytes a second
  add_bytes(bytes, 2, 2);         // bytes a sample
  add_bytes(bytes, 16, 2);        // bits
  add_word("data");
  add_bytes(bytes, size, 4);
  for (const float sample : samples)
    add_bytes(bytes, static_cast<std::int16_t>(std::lround(32767.0F * std::clamp(sample, -1.0F, 1.0F))), 2);
  return bytes;
}

}  // namespace bodkin::app
