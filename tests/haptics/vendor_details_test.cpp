// Specific to one vendor, beyond the contract of all drivers.
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

using mock::Trouble;
using testing::HasSubstr;

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

TEST(Mocks, take_their_trouble_from_the_environment) {
  // A copy is a separate library, which reads the environment anew.
  const std::filesystem::path copy =
      std::filesystem::temp_directory_path() / ("bodkin_mock_" + std::to_string(getpid()) + ".so");
  std::filesystem::copy_file(driver_subject("force_dimension").library, copy);
  setenv("BODKIN_MOCK", "stop_blocks@12", 1);
  DriverSubject troubled = driver_subject("force_dimension");
  troubled.library = copy;
  EXPECT_EQ(troubled.board().trouble, Trouble::stop_blocks);
  EXPECT_EQ(troubled.board().from_tick, 12);
  unsetenv("BODKIN_MOCK");
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

TEST(ForceDimension, an_sdk_without_the_newer_functions_works) {
  DriverSubject old = driver_subject("force_dimension");
  old.library = std::string(BODKIN_MOCKS) + "/force_dimension_old/libdrd.so";
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
  const DriverSubject& fd = driver_subject("force_dimension");
  fd.board().clear();
  fd.board().trouble = Trouble::uncalibrated;
  EXPECT_THROW(DevicePort(*fd.driver, "", fd.words()), DeviceError);
  EXPECT_EQ(DevicePort(*fd.driver, "", fd.words() + " initialise=yes").abilities().name, "sigma.7");
  fd.board().clear();
}

// It cannot calibrate itself: the vendor's samples send it forces of zero while the user moves its knob.
TEST(ForceDimension, a_falcon_is_calibrated_by_the_hand_that_moves_it) {
  const DriverSubject& fd = driver_subject("force_dimension");
  fd.board().clear();
  fd.board().type = 60;
  fd.board().trouble = Trouble::uncalibrated;
  const auto told = [&](const std::string& more) -> std::string {
    try {
      const DevicePort port(*fd.driver, "", fd.words() + more);
    } catch (const DeviceError& error) {
      EXPECT_EQ(error.fault(), DeviceFault::not_calibrated);
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(told(""), HasSubstr("initialise=yes"));
  EXPECT_THAT(told(" initialise=yes move_s=0.2"), HasSubstr("within 0.2 s"));
  fd.board().habit = mock::Hand::wander;
  EXPECT_EQ(told(" initialise=yes"), "");
  EXPECT_EQ(fd.board().pushes, 0);
  EXPECT_EQ(fd.board().violations, 0) << fd.board().first_violation.load();
  EXPECT_EQ(fd.board().open_devices, 0);
  fd.board().clear();
}

// The SDK's own limit of force is a setting that may be absent or another program's; the table is the device.
TEST(ForceDimension, knows_its_models_by_number) {
  const DriverSubject& fd = driver_subject("force_dimension");
  fd.board().clear();
  for (const auto& [type, force, torque] : {std::tuple{33, 12.0, 0.0},
                                            {64, 20.0, 200.0},
                                            {104, 12.0, 200.0},
                                            {107, 12.0, 200.0},
                                            {203, 12.0, 0.0},
                                            {206, 12.0, 0.0},
                                            {108, 12.0, 200.0},
                                            {999, 5.0, 0.0}}) {
    fd.board().type = type;
    const DevicePort port(*fd.driver, "", fd.words());
    EXPECT_EQ(port.abilities().peak_force, force) << type;
    EXPECT_EQ(port.abilities().peak_torque, torque) << type;
  }
  fd.board().clear();
}

TEST(ForceDimension, a_serial_number_that_is_not_there_is_told) {
  const DriverSubject& fd = driver_subject("force_dimension");
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

// Each time the power comes on: the loop runs meanwhile, lest the vendor drop the connection.
TEST(Haption, nobody_holds_it_and_it_has_no_force_until_the_relays_have_closed) {
  DriverSubject virtuose = driver_subject("haption");
  virtuose.settings = "relays_s=0.5";
  virtuose.board().clear();
  virtuose.board().trouble = Trouble::hand_off;
  {
    DriverRig rig(virtuose);
    rig.push({Vec3(1, 0, 0), Vec3::Zero()});
    rig.start();
    for (int grasp = 0; grasp < 2; ++grasp) {
      EXPECT_TRUE(rig.ticks(20));
      EXPECT_FALSE(rig.last().held);
      EXPECT_EQ(rig.last().fault, DeviceFault::none);
      const auto pushes = virtuose.board().pushes.load();
      const auto began = std::chrono::steady_clock::now();
      virtuose.board().trouble = Trouble::none;
      EXPECT_TRUE(comes_true([&] { return rig.last().held; }));
      EXPECT_GE(std::chrono::steady_clock::now() - began, std::chrono::milliseconds(490));
      EXPECT_TRUE(comes_true([&] { return virtuose.board().pushes > pushes; }));
      EXPECT_EQ(rig.last().fault, DeviceFault::none);
      virtuose.board().trouble = Trouble::hand_off;
      EXPECT_TRUE(comes_true([&] { return !rig.last().held; }));
    }
  }
  EXPECT_EQ(virtuose.board().violations, 0) << virtuose.board().first_violation.load();
  virtuose.board().clear();
}

TEST(Haption, a_held_handle_without_power_asks_for_the_switch) {
  const DriverSubject& virtuose = driver_subject("haption");
  virtuose.board().clear();
  virtuose.board().trouble = Trouble::no_power;
  {
    DriverRig rig(virtuose);
    rig.start();
    EXPECT_TRUE(rig.fault(DeviceFault::emergency_stop));
    EXPECT_THAT(rig.port().explain(), HasSubstr("press the button of the motors' power"));
    virtuose.board().trouble = Trouble::none;
    EXPECT_TRUE(comes_true([&] { return rig.last().fault == DeviceFault::none && rig.last().held; }));
  }
  EXPECT_EQ(virtuose.board().violations, 0) << virtuose.board().first_violation.load();
  virtuose.board().clear();
}

// Every type has the limits of the smallest one; torques only where motors turn the handle.
TEST(Haption, is_called_by_its_type) {
  const DriverSubject& virtuose = driver_subject("haption");
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
  const DriverSubject& virtuose = driver_subject("haption");
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
