#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bodkin::haptics {

// What Haply's service reports about itself and the connected devices, before any of them is used.

struct HaplyVersion {
  int major = 0, minor = 0;
  std::string text;  // in the service's format
};

// The body of GET /version. Throws DriverFailure{BODKIN_WRONG_VERSION} if the response is not from this service. The
// message says only what was found.
HaplyVersion parse_haply_version(std::string_view body);

struct HaplyInverse {
  std::string identity;
  std::string model;  // "Inverse3"
  bool calibrated = true;
  // Empty, or the basis, preset, mount or transform set by another program, so that the axes are not the vendor's
  // own: "the basis XZY".
  std::string moved;
};

struct HaplyInventory {
  std::vector<HaplyInverse> devices;
  std::vector<std::string> grips;  // identities, in the order of the message
};

// The first message of a session. Entries without an identity of letters, digits and . : _ - are left out. Throws
// DriverFailure{BODKIN_BAD_DATA} for text that is not an inventory.
HaplyInventory parse_haply_inventory(std::string_view text);

}  // namespace bodkin::haptics
