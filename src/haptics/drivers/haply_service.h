#pragma once

#include <memory>
#include <string>

#include "haptics/drivers/driver_settings.h"
#include "haptics/drivers/haply_connection.h"
#include "haptics/drivers/haply_inventory.h"

namespace bodkin::haptics {

// Where Haply's service is, and which one it is.
struct HaplyService {
  HaplyAddress address;
  HaplyVersion version;
};

// Asks at the port of the settings, or at the service's two usual ones. Throws DriverFailure: the port is closed,
// another service answers, or the service is too old. One sentence says what to do.
HaplyService find_haply_service(const DriverSettings& settings);

// A session with the service and what it said of the devices at its begin.
struct HaplySession {
  std::unique_ptr<HaplyConnection> connection;
  HaplyInventory inventory;
};

// Throws DriverFailure for the same reasons.
HaplySession open_haply_session(const HaplyService& service);

}  // namespace bodkin::haptics
