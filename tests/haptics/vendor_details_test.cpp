// What is particular to one vendor, beyond the contract of all drivers.
#include <cstdlib>
#include <filesystem>
#include <set>

#include "tests/haptics/driver_rig.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/driver_settings.h"
#include "haptics/drivers/drivers.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

using stand_in::Trouble;
using testing::HasSubstr;

const DriverSubject& subject(const std::string& name) {
  for (const DriverSubject& one : driver_subjects()) {
    if (one.name == name) return one;
  }
  throw std::out_of_range(name);
}

struct Push : DeviceTick {
  Wrench tick(const DeviceState& state, double) noexcept override {
    fault = state.fault;
    ++ticks;
    return {Vec3(1, 0, 0), Vec3::Zero()};
  }
  std::atomic<DeviceFault> fault{DeviceFault::none};
  std::atomic<int> ticks{0};
};

TEST(Drivers, have_names_of_their_own_and_speak_our_version) {
  std::set<std::string> names;
  for (const bodkin_driver* driver : built_in_drivers()) {
    names.insert(driver->name);
    EXPECT_EQ(driver->abi, BODKIN_DRIVER_ABI);
    EXPECT_NE(driver->explain, nullptr);
    EXPECT_EQ(find_driver(driver->name), driver);
  }
  EXPECT_EQ(names.size(), built_in_drivers().size());
}

TEST(StandIns, take_their_trouble_from_the_environment) {
  // A copy is a library of its own, which reads the environment anew.
  const std::filesystem::path copy =
      std::filesystem::temp_directory_path() / ("bodkin_stand_in_" + std::to_string(getpid()) + ".so");
  std::filesystem::copy_file(subject("force_dimension").library, copy);
  setenv("BODKIN_STAND_IN", "stop_blocks@12", 1);
  DriverSubject troubled = subject("force_dimension");
  troubled.library = copy;
  EXPECT_EQ(troubled.board().trouble, Trouble::stop_blocks);  // the last of the list
  EXPECT_EQ(troubled.board().from_tick, 12);
  unsetenv("BODKIN_STAND_IN");
  std::filesystem::remove(copy);
}

TEST(DriverSettings, hold_words_numbers_and_quoted_paths) {
  const DriverSettings settings("  a=1.5 b=\"a path/with spaces\"  c= d=yes", {"a", "b", "c", "d", "e"});
  EXPECT_DOUBLE_EQ(settings.number("a", 0.0, 0.0, 2.0), 1.5);
  EXPECT_EQ(settings.text("b", ""), "a path/with spaces");
  EXPECT_EQ(settings.text("c", "other"), "");
  EXPECT_TRUE(settings.flag("d", false));
  EXPECT_EQ(settings.text("e", "other"), "other");
  EXPECT_THROW(settings.number("a", 0.0, 2.0, 3.0), DriverFailure);
  EXPECT_THROW(settings.flag("a", false), DriverFailure);
}

