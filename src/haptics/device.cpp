#include "haptics/device.h"

namespace bodkin::haptics {

std::string_view text_of(DeviceFault fault) noexcept {
  switch (fault) {
    case DeviceFault::none:
      return "none";
    case DeviceFault::not_installed:
      return "not installed";
    case DeviceFault::not_connected:
      return "not connected";
    case DeviceFault::not_calibrated:
      return "not calibrated";
    case DeviceFault::busy:
      return "busy";
    case DeviceFault::no_permission:
      return "no permission";
    case DeviceFault::wrong_version:
      return "wrong version";
    case DeviceFault::communication_lost:
      return "communication lost";
    case DeviceFault::overheated:
      return "overheated";
    case DeviceFault::force_limit:
      return "force limit";
    case DeviceFault::velocity_limit:
      return "velocity limit";
    case DeviceFault::emergency_stop:
      return "emergency stop";
    case DeviceFault::bad_data:
      return "bad data";
    case DeviceFault::vendor_error:
      return "vendor error";
  }
  return "vendor error";
}

}  // namespace bodkin::haptics
