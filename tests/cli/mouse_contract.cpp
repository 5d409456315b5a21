// Mouse and keyboard, under driver_contract.cpp: the device behind the window (mouse_window_test.cpp has the window).
#include <cstdlib>

#include "desktop/mouse_driver.h"
#include "tests/haptics/driver_contract.h"

namespace bodkin {

using namespace bodkin::desktop;
using namespace bodkin::haptics;

std::vector<ContractSubject> contract_subjects() {
  for (const char* display : {"DISPLAY", "WAYLAND_DISPLAY"}) unsetenv(display);
  const auto arrange = [] {
    const auto feed = std::make_shared<PointerFeed>();
    connect_mouse(feed);
    PointerState moved;
    moved.right = 30.0;
    moved.pushed = 4.0;
    moved.tilted = 20.0;
    feed->write(moved);
    return ContractScene{.end =
                             [feed] {
                               PointerState closed;
                               closed.ended = true;
                               feed->write(closed);
                             },
                         .fault_at_end = DeviceFault::none};
  };
  return {{.name = "mouse",
           .driver = &mouse_driver(),
           .arrange = arrange,
           .fault_of_listing = DeviceFault::not_connected,
           .told_of_absent = {"no window is open"}}};
}

}  // namespace bodkin
