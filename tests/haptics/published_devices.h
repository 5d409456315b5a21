#pragma once

#include <vector>

namespace bodkin {

// Published numbers of a device, or of its kind, and the delay stated by its driver.
struct PublishedDevice {
  const char* name;
  double peak, stiffness;  // N, N/mm; stiffness 0 = the maker prints none that a loop at 1 kHz reaches
  double damping;          // N s/mm that a library dares to render
  double resolution;       // mm
  double delay;            // s
  bool vendors_loop;
};

// Data sheets (peak force, resolution) and CHAI3D's device table (stiffness, damping; of an Inverse3 that of its
// port, jashenlow/chai3d_haply on GitHub), as share/bodkin/devices.csv has them where it has the device; a lambda.7
// is the XTH-2 of that table; of a Touch the 0.5 N/mm and 0.004 N s/mm that its library reports. No source has
// numbers of each Virtuose, so the driver gives all of them those of the smallest; their stiffness and encoder and
// the encoder of an Inverse3 are assumed. published_devices_test.cpp holds them against the drivers.
inline const std::vector<PublishedDevice>& published_devices() {
  static const std::vector<PublishedDevice> devices = {
      {"Falcon", 8.0, 3.0, 0.02, 0.0635, 0.001, false},
      {"omega.3", 12.0, 5.0, 0.03, 0.01, 0.00025, false},
      {"omega.6", 12.0, 5.0, 0.03, 0.01, 0.00025, false},
      {"omega.7", 12.0, 5.0, 0.03, 0.01, 0.00025, false},
      {"sigma.7", 12.0, 4.0, 0.03, 0.01, 0.00025, false},
      {"lambda.7", 12.0, 8.0, 0.03, 0.01, 0.00025, false},
      {"delta.3", 20.0, 5.0, 0.03, 0.02, 0.00025, false},
      {"Touch", 3.3, 0.5, 0.004, 0.055, 0.001, true},
      {"Touch X", 7.9, 1.0, 0.005, 0.023, 0.001, true},
      {"Premium 1.5", 8.5, 0.8, 0.005, 0.0295, 0.001, true},
      {"Virtuose 3D", 10.0, 2.0, 0.01, 0.02, 0.001, true},
      {"Virtuose 6D", 10.0, 2.0, 0.01, 0.02, 0.001, true},
      {"Virtuose 6D Desktop", 10.0, 2.0, 0.01, 0.02, 0.001, true},
      {"Inverse3", 10.0, 1.0, 0.006, 0.01, 0.002, false},
  };
  return devices;
}

}  // namespace bodkin
