#pragma once

#include <memory>
#include <string>
#include <vector>

#include "haptics/drivers/driver_settings.h"
#include "haptics/drivers/haply_connection.h"
#include "haptics/drivers/haply_inventory.h"

namespace bodkin::haptics {

// Where the service listens unless its configuration says otherwise. HTTP and WebSocket share a port or have one
// each; the pages of one version say both. What speaks WebSocket on the older port speaks the 3.0 format.
struct HaplyPorts {
  int newer = 10001, older = 10000;
  int events = 10020;
};

// Where Haply's service is, and which one it is.
struct HaplyService {
  HaplyAddress address;               // of its HTTP
  std::vector<HaplyAddress> sockets;  // where its WebSocket may be, the likeliest first
  int events = 0;                     // port of its events; 0 = not to be asked for
  int older_port = 0;                 // which speaks the 3.0 format
  HaplyVersion version;
};

// Asks at the port of the settings, or at the service's two usual ones. Throws DriverFailure: the port is closed,
// another service answers, or the service is too old. One sentence says what to do.
HaplyService find_haply_service(const DriverSettings& settings, const HaplyPorts& ports = {});

// A session with the service and what it said of the devices at its begin.
struct HaplySession {
  std::unique_ptr<HaplyConnection> connection;
  HaplyInventory inventory;
  HaplyAddress address;       // of the WebSocket
  bool older_format = false;  // 3.0, whatever the service's version
};

// Throws DriverFailure for the same reasons.
HaplySession open_haply_session(const HaplyService& service);

}  // namespace bodkin::haptics
