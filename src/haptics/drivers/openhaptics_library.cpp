#include "haptics/drivers/openhaptics_library.h"

namespace bodkin::haptics {

OpenHapticsLibrary::OpenHapticsLibrary(const std::string& chosen)
    : library({.product = "OpenHaptics",
               .chosen = chosen,
               .places = {"libHD.so", "$OH_SDK_BASE/lib/libHD.so", "$OH_SDK_BASE/lib64/libHD.so",
                          "$3DTOUCH_BASE/lib/libHD.so", "/usr/lib/libHD.so", "/usr/lib64/libHD.so"},
               .advice = "install OpenHaptics 3.4 or newer and the Touch device driver, or say library=PATH",
               .share_symbols = true}) {
  library.need(hdInitDevice, "hdInitDevice");
  library.need(hdDisableDevice, "hdDisableDevice");
  library.need(hdMakeCurrentDevice, "hdMakeCurrentDevice");
  library.need(hdBeginFrame, "hdBeginFrame");
  library.need(hdEndFrame, "hdEndFrame");
  library.need(hdGetError, "hdGetError");
  library.need(hdGetErrorString, "hdGetErrorString");
  library.need(hdEnable, "hdEnable");
  library.need(hdDisable, "hdDisable");
  library.need(hdGetIntegerv, "hdGetIntegerv");
  library.need(hdGetDoublev, "hdGetDoublev");
  library.need(hdGetString, "hdGetString");
  library.need(hdSetDoublev, "hdSetDoublev");
  library.need(hdCheckCalibration, "hdCheckCalibration");
  library.need(hdUpdateCalibration, "hdUpdateCalibration");
  library.need(hdStartScheduler, "hdStartScheduler");
  library.need(hdStopScheduler, "hdStopScheduler");
  library.need(hdScheduleAsynchronous, "hdScheduleAsynchronous");
  library.need(hdUnschedule, "hdUnschedule");
  library.take(hdGetBooleanv, "hdGetBooleanv");
}

}  // namespace bodkin::haptics
