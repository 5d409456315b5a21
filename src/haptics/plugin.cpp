#include "haptics/plugin.h"

#include "haptics/driver_library.h"

namespace bodkin::haptics {

namespace {

const std::string spoken = std::to_string(BODKIN_DRIVER_ABI);

}  // namespace

void check(const bodkin_driver& driver, const std::string& origin) {
  if (driver.abi != BODKIN_DRIVER_ABI) {
    throw SystemError(origin + " speaks version " + std::to_string(driver.abi) +
                      " of the driver interface, Bodkin speaks " + spoken +
                      ": get the driver that was built for this Bodkin");
  }
  const bool whole = driver.name != nullptr && *driver.name != '\0' && driver.summary != nullptr &&
                     driver.list != nullptr && driver.open != nullptr && driver.start != nullptr &&
                     driver.exchange != nullptr && driver.stop != nullptr && driver.close != nullptr;
  if (!whole) {
    throw SystemError(origin +
                      " leaves out its name, its summary or a function of the driver interface: every one but " +
                      "explain is needed");
  }
}

const bodkin_driver& load_plugin(const std::string& path) {
  const DriverLibrary library({.product = "the driver " + path,
                               .chosen = path,
                               .places = {},
                               .advice = "give the path of a library that exports bodkin_driver_entry",
                               .share_symbols = false});
  const bodkin_driver* (*entry)(std::uint32_t) = nullptr;
  library.need(entry, "bodkin_driver_entry");
  const bodkin_driver* driver = entry(BODKIN_DRIVER_ABI);
  if (driver == nullptr) {
    throw SystemError(library.path() + " does not speak version " + spoken +
                      " of the driver interface: get the driver that was built for this Bodkin");
  }
  check(*driver, library.path());
  return *driver;
}

}  // namespace bodkin::haptics
