// The user's control of the needle in an attempt.
#include "app/practice.h"

namespace bodkin::app {

bool Practice::may_steer() const {
  const State now = state();
  if (feed_ == nullptr) return false;
  return now == State::ready || now == State::aiming || needle_is_down(now);
}

void Practice::aim(const SkinPoint& skin) {
  if (!may_steer()) return;
  machine_.apply(Signal::pointer_on_patient);
  aimed_ = true;
  control_.aim(skin);
}

void Practice::aim_left() {
  if (!control_.is_down()) machine_.apply(Signal::pointer_off_patient);
}

// If the planned path is hidden, the needle does not move to its entry automatically.
bool Practice::must_aim_first() {
  if (aimed_ || !stage_ || stage_->aids.overlay) return false;
  show_message("First point at the skin where you want to go in.");
  return true;
}

void Practice::put_down() {
  if (may_steer() && !must_aim_first()) control_.put_down();
}

void Practice::push(double notches, bool fine) {
  if (may_steer() && !must_aim_first()) control_.push(notches, fine);
}

void Practice::drag(double millimetres) {
  if (may_steer() && !must_aim_first()) control_.drag(millimetres);
}

void Practice::tilt(double right, double cranial) {
  if (!may_steer() || control_.tilt(right, cranial)) return;
  show_message("Draw back to just under the skin, then change the angle.");
}

void Practice::hold_key(int direction, bool fine) {
  const bool may = may_steer() && (direction == 0 || !must_aim_first());
  control_.hold_key(may ? direction : 0, fine);
}

void Practice::hold_turn(int direction) {
  control_.hold_turn(may_steer() ? direction : 0);
}

void Practice::withdraw() {
  if (may_steer()) control_.withdraw();
}

void Practice::leave_needle() {
  constexpr double least_left = 1.0;  // mm; a needle that is hardly in the skin falls out
  if (patient_ == nullptr || !is_attempt(state())) return;
  if (!maker_.is_touching() || !maker_.has_punctured() || frame_.depth < least_left)
    return show_message("Push the needle through the skin before you leave it there.");
  const Vec3 tip = frame_.needle.translation(), entry = tip - frame_.depth * needle_axis(frame_.needle);
  const anatomy::NeedlePath left{maker_.in_material(entry), frame_.in_tissue};
  again();
  if (again_wanted_) left_needles_.add(left);
}

void Practice::take_out_left_needle() {
  if (!left_needles_.take_out()) return show_message("No needle was left in the body.");
  left_needles_changed_ = true;
}

void Practice::press_plunger(bool on) {
  if (on == plunger_pressed_ || !has_syringe() || (on && !may_use_other_hand())) return;
  plunger_pressed_ = on;
  link_.command(on ? station::StationCommand::press_plunger : station::StationCommand::release_plunger);
}

// With every device, because it is done by keys and buttons.
bool Practice::may_use_other_hand() const {
  const State now = state();
  return now == State::ready || now == State::aiming || needle_is_down(now);
}

void Practice::turn(station::StationCommand what) {
  if (!may_use_other_hand()) return;
  const bool is_finger = what == station::StationCommand::turn_finger;
  if (is_finger && !haptics_.parts.fingertip) return show_message("This patient has no skin to feel with a finger.");
  const bool is_breath = what == station::StationCommand::turn_breath;
  if (is_breath && !frame_.other_hand.breathes) return show_message("This patient does not breathe.");
  if (!is_finger && !is_breath && !has_fluid()) {
    return show_message(haptics_.parts.csf_flow
                            ? "The syringe is on the needle: there is no place for stylet or manometer."
                            : "This patient has no fluid to measure.");
  }
  if (is_finger && frame_.other_hand.finger_presses)
    return show_message("Lift the finger first (W), then take the needle.");
  if (is_finger && maker_.is_touching()) return show_message("Withdraw the needle before you feel the skin.");
  link_.command(what);
}

void Practice::fill_syringe(anatomy::SyringeFilling filling) {
  if (is_decided_elsewhere() || !has_syringe() || !is_attempt(state())) return;
  if (maker_.is_touching()) return show_message("Withdraw the needle before you fill the syringe again.");
  ModelSettings models = models_ ? *models_ : ModelSettings{haptics_, patient_->patient.library.tissues()};
  if (!models.haptics.parts.syringe) models.haptics.parts.syringe = haptics_.parts.syringe;
  models.haptics.parts.syringe->filling = filling;
  set_models(models);
}

OtherHandState Practice::other_hand(const StationUpdate& news) const {
  const bool runs = news.phase == StationUpdate::Phase::running;
  const simulation::OtherHand now = runs ? news.needle.other : simulation::OtherHand();
  const anatomy::ForceParts& parts = haptics_.parts;
  OtherHandState state;
  state.has_finger = parts.fingertip.has_value();
  state.finger = now.finger;
  state.finger_presses = now.finger && news.needle.output.tissue != anatomy::tissue::air;
  if ((state.has_fluid = has_fluid())) {
    state.stylet_in = parts.csf_flow->stylet != now.stylet_moved;
    state.manometer_on = parts.csf_flow->manometer != now.manometer_moved;
  }
  if ((state.has_syringe = parts.syringe.has_value())) {
    state.plunger = plunger_pressed_;
    state.air = parts.syringe->filling == anatomy::SyringeFilling::air;
  }
  state.breathes = patient_ != nullptr && patient_->description().breathing.has_value();
  state.holds_breath = state.breathes && now.breath_held;
  return state;
}

// A syringe on the needle from the beginning leaves no place for stylet and manometer.
bool Practice::has_fluid() const {
  const anatomy::ForceParts& parts = haptics_.parts;
  return parts.csf_flow.has_value() && (!parts.syringe.has_value() || parts.csf_flow->stylet);
}

// In a search for the epidural space, going beyond it is always reported, whatever else is shown.
void Practice::follow_fluid() {
  for (const session::SessionEvent& each : frame_.events)
    if (each.event.kind == forces::EventKind::fluid_returned && has_syringe())
      show_message("Fluid comes back through the needle: the dura is open.");
}

// While the target is hidden, an automatic end would reveal that it was reached: the user ends the attempt.
void Practice::begin_watching(const training::Procedure& procedure) {
  taken_out_ = {};
  const bool reveals_target = procedure.withdrawal_ends == training::WithdrawalEnds::after_goal;
  if (server_ || (reveals_target && stage_ && !stage_->aids.overlay)) return;
  taken_out_ = {procedure, patient_->patient, plan_ ? std::optional(plan_->target) : std::nullopt};
}

void Practice::follow_taken_out() {
  const bool is_above = (state() == State::ready || state() == State::aiming) && !link_.news().needle.unseen;
  const bool has_needle = !frame_.other_hand.finger;
  taken_out_.follow({.time = clock_,
                     .is_inside = maker_.has_punctured() && has_needle,
                     .is_outside = is_above && !maker_.is_touching() && !control_.is_down() && has_needle,
                     .tissue = frame_.tissue,
                     .tip = frame_.in_tissue,
                     .events = frame_.events});
  if (taken_out_.remaining() != 0.0) return;
  completion_ = "The needle was taken out: the attempt is complete.";
  end();
}

bool Practice::has_syringe() const {
  return haptics_.parts.syringe.has_value();
}

}  // namespace bodkin::app
