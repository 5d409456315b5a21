#include "app/frame_maker.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "simulation/resistance_models.h"

namespace bodkin::app {

namespace {

constexpr double visible_motion = 0.05;          // mm
constexpr double turned_enough = 0.05 * degree;  // rad
constexpr double down_soon = -0.5;               // mm above the skin
constexpr double breath_step = 0.5;              // mm, from picture to picture of a patient who breathes

bool same_pose(const Pose& a, const Pose& b) {
  return (a.translation() - b.translation()).norm() <= visible_motion &&
         Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle() <= turned_enough;
}

}  // namespace

void FrameMaker::begin(std::shared_ptr<const OpenCase> patient, const std::optional<anatomy::NeedlePath>& plan) {
  patient_ = std::move(patient);
  plan_ = plan;
  breath_.reset();
  if (patient_ != nullptr && patient_->description().breathing) breath_.emplace(*patient_->description().breathing);
  drawn_in_ = 0.0;
  contact_ = {};
  new_attempt_ = true;
  time_in_body_ = last_time_ = 0.0;
}

void FrameMaker::place_needle(Frame& frame, const StationUpdate& news, const NeedleControl* control,
                              const HandReport& hand) const {
  frame.has_needle = news.needle.ticks > 0;
  frame.needle = news.needle.needle;
  frame.needle.translation() -= news.needle.coupling_offset;
  frame.hand = frame.needle;
  if (control == nullptr) return;
  frame.hand = hand.meant;
  // On its way to the skin it is drawn at its predicted position: there the force is zero, as above.
  const bool is_down = control->is_down() && (is_touching() || (hand.is_on_line && hand.depth > down_soon));
  if (!is_down && !is_touching()) frame.needle = frame.hand = control->hovering();
}

SkinDimple FrameMaker::dimple_of(const Frame& frame, const StationUpdate& news) const {
  SkinDimple dimple;
  if (!is_touching()) return dimple;
  dimple.inwards = needle_axis(frame.needle);
  dimple.at = frame.needle.translation() - frame.depth * dimple.inwards;
  dimple.depth = contact_.skin_dimple(news.needle.output, news.diagnostic_names);
  return dimple;
}

// Every step redraws the patient, so steps are as large as just invisible.
void FrameMaker::breathe(Frame& frame, double drawn_in) {
  if (!breath_) return;
  const double step = breath_step / std::max(breath_step, breath_->motion().norm());
  if (std::abs(drawn_in - drawn_in_) >= step || drawn_in == 0.0) drawn_in_ = drawn_in;
  frame.drawn_in = drawn_in_;
}

Vec3 FrameMaker::seen(const Vec3& material) const {
  return breath_ ? Vec3(material + breath_->moved(material, drawn_in_)) : material;
}

Vec3 FrameMaker::in_material(const Vec3& place) const {
  return breath_ ? breath_->material(place, drawn_in_) : place;
}

void FrameMaker::measure_plan(Frame& frame) const {
  frame.plan = plan_;
  if (!plan_ || plan_->length() <= 0.0) return;
  const anatomy::NeedlePath now{seen(plan_->entry), seen(plan_->target)};
  frame.plan = now;
  const Vec3 along = now.direction(), tip = frame.needle.translation();
  const Vec3 from_entry = tip - now.entry;
  frame.off_path_vector = from_entry - along * along.dot(from_entry);
  frame.off_path = frame.off_path_vector.norm();
  const Vec3 axis = needle_axis(frame.needle);
  frame.off_angle = std::atan2(along.cross(axis).norm(), along.dot(axis));
  frame.target_distance = (now.target - tip).norm();
  const anatomy::Procedure& procedure = patient_->description().procedure;
  frame.target_tolerance = procedure.target_tolerance;
  const anatomy::TissueProperties* tissue = patient_->patient.library.find(procedure.target_tissue);
  const bool in_target =
      tissue != nullptr ? frame.tissue == tissue->id : frame.target_distance <= procedure.target_tolerance;
  frame.target_reached = is_touching() && has_punctured() && in_target;
}

// By the force model's place of the tip in the material.
double FrameMaker::pushed_of(const Frame& frame) const {
  if (!is_touching()) return 0.0;
  for (std::size_t i = 0; i < frame.diagnostic_names.size(); ++i) {
    if (frame.diagnostic_names[i].name != simulation::material_depth_name) continue;
    const double pushed = frame.depth - frame.diagnostics[i];
    return std::isfinite(pushed) ? std::max(0.0, pushed) : 0.0;
  }
  return 0.0;
}

void FrameMaker::update(Frame& frame, const StationUpdate& news, const NeedleControl* control,
                        const HandReport& hand) {
  const simulation::TickOutput& now = news.needle.output;
  contact_.update(now, news.events);
  frame.time = news.time;
  if (is_touching() && last_time_ > 0.0) time_in_body_ += std::max(0.0, news.time - last_time_);
  last_time_ = news.time;
  frame.time_in_body = time_in_body_;
  frame.depth = is_touching() ? now.depth : 0.0;
  frame.velocity = now.velocity;
  frame.tissue = is_touching() ? now.tissue : anatomy::tissue::air;
  frame.force = now.requested.force.norm();
  frame.resistance = now.resistance;
  frame.constraint = now.constraint;
  frame.applied = now.applied.force;
  frame.energy = now.energy;
  frame.diagnostics = now.diagnostics;
  frame.diagnostic_names = news.diagnostic_names;
  frame.samples = news.samples;
  frame.events = news.events;
  frame.displacements = news.displacements;
  breathe(frame, now.drawn_in);
  place_needle(frame, news, control, hand);
  frame.in_tissue = in_material(frame.needle.translation());
  frame.pushed = pushed_of(frame);
  const Vec3 brought_to = frame.needle.translation() + news.needle.coupling_offset;
  frame.touched =
      frame.pushed > 0.0 ? in_material(brought_to - frame.pushed * needle_axis(frame.needle)) : frame.in_tissue;
  frame.entry.reset();
  if (is_touching()) frame.entry = frame.needle.translation() - frame.depth * needle_axis(frame.needle);
  frame.dimple = dimple_of(frame, news);
  if (patient_ != nullptr) {
    frame.place = is_touching()
                      ? place_name(patient_->patient, frame.touched, needle_axis(frame.needle), frame.tissue)
                      : std::string();
    measure_plan(frame);
  }
  frame.device = news.device;
  frame.device_limits = news.limits;
  frame.guard = news.servo.state;
  frame.fault = news.servo.fault;
  frame.limits = news.servo.limits;
  frame.ticks = news.needle.ticks;
  frame.late_ticks = news.timings.overruns;
  frame.recent_success = news.timings.recent_success;
  frame.timings = news.needle.ticks > 0 ? &news.timings : nullptr;
  frame.ultrasound = news.ultrasound.get();
  frame.message = news.needle.past_points
                      ? "The needle is past the tissue that was computed ahead of it: draw it back a little."
                      : news.message;
  if (frame.follows_tip && is_touching()) frame.crosshair = frame.needle.translation();
}

// The left needles, since they were last drawn.
bool FrameMaker::have_moved(std::span<const LeftNeedle> left) {
  const bool same = std::equal(left.begin(), left.end(), left_.begin(), left_.end(),
                               [](const LeftNeedle& now, const Pose& then) { return same_pose(now.pose, then); });
  if (same) return false;
  left_.clear();
  for (const LeftNeedle& one : left) left_.push_back(one.pose);
  return true;
}

Changes FrameMaker::changes(const Frame& frame) {
  Changes changes;
  changes.needle = have_moved(frame.left_needles) || frame.has_needle != last_.has_needle ||
                   !same_pose(frame.needle, last_.needle) || !same_pose(frame.hand, last_.hand);
  changes.tissue = frame.tissue != last_.tissue || frame.place != last_.place;
  changes.dimple = std::abs(frame.dimple.depth - last_.dimple.depth) > 0.5 * visible_motion ||
                   (frame.dimple.depth != 0.0 && (frame.dimple.at - last_.dimple.at).norm() > visible_motion) ||
                   !frame.displacements.empty() || frame.drawn_in != last_.drawn_in;
  changes.force = !frame.samples.empty() || !frame.events.empty();
  changes.state = frame.state != last_.state;
  const auto same_plan = [&] {
    if (frame.plan.has_value() != last_.plan.has_value()) return false;
    return !frame.plan || (frame.plan->entry == last_.plan->entry && frame.plan->target == last_.plan->target);
  };
  changes.plan = !same_plan();
  changes.crosshair = (frame.crosshair - last_.crosshair).norm() > visible_motion;
  changes.warning = frame.warning.has_value() != last_.warning.has_value() ||
                    (frame.warning && frame.warning->title != last_.warning->title);
  changes.attempt = new_attempt_;
  new_attempt_ = false;
  Frame before = std::exchange(last_, frame);
  // Motion too small to redraw is measured from the drawn position, because it may continue slowly.
  if (!changes.needle) {
    last_.needle = before.needle;
    last_.hand = before.hand;
  }
  if (!changes.dimple) last_.dimple = before.dimple;
  if (!changes.crosshair) last_.crosshair = before.crosshair;
  last_.samples = {};
  last_.events = {};
  last_.displacements = {};
  last_.left_needles = {};
  last_.diagnostic_names = {};
  last_.notes = {};
  last_.timings = nullptr;
  last_.ultrasound = nullptr;
  return changes;
}

}  // namespace bodkin::app
