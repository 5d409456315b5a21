#include "app/practice.h"

#include <algorithm>
#include <utility>

#include "app/models/data_folder.h"
#include "app/models/warnings.h"
#include "station/hand_session.h"
#include <fmt/format.h>

#include "simulation/contact_settings.h"
#include "training/planning_rules.h"
#include "training/procedure_file.h"

namespace bodkin::app {

namespace {

constexpr double warning_stays = 1.5;  // s after the tip has left the place
constexpr double far_outside = 400.0;  // mm from the middle of the image, where no patient is
constexpr double usual_length = 60.0;  // mm of a path where none is planned
constexpr double before_skin = 40.0;   // mm

Vec3 middle_of(const anatomy::Grid& grid) {
  return grid.to_patient(0.5 * Vec3(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1));
}

// The path of an unplanned needle: straight into the back at the middle of the image.
anatomy::NeedlePath unplanned_path(const anatomy::TissueVolume& tissues) {
  const Vec3 middle = middle_of(tissues.grid);
  const Vec3 inwards = -Vec3::UnitY();
  const std::optional<SkinPoint> skin = skin_on_ray(tissues, middle - far_outside * inwards, inwards, far_outside);
  const Vec3 entry = skin ? skin->point : middle;
  return {entry, entry + usual_length * inwards};
}

SkinPoint entry_of(const anatomy::TissueVolume& tissues, const anatomy::NeedlePath& path) {
  const Vec3 along = path.direction();
  const std::optional<SkinPoint> skin =
      skin_on_ray(tissues, path.entry - before_skin * along, along, 2.0 * before_skin);
  return skin ? *skin : SkinPoint{path.entry, -along};
}

}  // namespace

Practice::Practice(const std::filesystem::path& data) : cases_(data) {}

Practice::~Practice() {
  link_.stop();
}

void Practice::choose_practice(const PracticePatient& patient) {
  if (!machine_.apply(Signal::case_chosen)) return;
  failure_.clear();
  options_ = {};
  server_.reset();
  cases_.open_practice(patient);
}

void Practice::choose(const std::filesystem::path& path) {
  perform(path, {});
}

void Practice::perform(const std::filesystem::path& path, AttemptOptions options) {
  if (!machine_.apply(Signal::case_chosen)) return;
  failure_.clear();
  if (options.ultrasound) ultrasound_ = options.ultrasound;
  options_ = std::move(options);
  server_.reset();
  attempts_ = 0;
  cases_.open(path);
}

void Practice::follow(const link::ClientSettings& server, const std::filesystem::path& path) {
  perform(path, {});
  if (state() == State::preparing) server_ = server;
}

void Practice::follow_points(std::vector<Vec3> points) {
  points_ = std::move(points);
  if (server_) return link_.follow_points(points_, {});
  const bool enters_anywhere = std::holds_alternative<anatomy::EmbeddedNeedleSettings>(haptics_.resistance);
  if (!enters_anywhere || !is_attempt(state()) || frame_.dimple.depth == 0.0) return;
  const SkinDimple& entry = frame_.dimple;
  const double length = plan_ ? plan_->length() : patient_->description().needle.length;
  link_.follow_points(points_followed_on({entry.at, entry.at + length * entry.inwards}), entry.at);
}

// The view's points, with those of the slices' tissue about this path and those of left needles after them.
std::vector<Vec3> Practice::points_followed_on(const anatomy::NeedlePath& path) {
  return left_needles_.follow(slice_tissue_.follow(points_, path, patient_->patient.tissues), maker_.breath());
}

void Practice::cancel() {
  if (state() != State::preparing) return;
  cases_.cancel();
  server_ ? link_.stop() : link_.end();
  again_wanted_ = false;
  machine_.apply(Signal::cancelled);
}

void Practice::again() {
  if (patient_ == nullptr || !machine_.apply(Signal::again)) return;
  link_.end();
  again_wanted_ = true;
}

void Practice::end() {
  if (!machine_.apply(Signal::end)) return;
  link_.end();
}

void Practice::leave() {
  if (!machine_.apply(Signal::leave)) return;
  server_ ? link_.stop() : link_.end();  // a remote session continues
}

void Practice::pause(bool on) {
  machine_.apply(on ? Signal::pause : Signal::resume);
  control_.hold(on);
}

void Practice::toggle_hold() {
  const bool on = state() != State::held;
  if (!machine_.apply(on ? Signal::hold : Signal::release)) return;
  control_.hold(on);
  if (feed_ == nullptr) link_.command(station::StationCommand::toggle_hold);
}

void Practice::arm() {
  link_.command(station::StationCommand::arm);
}

void Practice::acknowledge() {
  acknowledged_ = true;
}

void Practice::set_models(const ModelSettings& models) {
  if (is_decided_elsewhere()) return;
  models_ = models;
  if (is_attempt(state())) again();
}

bool Practice::apply_models(const ModelSettings& models) {
  const bool is_same = models.haptics.resistance.index() == haptics_.resistance.index() &&
                       models.haptics.constraint.index() == haptics_.constraint.index();
  if (server_ || !is_attempt(state()) || !is_same) return false;
  if (anatomy::body_of(haptics_.resistance) != nullptr) {
    const auto before = models_ ? models_->tissues : forces::model_settings(patient_->patient).tissues;
    if (!simulation::differ_in_contact_alone(haptics_, before, models.haptics, models.tissues)) return false;
  }
  models_ = models;
  link_.change_numbers(models.haptics, models.tissues);
  return true;
}

void Practice::set_crosshair(const Vec3& point) {
  frame_.crosshair = point;
  frame_.follows_tip = false;
}

void Practice::toggle_follow() {
  frame_.follows_tip = !frame_.follows_tip;
}

void Practice::set_ultrasound(const std::optional<station::UltrasoundChoice>& choice) {
  ultrasound_ = choice;
  if (is_attempt(state()) && !server_) again();
}

void Practice::set_device(const std::optional<PracticeDevice>& device) {
  if (is_decided_elsewhere()) return;
  device_ = device;
  if (is_attempt(state())) again();
}

void Practice::set_plan(const anatomy::NeedlePath& path) {
  if (is_decided_elsewhere()) return;
  plan_ = path;
  mover_.begin(usual_place(path));
  if (is_attempt(state()) || state() == State::ended) again();
}

CaseModel::Status Practice::preparation() const {
  CaseModel::Status status = cases_.status();
  if (!status.is_busy) {
    status.stage = again_wanted_ ? "saving the attempt" : link_.news().stage;
    status.fraction = again_wanted_ ? 0.0 : link_.news().fraction;
  }
  status.seconds = clock_ - prepares_since_;
  return status;
}

void Practice::take_patient() {
  if (std::shared_ptr<const OpenCase> opened = cases_.take()) {
    patient_ = std::move(opened);
    plan_ = patient_->description().procedure.path;
    models_.reset();
    left_needles_.begin(options_.left_needles);
    points_.clear();  // of another patient
    mover_.begin(usual_place(plan_ ? *plan_ : unplanned_path(patient_->patient.tissues)));
    begin_attempt();
    for (const std::string& note : cases_.status().notes) {
      take_note(note);
      show_message(note);
    }
  }
  const CaseModel::Status status = cases_.status();
  if (state() == State::preparing && !status.is_busy && !status.error.empty() && failure_ != status.error) {
    failure_ = status.error;
    machine_.apply(Signal::cancelled);
  }
}

void Practice::finish() {
  link_.stop();
  take_result(link_.poll());
}

void Practice::take_result(const StationUpdate& news) {
  if (!news.result || result_) return;
  result_ = news.result;
  if (taker_) taker_(*result_);
}

void Practice::begin_attempt() {
  finish();
  result_.reset();
  failed_with_.clear();
  log_.clear();
  noted_ = reported_ = 0;
  dangers_.clear();
  again_wanted_ = false;
  acknowledged_ = was_forbidden_ = plunger_pressed_ = false;
  completion_.clear();
  aimed_ = false;
  const std::string procedure = stage_ ? stage_->procedure : std::string();
  const training::Procedure rules = procedure.empty()
                                        ? training::procedure_of_case(patient_->description().procedure.name)
                                        : training::find_procedure(procedure);
  begin_watching(rules);
  const anatomy::TissueProperties* const lesion = patient_->patient.library.find(training::completing_tissue(rules));
  completing_.reset();
  if (lesion != nullptr) completing_ = lesion->id;
  completes_at_target_ =
      lesion != nullptr && plan_ &&
      anatomy::nearest(patient_->patient.tissues, plan_->target, anatomy::tissue::air) != lesion->id;
  const anatomy::Case& patient = patient_->patient;
  const std::optional<anatomy::NeedlePath>& plan = plan_;
  const anatomy::NeedlePath path = plan ? *plan : unplanned_path(patient.tissues);
  const bool plan_is_shown = !stage_ || stage_->aids.overlay;
  if (plan_is_shown) {
    control_.begin(plan, entry_of(patient.tissues, path));
  } else {
    control_.begin({}, entry_of(patient.tissues, unplanned_path(patient.tissues)));
  }
  maker_.begin(patient_, plan);
  frame_.follows_tip = true;
  frame_.crosshair = plan_is_shown ? path.target : middle_of(patient.tissues.grid);
  if (server_) return begin_following();
  try {
    station::StationOptions options;
    options.patient = patient;
    options.patient.description.procedure.path = plan;
    options.case_folder = patient_->folder;
    options.path = path;
    options.device.driver = &mouse_driver();
    const bool is_asked = !options_.output.empty();  // by `bodkin perform`, which names the device
    if (device_ && !is_asked) options.device = device_->choice;
    options.output = options_.output.empty() ? new_session_file(patient_->title) : options_.file_of(attempts_);
    options.overwrite = options_.overwrite && attempts_ == 0;
    ++attempts_;
    options_.apply(options);
    options.left_needles = left_needles_.paths();
    if (models_) options.patient.description.haptics = models_->haptics;
    haptics_ = options.patient.description.haptics;
    if (models_) options.patient.library = anatomy::TissueLibrary(models_->tissues);  // felt from the first tick on
    options.ultrasound = ultrasound_;
    const bool has_mouse = options.device.driver == &mouse_driver();
    feed_ = has_mouse ? std::make_shared<MouseFeed>(station::workspace_about(path)) : nullptr;
    if (has_mouse) {
      feed_->goals.write(control_.goal());
      connect_mouse(feed_);
    }
    const std::string device = has_mouse ? "Mouse" : is_asked ? options.device.driver->name : device_->title;
    link_.start(std::move(options), device, {plan.has_value(), procedure}, points_followed_on(path));
    if (feed_ == nullptr && mover_.is_moved()) send_body();
  } catch (const std::exception& error) {
    failure_ = error.what();
    machine_.apply(Signal::cancelled);
  }
}

void Practice::apply_update(const StationUpdate& news) {
  using Phase = StationUpdate::Phase;
  connection_ = news.connection;
  for (const std::string& note : news.notes) take_note(note);
  take_result(news);
  frame_.other_hand = other_hand(news);
  const bool over = news.phase == Phase::finished || news.phase == Phase::failed || news.phase == Phase::idle;
  if (again_wanted_ && over && state() == State::preparing) return begin_attempt();
  if (again_wanted_) return;
  if (news.phase == Phase::failed && failed_with_ != news.error) {
    failed_with_ = failure_ = news.error;
    if (feed_ == nullptr && device_) failure_ += "; or choose the mouse on the page Devices";
    if (!machine_.apply(Signal::cancelled)) machine_.apply(Signal::end);
  }
  if (state() == State::preparing && news.phase == Phase::running && news.needle.ticks > 0)
    machine_.apply(Signal::prepared);
  if (is_attempt(state()) && news.phase == Phase::finished) machine_.apply(Signal::end);
  if (news.phase != Phase::running || !is_attempt(state())) return;
  if (news.servo.device.fault != haptics::DeviceFault::none)
    machine_.apply(Signal::device_gone);
  else if (state() == State::device_lost)
    machine_.apply(Signal::device_back);
  if (news.servo.state == haptics::GuardState::faulted)
    machine_.apply(Signal::guard_fault);
  else if (state() == State::faulted && news.servo.state != haptics::GuardState::disarmed)
    machine_.apply(Signal::armed);
}

void Practice::follow_needle() {
  if (maker_.is_touching()) {
    machine_.apply(Signal::touched);
    if (maker_.has_punctured()) machine_.apply(Signal::punctured);
    if (frame_.target_reached && (!stage_ || stage_->aids.overlay))
      machine_.apply(Signal::target_reached);
    else
      machine_.apply(Signal::target_left);
  } else {
    machine_.apply(Signal::lifted);
  }
}

void Practice::follow_warning() {
  std::optional<Warning> found;
  if (maker_.is_touching()) found = warning_at(patient_->patient, frame_.touched, frame_.tissue, maker_.is_on_bone());
  if (found) {
    if (!frame_.warning || frame_.warning->title != found->title) acknowledged_ = false;
    const auto same = [&](const TouchedDanger& danger) { return danger.warning.title == found->title; };
    if (std::none_of(dangers_.begin(), dangers_.end(), same)) dangers_.push_back({*found, frame_.time, frame_.depth});
    frame_.warning = found;
    safe_since_ = clock_;
    if (!acknowledged_) machine_.apply(Signal::forbidden);
  }
  const bool is_over = !found && clock_ - safe_since_ > warning_stays;
  if (is_over || acknowledged_) machine_.apply(Signal::safe_again);
  if (is_over || !maker_.is_touching() || (acknowledged_ && !found)) frame_.warning.reset();
}

// A biopsy is complete when the tip touches the lesion.
void Practice::follow_completion() {
  if (!completing_ || !maker_.has_punctured() || !needle_is_down(state())) return;
  const bool touches = frame_.tissue == *completing_;
  if (!touches && !(completes_at_target_ && frame_.target_reached)) return;
  completion_ = fmt::format("The tip {} {:.1f} mm below the skin: the attempt is complete.",
                            touches ? "touched the lesion" : "reached the target", frame_.depth);
  end();
}

const Frame& Practice::advance(double clock) {
  const double dt = std::clamp(clock - clock_, 0.0, 0.1);
  clock_ = clock;
  begin_saying();
  if (frame_.state != State::preparing) prepares_since_ = clock;
  if (state() == State::preparing && !again_wanted_) take_patient();
  const StationUpdate& news = link_.poll();
  // The spans of the last frame refer to the previous data.
  frame_.samples = {};
  frame_.events = {};
  frame_.displacements = {};
  frame_.diagnostic_names = {};
  frame_.notes = {};
  frame_.timings = nullptr;
  frame_.ultrasound = nullptr;
  apply_update(news);
  HandReport hand;
  if (feed_ != nullptr) {
    hand = feed_->reports.read();
    if (state() != State::ended) control_.update(dt, hand);
    feed_->goals.write(control_.goal());
  }
  const bool lives = is_attempt(state()) || state() == State::ended;
  if (lives && news.phase != StationUpdate::Phase::preparing)
    maker_.update(frame_, news, feed_ != nullptr ? &control_ : nullptr, hand);
  if (is_attempt(state())) {
    follow_needle();
    follow_fluid();
    follow_warning();
    follow_completion();
    follow_taken_out();
  } else {
    frame_.warning.reset();
  }
  if (state() == State::no_case) {
    patient_.reset();
    frame_.has_needle = false;
    frame_.plan.reset();
  }
  show_notes();
  ++frame_.number;
  frame_.state = state();
  frame_.clock = clock;
  frame_.hint = hint();
  frame_.left_needles = left_needles_.now(news.displacements, frame_.drawn_in);
  frame_.displacements = left_needles_.of_others(frame_.displacements);
  frame_.moved_tissue = slice_tissue_.now(frame_.displacements);
  frame_.displacements = slice_tissue_.of_others(frame_.displacements);
  changes_ = maker_.changes(frame_);
  if (std::exchange(left_needles_changed_, false)) changes_.plan = true;  // the pictures must be drawn again
  return frame_;
}

}  // namespace bodkin::app
