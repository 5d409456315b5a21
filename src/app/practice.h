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

#include "training/plan.h"
#include "training/taken_out.h"

namespace bodkin::app {

using namespace views;

// A place where the tip must not be, and when and how deep it was met first.
struct MetDanger {
  Warning warning;
  double time = 0.0, depth = 0.0;  // s, mm
};

// What holds the needle instead of the mouse.
struct PracticeDevice {
  station::DeviceChoice choice;
  std::string title;  // for people
};

// A person practises: patient, station, hand and state put together, without a widget. All calls from the window's
// thread; advance() once a frame.
class Practice {
 public:
  // `data`: where patients that are made here are kept.
  explicit Practice(const std::filesystem::path& data);
  // Saves what runs.
  ~Practice();

  // A patient is opened, and an attempt begins. From the start page and the results only.
  void choose_practice(const PracticePatient& patient);  // the patient that comes with Bodkin for a procedure
  void choose_built_in() { choose_practice(built_in_patient()); }
  void choose(const std::filesystem::path& path);
  // The same, with other models, devices and files than usual, until another patient is chosen.
  void perform(const std::filesystem::path& path, AttemptOptions options);
  // The session of a station elsewhere is shown, on this patient, who is the same there; until another patient is
  // chosen. Its device, models and probe are the station's; hold, arm, plunger and end reach it.
  void follow(const link::ClientSettings& server, const std::filesystem::path& path);
  void cancel();  // the preparation

  // What a person may wish of an attempt; ignored where the state does not allow it.
  void again();
  void end();
  void leave();
  void pause(bool on);
  void toggle_hold();
  void arm();
  void acknowledge();  // the warning was seen

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
  // The needle stays in the body, and the attempt is saved; another begins with another needle.
  void leave_needle();
  // The needle that was left last is taken out.
  void take_out_left_needle();
  // From entry to tip, where they lie when the patient has breathed out.
  const std::vector<anatomy::NeedlePath>& left_needles() const noexcept { return left_needles_.paths(); }
  void press_plunger(bool on);  // of the syringe, if the patient's needle has one
  // Finger, stylet or manometer, if the patient has the part for it; else it says so.
  void turn(station::StationCommand what);
  // The syringe in the attempts that follow. One that runs is saved, and another begins; not with the needle in.
  void fill_syringe(anatomy::SyringeFilling filling);
  void set_crosshair(const Vec3& point);
  void toggle_follow();

  // Ultrasound with this probe and machine in the attempts that follow (nothing: without). One that runs is saved,
  // and another begins.
  void set_ultrasound(const std::optional<station::UltrasoundChoice>& choice);
  // What holds the needle in the attempts that follow (nothing: the mouse). One that runs is saved, and another
  // begins.
  void set_device(const std::optional<PracticeDevice>& device);
  const std::optional<PracticeDevice>& device() const noexcept { return device_; }
  // Another path for the attempts that follow. One that runs is saved, and another begins.
  void set_plan(const anatomy::NeedlePath& path);
  // Other numbers of the force model in the attempts that follow on this patient. One that runs is saved, and another
  // begins.
  void set_models(const ModelSettings& models);
  // The attempt that runs feels them at once, and those after it. False, and nothing done: there is none, or it has
  // another model, or one with a deformable body.
  bool feel_models(const ModelSettings& models);
  // How the attempts that follow are done and judged by a stage of a training plan; nothing: as the case says.
  void set_stage(const std::optional<training::PlanStage>& stage) { stage_ = stage; }
  // Called with each attempt that was saved, also one that was left.
  void on_result(std::function<void(const AttemptResult&)> taker) { taker_ = std::move(taker); }
  // Saves what runs, and waits for it.
  void finish();
  // A sentence that the hint shows for some seconds, such as why a wish was not done.
  void say(const std::string& sentence);
  // The body in the workspace of the device, while no needle touches it; a mouse aims at it wherever it lies.
  void take_body();
  void place_body(const BodyPlace& place);
  void undo_body();
  void reset_body();
  const BodyPlace& body_place() const noexcept { return mover_.now(); }
  void order_scan(const station::ScanOrder& order) { link_.set_scan_order(order); }

  // The next frame, `clock` s after the window opened.
  const Frame& advance(double clock);
  const Frame& frame() const noexcept { return frame_; }
  const Changes& changes() const noexcept { return changes_; }  // of the newest frame

