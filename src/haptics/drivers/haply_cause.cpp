#include "haptics/drivers/haply_cause.h"

#include "haptics/bodkin_driver.h"

namespace bodkin::haptics {

int result_of(HaplyCause cause) noexcept {
  switch (cause) {
    case HaplyCause::none:
      return BODKIN_OK;
    case HaplyCause::silent:
    case HaplyCause::unplugged:
    case HaplyCause::without_position:
      return BODKIN_COMMUNICATION_LOST;
    case HaplyCause::damaged:
      return BODKIN_BAD_DATA;
    case HaplyCause::uncalibrated:
      return BODKIN_NOT_CALIBRATED;
    case HaplyCause::unpowered:
    case HaplyCause::braked:
      return BODKIN_EMERGENCY_STOP;
    case HaplyCause::moved:
    case HaplyCause::refused:
      break;
  }
  return BODKIN_VENDOR_ERROR;
}

const char* words_of(HaplyCause cause) noexcept {
  switch (cause) {
    case HaplyCause::none:
      break;
    case HaplyCause::silent:
      return "Haply's Inverse service has stopped answering: see whether haply-inverse-service runs, and start again";
    case HaplyCause::unplugged:
      return "Haply's Inverse service no longer lists the device: plug its USB cable in and start again";
    case HaplyCause::without_position:
      return "Haply's Inverse service no longer reports the device's position: check Haply Hub, and start again";
    case HaplyCause::damaged:
      return "Haply's Inverse service sent a message that cannot be read: restart haply-inverse-service";
    case HaplyCause::uncalibrated:
      return "the Inverse3 is not calibrated: put its arm into its rest and follow Haply Hub";
    case HaplyCause::unpowered:
      return "the Inverse3 has no power for its motors: connect its power supply";
    case HaplyCause::braked:
      return "the Inverse3's emergency brake is engaged: release it as Haply Hub says, and start again";
    case HaplyCause::moved:
      return "Haply's Inverse service has been given a transform, a basis, a preset or a mount of the device "
             "meanwhile, "
             "and forces would point the wrong way: take it back in Haply Hub";
    case HaplyCause::refused:
      return "Haply's Inverse service leaves the device idle although forces are sent: say force_key=vector or "
             "force_key=values, whichever was not used";
  }
  return "";
}

}  // namespace bodkin::haptics
