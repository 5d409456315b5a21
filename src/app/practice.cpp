#include "app/practice.h"

#include <algorithm>
#include <utility>

#include "app/models/data_folder.h"
#include "app/models/remote_station.h"
#include "app/models/warnings.h"
#include "station/hand_session.h"
#include <fmt/format.h>

#include "simulation/contact_settings.h"
#include "training/planning_rules.h"
#include "training/procedure_file.h"

namespace bodkin::app {

namespace {

constexpr double warning_stays = 1.5;  // s after the tip has left the place
constexpr double refusal_shown = 4.0;  // s
constexpr double far_outside = 400.0;  // mm from the middle of the image, where no patient is
constexpr double usual_length = 60.0;  // mm of a path where none is planned
constexpr double before_skin = 40.0;   // mm
constexpr std::size_t longest_log = 200;

Vec3 middle_of(const anatomy::Grid& grid) {
  return grid.to_patient(0.5 * Vec3(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1));
}

// Where a needle goes that nobody has planned: straight into the back at the middle of the image.
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
  link_.follow_points(points_);
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
  server_ ? link_.stop() : link_.end();  // a session elsewhere goes on
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

bool Practice::feel_models(const ModelSettings& models) {
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

void Practice::say(const std::string& sentence) {
  refusal_ = sentence;
  refused_at_ = clock_;
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
  return cases_.status();
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

void Practice::take_result(const StationNews& news) {
  if (!news.result || result_) return;
  result_ = news.result;
  if (taker_) taker_(*result_);
}

void Practice::begin_attempt() {
  finish();
  result_.reset();
  failed_with_.clear();
  log_.clear();
  dangers_.clear();
  again_wanted_ = false;
  acknowledged_ = was_forbidden_ = plunger_pressed_ = false;
  completion_.clear();
  aimed_ = false;
  const std::string procedure = stage_ ? stage_->procedure : std::string();
  const std::string completing = training::completing_tissue(
      procedure.empty() ? training::procedure_of_case(patient_->description().procedure.name)
                        : training::find_procedure(procedure));
  const anatomy::TissueProperties* const lesion = patient_->patient.library.find(completing);
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
      feed_->wishes.write(control_.wish());
      connect_mouse(feed_);
    }
    const std::string device = has_mouse ? "Mouse" : is_asked ? options.device.driver->name : device_->title;
    std::vector<Vec3> followed = left_needles_.follow(points_, maker_.breath());
    link_.start(std::move(options), device, {plan.has_value(), procedure}, std::move(followed));
    if (feed_ == nullptr && mover_.is_moved()) send_body();
  } catch (const std::exception& error) {
    failure_ = error.what();
    machine_.apply(Signal::cancelled);
  }
}

void Practice::begin_following() {
  feed_.reset();
  haptics_ = patient_->patient.description.haptics;
  completing_.reset();  // the station ends its session itself
  const bool is_first = attempts_++ == 0;
  link_.follow(std::make_unique<RemoteStation>(*server_, patient_, !is_first));
  link_.follow_points(points_);
}

bool Practice::is_decided_elsewhere() {
  if (!server_) return false;
  say(fmt::format("That is decided at the station, {}:{}.", server_->host, server_->port));
  return true;
}

void Practice::take_news(const StationNews& news) {
  using Phase = StationNews::Phase;
  connection_ = news.connection;
  for (const std::string& note : news.notes) log_.push_back(note);
  if (log_.size() > longest_log) log_.erase(log_.begin(), log_.end() - longest_log);
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
  if (maker_.is_touching())
    found = warning_at(patient_->patient, frame_.in_tissue, frame_.tissue, maker_.is_on_bone());
  if (found) {
    if (!frame_.warning || frame_.warning->title != found->title) acknowledged_ = false;
    const auto same = [&](const MetDanger& danger) { return danger.warning.title == found->title; };
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

std::string Practice::hint() const {
  if (!connection_.empty()) return connection_;
  if (clock_ - refused_at_ < refusal_shown && !refusal_.empty()) return refusal_;
  const bool is_above = state() == State::ready || state() == State::aiming;
  if (frame_.other_hand.finger && (is_above || state() == State::touching))
    return "Press with the finger. W, then H: the needle.";
  switch (state()) {
    case State::preparing:
      return "The patient is being prepared.";
    case State::ready:
      if (feed_ == nullptr) return "Bring the needle to the ring on the skin, and push.";
      if (stage_ && !stage_->aids.overlay) return "Point at the skin where you want to go in, and click.";
      return "Point at the ring on the skin and click, or just scroll.";
    case State::aiming:
      return control_.is_down() ? "The needle goes to the skin."
                                : "Click to put the needle on the skin. Drag the hub to tilt.";
    case State::touching:
      if (feed_ == nullptr) return "Pressing on skin. Push until it gives.";
      return "Pressing on skin. Scroll to push until it gives.";
    case State::in_tissue:
      if (has_syringe()) return "Hold B: press the plunger. E ends. F1 keys";
      if (has_fluid()) return "S: stylet out. R: manometer. E ends. F1 keys";
      if (feed_ == nullptr) return "Push or draw back. E ends. F1 keys";
      return "Scroll to push or draw back. Space holds. F1 keys";
    case State::reached:
      if (has_fluid() && frame_.other_hand.stylet_in)
        return fmt::format("Target reached at {:.1f} mm. S: stylet out.", frame_.depth);
      return fmt::format("Target reached at {:.1f} mm. E ends.", frame_.depth);
    case State::held:
      return "Held. Space takes the needle up again.";
    case State::faulted:
      return "The guard took the force away. V arms again.";
    case State::device_lost:
      return "The device does not answer.";
    default:
      return {};
  }
}

const Frame& Practice::advance(double clock) {
  const double dt = std::clamp(clock - clock_, 0.0, 0.1);
  clock_ = clock;
  if (state() == State::preparing && !again_wanted_) take_patient();
  const StationNews& news = link_.poll();
  // What the last frame looked at lay in the news before these.
  frame_.samples = {};
  frame_.events = {};
  frame_.displacements = {};
  frame_.diagnostic_names = {};
  frame_.timings = nullptr;
  frame_.ultrasound = nullptr;
  take_news(news);
  HandReport hand;
  if (feed_ != nullptr) {
    hand = feed_->reports.read();
    if (state() != State::ended) control_.update(dt, hand);
    feed_->wishes.write(control_.wish());
  }
  const bool lives = is_attempt(state()) || state() == State::ended;
  if (lives && news.phase != StationNews::Phase::preparing)
    maker_.update(frame_, news, feed_ != nullptr ? &control_ : nullptr, hand);
  if (is_attempt(state())) {
    follow_needle();
    follow_fluid();
    follow_warning();
    follow_completion();
  } else {
    frame_.warning.reset();
  }
  if (state() == State::no_case) {
    patient_.reset();
    frame_.has_needle = false;
    frame_.plan.reset();
  }
  ++frame_.number;
  frame_.state = state();
  frame_.clock = clock;
  frame_.hint = hint();
  frame_.left_needles = left_needles_.now(news.displacements, frame_.drawn_in);
  frame_.displacements = left_needles_.of_others(frame_.displacements);
  changes_ = maker_.changes(frame_);
  if (std::exchange(left_needles_changed_, false)) changes_.plan = true;  // the pictures must be drawn again
  return frame_;
}

}  // namespace bodkin::app
