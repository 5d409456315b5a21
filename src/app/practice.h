#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/frame_maker.h"
#include "app/hand/mouse_driver.h"
#include "app/hand/needle_control.h"
#include "app/models/attempt_options.h"
#include "app/models/case_model.h"
#include "app/models/left_needles.h"
#include "app/models/parameter_model.h"
#include "app/models/slice_tissue.h"
#include "app/models/station_link.h"
#include "link/client.h"
#include "views/frame.h"

#include "training/needle_withdrawal.h"
#include "training/plan.h"

namespace bodkin::app {

using namespace views;

// A forbidden place touched by the tip, with time and depth of the first contact.
struct TouchedDanger {
  Warning warning;
  double time = 0.0, depth = 0.0;  // s, mm
};

// The device that holds the needle instead of the mouse.
struct PracticeDevice {
  station::DeviceChoice choice;
  std::string title;  // for display
};

// The practice of a user: combines patient, station, hand and state, without widgets. All calls from the window's
// thread; advance() once a frame.
class Practice {
 public:
  // `data`: the folder of generated patients.
  explicit Practice(const std::filesystem::path& data);
  // Saves the running attempt.
  ~Practice();

  // Opens a patient and begins an attempt. Only from the start page and the results.
  void choose_practice(const PracticePatient& patient);  // the patient supplied with Bodkin for a procedure
  void choose_built_in() { choose_practice(built_in_patient()); }
  void choose(const std::filesystem::path& path);
  // The same, with other models, devices and files than the default, until another patient is chosen.
  void perform(const std::filesystem::path& path, AttemptOptions options);
  // Shows the session of a remote station on this patient, who is the same there; until another patient is chosen.
  // Device, models and probe belong to the station; hold, arm, plunger and end are sent to it.
  void follow(const link::ClientSettings& server, const std::filesystem::path& path);
  void cancel();  // the preparation

  // Commands of the user for an attempt; ignored if the state does not allow them.
  void again();
  void end();
  void leave();
  void pause(bool on);
  void toggle_hold();
  void arm();
  void acknowledge();  // confirms the warning

  // The pointer over the patient.
  void aim(const SkinPoint& skin);
  void aim_left();
  void put_down();
  void push(double notches, bool fine);
  void drag(double millimetres);
  void tilt(double right, double cranial);
  void hold_key(int direction, bool fine);
  void hold_turn(int direction);
  void withdraw();
  // Leaves the needle in the body and saves the attempt; another begins with another needle.
  void leave_needle();
  // Removes the needle that was left last.
  void take_out_left_needle();
  // From entry to tip, in the position after expiration.
  const std::vector<anatomy::NeedlePath>& left_needles() const noexcept { return left_needles_.paths(); }
  void press_plunger(bool on);  // of the syringe, if the patient's needle has one
  // Finger, stylet or manometer, if the patient has the part for it; else shows a message.
  void turn(station::StationCommand what);
  // The syringe of the following attempts. Saves a running one and begins another; no effect during an insertion.
  void fill_syringe(anatomy::SyringeFilling filling);
  void set_crosshair(const Vec3& point);
  void toggle_follow();

  // Ultrasound with this probe and machine in the following attempts (empty: without). Saves a running one and begins
  // another.
  void set_ultrasound(const std::optional<station::UltrasoundChoice>& choice);
  // The device that holds the needle in the following attempts (empty: the mouse). Saves a running one and begins
  // another.
  void set_device(const std::optional<PracticeDevice>& device);
  const std::optional<PracticeDevice>& device() const noexcept { return device_; }
  // Another path for the following attempts. Saves a running one and begins another.
  void set_plan(const anatomy::NeedlePath& path);
  // Other numbers of the force model for the following attempts on this patient. Saves a running one and begins
  // another.
  void set_models(const ModelSettings& models);
  // Applies settings to the running attempt at once, and to the following ones. False, without a change: no attempt
  // is running, or it has another model or a deformable body.
  bool apply_models(const ModelSettings& models);
  // Conduct and verdict of the following attempts by a stage of a training plan; empty: by the case.
  void set_stage(const std::optional<training::PlanStage>& stage) { stage_ = stage; }
  // Called with each saved attempt, also an abandoned one.
  void on_result(std::function<void(const AttemptResult&)> taker) { taker_ = std::move(taker); }
  // Saves the running attempt, and waits for it.
  void finish();
  // Shows a sentence in the hint for some seconds, such as why a command was refused.
  void show_message(const std::string& sentence);
  // Moves the body into the device's workspace, while no needle touches it; a mouse reaches it anywhere.
  void begin_body_drag();
  void place_body(const BodyPlace& place);
  void undo_body();
  void reset_body();
  const BodyPlace& body_place() const noexcept { return mover_.now(); }
  void set_scan_setup(const station::ScanSetup& setup) { link_.set_scan_setup(setup); }

