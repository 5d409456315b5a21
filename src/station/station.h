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
  toggle_hold,      // the needle stays in place while the hand moves, and is grasped again
  toggle_clutch,    // the needle stays in place while the hand moves, and follows from there
  press_plunger,    // on the case's syringe; a second hand on the plunger is the thumb itself
  release_plunger,  // as at the start; a simulated or recorded hand presses all the time
  turn_finger,      // a finger palpates the skin instead of the needle, or the needle is used again
  turn_stylet,      // removed from the needle, or reinserted
  turn_manometer,   // connected, or removed
  turn_breath,      // the patient is asked to hold the breath, or to breathe
  end
};

struct StationResult {
  session::RunResult run;                 // its notes: everything that the person should know
  std::uint64_t ultrasound_pictures = 0;  // number of images
};

// A session in which a hand on a device performs a procedure, assembled from options: device, servo, haptic tick,
// deformable body, second hand, probe, ultrasound, recorder. The command `bodkin perform`, an application, a server
// and a test all start this class.
//
//   Station station(options, observer);          // everything is checked, opened and prepared
//   const StationResult result = station.run();  // until a command, the device, the time or the disk ends it
//
// run() is start(), update() until ended(), and finish(), for callers without a loop of their own. Except for end(),
// all functions belong to one thread. The force begins with start(), which arms the devices.
class Station {
 public:
  // Throws InputError and SystemError, one sentence each. `observer` must outlive the station.
  Station(StationOptions options, StationObserver& observer);
  // Stops the devices unless finish() did.
  ~Station();
  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;

  StationResult run();

  // Starts the devices, the recording and the clock.
  void start();
  // To be called at least every 0.1 s, from start() to finish(): supervises the deformable body, reports events, and
  // refreshes the status, which is valid until the next call.
  const StationStatus& update();
  bool ended() const noexcept;
  // Zero force, end of the loops, and the recording closed. Throws SystemError if the device never responded, and the
  // error of a failed recording.
  StationResult finish();

  // Replaces the points of StationObserver::prepare() (LPS mm, at rest), for a needle that has entered at `entry`
  // (FollowedPoints::follow); the observer must have requested some. Throws InputError and SystemError if the memory
  // for them is refused, and keeps the previous ones.
  void follow(const std::vector<Vec3>& points, const Vec3& entry);

  void command(StationCommand command);
  // Moves the body in the workspace of the needle's device: `middle` (LPS mm) to its middle, rotated by `rotation`
  // (operator's frame to patient). It moves smoothly as WorkspaceSettings say, and stops when the needle touches it.
  // False, without effect: the needle touches it now, or there is a second hand, whose workspace would stay behind.
  bool move_body(const Vec3& middle, const Mat3& rotation);
  // Changes the force models' numbers in the running session; see HandSession::change_numbers. Errors are reported in
  // StationStatus::message.
  void change_numbers(const anatomy::HapticSettings& haptics, const std::vector<anatomy::TissueProperties>& tissues);
  // Any thread, and signal handlers.
  void end() noexcept;
  // The pose of the ultrasound probe and the settings of the machine; the pose is ignored while the second hand holds
  // the probe. No effect without ultrasound.
  void set_scan_setup(const ScanSetup& setup);

  // With the limits of the device.
  const anatomy::Case& patient() const noexcept;

 private:
  struct Parts;

  std::unique_ptr<Parts> parts_;
};

}  // namespace bodkin::station
