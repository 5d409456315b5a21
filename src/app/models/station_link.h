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

// How an attempt went, read from the session that was saved.
struct AttemptResult {
  std::filesystem::path session;
  session::RunResult run;
  std::optional<training::Grade> verdict;  // nothing: there is nothing to judge by
  bool reached = false;
  std::string headline;              // the verdict, one sentence
  std::vector<std::string> remarks;  // more of them, the worst first
  double deepest = 0.0;              // mm
  double peak_force = 0.0;           // N
  double target_distance = 0.0;      // mm
  double time_in_body = 0.0;         // s
  int bone_contacts = 0;
  std::optional<training::AttemptRecord> record;  // for a store of results; nothing: there is no verdict
};

// By what an attempt is judged.
struct AttemptRules {
  bool is_planned = false;  // the path of the options is somebody's aim; without, the attempt is not judged
  std::string procedure;    // a name or a file; empty: the case's
};

// What the window knows of the station, plain values.
struct StationNews {
  enum class Phase { idle, preparing, running, finishing, finished, failed };
  Phase phase = Phase::idle;
  std::string stage;      // while preparing; empty: it has not begun
  double fraction = 0.0;  // of the stage
  std::string error;      // why it failed

  double time = 0.0;  // s since the start
  haptics::ServoSnapshot servo;
  station::HandSnapshot needle;
  haptics::ServoTimings timings;
  std::vector<forces::DiagnosticName> diagnostic_names;
  std::string device;
  std::optional<anatomy::DeviceLimits> limits;  // of the device; nothing: none runs, or it is elsewhere
  std::string message;                          // the newest sentence
  std::vector<std::string> notes;               // since the last poll
  static constexpr std::size_t most_samples = 20000;
  std::vector<station::HandSample> samples;  // since the last poll; no more than these wait for a window
  std::vector<session::SessionEvent> events;
  std::vector<float> displacements;  // mm, of the points that were asked for
  std::shared_ptr<const station::LivePicture> ultrasound;
  std::optional<AttemptResult> result;  // when it has finished
  std::string connection;               // of a station elsewhere: why there is none now; empty: all is well
};

class RemoteStation;

// Runs a station on a thread of its own, or follows one elsewhere. The window takes the news once a frame and gives
// commands; neither waits for the other longer than a copy takes, and the haptic tick waits for none of them.
class StationLink {
 public:
  StationLink();
  // Ends the session and saves it.
  ~StationLink();
  StationLink(const StationLink&) = delete;
  StationLink& operator=(const StationLink&) = delete;

  // Ends what runs, and begins another session. `points`: of a deformable body, LPS mm at rest, that are followed.
  void start(station::StationOptions options, const std::string& device, AttemptRules rules,
             std::vector<Vec3> points = {});
  // Ends what runs, and follows this one from now on; end() ends its session, stop() looks away.
  void follow(std::unique_ptr<RemoteStation> station);
  // Other points than before, for a needle that has entered at `entry`; see station::Station::follow. Until the
  // station knows of them they are at rest.
  void follow_points(std::vector<Vec3> points, const Vec3& entry);
  void command(station::StationCommand command);
  void set_scan_order(const station::ScanOrder& order);
  // See station::Station::move_body; what was ordered last before the station runs holds as well.
  void move_body(const BodyPlace& place);
  // See station::Station::change_numbers; what was ordered last before the station runs holds as well.
  void change_numbers(const anatomy::HapticSettings& haptics, const std::vector<anatomy::TissueProperties>& tissues);
  // Ends the session; the news say when it is saved. One that is being prepared is given up, and leaves no file.
  void end();
  // Ends it, and waits until it is saved.
  void stop();

  // What is new since the last call; valid until the next one.
  const StationNews& poll();
  // What the last call of poll() found.
  const StationNews& news() const noexcept { return news_; }

 private:
  class Observer;
  struct Shared;

  std::shared_ptr<Shared> shared_;
  std::unique_ptr<RemoteStation> remote_;  // null: the station is this program's
  std::jthread thread_;
  StationNews news_;
};

}  // namespace bodkin::app
