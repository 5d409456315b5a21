#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>

#include "station/screen_event.h"
#include "station/ultrasound_choice.h"

#include "anatomy/case.h"
#include "imaging/ultrasound_screen/screen.h"

namespace bodkin::station {

// A person's use of a probe and its machine, from events of mouse and keyboard: the place of the probe, the settings
// of the knobs, the place of the needle, measurements. Independent of any window.
class LiveScan {
 public:
  // The machine's image is `width` x `height` pixels with its corner at (x, y) of the window.
  struct Place {
    double x = 0.0, y = 0.0;
    int width = 700, height = 600;
    // The sliders of the time-gain compensation, row below row, while they are shown; the middle of a row is 0 dB,
    // its ends are the ends of a slider's range.
    double sliders_x = 0.0, sliders_y = 0.0, sliders_width = 0.0;
  };
  static constexpr double slider_row = 18.0;   // pixels from one slider to the next
  static constexpr double slider_most = 20.0;  // dB, up and down
  LiveScan(const anatomy::Case& patient, const UltrasoundChoice& choice, const imaging::ProbeOnSkin& hand,
           const std::optional<imaging::NeedleInUltrasound>& needle, const Place& place);

  // Moves or resizes the image in the window.
  void set_place(const Place& place);
  const Place& place() const { return place_; }

  void take(const ScreenEvent& event);
  // The effect of held keys in `seconds`.
  void advance(double seconds);

  Pose pose() const { return hand_.pose(); }
  const imaging::UltrasoundSettings& settings() const { return settings_; }
  // In the patient; empty while it is out or if the case has no path.
  std::optional<imaging::NeedleInUltrasound> needle() const;
  std::string needle_words() const;
  // mm of the needle beyond its entry; negative while it is out.
  double needle_depth() const { return needle_in_ ? needle_depth_ : -1.0; }
  imaging::UltrasoundScreen& screen() { return screen_; }
  const imaging::UltrasoundScreen& screen() const { return screen_; }

  bool ended() const { return ended_; }
  bool help() const { return help_; }
  bool sliders_shown() const { return sliders_; }
  bool measuring() const { return calipers_; }  // a click sets a caliper instead of moving the probe
  // The latest message to the person; may be empty.
  const std::string& message() const { return message_; }
  void set_message(std::string message) { message_ = std::move(message); }
  // Whether an image was requested since the last call.
  bool take_save();

 private:
  void press(ScreenKey key, bool shift);
  void drag(double x, double y);
  void slide(double along, double across);
  std::optional<std::size_t> slider_at(const Eigen::Vector2d& at) const;
  void set_slider(std::size_t slider, double decibels);
  void turn_slider(std::size_t slider, double decibels) { set_slider(slider, settings_.sliders[slider] + decibels); }
  void turn_knob(double& value, double step, bool shift, double low, double high);

  const anatomy::Case& patient_;
  anatomy::UltrasoundProbe probe_;
  imaging::ProbeOnSkin hand_;
  imaging::UltrasoundSettings settings_;
  imaging::UltrasoundScreen screen_;
  Place place_;
  bool needle_in_ = false;
  double needle_depth_ = 0.0;  // mm
  imaging::OrientationMarkerSide mark_;
  bool ended_ = false, help_ = false, calipers_ = false, save_ = false, sliders_ = false;
  std::string message_;
  std::set<ScreenKey> held_;
  bool shift_ = false;
  std::optional<Eigen::Vector2d> pointer_;  // pixels of the window
  std::optional<std::size_t> held_slider_;  // by the mouse
};

}  // namespace bodkin::station
