/* Drivers that Bodkin must refuse: of another version, answering nothing (0), without functions, without an entry. */
#include <stddef.h>

#include "haptics/bodkin_driver.h"

#ifdef PLUG_IN_ABI
const bodkin_driver* bodkin_driver_entry(uint32_t abi) {
  static const bodkin_driver driver = {PLUG_IN_ABI, "plug_in", "refused", NULL, NULL, NULL, NULL, NULL, NULL, NULL};
  (void)abi;
  return PLUG_IN_ABI == 0 ? NULL : &driver;
}
#else
BODKIN_DRIVER_EXPORT int nothing_of_interest(void);
int nothing_of_interest(void) {
  return 0;
}
#endif
