/* The interface between Bodkin and a driver of haptic devices, in plain C, so that anyone can ship a driver as a
 * shared library. Bodkin's own drivers stand behind the same interface. A driver exports one function,
 * bodkin_driver_entry, declared at the end of this file.
 *
 * Threads: list, open, start, stop and close may block and are called by ordinary threads, not always the
 * same one, and never two at once for one handle. exchange is called by one thread between start and stop only.
 * Bodkin waits for a call that may block some seconds at most; one that comes back later is followed by stop and
 * close. explain never blocks. A driver's library is never unloaded.
 *
 * Poses, velocities, forces and torques are in the operator's frame: right-handed, +X to the operator's right, +Y
 * away from the operator, +Z up, origin in the middle of the usable workspace; mm, mm/s, N, N mm. Forces and torques
 * act on the hand. No function may throw or call exit(). Strings are UTF-8 and end in a zero. */
#ifndef BODKIN_DRIVER_H
#define BODKIN_DRIVER_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define BODKIN_DRIVER_ABI 1u
#define BODKIN_TEXT 128
#define BODKIN_MESSAGE 512

/* Results. The order is that of bodkin::haptics::DeviceFault. */
enum {
  BODKIN_OK,
  BODKIN_NOT_INSTALLED,
  BODKIN_NOT_CONNECTED,
  BODKIN_NOT_CALIBRATED,
  BODKIN_BUSY,
  BODKIN_NO_PERMISSION,
  BODKIN_WRONG_VERSION,
  BODKIN_COMMUNICATION_LOST,
  BODKIN_OVERHEATED,
  BODKIN_FORCE_LIMIT,
  BODKIN_VELOCITY_LIMIT,
  BODKIN_EMERGENCY_STOP,
  BODKIN_BAD_DATA,
  BODKIN_VENDOR_ERROR,
  BODKIN_BAD_SETTINGS = 100 /* of list and open alone: the user's settings are wrong; no DeviceFault */
};

/* The last bit of a state's buttons is none that a finger presses: the hand has ended the session, as where a
 * recording is over or a window was closed. It stays set. */
#define BODKIN_BUTTON_END (1u << 31)
/* Nor is the one before it: where the hand is is not known, and the pose is the last one that was. */
#define BODKIN_BUTTON_UNSEEN (1u << 30)

/* Numbers of which nothing is known are 0. */
typedef struct bodkin_abilities {
  char name[BODKIN_TEXT];                     /* of the model */
  char serial[BODKIN_TEXT];                   /* may be empty */
  double peak_force, continuous_force;        /* N; peak 0 = the device renders no force */
  double peak_torque;                         /* N mm; 0 = none */
  double stiffness, damping;                  /* N/mm, N s/mm that it renders stably; 0 = unknown */
  double resolution;                          /* mm; 0 = unknown */
  double rate;                                /* Hz */
  double workspace_low[3], workspace_high[3]; /* mm; all 0 = unknown */
  uint32_t measures_rotation, has_dead_man;
  uint32_t owns_loop; /* 1: the driver's thread calls the tick; 0: Bodkin's thread calls exchange() */
  /* Since 0.2. A driver that was built before leaves these two as they are: zero. */
  double delay;                   /* s from a command (the tick's return, the call of exchange) to the force at the
                                   * hand, 0 to 0.02; 0 = less than one can tell, or unknown */
  char delay_source[BODKIN_TEXT]; /* where that is written; may be empty */
} bodkin_abilities;

typedef struct bodkin_state {
  double position[3]; /* mm */
  double rotation[9]; /* row by row, tool to operator's frame; its third column points along the needle, hub to tip */
  double velocity[3]; /* mm/s; NaN: not reported */
  double temperature; /* 0 cold to 1 hot */
  uint32_t buttons;   /* bit 0: the first button is pressed */
  uint32_t held;      /* the dead-man's switch; 1 for a device without one */
  uint32_t fault;     /* one of the results above */
} bodkin_state;

typedef struct bodkin_command {
  double force[3];  /* N */
  double torque[3]; /* N mm */
} bodkin_command;

/* Called with each device that is found: its identity for open(), and words for people. */
typedef void (*bodkin_found)(void* user, const char* identity, const char* title);

/* One tick: the state goes in, the command comes out. dt: s by the clock since the tick before, the nominal period at
 * the first. Never blocks. After a fault a driver keeps calling it for as long as it can. */
typedef void (*bodkin_tick)(void* user, const bodkin_state* state, double dt, bodkin_command* command);

typedef struct bodkin_driver {
  uint32_t abi;        /* BODKIN_DRIVER_ABI */
  const char* name;    /* "openhaptics" */
  const char* summary; /* one line for `bodkin devices list` */

  /* Finds devices without moving or energising any. `settings`: "key=value" words from the user's profile, may be
   * empty; a value with spaces stands in double quotes, key="a value". Where the result is not BODKIN_OK, `message`
   * (BODKIN_MESSAGE bytes) gets one sentence that says what to do. */
  int (*list)(const char* settings, bodkin_found found, void* user, char* message);
  /* Opens a device ("" = the first) without force; a handle other than null comes with BODKIN_OK. */
  int (*open)(const char* identity, const char* settings, void** handle, bodkin_abilities* abilities, char* message);
  /* Enables forces, which are zero. With owns_loop the driver's thread calls `tick` from now on; else it is ignored.
   */
  int (*start)(void* handle, bodkin_tick tick, void* user, char* message);
  /* One round without owns_loop: sends the command, returns the state that answers it. Does not allocate. A result
   * other than BODKIN_OK is the state's fault. */
  int (*exchange)(void* handle, const bodkin_command* command, bodkin_state* state);
  /* Zero force, forces disabled, no tick any more once it has returned. */
  int (*stop)(void* handle);
  void (*close)(void* handle);
  /* One sentence about the last fault, with the vendor's own code and words; empty where there was none. May be a
   * null pointer. */
  void (*explain)(void* handle, char* message);
} bodkin_driver;

typedef const bodkin_driver* (*bodkin_driver_entry_function)(uint32_t abi);

#define BODKIN_DRIVER_EXPORT __attribute__((visibility("default")))

/* The driver, which lives for ever; a null pointer for an abi that it does not speak. */
BODKIN_DRIVER_EXPORT const bodkin_driver* bodkin_driver_entry(uint32_t abi);

#ifdef __cplusplus
}
#endif

#endif
