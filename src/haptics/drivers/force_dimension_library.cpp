#include "haptics/drivers/force_dimension_library.h"

namespace bodkin::haptics {

namespace {

LibraryPlaces places(const std::string& chosen) {
  LibraryPlaces where{.product = "Force Dimension",
                      .chosen = chosen,
                      .places = {},
                      .advice = "install the Force Dimension SDK 3.14 or newer, or say library=PATH",
                      .share_symbols = false};
  // libdrd holds the functions of libdhd and can calibrate; the SDK's archive is often unpacked without installing
  // it.
  for (const std::string name : {"libdrd.so", "libdhd.so"}) {
    where.places.push_back(name);
    for (const std::string folder : {"$FDSDK/lib/release/lin-x86_64-gcc/", "$FDSDK/lib/release/lin-aarch64-gcc/",
                                     "/usr/local/lib/", "$HOME/.local/lib/"}) {
      where.places.push_back(folder + name);
      where.places.push_back(folder + name + ".*");
    }
  }
  return where;
}

}  // namespace

ForceDimensionLibrary::ForceDimensionLibrary(const std::string& chosen) : library(places(chosen)) {
  library.need(dhdGetSDKVersion, "dhdGetSDKVersion");
  library.need(dhdGetDeviceCount, "dhdGetDeviceCount");
  library.need(dhdOpenID, "dhdOpenID");
  library.need(dhdClose, "dhdClose");
  library.need(dhdGetSystemType, "dhdGetSystemType");
  library.need(dhdGetSystemName, "dhdGetSystemName");
  library.need(dhdGetSerialNumber, "dhdGetSerialNumber");
  library.need(dhdHasWrist, "dhdHasWrist");
  library.need(dhdHasActiveWrist, "dhdHasActiveWrist");
  library.need(dhdGetStatus, "dhdGetStatus");
  library.need(dhdGetPositionAndOrientationFrame, "dhdGetPositionAndOrientationFrame");
  library.need(dhdGetLinearVelocity, "dhdGetLinearVelocity");
  library.need(dhdSetForce, "dhdSetForce");
  library.need(dhdSetForceAndTorque, "dhdSetForceAndTorque");
  library.need(dhdGetButtonMask, "dhdGetButtonMask");
  library.need(dhdEnableForce, "dhdEnableForce");
  library.need(dhdSetBrakes, "dhdSetBrakes");
  library.need(dhdStop, "dhdStop");
  library.need(dhdErrorGetLast, "dhdErrorGetLast");
  library.need(dhdErrorGetLastStr, "dhdErrorGetLastStr");
  library.take(dhdSetMaxForce, "dhdSetMaxForce");
  library.take(dhdSetGravityCompensation, "dhdSetGravityCompensation");
  library.take(dhdHasActiveGripper, "dhdHasActiveGripper");
  library.take(dhdEmulateButton, "dhdEmulateButton");
  library.take(dhdEnableExpertMode, "dhdEnableExpertMode");
  library.take(dhdDisableExpertMode, "dhdDisableExpertMode");
  library.take(dhdSetWatchdog, "dhdSetWatchdog");
  library.take(drdOpenID, "drdOpenID");
  library.take(drdClose, "drdClose");
  library.take(drdIsInitialized, "drdIsInitialized");
  library.take(drdAutoInit, "drdAutoInit");
  library.take(drdStop, "drdStop");
}

}  // namespace bodkin::haptics
