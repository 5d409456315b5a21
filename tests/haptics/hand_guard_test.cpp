#include "haptics/hand_guard.h"

#include <cmath>
#include <limits>

#include "tests/haptics/guard_rig.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

const Vec3 push3(0.0, 0.0, 3.0);
const Vec3 no_force = Vec3::Zero();

TEST(HandGuard, lets_nothing_through_until_it_is_armed) {
  GuardRig rig;
  for (int i = 0; i < 500; ++i) EXPECT_TRUE(rig.tick(push3).force.isZero(0.0));
  EXPECT_EQ(rig.guard.state(), GuardState::disarmed);
  EXPECT_TRUE(rig.events.empty());
}

TEST(HandGuard, brings_the_force_in_over_one_second) {
  GuardRig rig;
  for (int i = 0; i < 60; ++i) rig.tick(no_force);
  rig.guard.arm();
  rig.tick(no_force);
  EXPECT_EQ(rig.guard.state(), GuardState::ramping);
  for (int i = 2; i <= 1000; ++i) {
    EXPECT_NEAR(rig.tick({0.0, 2.0, 0.0}).force.y(), 2.0 * i / 1000.0, 1e-9);
    EXPECT_EQ(rig.guard.state(), i < 1000 ? GuardState::ramping : GuardState::active) << i;
  }
  EXPECT_EQ(rig.count(GuardReason::armed), 1);
  EXPECT_EQ(rig.count(GuardReason::full_force), 1);
}

TEST(HandGuard, carries_the_handle_as_gently_as_it_brings_the_force_in) {
  GuardRig rig;
  for (int i = 0; i < 60; ++i) rig.tick(no_force);
  rig.guard.arm();
  rig.tick(no_force);
  for (int i = 2; i <= 1000; ++i) {
    rig.device.hand.translation().x() += i % 2 == 0 ? 1e-6 : -1e-6;
    const Wrench& applied = rig.guard.step(rig.device, {.dt = 0.001, .weight = {0.0, 0.0, 0.8}});
    EXPECT_NEAR(applied.force.z(), 0.8 * i / 1000.0, 1e-9) << i;
  }
}

TEST(HandGuard, waits_for_a_moving_hand_and_gives_up_after_two_seconds) {
  GuardRig rig;
  rig.guard.arm();
  for (int i = 0; i < 1900; ++i) {
    rig.device.hand.translation().y() = 30.0 * std::sin(0.006 * i);  // up to 180 mm/s
    rig.tick(no_force);
  }
  EXPECT_EQ(rig.guard.state(), GuardState::disarmed);
  for (int i = 0; i < 80; ++i) rig.tick(no_force);  // rests in time
  EXPECT_EQ(rig.guard.state(), GuardState::ramping);

  GuardRig restless;
  restless.guard.arm();
  for (int i = 0; i < 2100; ++i) {
    restless.device.hand.translation().y() = 0.1 * (i % 100);
    restless.tick(no_force);
  }
  EXPECT_EQ(restless.guard.state(), GuardState::disarmed);
  ASSERT_EQ(restless.count(GuardReason::refused), 1);
  EXPECT_EQ(restless.events.back().cause, GuardReason::moving);
}

TEST(HandGuard, refuses_to_be_armed_and_says_why) {
  const auto refusal = [](GuardRig& rig, const Vec3& force) {
    for (int i = 0; i < 60; ++i) rig.tick(force);
    rig.guard.arm();
    for (int i = 0; i < 2100; ++i) EXPECT_TRUE(rig.tick(force).force.isZero(0.0));
    EXPECT_EQ(rig.count(GuardReason::refused), 1);
    return rig.events.back().cause;
  };
  GuardRig pulled, loose, broken, silent;
  EXPECT_EQ(refusal(pulled, {0.0, 0.0, 0.31}), GuardReason::pulling);
  loose.device.held = false;
  EXPECT_EQ(refusal(loose, no_force), GuardReason::released);
  broken.device.fault = DeviceFault::overheated;
  EXPECT_EQ(refusal(broken, no_force), GuardReason::device_fault);
  EXPECT_EQ(refusal(silent, {std::nan(""), 0.0, 0.0}), GuardReason::not_finite);
}

