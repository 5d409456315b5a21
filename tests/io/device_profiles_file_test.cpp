#include "io/device_profiles_file.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "anatomy/case.h"
#include "core/error.h"
#include "core/settings_check.h"

namespace bodkin {

using namespace bodkin::haptics;
using namespace bodkin::io;
namespace {

const std::string header = "device,quantity,value,unit,source,provenance,remark\n";

std::string sentence(const std::string& rows) {
  try {
    parse_device_profiles(header + rows, "devices.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(DeviceProfilesFile, reads_numbers_names_and_where_they_come_from) {
  const auto profiles = parse_device_profiles(
      "# a comment\n" + header +
          "Pen,also_called,PEN 2,,,,\nPen,peak_force,3.5,N,a note,looked-up,cold\nArm,resolution,,mm,,not sourced,\n"
          "Pen,workspace_x,120,mm,a note,recalled,\n",
      "devices.csv");
  ASSERT_EQ(profiles.size(), 2u);
  EXPECT_EQ(profiles[0].name, "Pen");
  EXPECT_EQ(profiles[0].other_names, std::vector<std::string>{"PEN 2"});
  EXPECT_EQ(profiles[0].of(DeviceQuantity::peak_force).value, 3.5);
  EXPECT_EQ(profiles[0].of(DeviceQuantity::peak_force).provenance, Provenance::looked_up);
  EXPECT_EQ(profiles[0].of(DeviceQuantity::peak_force).source, "a note");
  EXPECT_EQ(profiles[0].of(DeviceQuantity::peak_force).remark, "cold");
  EXPECT_EQ(profiles[0].of(DeviceQuantity::workspace_x).value, 120.0);
  EXPECT_EQ(profiles[0].of(DeviceQuantity::stiffness).value, 0.0);
  EXPECT_EQ(profiles[1].of(DeviceQuantity::resolution).provenance, Provenance::unknown);
}

TEST(DeviceProfilesFile, the_table_that_comes_with_bodkin_is_sound) {
  const auto profiles = default_device_profiles();
  EXPECT_GE(profiles.size(), 10u);
  const auto touch = std::find_if(profiles.begin(), profiles.end(), [](const auto& p) { return p.name == "Touch"; });
  ASSERT_NE(touch, profiles.end());
  EXPECT_EQ(touch->of(DeviceQuantity::peak_force).value, 3.3);
  EXPECT_EQ(touch->of(DeviceQuantity::continuous_force).value, 0.88);
  EXPECT_EQ(touch->of(DeviceQuantity::workspace_y).value, 70.0) << "depth, the operator's y";
  for (const DeviceProfile& profile : profiles) {
    for (const ProfileValue& value : profile.values) {
      EXPECT_EQ(value.provenance == Provenance::unknown, value.value == 0.0) << profile.name;
      EXPECT_EQ(value.value == 0.0, value.source.empty()) << profile.name;
    }
  }
}

TEST(DeviceProfilesFile, a_bad_row_is_told_in_one_sentence_with_file_and_line) {
  EXPECT_EQ(
      sentence("Pen,peak_force,much,N,a note,recalled,\n"),
      "devices.csv, line 2: column 3: value is 'much', expected a number above 0 and at most 100 N, or nothing");
  EXPECT_EQ(sentence("Pen,peak_force,3,lbf,a note,recalled,\n"),
            "devices.csv, line 2: column 4: unit is 'lbf', expected N for peak_force");
  EXPECT_EQ(
      sentence("\nPen,peak_force,3,N,a note,somewhere,\n"),
      "devices.csv, line 3: column 6: provenance is 'somewhere', expected paper, looked-up, recalled, derived or not "
      "sourced");
  EXPECT_NE(sentence("Pen,colour,3,N,a note,recalled,\n").find("devices.csv, line 2: column 2: quantity is 'colour'"),
            std::string::npos);
  EXPECT_NE(sentence("Pen,peak_force,3,N\n").find("there are 4 columns, expected 7"), std::string::npos);
  EXPECT_NE(sentence("Pen,peak_force,-3,N,a note,recalled,\n").find("value is '-3'"), std::string::npos);
  EXPECT_NE(sentence("Pen,peak_force,nan,N,a note,recalled,\n").find("value is 'nan'"), std::string::npos);
  EXPECT_NE(sentence("Pen,peak_force,1e9,N,a note,recalled,\n").find("value is '1e9'"), std::string::npos);
  EXPECT_NE(sentence(",peak_force,3,N,a note,recalled,\n").find("the name of a device"), std::string::npos);
  EXPECT_NE(sentence("Pen,peak_force,,N,,recalled,\n").find("not sourced, because there is no value"),
            std::string::npos);
  EXPECT_NE(sentence("Pen,peak_force,3,N,,recalled,\n").find("column 5: source"), std::string::npos);
  EXPECT_NE(sentence("Pen,also_called,,,,,\n").find("another name"), std::string::npos);
  EXPECT_NE(sentence("Pen,peak_force,3,N,a note,recalled,\nPen,peak_force,4,N,a note,recalled,\n")
                .find("devices.csv, line 3: peak_force of 'Pen' is given again, which line 2 gives already"),
            std::string::npos);
  EXPECT_NE(
      sentence("Pen,peak_force,3,N,a note,recalled,\nPen,continuous_force,4,N,a note,recalled,\n")
          .find("devices.csv, line 3: the continuous force of 'Pen' is 4 N, expected at most its peak force of 3 N"),
      std::string::npos);
  EXPECT_NE(sentence("").find("no devices"), std::string::npos);
  EXPECT_THROW(parse_device_profiles("", "devices.csv"), InputError);
  EXPECT_THROW(parse_device_profiles("device,quantity\n", "devices.csv"), InputError);
}

// A profile's numbers become the device of a case.
TEST(DeviceProfilesFile, takes_what_a_case_can_state_and_no_more) {
  using anatomy::DeviceLimits;
  const std::vector<std::pair<std::string, double DeviceLimits::*>> quantities = {
      {"peak_force", &DeviceLimits::peak_force},
      {"continuous_force", &DeviceLimits::continuous_force},
      {"peak_torque", &DeviceLimits::peak_torque},
      {"stiffness", &DeviceLimits::stiffness},
      {"resolution", &DeviceLimits::position_resolution}};
  for (const auto& [name, limit] : quantities) {
    const DeclaredParameter declared = declaration_of(limit);
    const auto row = [&, quantity = name](double value) {
      return "Pen," + quantity + "," + number_text(value) + "," + std::string(declared.unit) + ",a note,recalled,\n";
    };
    const std::string peak = name == "continuous_force" ? "Pen,peak_force,100,N,a note,recalled,\n" : "";
    EXPECT_EQ(sentence(peak + row(declared.range.high)), "no error") << name;
    EXPECT_NE(sentence(peak + row(1.01 * declared.range.high)).find("at most " + number_text(declared.range.high)),
              std::string::npos)
        << name;
  }
}

TEST(DeviceProfilesFile, a_file_that_is_not_there_is_told) {
  EXPECT_THROW(read_device_profiles("/nowhere/devices.csv"), InputError);
}

}  // namespace
}  // namespace bodkin
