#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "session/session_run.h"
#include "station/station_observer.h"
#include "station/station_options.h"

namespace bodkin::station {

enum class StationCommand {
  arm,              // both hands feel their forces
  disarm,           // neither does
  toggle_hold,      // the needle stays where it is while the hand moves, and is taken up again
  toggle_clutch,    // the needle stays where it is while the hand moves, and follows from there
  press_plunger,    // the thumb, on that of the case's syringe; a second hand on the plunger has its own thumb
  release_plunger,  // as it is at the start; a simulated or recorded hand presses all the time
  turn_finger,      // a finger feels the skin in place of the needle, or the needle is taken again
  turn_stylet,      // it is taken out of the needle, or put back
  turn_manometer,   // it is connected, or taken off
  turn_breath,      // the patient is asked to hold the breath, or to breathe on
  end
};

struct StationResult {
  session::RunResult run;                 // its notes: all that the person should know
  std::uint64_t ultrasound_pictures = 0;  // made
};

// A session in which a hand on a device performs a procedure, put together from options: device, servo, haptic tick,
// deformable body, second hand, probe, ultrasound, recorder. The command `bodkin perform`, an
// application, a server and a test all start this.
//
//   Station station(options, observer);          // everything is checked, opened and prepared
//   const StationResult result = station.run();  // until a command, the device, the time or the disk ends it
//
// run() is start(), update() until ended(), and finish(), for callers that have no loop of their own. Except end(),
// all functions belong to one thread. The force begins with start(), which arms the devices.
class Station {
 public:
  // Throws InputError and SystemError, one sentence each. `observer` must outlive the station.
  Station(StationOptions options, StationObserver& observer);
  // Stops the devices if finish() did not.
  ~Station();
  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;

  StationResult run();

  // Starts the devices and the recording; the time begins.
  void start();
  // To be called every 0.1 s or more often, from start() to finish(): takes care of the deformable body, reports
  // events, and refreshes the status, which is valid until the next call.
  const StationStatus& update();
  bool ended() const noexcept;
  // Zero force, the end of the loops, and the recording closed. Throws SystemError if the device never answered, and
  // what went wrong with the recording.
  StationResult finish();

  // Other points (LPS mm, at rest) than those of StationObserver::prepare(), for a needle that has entered at `entry`
  // (FollowedPoints::follow); the observer must have wanted some. Throws InputError and SystemError where the memory
  // for them is refused, and goes on with those of before.
  void follow(const std::vector<Vec3>& points, const Vec3& entry);

  void command(StationCommand command);
  // The body's place in the workspace of the needle's device: `middle` (LPS mm) comes to lie in its middle, turned by
  // `rotation` (operator's frame to patient). It glides there as WorkspaceSettings say, and stops where the needle
  // touches it. False, and nothing done: the needle touches it now, or there is a second hand, whose workspace would
  // stay behind.
  bool move_body(const Vec3& middle, const Mat3& rotation);
  // Other numbers for the force models of the running session; see HandSession::change_numbers. What cannot be is
  // said in StationStatus::message.
  void change_numbers(const anatomy::HapticSettings& haptics, const std::vector<anatomy::TissueProperties>& tissues);
  // Any thread, and signal handlers.
  void end() noexcept;
  // Where the ultrasound probe is and how the machine is set; the place is ignored while the second hand holds the
  // probe. Nothing happens without ultrasound.
  void set_scan_order(const ScanOrder& order);

  // With the limits of the device.
  const anatomy::Case& patient() const noexcept;

 private:
  struct Parts;

  std::unique_ptr<Parts> parts_;
};

}  // namespace bodkin::station
