#include "haptics/drivers/haption_library.h"

namespace bodkin::haptics {

HaptionLibrary::HaptionLibrary(const std::string& chosen)
    : library({.product = "Haption",
               .chosen = chosen,
               .places = {"libVirtuoseAPI.so", "$VIRTUOSEAPI_HOME/lib/libVirtuoseAPI.so",
                          "$VIRTUOSEAPI_HOME/libVirtuoseAPI.so", "/usr/local/lib/libVirtuoseAPI.so",
                          "/opt/haption/lib/libVirtuoseAPI.so"},
               .advice = "install Haption's VirtuoseAPI 4, or say library=PATH",
               .share_symbols = false}) {
  library.need(virtAPIVersion, "virtAPIVersion");
  library.need(virtOpen, "virtOpen");
  library.need(virtClose, "virtClose");
  library.take(virtGetControlerVersion, "virtGetControlerVersion");
  library.need(virtGetDeviceID, "virtGetDeviceID");
  library.need(virtSetIndexingMode, "virtSetIndexingMode");
  library.need(virtSetForceFactor, "virtSetForceFactor");
  library.need(virtSetSpeedFactor, "virtSetSpeedFactor");
  library.need(virtSetTimeStep, "virtSetTimeStep");
  library.need(virtSetBaseFrame, "virtSetBaseFrame");
  library.need(virtSetObservationFrame, "virtSetObservationFrame");
  library.need(virtSetCommandType, "virtSetCommandType");
  library.need(virtSaturateTorque, "virtSaturateTorque");
  library.take(virtEnableForceFeedback, "virtEnableForceFeedback");
  library.need(virtSetPowerOn, "virtSetPowerOn");
  library.need(virtGetPowerOn, "virtGetPowerOn");
  library.need(virtGetPosition, "virtGetPosition");
  library.need(virtGetSpeed, "virtGetSpeed");
  library.need(virtSetForce, "virtSetForce");
  library.need(virtGetDeadMan, "virtGetDeadMan");
  library.need(virtGetEmergencyStop, "virtGetEmergencyStop");
  library.need(virtGetAlarm, "virtGetAlarm");
  library.need(virtGetButton, "virtGetButton");
  library.need(virtSetPeriodicFunction, "virtSetPeriodicFunction");
  library.need(virtStartLoop, "virtStartLoop");
  library.need(virtStopLoop, "virtStopLoop");
  library.need(virtGetErrorCode, "virtGetErrorCode");
  library.need(virtGetErrorMessage, "virtGetErrorMessage");
}

}  // namespace bodkin::haptics
