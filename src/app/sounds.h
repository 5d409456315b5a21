#pragma once

#include <QString>
#include <array>

#include "app/models/sound_cues.h"

namespace bodkin::app {

// Plays short sounds through the machine's own player (pw-play, paplay or aplay), in a process of its own: nothing
// waits for it. Without a player, or without a sound device, there is no sound and no error.
class Sounds {
 public:
  // As it was left the last time.
  Sounds();

  bool is_on() const { return on_; }
  void toggle();  // and remember
  // Silent, whatever the person has chosen, until it is allowed again.
  void allow(bool allowed) { allowed_ = allowed; }
  // There is something to play with.
  bool can_play() const { return !player_.isEmpty(); }
  void follow(const Frame& frame);
  // Sounds that were asked for since the window opened, also while it is silent.
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
