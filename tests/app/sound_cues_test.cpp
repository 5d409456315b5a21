#include "app/models/sound_cues.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

Frame frame_at(double clock) {
  Frame frame;
  frame.state = State::in_tissue;
  frame.clock = clock;
  return frame;
}

session::SessionEvent event_of(forces::EventKind kind) {
  session::SessionEvent event;
  event.event.kind = kind;
  return event;
}

TEST(SoundCues, a_layer_that_gives_way_is_heard_once) {
  SoundCues cues;
  EXPECT_FALSE(cues.cue_for(frame_at(1.0)).has_value());
  const session::SessionEvent give = event_of(forces::EventKind::puncture);
  Frame frame = frame_at(1.1);
  frame.events = {&give, 1};
  EXPECT_EQ(cues.cue_for(frame), Sound::give);
  frame.clock = 1.2;
  EXPECT_FALSE(cues.cue_for(frame).has_value()) << "250 ms apart at least";
  frame.clock = 1.4;
  EXPECT_EQ(cues.cue_for(frame), Sound::give);
}

TEST(SoundCues, a_warning_is_repeated_every_two_seconds_and_bone_knocks_once) {
  SoundCues cues;
  Frame frame = frame_at(0.0);
  frame.warning = Warning{Warning::Kind::nerve, "Nerve", ""};
  int heard = 0;
  for (double clock = 0.0; clock < 5.0; clock += 0.016) {
    frame.clock = clock;
    if (const auto sound = cues.cue_for(frame)) {
      EXPECT_EQ(*sound, Sound::warning);
      ++heard;
    }
  }
  EXPECT_EQ(heard, 3);
  frame.warning.reset();
  frame.clock = 6.0;
  EXPECT_FALSE(cues.cue_for(frame).has_value());
  frame.warning = Warning{Warning::Kind::bone, "Bone", ""};
  heard = 0;
  for (double clock = 7.0; clock < 12.0; clock += 0.016) {
    frame.clock = clock;
    if (const auto sound = cues.cue_for(frame)) {
      EXPECT_EQ(*sound, Sound::bone);
      ++heard;
    }
  }
  EXPECT_EQ(heard, 1);
}

TEST(SoundCues, the_target_is_heard_when_it_is_reached_and_not_while_it_lasts) {
  SoundCues cues;
  Frame frame = frame_at(1.0);
  frame.target_reached = true;
  EXPECT_EQ(cues.cue_for(frame), Sound::target);
  frame.clock = 3.0;
  EXPECT_FALSE(cues.cue_for(frame).has_value());
  frame.target_reached = false;
  frame.clock = 4.0;
  EXPECT_FALSE(cues.cue_for(frame).has_value());
  frame.target_reached = true;
  frame.clock = 5.0;
  EXPECT_EQ(cues.cue_for(frame), Sound::target);
}

// Cycles per second between two times, from upward zero crossings of the curve.
double frequency_of(const std::vector<float>& samples, double from, double to, double rate) {
  int crossings = 0;
  double first = -1.0, last = -1.0;
  for (auto i = static_cast<std::size_t>(from * rate) + 1; i < static_cast<std::size_t>(to * rate); ++i) {
    if (!(samples[i - 1] < 0.0F && samples[i] >= 0.0F)) continue;
    last = static_cast<double>(i) / rate;
    if (first < 0.0) first = last;
    ++crossings;
  }
  return (crossings - 1) / (last - first);
}

TEST(Sounds, have_the_pitch_and_the_length_that_the_design_says) {
  constexpr double rate = 44100.0;
  const std::vector<float> warning = samples_of(Sound::warning, rate);
  EXPECT_NEAR(frequency_of(warning, 0.01, 0.13, rate), 880.0, 5.0);
  EXPECT_NEAR(frequency_of(warning, 0.15, 0.27, rate), 660.0, 5.0);
  const std::vector<float> target = samples_of(Sound::target, rate);
  EXPECT_LT(frequency_of(target, 0.01, 0.13, rate), frequency_of(target, 0.15, 0.27, rate)) << "it rises";
  const std::vector<float> bone = samples_of(Sound::bone, rate);
  EXPECT_NEAR(static_cast<double>(bone.size()) / rate, 0.08, 1e-4);
  EXPECT_NEAR(frequency_of(bone, 0.0, 0.08, rate), 120.0, 3.0);
  EXPECT_NEAR(static_cast<double>(samples_of(Sound::give, rate).size()) / rate, 0.012, 1e-4);
  for (int i = 0; i < sound_count; ++i) {
    for (const float sample : samples_of(static_cast<Sound>(i), rate)) ASSERT_LE(std::abs(sample), 1.0F);
  }
}

TEST(Sounds, are_whole_wav_files) {
  const std::vector<char> bytes = wav_of(Sound::warning);
  const auto word = [&bytes](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, &bytes[at], sizeof value);
    return value;
  };
  EXPECT_EQ(std::string(bytes.data(), 4), "RIFF");
  EXPECT_EQ(word(4), bytes.size() - 8);
  EXPECT_EQ(word(24), 44100U);
  EXPECT_EQ(word(40), bytes.size() - 44);
}

}  // namespace
}  // namespace bodkin::app
