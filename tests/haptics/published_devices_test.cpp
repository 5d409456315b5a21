// What the campaigns take for a device is what its driver says of it, completed from the table of devices: otherwise
// they would prove the safety of devices that nobody holds.
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

// A driver and a device of its vendor, as that numbers them; 0: the one that the stand-in has by itself.
struct Owned {
  std::string driver;
  int type = 0;
};

void PrintTo(const Owned& owned, std::ostream* to) {
  *to << owned.driver << owned.type;
}

class PublishedDeviceOf : public testing::TestWithParam<Owned> {};

TEST_P(PublishedDeviceOf, has_the_numbers_of_the_driver) {
  const auto& subjects = driver_subjects();
  const DriverSubject& subject =
      *std::find_if(subjects.begin(), subjects.end(), [](auto& one) { return one.name == GetParam().driver; });
  subject.board().clear();
  subject.board().type = GetParam().type;
  const DevicePort port(*subject.driver, "", subject.words());
  DeviceAbilities device = port.abilities();
  const auto profiles = io::default_device_profiles();
  if (const DeviceProfile* profile = find_profile(profiles, device.name)) complete(device, *profile);
  const auto& published = published_devices();
  // A 3D Desktop differs from a 3D by its arm alone, of which nothing is known.
  const std::string name = device.name == "Virtuose 3D Desktop" ? "Virtuose 3D" : device.name;
  const auto same =
      std::find_if(published.begin(), published.end(), [&](const auto& one) { return one.name == name; });
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
  subject.board().clear();
}

INSTANTIATE_TEST_SUITE_P(EveryDevice, PublishedDeviceOf,
                         testing::Values(Owned{"openhaptics"}, Owned{"haply"}, Owned{"force_dimension", 33},
                                         Owned{"force_dimension", 34}, Owned{"force_dimension", 35},
                                         Owned{"force_dimension", 60}, Owned{"force_dimension", 63},
                                         Owned{"force_dimension", 104}, Owned{"force_dimension", 108},
                                         Owned{"haption", 1}, Owned{"haption", 2}, Owned{"haption", 3},
                                         Owned{"haption", 4}));

}  // namespace
}  // namespace bodkin
