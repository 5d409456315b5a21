/* A driver for a device that does not exist: it stands still in the middle of its workspace and stores the last
 * commanded force. Build it with
 *
 *     cc -std=c11 -shared -fPIC -fvisibility=hidden -I <include>/bodkin example_driver.c -o example_driver.so
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "haptics/bodkin_driver.h"

typedef struct device {
  int started;
  bodkin_command last;
} device;

static device only_device;

static int check(const char* settings, char* message) {
  if (*settings == '\0') return BODKIN_OK;
  snprintf(message, BODKIN_MESSAGE, "the settings are '%.200s', but this driver has none; leave them away", settings);
  return BODKIN_BAD_SETTINGS;
}

static int list(const char* settings, bodkin_found found, void* user, char* message) {
  const int result = check(settings, message);
  if (result != BODKIN_OK) return result;
  found(user, "0", "Example device");
  return BODKIN_OK;
}

static int open_device(const char* identity, const char* settings, void** handle, bodkin_abilities* abilities,
                       char* message) {
  const int result = check(settings, message);
  if (result != BODKIN_OK) return result;
  if (*identity != '\0' && strcmp(identity, "0") != 0) {
    snprintf(message, BODKIN_MESSAGE, "there is no device '%s', expected 0", identity);
    return BODKIN_NOT_CONNECTED;
  }
  memset(abilities, 0, sizeof *abilities);
  snprintf(abilities->name, sizeof abilities->name, "Example");
  abilities->peak_force = 3.0;
  abilities->continuous_force = 1.0;
  abilities->rate = 1000.0;
  memset(&only_device, 0, sizeof only_device);
  *handle = &only_device;
  return BODKIN_OK;
}

static int start(void* handle, bodkin_tick tick, void* user, char* message) {
  (void)tick; /* Bodkin's thread calls exchange(), because owns_loop is 0 */
  (void)user;
  (void)message;
  ((device*)handle)->started = 1;
  return BODKIN_OK;
}

static int exchange(void* handle, const bodkin_command* command, bodkin_state* state) {
  device* self = handle;
  if (!self->started) return BODKIN_NOT_CONNECTED;
  self->last = *command; /* a real driver sends this to the motors */
  memset(state, 0, sizeof *state);
  state->rotation[0] = state->rotation[4] = state->rotation[8] = 1.0;
  state->velocity[0] = state->velocity[1] = state->velocity[2] = NAN; /* not measured */
  state->held = 1;
  return BODKIN_OK;
}

static int stop(void* handle) {
  device* self = handle;
  self->started = 0;
  memset(&self->last, 0, sizeof self->last);
  return BODKIN_OK;
}

static void close_device(void* handle) { stop(handle); }

const bodkin_driver* bodkin_driver_entry(uint32_t abi) {
  static const bodkin_driver driver = {
      BODKIN_DRIVER_ABI, "example", "a device that stands still", list, open_device, start, exchange, stop,
      close_device,      NULL /* explain */};
  return abi == BODKIN_DRIVER_ABI ? &driver : NULL;
}