  State state() const noexcept { return machine_.state(); }
  const std::shared_ptr<const OpenCase>& patient() const noexcept { return patient_; }
  // The machine of the attempts; nothing without one.
  const std::optional<station::UltrasoundChoice>& ultrasound() const noexcept { return ultrasound_; }
  // While it prepares: what (empty: it is about to begin), how far, and for how long, s. First the patient, then what
  // the attempt needs.
  CaseModel::Status preparation() const;
  // Why the last preparation came to nothing; empty: it did not.
  const std::string& failure() const noexcept { return failure_; }
  // Why the attempt has ended by itself, a sentence: the procedure is complete, or the needle was taken out; empty:
  // it has not.
  const std::string& completion() const noexcept { return completion_; }
  // Of the attempt that has ended, as soon as it is saved.
  const std::optional<AttemptResult>& result() const noexcept { return result_; }
  // Every place of this attempt where the tip must not be, in the order in which it was met; the same place once.
  const std::vector<MetDanger>& dangers() const noexcept { return dangers_; }
  // What station and guard have said in this attempt, and what was assumed of the patient; the newest last.
  const std::vector<std::string>& log() const noexcept { return log_; }
  CaseModel& cases() noexcept { return cases_; }
  // Points of the skin (LPS mm, at rest) whose displacements a view draws when the body is a deformable one: from the
  // next session on, and at once of a station elsewhere and of a needle that has entered where others were drawn.
  void follow_points(std::vector<Vec3> points);

 private:
  void begin_attempt();
  void take_result(const StationNews& news);
  void take_patient();
  void take_news(const StationNews& news);
  void take_note(const std::string& sentence);
  void show_notes();
  void follow_needle();
  void follow_fluid();
  void follow_warning();
  void follow_completion();
  void begin_watching(const training::Procedure& procedure);
  void follow_taken_out();
  void begin_saying();
  bool is_saying() const;
  std::string hint() const;
  bool may_steer() const;
  bool may_use_other_hand() const;
  OtherHandState other_hand(const StationNews& news) const;
  bool has_syringe() const;
  bool has_fluid() const;
  bool must_aim_first();
  bool may_move_body();
  void send_body();
  std::vector<Vec3> points_followed_on(const anatomy::NeedlePath& path);
  void begin_following();
  // Says so, where the station is elsewhere: what was asked for is decided there.
  bool is_decided_elsewhere();

  CaseModel cases_;
  StationLink link_;
  StateMachine machine_;
  FrameMaker maker_;
  NeedleControl control_;
  std::shared_ptr<MouseFeed> feed_;  // null where another device holds the needle
  std::shared_ptr<const OpenCase> patient_;
  std::optional<anatomy::NeedlePath> plan_;      // instead of the one of the case
  std::optional<anatomy::TissueId> completing_;  // the tissue whose touch ends the attempt
  bool completes_at_target_ = false;             // the target is not made of it: reaching it does
  training::TakenOut taken_out_;
  std::string completion_;
  std::optional<AttemptResult> result_;
  std::optional<training::PlanStage> stage_;
  std::function<void(const AttemptResult&)> taker_;
  std::optional<station::UltrasoundChoice> ultrasound_;
  std::optional<PracticeDevice> device_;
  AttemptOptions options_;
  std::optional<link::ClientSettings> server_;  // of the station, if it is elsewhere
  std::optional<ModelSettings> models_;
  anatomy::HapticSettings haptics_;  // with which the attempt began
  int attempts_ = 0;                 // with these options
  std::vector<Vec3> points_;
  BodyMover mover_;
  Frame frame_;
  Changes changes_;
  std::string failure_, failed_with_;
  std::string connection_;  // why there is none to the station; empty: all is well
  std::string said_;        // what the hint shows for some seconds
  std::vector<std::string> log_;
  std::size_t noted_ = 0, told_ = 0;  // of the log, what a frame and what the hint has had
  std::vector<MetDanger> dangers_;
  SliceTissue slice_tissue_;
  LeftNeedles left_needles_;
  double said_for_ = 0.0;  // s; of a sentence that no frame has shown yet
  double said_until_ = 0.0, safe_since_ = 0.0, clock_ = 0.0, prepares_since_ = 0.0;
  bool again_wanted_ = false, acknowledged_ = false, was_forbidden_ = false, plunger_pressed_ = false,
       left_needles_changed_ = false, aimed_ = false;
};

}  // namespace bodkin::app
