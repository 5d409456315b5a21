#pragma once

#include <memory>
#include <string>
#include <vector>

#include "haptics/drivers/driver_settings.h"
#include "haptics/drivers/haply_connection.h"
#include "haptics/drivers/haply_inventory.h"

namespace bodkin::haptics {

// The ports of the service unless its configuration says otherwise. HTTP and WebSocket share a port or have one each;
// the documentation of one version says both. A WebSocket on the older port uses the 3.0 format.
struct HaplyPorts {
  int newer = 10001, older = 10000;
  int events = 10020;
};

// The address and version of Haply's service.
struct HaplyService {
  HaplyAddress address;               // of its HTTP
  std::vector<HaplyAddress> sockets;  // candidates for its WebSocket, the likeliest first
  int events = 0;                     // port of its events; 0 = not to be used
  int older_port = 0;                 // which uses the 3.0 format
  HaplyVersion version;
};

// Looks at the port of the settings, or at the service's two usual ones. Throws DriverFailure: the port is closed,
// another service responds, or the service is too old. One sentence says what to do.
HaplyService find_haply_service(const DriverSettings& settings, const HaplyPorts& ports = {});

// A session with the service and its first report of the devices.
struct HaplySession {
  std::unique_ptr<HaplyConnection> connection;
  HaplyInventory inventory;
  HaplyAddress address;       // of the WebSocket
  bool older_format = false;  // 3.0, whatever the service's version
};

// Throws DriverFailure for the same reasons.
HaplySession open_haply_session(const HaplyService& service);

}  // namespace bodkin::haptics
