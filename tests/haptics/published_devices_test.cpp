// What the campaigns take for a device is what its driver says of it, completed from the table of devices: otherwise
// they would prove the safety of devices that nobody holds.
#include "tests/haptics/published_devices.h"

#include <algorithm>
#include <string>

#include "tests/haptics/driver_rig.h"
#include <gtest/gtest.h>

#include "haptics/device_profiles.h"
#include "io/device_profiles_file.h"

namespace bodkin {

using namespace bodkin::haptics;

namespace {

class PublishedDeviceOf : public testing::TestWithParam<DriverSubject> {};

TEST_P(PublishedDeviceOf, has_the_numbers_of_the_driver) {
  GetParam().board().clear();
  const DevicePort port(*GetParam().driver, "", GetParam().words());
  DeviceAbilities device = port.abilities();
  const auto profiles = io::default_device_profiles();
  if (const DeviceProfile* profile = find_profile(profiles, device.name)) complete(device, *profile);
  const auto& published = published_devices();
  const auto same =
      std::find_if(published.begin(), published.end(), [&](const auto& one) { return one.name == device.name; });
  ASSERT_NE(same, published.end()) << device.name;
  EXPECT_DOUBLE_EQ(device.peak_force, same->peak);
  EXPECT_DOUBLE_EQ(device.stiffness, same->stiffness);
  EXPECT_DOUBLE_EQ(device.damping, same->damping);
  EXPECT_NEAR(device.delay, same->delay, 1e-6);  // Haption's library counts in float
  EXPECT_EQ(device.owns_loop, same->vendors_loop);
  // Where neither driver nor table knows the encoder, the campaign assumes one.
  if (device.resolution > 0.0) {
    EXPECT_DOUBLE_EQ(device.resolution, same->resolution);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryDriver, PublishedDeviceOf, testing::ValuesIn(driver_subjects()),
                         [](const auto& subject) { return subject.param.name; });

}  // namespace
}  // namespace bodkin