TEST(OpenHaptics, two_devices_share_the_scheduler_and_one_may_leave) {
  const DriverSubject& hd = subject("openhaptics");
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
  const DriverSubject& hd = subject("openhaptics");
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

// As an inkwell and a Desktop's continual refinement do: asked for before the scheduler runs, and again while it
// does.
TEST(OpenHaptics, a_calibration_that_needs_an_update_gets_it_in_the_servo_and_is_no_fault) {
  const DriverSubject& hd = subject("openhaptics");
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
  const DriverSubject& hd = subject("openhaptics");
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

// Wherever the arm is becomes the origin, so that only the user can ask for it, and never under a hand.
TEST(OpenHaptics, resets_encoders_before_the_servo_and_only_when_it_is_asked_to) {
  const DriverSubject& hd = subject("openhaptics");
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
    EXPECT_TRUE(comes_true([&] { return push.ticks > 200; }));  // the stand-in asks again after 50
    EXPECT_EQ(push.fault, DeviceFault::none);
    EXPECT_EQ(hd.board().calibrations, before + 1);
  }
  EXPECT_EQ(hd.board().violations, 0) << hd.board().first_violation.load();
  hd.board().clear();
}

TEST(OpenHaptics, hot_motors_stay_off_until_the_next_start) {
  const DriverSubject& hd = subject("openhaptics");
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
  const DriverSubject& hd = subject("openhaptics");
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
  const DriverSubject& hd = subject("openhaptics");
  hd.board().clear();
  const DevicePort port(*hd.driver, "", hd.words());
  EXPECT_THROW(DevicePort(*hd.driver, "", hd.unfit), DeviceError);
}

TEST(ForceDimension, an_sdk_without_the_newer_functions_works) {
  DriverSubject old = subject("force_dimension");
  old.library = std::string(BODKIN_STAND_INS) + "/force_dimension_old/libdrd.so";
  old.board().clear();
  DriverRig rig(old);
  EXPECT_DOUBLE_EQ(rig.port().abilities().peak_force, 12.0);  // of the model's table
  rig.push({Vec3(1, 2, 3), Vec3::Zero()});
  rig.start();
  EXPECT_TRUE(comes_true([&] { return old.board().force[2] == 3.0; }));
  rig.close();
  old.board().trouble = Trouble::uncalibrated;
  EXPECT_THROW(DevicePort(*old.driver, "", old.words() + " initialise=yes"),
               DeviceError);  // it has no DRD to do that
  EXPECT_EQ(old.board().violations, 0) << old.board().first_violation.load();
  EXPECT_EQ(old.board().open_devices, 0);
  old.board().clear();
}

TEST(ForceDimension, a_device_calibrates_itself_only_where_the_user_allows_it_to_move) {
  const DriverSubject& fd = subject("force_dimension");
  fd.board().clear();
  fd.board().trouble = Trouble::uncalibrated;
  EXPECT_THROW(DevicePort(*fd.driver, "", fd.words()), DeviceError);
  EXPECT_EQ(DevicePort(*fd.driver, "", fd.words() + " initialise=yes").abilities().name, "sigma.7");
  fd.board().clear();
}

TEST(ForceDimension, a_serial_number_that_is_not_there_is_told) {
  const DriverSubject& fd = subject("force_dimension");
  fd.board().clear();
  EXPECT_EQ(DevicePort(*fd.driver, "10204", fd.words()).abilities().serial, "10204");
  try {
    const DevicePort port(*fd.driver, "4", fd.words());
    FAIL();
  } catch (const DeviceError& error) {
    EXPECT_EQ(error.fault(), DeviceFault::not_connected);
    EXPECT_THAT(error.what(), HasSubstr("serial number 4"));
  }
  EXPECT_EQ(fd.board().open_devices, 0);
}

TEST(Haption, the_tick_begins_when_the_relays_have_closed) {
  DriverSubject virtuose = subject("haption");
  virtuose.settings = "relays_s=0.5";
  virtuose.board().clear();
  {
    DevicePort port(*virtuose.driver, "", virtuose.words());
    Push push;
    port.start(&push);
    EXPECT_GT(virtuose.board().ticks, 1);  // the loop ran, lest the vendor drop the connection
    EXPECT_TRUE(comes_true([&] { return push.ticks > 5; }));
    EXPECT_LT(virtuose.board().pushes, virtuose.board().ticks);
  }
  EXPECT_EQ(virtuose.board().violations, 0) << virtuose.board().first_violation.load();
}

// Every type has the limits of the smallest one; torques only where motors turn the handle.
TEST(Haption, is_called_by_its_type) {
  const DriverSubject& virtuose = subject("haption");
  virtuose.board().clear();
  for (const auto& [type, name, torque] : {std::tuple{1, "Virtuose 3D", 0.0},
                                           {2, "Virtuose 3D Desktop", 0.0},
                                           {3, "Virtuose 6D", 800.0},
                                           {4, "Virtuose 6D Desktop", 800.0},
                                           {8, "Inca 6D", 800.0},
                                           {13, "Virtuose of type 13", 0.0}}) {
    virtuose.board().type = type;
    const DevicePort port(*virtuose.driver, "", virtuose.words());
    EXPECT_EQ(port.abilities().name, name);
    EXPECT_EQ(port.abilities().peak_torque, torque) << name;
    EXPECT_EQ(port.abilities().peak_force, 10.0) << name;
  }
  virtuose.board().clear();
}

TEST(Haption, tells_the_version_of_the_library_from_that_of_the_controller) {
  const DriverSubject& virtuose = subject("haption");
  virtuose.board().clear();
  EXPECT_THAT(list_devices(*virtuose.driver, virtuose.words()).at(0).title,
              HasSubstr("VirtuoseAPI 4.1, controller 3.98"));
  for (const auto& [trouble, words] :
       {std::pair{Trouble::wrong_version, "is version 3.1, expected 4"},
        {Trouble::other_controller, "version 4.1, do not speak one version (error 20"}}) {
    virtuose.board().trouble = trouble;
    try {
      const DevicePort port(*virtuose.driver, "", virtuose.words());
      ADD_FAILURE() << words;
    } catch (const DeviceError& error) {
      EXPECT_EQ(error.fault(), DeviceFault::wrong_version);
      EXPECT_THAT(error.what(), HasSubstr(words));
    }
  }
  virtuose.board().clear();
}

}  // namespace
}  // namespace bodkin