TEST(HandGuard, every_device_fault_ends_the_force_in_the_same_tick) {
  for (int code = 1; code <= static_cast<int>(DeviceFault::vendor_error); ++code) {
    GuardRig rig;
    rig.push(push3);
    rig.device.fault = static_cast<DeviceFault>(code);
    EXPECT_EQ(rig.ticks_to_zero(push3), 1);
    EXPECT_EQ(rig.guard.state(), GuardState::faulted);
    ASSERT_EQ(rig.events.size(), 1u) << "one event, not one per tick";
    EXPECT_EQ(rig.events.back().reason, GuardReason::device_fault);
    EXPECT_EQ(rig.events.back().device_fault, rig.device.fault);
    rig.device.fault = DeviceFault::none;
    for (int i = 0; i < 300; ++i) EXPECT_TRUE(rig.tick(push3).force.isZero(0.0)) << "only arm() leads out";
  }
}

TEST(HandGuard, a_pose_that_cannot_be_ends_the_force_in_the_same_tick) {
  for (int kind = 0; kind < 4; ++kind) {
    GuardRig rig;
    rig.push(push3);
    if (kind == 0) rig.device.hand.translation().y() = std::nan("");
    if (kind == 1) rig.device.hand.linear()(1, 2) = std::numeric_limits<double>::infinity();
    if (kind == 2) rig.device.hand.linear() *= 2.0;
    if (kind == 3) rig.device.hand.translation().z() = 1e7;
    EXPECT_EQ(rig.ticks_to_zero(push3), 1) << kind;
    EXPECT_EQ(rig.guard.fault(), GuardReason::bad_pose) << kind;
    EXPECT_EQ(rig.events.size(), 1u);
  }
}

TEST(HandGuard, a_jump_ends_the_force_in_the_same_tick) {
  GuardRig rig;
  rig.push(push3);
  rig.device.hand.translation().y() += 6.0;
  EXPECT_EQ(rig.ticks_to_zero(push3), 1);
  EXPECT_EQ(rig.guard.fault(), GuardReason::jump);
  EXPECT_EQ(rig.events.size(), 1u);
}

TEST(HandGuard, a_hand_faster_than_one_metre_a_second_ends_the_force_at_the_third_tick) {
  for (const bool told : {false, true}) {
    GuardRig rig;
    rig.push(push3);
    int ticks = 0;
    while (rig.guard.is_armed() && ticks < 50) {
      ++ticks;
      rig.device.hand.translation().y() += 1.2;
      if (told) rig.device.velocity = Vec3(0.0, 1200.0, 0.0);
      rig.tick(push3);
    }
    EXPECT_EQ(ticks, 3);
    EXPECT_TRUE(rig.guard.applied().force.isZero(0.0));
    EXPECT_EQ(rig.guard.fault(), GuardReason::too_fast);
  }
}

TEST(HandGuard, a_device_that_tells_a_wrong_velocity_is_seen_through_by_its_positions) {
  GuardRig rig;
  rig.push(push3);
  rig.device.velocity = no_force;
  int ticks = 0;
  for (; rig.guard.is_armed() && ticks < 50; ++ticks) {
    rig.device.hand.translation().y() += 1.2;
    rig.tick(push3);
  }
  EXPECT_LE(ticks, 10);
  EXPECT_EQ(rig.guard.fault(), GuardReason::too_fast);
}

TEST(HandGuard, the_coarsest_encoder_at_an_ordinary_pace_is_not_too_fast) {
  GuardRig rig;
  rig.push(push3);
  for (int i = 0; i < 1500; ++i) {
    rig.device.hand.translation().y() = std::floor(30.0 * std::sin(0.01 * i) / 0.0635) * 0.0635;  // 300 mm/s
    rig.tick(push3);
  }
  EXPECT_EQ(rig.guard.state(), GuardState::active);
  EXPECT_TRUE(rig.events.empty());
}

TEST(HandGuard, a_force_that_is_no_number_fades_from_the_last_good_one_in_20_ms) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e300}) {
    GuardRig rig;
    rig.push(push3);
    const Vec3 wanted(bad, 0.0, 0.0);
    for (int i = 1; i <= 19; ++i) EXPECT_NEAR(rig.tick(wanted).force.z(), 3.0 * (1.0 - 0.05 * i), 1e-9);
    EXPECT_TRUE(rig.tick(wanted).force.isZero(0.0));
    EXPECT_EQ(rig.guard.fault(), GuardReason::not_finite);
    EXPECT_EQ(rig.events.size(), 1u);
  }
}

