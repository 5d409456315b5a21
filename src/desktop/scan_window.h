#pragma once

#include <string>

#include "desktop/sdl_screen.h"
#include "station/live_scan.h"

#include "imaging/slice.h"

namespace bodkin::desktop {

// How long it took, for people.
struct ScanPace {
  double picture = 0.0;  // ms for the newest ultrasound picture
  double frames = 0.0;   // of the window a second
};

// The window of `bodkin ultrasound --live`: the machine's screen, beside it the CT in the same plane. For one thread.
class ScanWindow {
 public:
  // Throws as SdlScreen does.
  ScanWindow(const anatomy::Case& patient, imaging::MarkSide mark);

  // Where the machine's screen lies in it.
  static station::LiveScan::Place machine_place();

  bool next(ScreenEvent& event) { return screen_.next(event); }
  void draw(const station::LiveScan& scan, const ScanPace& pace);

 private:
  void draw_gain(const station::LiveScan& scan);
  void draw_ct(const station::LiveScan& scan);
  void draw_ct_lines(const station::LiveScan& scan);
  void draw_keys();
  void draw_foot(const station::LiveScan& scan, const ScanPace& pace);
  void draw_help();

  const anatomy::Case& patient_;
  imaging::MarkSide mark_;
  SdlScreen screen_;
  imaging::SlicePlane ct_plane_;  // that was cut last
  imaging::ImageRgb ct_;
};

}  // namespace bodkin::desktop
