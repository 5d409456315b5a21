#pragma once

#include <QString>
#include <array>

#include "app/models/sound_cues.h"

namespace bodkin::app {

// Plays short sounds through the system's player (pw-play, paplay or aplay) in a separate process, without waiting.
// Without a player or a sound device there is no sound and no error.
class Sounds {
 public:
  // With the last stored setting.
  Sounds();

  bool is_on() const { return on_; }
  void toggle();  // and stores the setting
  // False: silent, whatever the setting.
  void allow(bool allowed) { allowed_ = allowed; }
  // A player is available.
  bool can_play() const { return !player_.isEmpty(); }
  void follow(const Frame& frame);
  // Number of requested sounds since the window opened, including silenced ones.
  int heard() const { return heard_; }

 private:
  void play(Sound sound);

  SoundCues cues_;
  QString player_;
  std::array<QString, sound_count> files_;  // empty: not written yet
  bool on_, allowed_ = true;
  int heard_ = 0;
};

}  // namespace bodkin::app
