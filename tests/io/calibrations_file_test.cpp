#include "io/calibrations_file.h"

#include <cstdlib>
#include <fstream>
#include <numbers>
#include <string>

#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::haptics;
using namespace bodkin::io;
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

DeviceCalibration whole() {
  DeviceCalibration calibration;
  calibration.driver = "force_dimension";
  calibration.model = "omega.3 <\"left\">";
  calibration.serial = "0042";
  calibration.measured_at = "2026-11-22T04:30:00Z";
  calibration.reach = {{-60.25, -50.0, 1.0 / 3.0}, {60.0, 50.0, 80.0}};
  calibration.mounting = 0.5;
  calibration.tip_offset = Vec3(1.5, -2.0, 39.0);
  calibration.tip_residual = 0.12;
  calibration.tool_axis = Vec3(1.0, 2.0, -2.0) / 3.0;
  calibration.weight = 0.8;
  calibration.delay = 0.0012;
  calibration.friction = Vec3(0.02, 0.03, 0.05);
  return calibration;
}

std::string refusal_of(const std::string& document) {
  try {
    parse_calibrations(document, "calibrations.xml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CalibrationsFile, what_is_written_reads_back) {
  const ScratchFolder folder;
  const fs::path file = folder.path() / "a new folder" / "calibrations.xml";
  DeviceCalibration bare;
  bare.driver = "haply";
  bare.model = "Inverse3";
  bare.measured_at = "2026-11-22T04:30:00Z";
  write_calibrations(std::vector{whole(), bare}, file);
  const std::vector<DeviceCalibration> found = read_calibrations(file);
  ASSERT_EQ(found.size(), 2U);
  const DeviceCalibration wanted = whole();
  EXPECT_EQ(found[0].model, wanted.model);
  EXPECT_EQ(found[0].serial, wanted.serial);
  EXPECT_EQ(found[0].measured_at, wanted.measured_at);
  EXPECT_EQ(found[0].reach->low, wanted.reach->low);
  EXPECT_EQ(found[0].reach->high, wanted.reach->high);
  EXPECT_NEAR(*found[0].mounting, 0.5, 1e-15);
  EXPECT_EQ(*found[0].tip_offset, *wanted.tip_offset);
  EXPECT_EQ(found[0].tip_residual, wanted.tip_residual);
  EXPECT_EQ(*found[0].tool_axis, *wanted.tool_axis);
  EXPECT_EQ(*found[0].weight, 0.8);
  EXPECT_EQ(*found[0].delay, 0.0012);
  EXPECT_EQ(found[0].friction, wanted.friction);
  EXPECT_TRUE(found[1].empty());
  EXPECT_FALSE(fs::exists(file.string() + ".new"));
}

TEST(CalibrationsFile, no_file_is_no_calibration) {
  const ScratchFolder folder;
  EXPECT_TRUE(read_calibrations(folder.path() / "none.xml").empty());
}

TEST(CalibrationsFile, a_new_measurement_keeps_what_it_did_not_measure) {
  std::vector<DeviceCalibration> all = {whole()};
  DeviceCalibration again;
  again.driver = whole().driver;
  again.model = whole().model;
  again.serial = whole().serial;
  again.measured_at = "2026-12-01T00:00:00Z";
  again.weight = 0.5;
  merge_calibration(all, again);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(*all[0].weight, 0.5);
  EXPECT_EQ(all[0].friction, Vec3(Vec3::Zero()));
  EXPECT_EQ(*all[0].tip_offset, *whole().tip_offset);
  EXPECT_EQ(all[0].measured_at, "2026-12-01T00:00:00Z");
  again.serial = "another";
  merge_calibration(all, again);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(find_calibration(all, again.driver, again.model, "another"), &all[1]);
  EXPECT_EQ(find_calibration(all, "haply", again.model, "another"), nullptr);
}

TEST(CalibrationsFile, what_cannot_be_is_refused_in_a_sentence) {
  const std::string device = R"(<device driver="a" model="b" measured_at="2026-11-22T04:30:00Z">)";
  const auto with = [&](const std::string& inside) {
    return refusal_of("<calibrations version=\"1\">\n" + device + inside + "</device></calibrations>");
  };
  EXPECT_EQ(with(""), "");
  EXPECT_THAT(with("<axis x=\"1\" y=\"1\" z=\"0\"/>"), HasSubstr("line 2: the axis has the length 1.41"));
  EXPECT_THAT(with("<weight N=\"9\"/>"), HasSubstr("line 2"));
  EXPECT_THAT(with("<delay s=\"0.5\"/>"), HasSubstr("line 2"));
  EXPECT_THAT(with("<weight N=\"nan\"/>"), HasSubstr("line 2"));
  EXPECT_THAT(with("<tip x_mm=\"1e9\" y_mm=\"0\" z_mm=\"0\"/>"), HasSubstr("line 2"));
  EXPECT_THAT(with("<reach low_x_mm=\"0\" low_y_mm=\"0\" low_z_mm=\"0\" high_x_mm=\"0\" high_y_mm=\"9\" "
                   "high_z_mm=\"9\"/>"),
              HasSubstr("smallest side of the reach is 0 mm"));
  EXPECT_THAT(with("<colour/>"), HasSubstr("colour"));
  EXPECT_THAT(refusal_of("<calibrations version=\"1\">" + device + "</device>" + device + "</device></calibrations>"),
              HasSubstr("a second calibration of a b"));
  EXPECT_THAT(refusal_of(""), HasSubstr("calibrations.xml"));
}

TEST(CalibrationsFile, lies_where_settings_of_programs_lie) {
  const char* const config = std::getenv("XDG_CONFIG_HOME");
  const char* const home = std::getenv("HOME");
  const std::string before_config = config != nullptr ? config : "", before_home = home != nullptr ? home : "";
  setenv("XDG_CONFIG_HOME", "/etc/somebody", 1);
  EXPECT_EQ(calibrations_file().value(), "/etc/somebody/bodkin/calibrations.xml");
  setenv("XDG_CONFIG_HOME", "relative", 1);
  setenv("HOME", "/home/somebody", 1);
  EXPECT_EQ(calibrations_file().value(), "/home/somebody/.config/bodkin/calibrations.xml");
  unsetenv("HOME");
  EXPECT_EQ(calibrations_file(), std::nullopt);
  config != nullptr ? setenv("XDG_CONFIG_HOME", before_config.c_str(), 1) : unsetenv("XDG_CONFIG_HOME");
  home != nullptr ? setenv("HOME", before_home.c_str(), 1) : unsetenv("HOME");
}

}  // namespace
}  // namespace bodkin