TEST(HandGuard, a_torque_that_is_no_number_or_a_controller_that_failed_ends_the_force_likewise) {
  GuardRig rig;
  rig.push(push3);
  for (int i = 0; i < 20; ++i) rig.tick(Wrench{push3, Vec3(0.0, std::nan(""), 0.0)});
  EXPECT_TRUE(rig.guard.applied().force.isZero(0.0));
  EXPECT_EQ(rig.guard.fault(), GuardReason::not_finite);

  GuardRig failing;
  failing.push(push3);
  for (int i = 0; i < 20; ++i) failing.guard.step(failing.device, {.dt = 0.001, .controller_failed = true});
  EXPECT_TRUE(failing.guard.applied().force.isZero(0.0));
  EXPECT_EQ(failing.guard.fault(), GuardReason::controller_failed);
}

TEST(HandGuard, the_dead_mans_switch_and_disarming_end_the_force_in_20_ms) {
  for (const bool by_hand : {false, true}) {
    GuardRig rig;
    rig.push(push3);
    if (by_hand) {
      rig.guard.disarm();
    } else {
      rig.device.held = false;
    }
    EXPECT_EQ(rig.ticks_to_zero(push3), 20);
    EXPECT_EQ(rig.guard.state(), GuardState::disarmed);
    ASSERT_EQ(rig.events.size(), 1u);
    EXPECT_EQ(rig.events[0].reason, by_hand ? GuardReason::disarmed : GuardReason::released);
    rig.device.held = true;
    for (int i = 0; i < 300; ++i) EXPECT_TRUE(rig.tick(push3).force.isZero(0.0));
  }
}

TEST(HandGuard, a_device_that_fails_while_the_force_fades_gets_none_at_once) {
  GuardRig rig;
  rig.push(push3);
  rig.device.held = false;
  for (int i = 0; i < 5; ++i) rig.tick(push3);
  EXPECT_GT(rig.guard.applied().force.norm(), 1.0);
  rig.device.fault = DeviceFault::communication_lost;
  EXPECT_TRUE(rig.tick(push3).force.isZero(0.0));
}

TEST(HandGuard, a_late_simulation_is_held_then_fades_then_is_a_fault) {
  GuardRig rig;
  rig.push(push3);
  for (int age = 1; age <= 60; ++age) {
    const double force = rig.tick({0.0, 0.0, 5.0 + age}, 0.001 * age).force.z();
    if (age <= 5) {
      EXPECT_GE(force, 3.0) << "not late yet";
    }
    if (age > 5 && age <= 15) {
      EXPECT_EQ(rig.guard.state(), GuardState::holding);
    }
    if (age > 6 && age <= 15) {
      EXPECT_NEAR(force, 5.5, 1e-12) << age;
    }
    if (age > 15 && age < 45) {
      EXPECT_NEAR(force, 5.5 * (1.0 - (age - 15) / 30.0), 1e-9) << age;
    }
    if (age >= 46) {
      EXPECT_EQ(force, 0.0) << age;
    }
  }
  EXPECT_EQ(rig.guard.fault(), GuardReason::stale_fault);
  EXPECT_EQ(rig.count(GuardReason::stale), 1);
  EXPECT_EQ(rig.count(GuardReason::stale_decay), 1);
  EXPECT_EQ(rig.count(GuardReason::stale_fault), 1);
}

TEST(HandGuard, a_simulation_that_comes_back_in_time_goes_on_without_a_step) {
  GuardRig rig;
  rig.push(push3);
  for (int age = 1; age <= 40; ++age) rig.tick(push3, 0.001 * age);
  const double before = rig.guard.applied().force.z();
  EXPECT_LT(before, 1.0);
  EXPECT_NEAR(rig.tick(push3).force.z(), before + 0.5, 1e-9);
  EXPECT_EQ(rig.guard.state(), GuardState::active);
  EXPECT_EQ(rig.count(GuardReason::fresh_again), 1);
}

TEST(HandGuard, a_gap_between_ticks_starts_the_force_again_from_zero) {
  GuardRig rig;
  rig.push(push3);
  EXPECT_GT(rig.tick(push3, 0.0, 0.049).force.z(), 2.9);
  EXPECT_LT(rig.tick(push3, 0.0, 0.051).force.z(), 0.01);
  EXPECT_EQ(rig.guard.state(), GuardState::ramping);
  EXPECT_EQ(rig.count(GuardReason::tick_gap), 1);
  for (int i = 0; i < 500; ++i) rig.tick(push3);
  EXPECT_NEAR(rig.guard.applied().force.z(), 1.5, 0.02);
}

