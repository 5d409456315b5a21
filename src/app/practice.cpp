#include "app/practice.h"

#include <algorithm>
#include <utility>

#include "app/models/data_folder.h"
#include "app/models/warnings.h"
#include "station/hand_session.h"
#include <fmt/format.h>

namespace bodkin::app {

namespace {

constexpr double warning_stays = 1.5;  // s after the tip has left the place
constexpr double refusal_shown = 4.0;  // s
constexpr double far_outside = 400.0;  // mm from the middle of the image, where no patient is
constexpr double usual_length = 60.0;  // mm of a path where none is planned
constexpr double before_skin = 40.0;   // mm
constexpr std::size_t longest_log = 200;

// Where a needle goes that nobody has planned: straight into the back at the middle of the image.
anatomy::NeedlePath unplanned_path(const anatomy::TissueVolume& tissues) {
  const anatomy::Grid& grid = tissues.grid;
  const Vec3 middle = grid.to_patient(0.5 * Vec3(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1));
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

void Practice::choose_built_in() {
  if (!machine_.apply(Signal::case_chosen)) return;
  failure_.clear();
  cases_.open_built_in();
}

void Practice::choose(const std::filesystem::path& path) {
  if (!machine_.apply(Signal::case_chosen)) return;
  failure_.clear();
  cases_.open(path);
}

void Practice::cancel() {
  if (state() != State::preparing) return;
  cases_.cancel();
  link_.end();
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
  link_.end();
}

void Practice::pause(bool on) {
  machine_.apply(on ? Signal::pause : Signal::resume);
  control_.hold(on);
}

void Practice::toggle_hold() {
  const bool on = state() != State::held;
  if (!machine_.apply(on ? Signal::hold : Signal::release)) return;
  control_.hold(on);
}

void Practice::arm() {
  link_.command(station::StationCommand::arm);
}

void Practice::acknowledge() {
  acknowledged_ = true;
}

bool Practice::may_steer() const {
  const State now = state();
  return now == State::ready || now == State::aiming || needle_is_down(now);
}

void Practice::aim(const SkinPoint& skin) {
  if (!may_steer()) return;
  machine_.apply(Signal::pointer_on_patient);
  control_.aim(skin);
}

void Practice::aim_left() {
  if (!control_.is_down()) machine_.apply(Signal::pointer_off_patient);
}

void Practice::put_down() {
  if (may_steer()) control_.put_down();
}

void Practice::push(double notches, bool fine) {
  if (may_steer()) control_.push(notches, fine);
}

void Practice::drag(double millimetres) {
  if (may_steer()) control_.drag(millimetres);
}

void Practice::tilt(double right, double cranial) {
  if (!may_steer() || control_.tilt(right, cranial)) return;
  say("Draw back to just under the skin, then change the angle.");
}

void Practice::say(const std::string& sentence) {
  refusal_ = sentence;
  refused_at_ = clock_;
}

void Practice::hold_key(int direction, bool fine) {
  control_.hold_key(may_steer() ? direction : 0, fine);
}

void Practice::withdraw() {
  if (may_steer()) control_.withdraw();
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
  if (is_attempt(state())) again();
}

CaseModel::Status Practice::preparation() const {
  return cases_.status();
}

void Practice::take_patient() {
  if (std::shared_ptr<const OpenCase> opened = cases_.take()) {
    patient_ = std::move(opened);
    begin_attempt();
  }
  const CaseModel::Status status = cases_.status();
  if (state() == State::preparing && !status.is_busy && !status.error.empty() && failure_ != status.error) {
    failure_ = status.error;
    machine_.apply(Signal::cancelled);
  }
}

void Practice::begin_attempt() {
  result_.reset();
  log_.clear();
  dangers_.clear();
  again_wanted_ = false;
  acknowledged_ = was_forbidden_ = false;
  const anatomy::Case& patient = patient_->patient;
  const std::optional<anatomy::NeedlePath>& plan = patient.description.procedure.path;
  const anatomy::NeedlePath path = plan ? *plan : unplanned_path(patient.tissues);
  control_.begin(plan, entry_of(patient.tissues, path));
  maker_.begin(patient_, plan);
  frame_.follows_tip = true;
  frame_.crosshair = path.target;
  try {
    station::StationOptions options;
    options.patient = patient;
    options.case_folder = patient_->folder;
    options.path = path;
    options.device.driver = &mouse_driver();
    options.output = new_session_file(patient_->title);
    options.longest = longest_;
    options.ultrasound = ultrasound_;
    feed_ = std::make_shared<MouseFeed>(station::workspace_about(path));
    feed_->wishes.write(control_.wish());
    connect_mouse(feed_);
    link_.start(std::move(options), "Mouse", plan.has_value(), points_);
  } catch (const std::exception& error) {
    failure_ = error.what();
    machine_.apply(Signal::cancelled);
  }
}

void Practice::take_news(const StationNews& news) {
  using Phase = StationNews::Phase;
  for (const std::string& note : news.notes) log_.push_back(note);
  if (log_.size() > longest_log) log_.erase(log_.begin(), log_.end() - longest_log);
  if (news.result && !result_) result_ = news.result;
  const bool over = news.phase == Phase::finished || news.phase == Phase::failed || news.phase == Phase::idle;
  if (again_wanted_ && over && state() == State::preparing) return begin_attempt();
  if (again_wanted_) return;
  if (news.phase == Phase::failed && failure_ != news.error) {
    failure_ = news.error;
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
    if (frame_.target_reached)
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
    found = warning_at(patient_->patient, frame_.needle.translation(), frame_.tissue, maker_.is_on_bone());
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

std::string Practice::hint() const {
  if (clock_ - refused_at_ < refusal_shown && !refusal_.empty()) return refusal_;
  switch (state()) {
    case State::preparing:
      return "The patient is being prepared.";
    case State::ready:
      return "Point at the ring on the skin and click, or just scroll.";
    case State::aiming:
      return control_.is_down() ? "The needle goes to the skin."
                                : "Click to put the needle on the skin. Drag the hub to tilt.";
    case State::touching:
      return "Pressing on skin. Scroll to push until it gives.";
    case State::in_tissue:
      return "Scroll to push or draw back. Space holds. F1 keys";
    case State::reached:
      return fmt::format("Target reached at {:.1f} mm. E ends.", frame_.depth);
    case State::held:
      return "Held. Space takes the needle up again.";
    case State::faulted:
      return "The guard took the force away. V arms again.";
    case State::device_lost:
      return "The device does not answer. Reconnect it, or end.";
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
  if (lives && news.phase != StationNews::Phase::preparing) maker_.update(frame_, news, &control_, hand);
  if (is_attempt(state())) {
    follow_needle();
    follow_warning();
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
  changes_ = maker_.changes(frame_);
  return frame_;
}

}  // namespace bodkin::app
