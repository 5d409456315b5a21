// Duration of a force after a fault, measured at the motors of the mocks of the vendors' libraries: driver,
// port, servo and guard together, in real time. BODKIN_FAULT_ROUNDS=30 haptics_tests --gtest_filter='*FaultTimes*'
// measures every fault so often and prints the table of docs/safety.md; with BODKIN_WRITE_PAGES=1 it writes it there.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/haptics/driver_rig.h"
#include "tests/training/page_table.h"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "haptics/device_servo.h"

namespace bodkin {

using namespace bodkin::haptics;

namespace {

using mock::Trouble;

// 0: the short form, which leaves out what force_contract_test.cpp has.
int wanted_rounds() {
  const char* text = std::getenv("BODKIN_FAULT_ROUNDS");
  return text != nullptr ? std::atoi(text) : 0;
}

struct TimedFault {
  const char* name;
  Trouble trouble;     // none: the session ends
  double limit;        // ms from the fault to zero force, as docs/safety.md says
  double later;        // ms that this driver takes longer
  GuardReason reason;  // why the guard is faulted then
};

// Additional ticks of a driver: a command in transit, and a status that is not polled in every tick.
constexpr double of_the_driver = 5.0;

// ms; a tick delayed by the machine prolongs the force.
struct Measured {
  double time = 0.0, longest_gap = 1.0;
};

class FaultTimes : public testing::TestWithParam<DriverSubject> {
 protected:
  static void TearDownTestSuite() {
    if (wanted_rounds() == 0) return;
    std::string heading = "| fault | limit |", line = "|---|---|", rows;
    for (const DriverSubject& subject : driver_subjects()) {
      heading += " `" + subject.name + "` |";
      line += "---|";
    }
    for (const auto& [fault, longest] : limits()) {
      rows += fmt::format("| {} | {:.0f} |", fault, longest);
      for (const DriverSubject& subject : driver_subjects()) {
        const auto found = cells().find({fault, subject.name});
        rows += " " + (found == cells().end() ? "-" : found->second) + " |";
      }
      rows += "\n";
    }
    const std::string table = heading + "\n" + line + "\n" + rows;
    std::printf("%s", table.c_str());
    if (std::getenv("BODKIN_WRITE_PAGES") != nullptr)
      training::expect_table_on_page("safety.md", "| fault | limit |", table);
  }
  // The measurements of the drivers' tests so far: the limits of the faults in their order, and median and largest of
  // a fault and a driver.
  static std::vector<std::pair<std::string, double>>& limits() {
    static std::vector<std::pair<std::string, double>> all;
    return all;
  }
  static std::map<std::pair<std::string, std::string>, std::string>& cells() {
    static std::map<std::pair<std::string, std::string>, std::string> all;
    return all;
  }
  void keep(const TimedFault& fault, std::vector<double> times) const {
    std::sort(times.begin(), times.end());
    cells()[{fault.name, GetParam().name}] = fmt::format("{:.1f}, {:.1f}", times[times.size() / 2], times.back());
    const auto same = [&](const auto& one) { return one.first == fault.name; };
    if (std::none_of(limits().begin(), limits().end(), same)) limits().emplace_back(fault.name, fault.limit);
  }

  ~FaultTimes() override {
    servo_.reset();
    board().clear();
  }

  mock::Board& board() const { return GetParam().board(); }
  double force() const { return Vec3(board().force[0], board().force[1], board().force[2]).norm(); }

  std::vector<TimedFault> faults() const {
    const double of_the_grip = GetParam().name == "haply" ? 20.0 : 0.0;  // it tells of its buttons 50 times a second
    std::vector<TimedFault> all = {{"the readings stand still", Trouble::stuck, 521, 0, GuardReason::frozen},
                                   {"the hand lets go", Trouble::hand_off, 20, of_the_grip, GuardReason::none},
                                   {"the session ends", Trouble::none, 20, 0, GuardReason::none}};
    if (wanted_rounds() == 0) return all;
    const auto add = [&](Trouble trouble, const char* name) {
      if (GetParam().in_loop.count(trouble) > 0) all.push_back({name, trouble, 1, 0, GuardReason::device_fault});
    };
    add(Trouble::unplug, "it is unplugged");
    add(Trouble::emergency_stop, "its emergency stop is pressed");
    add(Trouble::hot, "its motors are hot");
    add(Trouble::too_fast, "its own limit of speed");
    add(Trouble::too_much_force, "its own limit of force");
    add(Trouble::uncalibrated, "it loses its calibration");
    add(Trouble::unknown_code, "an error that nobody knows");
    add(Trouble::not_a_number, "its pose is no number");
    return all;
  }

