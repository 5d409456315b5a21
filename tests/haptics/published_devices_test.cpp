// The campaigns' device numbers are those of its driver, completed from the table of devices: otherwise they would
// prove the safety of fictitious devices.
#include "tests/haptics/published_devices.h"

#include <algorithm>
#include <ostream>
#include <string>

#include "tests/haptics/driver_rig.h"
#include <gtest/gtest.h>

#include "haptics/device_profiles.h"
#include "io/device_profiles_file.h"

namespace bodkin {

using namespace bodkin::haptics;

namespace {

// A driver and a device by its vendor's number; 0: the mock's default device.
struct Owned {
  std::string driver;
  int type = 0;
  bool in_late_campaign = true;
};

void PrintTo(const Owned& owned, std::ostream* to) {
  *to << owned.driver << owned.type;
}

class PublishedDeviceOf : public testing::TestWithParam<Owned> {
 protected:
  PublishedDeviceOf() {
    const DriverSubject& subject = driver_subject(GetParam().driver);
    subject.board().clear();
    subject.board().type = GetParam().type;
    told = DevicePort(*subject.driver, "", subject.words()).abilities();
    subject.board().clear();
    profile = find_profile(profiles, told.name);
  }

  const std::vector<DeviceProfile> profiles = io::default_device_profiles();
  DeviceAbilities told;  // by the driver only
  const DeviceProfile* profile = nullptr;
};

// All sources agree on a number, and the table has every number of the driver except a Touch's torque, which only the
// mock renders.
TEST_P(PublishedDeviceOf, agrees_with_the_table) {
  ASSERT_NE(profile, nullptr) << told.name;
  const auto expect_same = [this](double of_driver, DeviceQuantity quantity, const char* what) {
    if (of_driver > 0.0) {
      EXPECT_DOUBLE_EQ(of_driver, profile->of(quantity).value) << told.name << ": " << what;
    }
  };
  expect_same(told.peak_force, DeviceQuantity::peak_force, "peak force");
  expect_same(told.continuous_force, DeviceQuantity::continuous_force, "continuous force");
  expect_same(told.stiffness, DeviceQuantity::stiffness, "stiffness");
  expect_same(told.damping, DeviceQuantity::damping, "damping");
  expect_same(told.resolution, DeviceQuantity::resolution, "resolution");
  const Vec3 box = told.workspace_high - told.workspace_low;
  expect_same(box.x(), DeviceQuantity::workspace_x, "width");
  expect_same(box.y(), DeviceQuantity::workspace_y, "depth");
  expect_same(box.z(), DeviceQuantity::workspace_z, "height");
  const double torque = profile->of(DeviceQuantity::peak_torque).value;
  if (torque > 0.0) {
    EXPECT_DOUBLE_EQ(told.peak_torque, torque) << told.name;
  }
}

TEST_P(PublishedDeviceOf, is_what_the_campaign_with_late_forces_takes_it_for) {
  if (!GetParam().in_late_campaign) return;  // SafetyCampaign runs over the whole table
  DeviceAbilities device = told;
  ASSERT_NE(profile, nullptr) << told.name;
  complete(device, *profile);
  const auto& published = published_devices();
  const auto same = std::find_if(published.begin(), published.end(),
                                 [this](const auto& one) { return find_profile(profiles, one.name) == profile; });
  ASSERT_NE(same, published.end()) << device.name;
  EXPECT_DOUBLE_EQ(device.peak_force, same->peak);
  EXPECT_DOUBLE_EQ(device.stiffness, same->stiffness);
  EXPECT_DOUBLE_EQ(device.damping, same->damping);
  EXPECT_NEAR(device.delay, same->delay, 1e-6);  // Haption's library counts in float
  EXPECT_EQ(device.owns_loop, same->vendors_loop);
  // If neither driver nor table has the encoder, the campaign assumes one.
  if (device.resolution > 0.0) {
    EXPECT_DOUBLE_EQ(device.resolution, same->resolution);
  }
}

// Driver and type of all published_devices(), and of the two others in the table.
INSTANTIATE_TEST_SUITE_P(EveryDevice, PublishedDeviceOf,
                         testing::Values(Owned{"openhaptics"}, Owned{"openhaptics", 1}, Owned{"openhaptics", 2},
                                         Owned{"haply"}, Owned{"force_dimension", 33}, Owned{"force_dimension", 34},
                                         Owned{"force_dimension", 35}, Owned{"force_dimension", 60},
                                         Owned{"force_dimension", 63}, Owned{"force_dimension", 64, false},
                                         Owned{"force_dimension", 104}, Owned{"force_dimension", 106, false},
                                         Owned{"force_dimension", 108}, Owned{"haption", 1}, Owned{"haption", 2},
                                         Owned{"haption", 3}, Owned{"haption", 4}));

}  // namespace
}  // namespace bodkin
