#pragma once

#include <cstdint>

#include "desktop/sdl_screen.h"
#include "station/live_scan.h"
#include "station/scan_thread.h"
#include "station/ultrasound_choice.h"

#include "anatomy/case.h"

namespace bodkin::desktop {

// The ultrasound beside a needle that somebody holds: the newest picture, and the keys of the machine and the probe.
// All of it for one thread.
class UltrasoundPane {
 public:
  static constexpr double width = 560.0, height = 600.0;  // pixels

  // `has_body`: the pictures show how a deformable body moves. `x`, `y`: its corner in the window. Throws InputError
  // when there is no place for the probe.
  UltrasoundPane(const anatomy::Case& patient, const station::UltrasoundChoice& choice, bool has_body, double x,
                 double y);

  // Handles a key if it is one of the pane's; otherwise returns false.
  bool handle(const ScreenEvent& event);
  // Advances what held keys do, and shows this picture from now on; some sixty times a second. `probe_is_held`: a
  // second hand holds the probe.
  void update(const station::LivePicture& picture, bool probe_is_held);
  // Where the keys have the probe, and how they have set the machine.
  station::ScanOrder order() const { return {scan_.pose(), scan_.settings()}; }
  void draw(SdlScreen& screen) const;

 private:
  anatomy::UltrasoundProbe probe_;
  anatomy::Needle needle_;
  double x_, y_;
  station::LiveScan scan_;
  bool held_ = false;      // by a second hand
  double updated_ = -1.0;  // s of the steady clock
  std::uint64_t made_ = 0;
  std::uint64_t counted_ = 0;  // pictures, at `counting_` s
  double counting_ = -1.0;
  double rate_ = 0.0;  // a second
  double most_ = 0.0, left_out_ = 0.0, milliseconds_ = 0.0;
  bool has_body_;
};

}  // namespace bodkin::desktop
