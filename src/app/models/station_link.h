#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/models/body_place.h"
#include "session/session_run.h"
#include "station/station.h"
#include "station/station_observer.h"

#include "training/procedure.h"
#include "training/store/attempt_record.h"

namespace bodkin::app {

// The result of an attempt, from its saved session.
struct AttemptResult {
  std::filesystem::path session;
  session::RunResult run;
  std::optional<training::Grade> verdict;  // empty: it cannot be judged
  bool reached = false;
  std::string headline;              // the verdict, one sentence
  std::vector<std::string> remarks;  // further ones, the worst first
  double deepest = 0.0;              // mm
  double peak_force = 0.0;           // N
  double target_distance = 0.0;      // mm
  double time_in_body = 0.0;         // s
  int bone_contacts = 0;
  std::optional<training::AttemptRecord> record;  // for a store of results; empty: no verdict
};

// Rules for judging an attempt.
struct AttemptRules {
  bool is_planned = false;  // the path of the options is a plan; without one, the attempt is not judged
  std::string procedure;    // a name or a file; empty: the case's
};

// State of the station for the window, plain values.
struct StationUpdate {
  enum class Phase { idle, preparing, running, finishing, finished, failed };
  Phase phase = Phase::idle;
  std::string stage;      // during preparation; empty: not begun
  double fraction = 0.0;  // of the stage
  std::string error;      // cause of a failure

  double time = 0.0;  // s since the start
  haptics::ServoSnapshot servo;
  station::HandSnapshot needle;
  haptics::ServoTimings timings;
  std::vector<forces::DiagnosticName> diagnostic_names;
  std::string device;
  std::optional<anatomy::DeviceLimits> limits;  // of the device; empty: none is running, or the station is remote
  std::string message;                          // the newest sentence
  std::vector<std::string> notes;               // since the last poll
  static constexpr std::size_t most_samples = 20000;
  std::vector<station::HandSample> samples;  // since the last poll; the number is limited
  std::vector<session::SessionEvent> events;
  std::vector<float> displacements;  // mm, of the requested points
  std::shared_ptr<const station::LiveImage> ultrasound;
  std::optional<AttemptResult> result;  // after the end
  std::string connection;               // of a remote station: why there is no connection; empty: connected
};

class RemoteStation;

// Runs a station on a separate thread, or follows a remote one. The window reads the news once a frame and sends
// commands; each waits for the other only during a copy, and the haptic tick waits for neither.
class StationLink {
 public:
  StationLink();
  // Ends and saves the session.
  ~StationLink();
  StationLink(const StationLink&) = delete;
  StationLink& operator=(const StationLink&) = delete;

  // Ends the present session and begins another. `points`: of a deformable body, LPS mm at rest, to be followed.
  void start(station::StationOptions options, const std::string& device, AttemptRules rules,
             std::vector<Vec3> points = {});
  // Ends the present session and follows this station; end() ends its session, stop() only disconnects.
  void follow(std::unique_ptr<RemoteStation> station);
  // Replaces the points, for a needle that has entered at `entry`; see station::Station::follow. They are at rest
  // until the station has received them.
  void follow_points(std::vector<Vec3> points, const Vec3& entry);
  void command(station::StationCommand command);
  void set_scan_setup(const station::ScanSetup& setup);
  // See station::Station::move_body; the last request before the station runs takes effect too.
  void move_body(const BodyPlace& place);
  // See station::Station::change_numbers; the last request before the station runs takes effect too.
  void change_numbers(const anatomy::HapticSettings& haptics, const std::vector<anatomy::TissueProperties>& tissues);
  // Ends the session; the news report when it is saved. A session in preparation is cancelled and leaves no file.
  void end();
  // Ends the session, and waits until it is saved.
  void stop();

  // The news since the last call; valid until the next one.
  const StationUpdate& poll();
  // The result of the last poll().
  const StationUpdate& news() const noexcept { return news_; }

 private:
  class Observer;
  struct Shared;

  std::shared_ptr<Shared> shared_;
  std::unique_ptr<RemoteStation> remote_;  // null: a local station
  std::jthread thread_;
  StationUpdate news_;
};

}  // namespace bodkin::app
