#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "station/hand_session.h"
#include "station/scan_thread.h"
#include "station/second_hand.h"

#include "anatomy/case.h"
#include "core/progress.h"
#include "fem/solid/elastic_body.h"
#include "haptics/servo_records.h"

namespace bodkin::station {

class Station;

struct SecondStatus {
  session::SecondRole role = session::SecondRole::plunger;
  session::SecondSample sample;
};

// A running session as an observer sees it.
struct StationStatus {
  double time = 0.0;  // s on the clock since the start
  haptics::ServoSnapshot servo;
  HandSnapshot needle;
  std::span<const forces::DiagnosticName> diagnostic_names;  // of its output
  std::span<const HandSample> samples;                       // every tick since the last status
  std::span<const session::SessionEvent> events;             // of the needle, since the last status
  haptics::ServoTimings timings;                             // published every hundred ticks
  std::optional<SecondStatus> second;
  std::string message;                    // the newest sentence for the person
  std::span<const float> displacements;   // mm, x y z of every point of StationObserver::prepare()
  const LiveImage* ultrasound = nullptr;  // the newest image; null: no ultrasound
  bool probe_is_held = false;             // the second hand holds the ultrasound probe
  bool plunger_pressed = false;           // the thumb is on the plunger of the case's syringe
};

// Observer and controller of a running session: a window, a terminal, a server, a test. All calls come from the
// thread that runs the station; no override is required.
class StationObserver {
 public:
  virtual ~StationObserver() = default;

  // For the work before the start.
  virtual Progress progress() { return {}; }
  // A sentence for the person: an assumption, an event.
  virtual void note(const std::string& /*sentence*/) {}
  // Once, before any device opens. `patient` and `body` (null: rigid) stay valid while the station lives. Returns the
  // points (LPS mm, at rest) whose displacements are required in every status.
  virtual std::vector<Vec3> prepare(const anatomy::Case& /*patient*/, const fem::BodyDescription* /*body*/) {
    return {};
  }
  // Time between two calls of update().
  virtual std::chrono::milliseconds interval() const { return std::chrono::milliseconds(100); }
  // While the session runs. May send commands to the station.
  virtual void update(Station& /*station*/, const StationStatus& /*status*/) {}
};

}  // namespace bodkin::station