TEST(HandGuard, a_late_tick_gives_no_right_to_a_larger_step) {
  GuardRig rig;
  rig.push(no_force);
  EXPECT_LE(rig.tick(push3, 0.0, 0.030).force.z(), 1.0 + 1e-12);
}

TEST(HandGuard, readings_that_stand_still_under_force_are_a_fault_after_half_a_second) {
  GuardRig rig;
  rig.push(push3);
  rig.alive = false;
  int ticks = 0;
  while (rig.guard.is_armed() && ticks < 2000) {
    rig.tick(push3);
    ++ticks;
  }
  EXPECT_NEAR(ticks, 501, 1);
  EXPECT_EQ(rig.guard.fault(), GuardReason::frozen);
  EXPECT_LE(rig.ticks_to_zero(push3), 20);

  GuardRig free;
  free.push(no_force);
  free.alive = false;
  for (int i = 0; i < 2000; ++i) free.tick(Vec3(0.0, 0.0, 0.2));
  EXPECT_EQ(free.guard.state(), GuardState::active) << "a device that lies on the table";
}

TEST(HandGuard, a_frozen_device_loses_its_force_in_time_though_the_tissue_relaxes_or_a_tick_is_missed) {
  for (const bool gap : {false, true}) {
    GuardRig rig;
    rig.push({0.0, 0.0, 0.7});
    rig.alive = false;
    rig.tick(Vec3(0.0, 0.0, 0.7));
    double seconds = 0.0;
    while (rig.guard.is_armed() && seconds < 2.0) {
      // Under 0.5 N after 80 ms; and once no tick for 60 ms, after which the force ramps up again.
      const double dt = gap && seconds > 0.2 && seconds < 0.2015 ? 0.060 : 0.001;
      rig.tick(Vec3(0.0, 0.0, std::max(0.3, 0.7 * (1.0 - 4.0 * seconds))), 0.0, dt);
      seconds += dt;
    }
    EXPECT_EQ(rig.guard.fault(), GuardReason::frozen) << gap;
    EXPECT_LE(seconds, 0.503) << gap;
  }
}

TEST(HandGuard, can_be_armed_again_after_a_fault) {
  GuardRig rig;
  rig.push(push3);
  rig.device.fault = DeviceFault::velocity_limit;
  rig.tick(push3);
  rig.device.fault = DeviceFault::none;
  rig.push(push3);
  EXPECT_NEAR(rig.guard.applied().force.z(), 3.0, 1e-9);
  EXPECT_EQ(rig.guard.fault(), GuardReason::none);
}

TEST(HandGuard, settings_that_cannot_be_are_refused_in_a_sentence) {
  const auto sentence = [](auto change) -> std::string {
    GuardSettings settings = GuardRig::example();
    change(settings);
    try {
      const HandGuard guard(settings);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(sentence([](GuardSettings&) {}), "");
  EXPECT_EQ(sentence([](GuardSettings& s) { s.continuous_force = 11.0; }),
            "device: continuous_force_N is 11 N, expected at most the peak_force_N of 10 N");
  EXPECT_NE(sentence([](GuardSettings& s) { s.peak_force = std::nan(""); }), "");
  EXPECT_NE(sentence([](GuardSettings& s) { s.workspace_high.x() = -90.0; }), "");
  EXPECT_NE(sentence([](GuardSettings& s) { s.fade_time = 0.5; }), "");
  EXPECT_NE(sentence([](GuardSettings& s) { s.dt = 0.0; }), "");
  EXPECT_NE(sentence([](GuardSettings& s) { s.speed_limit = 0.0; }), "");
}

TEST(HandGuard, every_reason_and_state_has_its_own_words) {
  std::vector<std::string_view> seen;
  for (int i = 1; i < static_cast<int>(GuardReason::count_of_reasons); ++i) {
    seen.push_back(text_of(static_cast<GuardReason>(i)));
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_NE(seen[i], "nothing") << i;
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(seen[i], seen[j]);
  }
}

}  // namespace
}  // namespace bodkin
