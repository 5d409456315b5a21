#pragma once

#include <memory>
#include <optional>
#include <string>

#include "desktop/live_scan.h"
#include "desktop/sdl_screen.h"
#include "station/scan_thread.h"
#include "station/second_hand.h"
#include "station/ultrasound_choice.h"

#include "anatomy/case.h"

namespace bodkin {

// The ultrasound beside a needle that somebody holds: the newest picture of a ScanThread, and the keys of the
// machine. All of it for one thread.
class UltrasoundPane {
 public:
  static constexpr double width = 560.0, height = 600.0;  // pixels

  // `x`, `y`: its corner in the window. `body`: see ScanThread. Throws InputError when there is no place for the
  // probe.
  UltrasoundPane(const Case& patient, const UltrasoundChoice& choice, ScanBody body, double x, double y,
                 const Progress& progress = {});

  const std::shared_ptr<ScanThread>& thread() const noexcept { return thread_; }

  // Whether the key is one of the pane's; then it has been taken.
  bool take(const ScreenEvent& event);
  // Asks a second hand that holds the probe where it is, instead of the keys, and a body that moves by itself how it
  // has moved. Both may be null.
  void follow(SecondHand* second, PressedPatient* moving);
  // Sends what was done to the machine, and takes its newest picture; some sixty times a second.
  void look();
  void draw(SdlScreen& screen) const;
  std::uint64_t pictures() const noexcept { return made_; }
  // How many pictures there were in `seconds`, in one sentence.
  std::string tell(double seconds) const;

 private:
  void hold(const Pose& tool);

  UltrasoundProbe probe_;
  Needle needle_;
  double x_, y_;
  LiveScan scan_;
  std::optional<Pose> held_;
  std::shared_ptr<ScanThread> thread_;
  double looked_ = -1.0;  // s of the steady clock
  std::uint64_t made_ = 0;
  std::uint64_t counted_ = 0;  // pictures, at `counting_` s
  double counting_ = -1.0;
  double rate_ = 0.0;  // a second
  double most_ = 0.0, left_out_ = 0.0, milliseconds_ = 0.0;
  bool moves_;
};

}  // namespace bodkin
