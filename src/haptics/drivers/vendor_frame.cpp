#include "haptics/drivers/vendor_frame.h"

#include <limits>

namespace bodkin::haptics {

bodkin_state blank_state() noexcept {
  bodkin_state state{};
  y_up_frame().put_rotation(Mat3::Identity(), state);
  for (double& component : state.velocity) component = std::numeric_limits<double>::quiet_NaN();
  state.held = 1;
  return state;
}

}  // namespace bodkin::haptics
