#include "haptics/drivers/simulated.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <string>

#include "core/repeatable.h"
#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/driver_settings.h"
#include "haptics/drivers/vendor_frame.h"
#include "haptics/simulated_hand.h"
#include "haptics/tremor.h"

namespace bodkin::haptics {

namespace {

constexpr double entry_below = 30.0;  // mm from the middle of the workspace to the planned entry
constexpr double before = 1.5;        // s at rest, for the guard to arm and ramp the force up
constexpr double after = 0.5;         // s at rest at the end
constexpr double tremor_onset = 0.5;  // s

struct Plan {
  HandParameters hand;
  double rate = 1000.0;  // Hz
  double tremor = 0.1;   // mm, root mean square along each axis
  double speed = 5.0;    // mm/s
  double start = 30.0;   // mm above the entry
  double depth = 60.0;   // mm beyond it
  double wait = 2.0;     // s there
  double lateral = 0.0;  // mm to the operator's right
  Vec3 axis = -Vec3::UnitZ();
  double peak = 10.0;  // N
  std::uint64_t seed = 1;

  double deepest() const noexcept { return start + depth; }
  // mm along the axis from the start, `time` s after the session began.
  double place(double time) const noexcept {
    const double inwards = speed * (time - before);
    const double outwards = deepest() - speed * (time - before - deepest() / speed - wait);
    return std::clamp(std::min(inwards, outwards), 0.0, deepest());
  }
  double duration() const noexcept { return before + 2.0 * deepest() / speed + wait + after; }
};

double radians(double degrees) {
  return degrees * (std::numbers::pi / 180.0);
}

Plan plan_of(const char* text) {
  const DriverSettings settings(
      text, {"speed_mm_s", "start_mm", "depth_mm", "wait_s", "lateral_mm", "tilt_deg", "side_deg", "tremor_mm",
             "seed", "stiffness_N_mm", "mass_kg", "damping_N_s_mm", "peak_N", "rate_Hz"});
  Plan plan;
  plan.speed = settings.number("speed_mm_s", plan.speed, 0.1, 500.0);
  plan.start = settings.number("start_mm", plan.start, 0.0, 200.0);
  plan.depth = settings.number("depth_mm", plan.depth, -200.0, 300.0);
  if (plan.deepest() < 0.0) {
    throw DriverFailure(BODKIN_BAD_SETTINGS,
                        "the setting depth_mm lies above the start, expected at least -start_mm");
  }
  plan.wait = settings.number("wait_s", plan.wait, 0.0, 600.0);
  plan.lateral = settings.number("lateral_mm", plan.lateral, -200.0, 200.0);
  const double tilt = radians(settings.number("tilt_deg", 0.0, -80.0, 80.0));
  const double side = radians(settings.number("side_deg", 0.0, -80.0, 80.0));
  plan.axis = {repeatable::sin(side), repeatable::cos(side) * repeatable::sin(tilt),
               -repeatable::cos(side) * repeatable::cos(tilt)};
  plan.tremor = settings.number("tremor_mm", plan.tremor, 0.0, 1.0);
  plan.seed = static_cast<std::uint64_t>(settings.number("seed", 1.0, 0.0, 1e9));
  plan.hand.stiffness = settings.number("stiffness_N_mm", plan.hand.stiffness, 0.05, 20.0);
  plan.hand.mass = settings.number("mass_kg", plan.hand.mass, 0.02, 5.0);
  plan.hand.damping = settings.number("damping_N_s_mm", plan.hand.damping, 0.0, 1.0);
  plan.peak = settings.number("peak_N", plan.peak, 0.1, 100.0);
  plan.rate = settings.number("rate_Hz", plan.rate, 200.0, 4000.0);
  return plan;
}

class SimulatedDevice : public OpenDevice {
 public:
  explicit SimulatedDevice(const Plan& plan) : plan_(plan) { begin(); }

  void start(bodkin_tick, void*) override { begin(); }
  void stop() override {}
  std::string explain() override { return {}; }

  int exchange(const bodkin_command& command, bodkin_state& state) noexcept override {
    const double time = static_cast<double>(++round_) / plan_.rate;
    const double onset = std::clamp((time - before) / tremor_onset, 0.0, 1.0);
    const Vec3 shake = onset * tremor_->next();
    Pose intended = at(plan_.place(time));
    intended.translation() += shake;
    const Wrench push{Eigen::Map<const Vec3>(command.force), Eigen::Map<const Vec3>(command.torque)};
    const Pose& needle = hand_->step(intended, push);
    state = blank_state();
    Eigen::Map<Vec3>(state.position) = needle.translation();
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(state.rotation) = needle.linear();
    Eigen::Map<Vec3>(state.velocity) = hand_->velocity();
    if (time >= plan_.duration()) state.buttons = BODKIN_BUTTON_END;
    return BODKIN_OK;
  }

 private:
  void begin() {
    hand_.emplace(plan_.hand, 1.0 / plan_.rate, plan_.seed);
    tremor_.emplace(plan_.tremor, 1.0 / plan_.rate, plan_.seed);
    hand_->start(at(0.0));
    round_ = 0;
  }

  Pose at(double place) const noexcept {
    const Vec3 entry(plan_.lateral, 0.0, -entry_below);
    return needle_pose(entry + (place - plan_.start) * plan_.axis, plan_.axis);
  }

  Plan plan_;
  std::optional<SimulatedHand> hand_;
  std::optional<Tremor> tremor_;
  std::uint64_t round_ = 0;
};

struct Simulated {
  static constexpr const char* name = "simulated";
  static constexpr const char* summary = "a simulated hand, for use without a device";

  static void list(const char* text, const DeviceSink& found) {
    plan_of(text);
    found("", "a hand of mass and spring that goes in and comes out again");
  }

  static std::unique_ptr<OpenDevice> open(const std::string&, const char* text, bodkin_abilities& abilities) {
    const Plan plan = plan_of(text);
    auto device = std::make_unique<SimulatedDevice>(plan);
    copy_text("simulated hand", abilities.name, BODKIN_TEXT);
    abilities.peak_force = plan.peak;
    abilities.continuous_force = 0.5 * plan.peak;
    abilities.rate = plan.rate;
    abilities.measures_rotation = 1;
    return device;
  }
};

}  // namespace

const bodkin_driver& simulated_driver() noexcept {
  static constexpr bodkin_driver driver = driver_of<Simulated>();
  return driver;
}

}  // namespace bodkin::haptics