  // The hand drifts to and fro by some millimetres in four seconds, unlike a frozen device.
  void drift() {
    const double way = std::abs(std::fmod(0.001 * static_cast<double>(board().ticks.load()), 4.0) - 2.0);
    const Vec3 at = GetParam().origin_vendor + 0.05 * way * (GetParam().pushed_vendor - GetParam().origin_vendor);
    for (int i = 0; i < 3; ++i) board().hand[static_cast<std::size_t>(i)] = at[i];
  }

  // With a force of more than a newton.
  void start() {
    board().clear();
    drift();
    DevicePort port(*GetParam().driver, "", GetParam().words());
    const DeviceAbilities known = port.abilities();
    servo_ = std::make_unique<DeviceServo>(std::move(port), known, ServoSettings{}, [](const ControlInput& input) {
      Control control;
      const bool armed = input.guard == GuardState::ramping || input.guard == GuardState::active;
      if (armed) control.wrench.force = Vec3(0.0, 0.0, 2.5);
      return control;
    });
    servo_->start();
    ASSERT_TRUE(comes_true([this] {
      drift();
      const GuardState state = servo_->tick().snapshot().state;
      if (state == GuardState::disarmed || state == GuardState::faulted) {
        servo_->tick().command({.kind = ServoCommand::Kind::arm});
      }
      return force() > 1.0;
    }));
  }

  // From the first tick with the fault, or from the request to end the session, to the first tick without force.
  Measured measured(const TimedFault& fault) {
    // The fault and the clock begin with one store, the last one, however long this thread is held up before it.
    board().from_tick = std::numeric_limits<std::int64_t>::max();
    board().trouble = fault.trouble;
    board().watched = true;
    board().from_tick = board().ticks + 5;
    std::int64_t began = 0;  // of the steady clock, ns
    if (fault.trouble == Trouble::none) {
      EXPECT_TRUE(comes_true([this] { return board().watched_at != 0; }));
      began = std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
      EXPECT_TRUE(servo_->stop());
    } else {
      EXPECT_TRUE(comes_true([&] {
        if (fault.trouble != Trouble::stuck) drift();
        const GuardState state = servo_->tick().snapshot().state;
        return board().zero_at != 0 && (state == GuardState::disarmed || state == GuardState::faulted);
      })) << fault.name;
      EXPECT_EQ(servo_->tick().snapshot().fault, fault.reason) << fault.name;
      board().trouble = Trouble::none;
      servo_->stop();
    }
    Measured result;
    EXPECT_NE(board().zero_at, 0) << fault.name;
    if (began == 0) began = board().watched_at;
    result.time = 1e-6 * static_cast<double>(board().zero_at - began);
    result.longest_gap = std::max(1.0, 1e-6 * static_cast<double>(board().longest_gap));
    return result;
  }

  std::unique_ptr<DeviceServo> servo_;
};

TEST_P(FaultTimes, of_a_device_are_within_what_the_page_says) {
  for (const TimedFault& fault : faults()) {
    std::vector<double> times;
    int held_up = 0;
    const int rounds = std::max(1, wanted_rounds());
    for (int round = 0; round < rounds; ++round) {
      ASSERT_NO_FATAL_FAILURE(start()) << fault.name;
      const Measured seen = measured(fault);
      EXPECT_EQ(force(), 0.0) << fault.name;
      EXPECT_LE(seen.time, fault.limit + fault.later + of_the_driver * seen.longest_gap)
          << fault.name << ", round " << round;
      times.push_back(seen.time);
      held_up += seen.longest_gap > 3.0 ? 1 : 0;
      servo_.reset();
    }
    if (wanted_rounds() == 0) continue;
    keep(fault, times);
    if (held_up > 0) {
      std::printf("%s, %s: ticks were held up by more than 3 ms in %d of %d rounds\n", GetParam().name.c_str(),
                  fault.name, held_up, rounds);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EveryDriver, FaultTimes, testing::ValuesIn(driver_subjects()),
                         [](const auto& subject) { return subject.param.name; });

}  // namespace
}  // namespace bodkin