  // The next frame, `clock` s after the window opened.
  const Frame& advance(double clock);
  const Frame& frame() const noexcept { return frame_; }
  const Changes& changes() const noexcept { return changes_; }  // of the newest frame

  State state() const noexcept { return machine_.state(); }
  const std::shared_ptr<const OpenCase>& patient() const noexcept { return patient_; }
  // The machine of the attempts; empty: none.
  const std::optional<station::UltrasoundChoice>& ultrasound() const noexcept { return ultrasound_; }
  // During preparation: the step (empty: about to begin), its progress, and its duration, s. First of the patient,
  // then of the attempt.
  CaseModel::Status preparation() const;
  // Why the last preparation failed; empty: it did not.
  const std::string& failure() const noexcept { return failure_; }
  // Why the attempt ended automatically, a sentence: the procedure is complete, or the needle was withdrawn; empty:
  // it did not.
  const std::string& completion() const noexcept { return completion_; }
  // Of the last attempt, as soon as it is saved.
  const std::optional<AttemptResult>& result() const noexcept { return result_; }
  // Every forbidden place touched in this attempt, in order of first contact; each place once.
  const std::vector<TouchedDanger>& dangers() const noexcept { return dangers_; }
  // Messages of station and guard in this attempt, and assumptions about the patient; the newest last.
  const std::vector<std::string>& log() const noexcept { return log_; }
  CaseModel& cases() noexcept { return cases_; }
  // Points of the skin (LPS mm, at rest) whose displacements a view draws for a deformable body: from the next
  // session on, or immediately if the station is remote or the needle has entered away from the drawn points.
  void follow_points(std::vector<Vec3> points);

 private:
  void begin_attempt();
  void take_result(const StationUpdate& news);
  void take_patient();
  void apply_update(const StationUpdate& news);
  void take_note(const std::string& sentence);
  void show_notes();
  void follow_needle();
  void follow_fluid();
  void follow_warning();
  void follow_completion();
  void begin_watching(const training::Procedure& procedure);
  void follow_taken_out();
  void begin_saying();
  bool shows_message() const;
  std::string hint() const;
  bool may_steer() const;
  bool may_use_other_hand() const;
  OtherHandState other_hand(const StationUpdate& news) const;
  bool has_syringe() const;
  bool has_fluid() const;
  bool must_aim_first();
  bool may_move_body();
  void send_body();
  std::vector<Vec3> points_followed_on(const anatomy::NeedlePath& path);
  void begin_following();
  // True, with a message, if the station is remote and makes the decision.
  bool is_decided_elsewhere();

  CaseModel cases_;
  StationLink link_;
  StateMachine machine_;
  FrameMaker maker_;
  NeedleControl control_;
  std::shared_ptr<MouseFeed> feed_;  // null if another device holds the needle
  std::shared_ptr<const OpenCase> patient_;
  std::optional<anatomy::NeedlePath> plan_;      // instead of the one of the case
  std::optional<anatomy::TissueId> completing_;  // the tissue whose touch ends the attempt
  bool completes_at_target_ = false;             // reaching the target ends the attempt too
  training::NeedleWithdrawal taken_out_;
  std::string completion_;
  std::optional<AttemptResult> result_;
  std::optional<training::PlanStage> stage_;
  std::function<void(const AttemptResult&)> taker_;
  std::optional<station::UltrasoundChoice> ultrasound_;
  std::optional<PracticeDevice> device_;
  AttemptOptions options_;
  std::optional<link::ClientSettings> server_;  // of the station, if it is remote
  std::optional<ModelSettings> models_;
  anatomy::HapticSettings haptics_;  // at the beginning of the attempt
  int attempts_ = 0;                 // with these options
  std::vector<Vec3> points_;
  BodyMover mover_;
  Frame frame_;
  Changes changes_;
  std::string failure_, failed_with_;
  std::string connection_;  // why there is no connection to the station; empty: connected
  std::string message_;     // shown by the hint for some seconds
  std::vector<std::string> log_;
  std::size_t noted_ = 0, reported_ = 0;  // length of the log that a frame and the hint have shown
  std::vector<TouchedDanger> dangers_;
  SliceTissue slice_tissue_;
  LeftNeedles left_needles_;
  double message_time_ = 0.0;  // s; of a sentence not yet shown by a frame
  double message_until_ = 0.0, safe_since_ = 0.0, clock_ = 0.0, prepares_since_ = 0.0;
  bool again_wanted_ = false, acknowledged_ = false, was_forbidden_ = false, plunger_pressed_ = false,
       left_needles_changed_ = false, aimed_ = false;
};

}  // namespace bodkin::app
