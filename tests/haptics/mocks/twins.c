/* A driver that finds two devices and cannot tell them apart. */
#include "haptics/bodkin_driver.h"

static int list(const char* settings, bodkin_found found, void* user, char* message) {
  (void)settings;
  (void)message;
  found(user, "7", "the left one");
  found(user, "7", "the right one");
  return BODKIN_OK;
}
static int open_device(const char* identity, const char* settings, void** handle, bodkin_abilities* abilities,
                       char* message) {
  (void)identity, (void)settings, (void)handle, (void)abilities, (void)message;
  return BODKIN_NOT_CONNECTED;
}
static int start(void* handle, bodkin_tick tick, void* user, char* message) {
  (void)handle, (void)tick, (void)user, (void)message;
  return BODKIN_NOT_CONNECTED;
}
static int exchange(void* handle, const bodkin_command* command, bodkin_state* state) {
  (void)handle, (void)command, (void)state;
  return BODKIN_NOT_CONNECTED;
}
static int stop(void* handle) {
  (void)handle;
  return BODKIN_OK;
}
static void close_device(void* handle) {
  (void)handle;
}

const bodkin_driver* bodkin_driver_entry(uint32_t abi) {
  static const bodkin_driver driver = {BODKIN_DRIVER_ABI, "twins",  "two of one name", list,        open_device, start,
                                       exchange,          stop,     close_device,      (void*)0};
  return abi == BODKIN_DRIVER_ABI ? &driver : (void*)0;
}
