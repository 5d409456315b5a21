// Specific to OpenHaptics, beyond the contract of all drivers: one scheduler and one stack of errors for all devices,
// and calibration in the servo.
#include <limits>

#include "tests/haptics/driver_rig.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::haptics;

namespace {

using mock::Trouble;
using testing::HasSubstr;

TEST(OpenHaptics, two_devices_share_the_scheduler_and_one_may_leave) {
  const DriverSubject& hd = driver_subject("openhaptics");
  hd.board().clear();
  {
    Push first_push, second_push;
    DevicePort first(*hd.driver, "", hd.words());
    first.start(&first_push);
    EXPECT_TRUE(comes_true([&] { return first_push.ticks > 5; }));
    {
      DevicePort second(*hd.driver, "second", hd.words());  // while the scheduler runs
      second.start(&second_push);
      EXPECT_TRUE(comes_true([&] { return second_push.ticks > 5; }));
      second.stop();
      const int stopped = second_push.ticks, others = first_push.ticks;
      EXPECT_TRUE(comes_true([&] { return first_push.ticks > others + 5; }));
      EXPECT_EQ(second_push.ticks, stopped);
    }
    const int others = first_push.ticks;
    EXPECT_TRUE(comes_true([&] { return first_push.ticks > others + 5; }));
    EXPECT_EQ(first_push.fault, DeviceFault::none);
  }
  EXPECT_EQ(hd.board().violations, 0) << hd.board().first_violation.load();
  EXPECT_EQ(hd.board().open_devices, 0);
}

TEST(OpenHaptics, an_error_of_one_device_is_not_the_others) {
  const DriverSubject& hd = driver_subject("openhaptics");
  hd.board().clear();
  {
    Push first_push, second_push;
    DevicePort first(*hd.driver, "", hd.words()), second(*hd.driver, "second", hd.words());
    first.start(&first_push);
    second.start(&second_push);
    hd.board().only_first = true;
    hd.board().trouble = Trouble::hot;
    EXPECT_TRUE(comes_true([&] { return first_push.fault == DeviceFault::overheated; }));
    const int ticks = second_push.ticks;
    EXPECT_TRUE(comes_true([&] { return second_push.ticks > ticks + 20; }));
    EXPECT_EQ(second_push.fault, DeviceFault::none);
  }
  hd.board().clear();
}

// As an inkwell and a Desktop's continual refinement do: requested before the scheduler runs, and again while it
// does.
TEST(OpenHaptics, a_calibration_that_needs_an_update_gets_it_in_the_servo_and_is_no_fault) {
  const DriverSubject& hd = driver_subject("openhaptics");
  hd.board().clear();
  hd.board().trouble = Trouble::needs_update;
  {
    DriverRig rig(hd);
    rig.start();
    const int before = hd.board().calibrations;
    EXPECT_TRUE(comes_true([&] { return hd.board().calibrations > before + 3; }));
    EXPECT_EQ(rig.last().fault, DeviceFault::none);
    EXPECT_TRUE(hd.board().motors_on);
  }
  EXPECT_EQ(hd.board().violations, 0) << hd.board().first_violation.load();
  hd.board().clear();
}

// Each style alone, and two of which one is chosen.
TEST(OpenHaptics, is_calibrated_in_one_style_that_it_supports) {
  const DriverSubject& hd = driver_subject("openhaptics");
  for (const int styles : {4, 6}) {
    hd.board().clear();
    hd.board().calibration_styles = styles;
    hd.board().trouble = Trouble::needs_update;
    {
      DriverRig rig(hd);
      rig.start();
      const int before = hd.board().calibrations;
      EXPECT_TRUE(comes_true([&] { return hd.board().calibrations > before + 3; })) << styles;
      EXPECT_EQ(rig.last().fault, DeviceFault::none);
    }
    EXPECT_EQ(hd.board().violations, 0) << styles << hd.board().first_violation.load();
  }
  hd.board().clear();
}

// The arm's present place becomes the origin, so only the user can request it, and never under a hand.
TEST(OpenHaptics, resets_encoders_before_the_servo_and_only_when_it_is_asked_to) {
  const DriverSubject& hd = driver_subject("openhaptics");
  hd.board().clear();
  hd.board().calibration_styles = 1;
  hd.board().trouble = Trouble::needs_update;
  const int before = hd.board().calibrations;
  try {
    const DevicePort port(*hd.driver, "", hd.words());
    ADD_FAILURE() << "opened with encoders that are not reset";
  } catch (const DeviceError& error) {
    EXPECT_EQ(error.fault(), DeviceFault::not_calibrated);
    EXPECT_THAT(error.what(), HasSubstr("reset_encoders=yes"));
  }
  EXPECT_EQ(hd.board().calibrations, before);
  {
    Push push;
    DevicePort port(*hd.driver, "", hd.words() + " reset_encoders=yes");
    EXPECT_EQ(hd.board().calibrations, before + 1);
    port.start(&push);
    EXPECT_TRUE(comes_true([&] { return push.ticks > 200; }));  // the mock asks again after 50
    EXPECT_EQ(push.fault, DeviceFault::none);
    EXPECT_EQ(hd.board().calibrations, before + 1);
  }
  EXPECT_EQ(hd.board().violations, 0) << hd.board().first_violation.load();
  hd.board().clear();
}

// As the vendor's Calibration.c: it opens, and the stylus is put into its inkwell while the servo runs.
TEST(OpenHaptics, is_calibrated_by_its_inkwell_while_the_servo_runs_and_has_no_force_before) {
  const DriverSubject& hd = driver_subject("openhaptics");
  hd.board().clear();
  hd.board().trouble = Trouble::uncalibrated;
  {
    DriverRig rig(hd);
    rig.push({Vec3(1, 0, 0), Vec3::Zero()});
    rig.start();
    EXPECT_TRUE(rig.fault(DeviceFault::not_calibrated));
    EXPECT_TRUE(rig.ticks(50));
    EXPECT_FALSE(hd.board().motors_on);
    EXPECT_EQ(hd.board().pushes, 0);
    EXPECT_THAT(rig.port().explain(), HasSubstr("inkwell"));
    hd.board().in_inkwell = true;
    EXPECT_TRUE(rig.fault(DeviceFault::none));
    EXPECT_TRUE(comes_true([&] { return hd.board().force[0] == 1.0; }));
    EXPECT_TRUE(hd.board().motors_on);
  }
  EXPECT_EQ(hd.board().violations, 0) << hd.board().first_violation.load();
  hd.board().clear();
}

TEST(OpenHaptics, a_frame_that_is_lost_passes_and_a_device_that_stays_away_does_not) {
  const DriverSubject& hd = driver_subject("openhaptics");
  hd.board().clear();
  {
    DriverRig rig(hd);
    rig.start();
    EXPECT_TRUE(rig.ticks(5));
    for (int time = 0; time < 3; ++time) {
      const auto now = hd.board().ticks.load();
      hd.board().from_tick = now + 50;
      hd.board().until_tick = now + 100;
      hd.board().trouble = Trouble::device_fault;
      EXPECT_TRUE(rig.ticks(200));
      EXPECT_TRUE(rig.fault(DeviceFault::none));
      EXPECT_TRUE(hd.board().motors_on);
    }
    hd.board().until_tick = std::numeric_limits<std::int64_t>::max();
    EXPECT_TRUE(comes_true([&] { return !hd.board().motors_on; }));
    hd.board().trouble = Trouble::none;
    EXPECT_TRUE(rig.ticks(200));
    EXPECT_EQ(rig.last().fault, DeviceFault::vendor_error);
    EXPECT_THAT(rig.port().explain(), HasSubstr("0x0300"));
  }
  hd.board().clear();
}

TEST(OpenHaptics, a_scheduler_that_does_not_start_is_told) {
  const DriverSubject& hd = driver_subject("openhaptics");
  hd.board().clear();
  hd.board().trouble = Trouble::no_scheduler;
  {
    Push push;
    DevicePort port(*hd.driver, "", hd.words());
    try {
      port.start(&push);
      ADD_FAILURE() << "started";
    } catch (const DeviceError& error) {
      EXPECT_EQ(error.fault(), DeviceFault::vendor_error);
      EXPECT_THAT(error.what(), HasSubstr("0x0500"));
    }
    EXPECT_FALSE(hd.board().motors_on);
    hd.board().trouble = Trouble::none;
    port.start(&push);
    EXPECT_TRUE(comes_true([&] { return push.ticks > 5; }));
  }
  EXPECT_EQ(hd.board().violations, 0) << hd.board().first_violation.load();
  hd.board().clear();
}

TEST(OpenHaptics, hot_motors_stay_off_until_the_next_start) {
  const DriverSubject& hd = driver_subject("openhaptics");
  hd.board().clear();
  {
    DriverRig rig(hd);
    rig.start();
    hd.board().trouble = Trouble::hot;
    EXPECT_TRUE(rig.fault(DeviceFault::overheated));
    hd.board().trouble = Trouble::none;
    EXPECT_TRUE(rig.ticks(200));
    EXPECT_EQ(rig.last().fault, DeviceFault::overheated);
    EXPECT_FALSE(hd.board().motors_on);
    EXPECT_THAT(rig.port().explain(), testing::AllOf(HasSubstr("0x0200"), HasSubstr("words of the vendor")));
    rig.stop();
    rig.start();
    EXPECT_TRUE(rig.fault(DeviceFault::none));
    EXPECT_TRUE(hd.board().motors_on);
  }
}

TEST(OpenHaptics, a_force_that_was_too_great_passes) {
  const DriverSubject& hd = driver_subject("openhaptics");
  hd.board().clear();
  {
    DriverRig rig(hd);
    rig.start();
    hd.board().trouble = Trouble::too_much_force;
    EXPECT_TRUE(rig.fault(DeviceFault::force_limit));
    hd.board().trouble = Trouble::none;
    EXPECT_TRUE(rig.fault(DeviceFault::none));
  }
}

TEST(OpenHaptics, refuses_a_second_library_while_the_first_is_in_use) {
  const DriverSubject& hd = driver_subject("openhaptics");
  hd.board().clear();
  const DevicePort port(*hd.driver, "", hd.words());
  EXPECT_THROW(DevicePort(*hd.driver, "", hd.unfit), DeviceError);
}

}  // namespace
}  // namespace bodkin
