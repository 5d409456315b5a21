// A mock of libHD.so with one Touch-like device and a second one of the name "second". Its scheduler is a thread
// that ticks as fast as it likes, one simulated millisecond each. It enforces the order of calls: about devices only
// in the scheduler's thread while that runs; state between begin and end of a frame; one frame a tick; the force of a
// tick is what its frame has set, zero otherwise. Violations go onto the stack of errors and to the board.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <mutex>
#include <optional>
#include <thread>

#include "tests/haptics/mocks/mechanism.h"

#define EXPORT extern "C" __attribute__((visibility("default")))

namespace {

using mock::board;
using mock::Board;
using mock::Trouble;

struct ErrorRecord {
  unsigned code;
  int internal;
  unsigned device;
};

constexpr unsigned no_device = 0xFFFFFFFF;
// The library's numbers of a model, in the vendor's units and axes: those published by its maker.
struct Model {
  const char* name;
  double stiffness, peak, continuous, damping, torque;
  double box[6];
};
constexpr Model models[] = {
    // not symmetric about the origin
    {"Touch", 0.5, 3.3, 0.88, 0.004, 188.0, {-80, -40, -35, 80, 80, 35}},
    {"Touch X", 1.0, 7.9, 1.75, 0.005, 188.0, {-80, -50, -60, 80, 70, 60}},
    {"PHANTOM Premium 1.5 6DOF", 0.8, 8.5, 1.4, 0.005, 170.0, {-190.5, -133.5, -95.5, 190.5, 133.5, 95.5}},
};
constexpr double peak = models[0].peak;  // N

// Board::type is an index.
const Model& model() {
  return models[std::min(static_cast<std::size_t>(board().type), std::size(models) - 1)];
}

struct Device {
  bool open = false;
  bool forces = false;
  bool in_frame = false;
  bool framed = false;  // this tick
  double force[3] = {}, torque[3] = {};
  mock::Mechanism mechanism{0.001, peak};
};

struct Callback {
  unsigned (*function)(void*) = nullptr;
  void* user = nullptr;
  unsigned short priority = 0;
};

Device devices[2];
Board second_board;  // nobody looks at it
std::atomic<unsigned> current{no_device};
Callback callbacks[8];
std::mutex schedule;  // held during a tick
std::atomic<bool> running{false};
std::thread scheduler;
thread_local bool is_scheduler = false;

// The stack of errors, which the scheduler's thread pushes to without a lock.
std::atomic_flag stack_busy = ATOMIC_FLAG_INIT;
ErrorRecord stack[64];
std::size_t depth = 0;

std::atomic<bool> updated{false};
std::atomic<bool> calibrated_by_hand{false};  // since the stylus was in its inkwell
std::atomic<std::int64_t> updated_at{0};      // tick
std::atomic<double> shifted{0.0};             // mm, along the first axis

unsigned styles() {
  const int set = board().calibration_styles;
  return set != 0 ? static_cast<unsigned>(set) : 2 | 4;  // automatic, inkwell
}

void push(unsigned code, unsigned device) {
  while (stack_busy.test_and_set(std::memory_order_acquire)) std::this_thread::yield();
  if (depth < std::size(stack)) stack[depth++] = {code, 0, device};
  stack_busy.clear(std::memory_order_release);
}

void refuse(unsigned code, const char* rule) {
  push(code, current);
  board().violation(rule);
}

Device* device(unsigned id) {
  if (id < 2 && devices[id].open) return &devices[id];
  refuse(0x0104, "a handle that is not open");
  return nullptr;
}

// The device of a call, if the call is permitted here and now.
Device* about(bool frame_needed) {
  if (running && !is_scheduler) {
    refuse(0x0102, "a call about a device from outside while the scheduler runs");
    return nullptr;
  }
  Device* found = device(current);
  if (found != nullptr && frame_needed && running && !found->in_frame) {
    refuse(0x0402, "state outside a frame");
    return nullptr;
  }
  return found;
}

bool first(const Device* which) {
  return which == devices;
}

// As in hdCheckCalibration. An update is requested now and then; a device without a known position waits for its
// stylus in the inkwell, and for the update there.
unsigned calibration() {
  const Board& b = board();
  if (b.troubled_by(Trouble::needs_update) && (!updated || b.ticks - updated_at > 50)) return 0x5001;
  if (!b.troubled_by(Trouble::uncalibrated) || calibrated_by_hand) return 0x5000;
  return b.in_inkwell ? 0x5001 : 0x5002;
}

void tick() {
  const std::lock_guard lock(schedule);
  for (Device& one : devices) {
    one.framed = false;
    std::fill_n(one.force, 3, 0.0);
    std::fill_n(one.torque, 3, 0.0);
  }
  if (board().troubled_by(Trouble::late)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  if (auto before = board().before_callback.load()) before();
  for (Callback& callback : callbacks) {
    if (callback.function != nullptr && callback.function(callback.user) == 0) callback = {};
  }
  if (auto after = board().after_callback.load()) after();
  for (Device& one : devices) {
    if (one.open && one.in_frame) board().violation("a frame was not ended");
    const bool off = !one.forces || !one.framed || board().troubled_by(Trouble::unplug);
    if (off) std::fill_n(one.force, 3, 0.0);
    if (off) std::fill_n(one.torque, 3, 0.0);
    if (one.open) one.mechanism.step(first(&one) ? board() : second_board, one.force, one.torque);
  }
}

void rest() {
  for (auto* triple : {&board().force, &board().torque}) {
    for (auto& component : *triple) component = 0.0;
  }
}

}  // namespace

EXPORT unsigned hdInitDevice(const char* name) {
  board().wait_while(Trouble::open_blocks);
  const unsigned id = name != nullptr && std::strcmp(name, "second") == 0 ? 1 : 0;
  if (running) refuse(0x0102, "a device was initialised while the scheduler ran");
  if (board().troubled_by(Trouble::no_device)) {
    push(0x0300, no_device);
    return no_device;
  }
  if (devices[id].open || board().troubled_by(Trouble::busy)) {
    push(0x0301, no_device);
    return no_device;
  }
  devices[id] = Device{};
  updated = calibrated_by_hand = false;
  shifted = 0.0;
  devices[id].open = true;
  board().opened();
  current = id;
  return id;
}
EXPORT void hdDisableDevice(unsigned id) {
  Device* which = device(id);
  if (which == nullptr) return;
  if (running) board().violation("a device was disabled while the scheduler ran");
  for (const Callback& callback : callbacks) {
    if (callback.function != nullptr && !devices[1 - id].open) board().violation("a callback was left scheduled");
  }
  if (first(which)) board().motors_on = false;
  which->open = false;
  --board().open_devices;
}
EXPORT void hdMakeCurrentDevice(unsigned id) {
  if (device(id) != nullptr) current = id;
}
EXPORT void hdBeginFrame(unsigned id) {
  Device* which = device(id);
  if (which == nullptr) return;
  current = id;
  if (about(false) == nullptr) return;
  if (which->in_frame || which->framed) refuse(0x0400, "a second frame in one tick");
  which->in_frame = true;
  std::fill_n(which->force, 3, 0.0);
  std::fill_n(which->torque, 3, 0.0);
  const Board& b = board();
  const unsigned whose = b.only_first ? 0 : id;  // an error may come up in a frame of the other device
  if (b.troubled_by(Trouble::unplug)) push(0x0302, whose);
  if (b.troubled_by(Trouble::hot)) push(0x0200, whose);
  if (b.troubled_by(Trouble::too_fast)) push(0x0203, whose);
  if (b.troubled_by(Trouble::too_much_force)) push(0x0201, whose);
  if (b.troubled_by(Trouble::unknown_code)) push(0x0999, whose);
  if (b.troubled_by(Trouble::device_fault)) push(0x0300, whose);
}
EXPORT void hdEndFrame(unsigned id) {
  Device* which = device(id);
  if (which == nullptr) return;
  if (!which->in_frame) refuse(0x0401, "a frame was ended that was not begun");
  which->in_frame = false;
  which->framed = true;
}
EXPORT ErrorRecord hdGetError() {
  while (stack_busy.test_and_set(std::memory_order_acquire)) std::this_thread::yield();
  ErrorRecord top{0, 0, no_device};
  if (depth > 0) top = stack[--depth];
  stack_busy.clear(std::memory_order_release);
  return top;
}
EXPORT const char* hdGetErrorString(unsigned) {
  return "words of the vendor";
}
EXPORT void hdEnable(unsigned capability) {
  board().wait_while(Trouble::start_blocks);
  Device* which = about(false);
  if (which == nullptr) return;
  if (capability != 0x4000) return refuse(0x0100, "an unknown capability");
  if (calibration() == 0x5002) board().violation("forces enabled without calibration");
  which->forces = true;
  if (first(which)) board().motors_on = true;
}
#ifndef BROKEN_SDK
EXPORT void hdDisable(unsigned capability) {
  Device* which = about(false);
  if (which == nullptr) return;
  if (capability != 0x4000) return refuse(0x0101, "a safety capability was disabled");
  which->forces = false;
  if (first(which)) board().motors_on = false;
}
#endif
EXPORT void hdGetIntegerv(unsigned parameter, int* value) {
  if (about(parameter == 0x2000) == nullptr) return;
  switch (parameter) {
    case 0x2000:
      *value = static_cast<int>(board().buttons.load());
      return;
    case 0x2553:
      *value = 6;
      return;
    case 0x2554:
      *value = 6;
      return;
    case 0x2555:
      *value = static_cast<int>(styles());
      return;
    case 0x2600:
      *value = 1000;
      return;
    default:
      refuse(0x0103, "not a parameter of integers");
  }
}
EXPORT void hdGetBooleanv(unsigned parameter, unsigned char* value) {
  if (about(true) == nullptr) return;
  if (parameter != 0x2001) return refuse(0x0103, "not a parameter of truth values");
  *value = board().troubled_by(Trouble::hand_off) ? 0 : 1;
}
EXPORT void hdGetDoublev(unsigned parameter, double* values) {
  const Device* which = about(parameter < 0x2500);
  if (which == nullptr) return;
  switch (parameter) {
    case 0x2051:
      std::copy_n(which->mechanism.velocity().data(), 3, values);
      return;
    case 0x2052:
      for (std::size_t i = 0; i < 9; ++i) values[i % 3 * 4 + i / 3] = board().turn[i];
      values[3] = values[7] = values[11] = 0.0;
      std::copy_n(which->mechanism.position().data(), 3, values + 12);
      if (first(which)) values[12] += shifted;
      values[15] = 1.0;
      return;
    case 0x2551:
      std::copy_n(model().box, 6, values);
      return;
    case 0x2602:
      *values = model().stiffness;
      return;
    case 0x2603:
      *values = model().peak;
      return;
    case 0x2604:
      *values = model().continuous;
      return;
    case 0x2605:
      std::fill_n(values, 6, board().troubled_by(Trouble::hot) ? 1.0 : 0.2);
      return;
    case 0x2609:
      *values = model().damping;
      return;
    case 0x2622:
      *values = model().torque;
      return;
    default:
      refuse(0x0103, "not a parameter of doubles");
  }
}
EXPORT const char* hdGetString(unsigned parameter) {
  if (about(false) == nullptr) return nullptr;
  switch (parameter) {
    case 0x2500:
      return board().troubled_by(Trouble::wrong_version) ? "2.1" : "3.40";
    case 0x2501:
      return model().name;
    case 0x2504:
      return "51025300001";
    default:
      refuse(0x0103, "not a parameter of strings");
      return nullptr;
  }
}
EXPORT void hdSetDoublev(unsigned parameter, const double* values) {
  Device* which = about(true);
  if (which == nullptr) return;
  if (parameter != 0x2700 && parameter != 0x2701) return refuse(0x0103, "not a parameter to be set");
  std::copy_n(values, 3, parameter == 0x2700 ? which->force : which->torque);
}
EXPORT unsigned hdCheckCalibration() {
  return about(false) == nullptr ? 0x5001 : calibration();
}
EXPORT void hdUpdateCalibration(unsigned style) {
  // Calibration.c of the vendor's samples: one of the supported styles, encoders while the arm is in its reset
  // position before the scheduler runs, the inkwell while it runs.
  if (about(false) == nullptr) return;
  const bool is_one = style == 1 || style == 2 || style == 4;
  if (!is_one || (style & styles()) == 0) return refuse(0x0101, "not one style of calibration that this device has");
  if (style == 1 && running) return refuse(0x0102, "encoders reset while the scheduler ran");
  if (style != 1 && !running) return refuse(0x0102, "calibrated before the scheduler ran");
  if (calibration() == 0x5002) return board().violation("an update before the stylus was in its inkwell");
  if (board().in_inkwell) calibrated_by_hand = true;
  shifted = shifted + board().calibration_shift.exchange(0.0);
  updated = true;
  updated_at = board().ticks.load();
  ++board().calibrations;
}
EXPORT void hdStartScheduler() {
  if (board().troubled_by(Trouble::no_scheduler)) return push(0x0500, no_device);
  if (running.exchange(true)) return refuse(0x0102, "the scheduler was started twice");
  scheduler = std::thread([] {
    is_scheduler = true;
    while (running) {
      if (!board().troubled_by(Trouble::freeze)) tick();
      std::this_thread::sleep_for(std::chrono::microseconds(50));
    }
  });
}
EXPORT void hdStopScheduler() {
  board().wait_while(Trouble::stop_blocks);
  if (is_scheduler) return refuse(0x0102, "the scheduler was stopped by itself");
  if (!running.exchange(false)) return refuse(0x0102, "the scheduler was stopped twice");
  scheduler.join();
  rest();
}
EXPORT unsigned long hdScheduleAsynchronous(unsigned (*function)(void*), void* user, unsigned short priority) {
  const std::lock_guard lock(schedule);
  for (std::size_t i = 0; i < std::size(callbacks); ++i) {
    if (callbacks[i].function != nullptr) continue;
    callbacks[i] = {function, user, priority};
    return 0x100000000UL + i;  // does not fit into 32 bits
  }
  push(0x0501, no_device);
  return 0;
}
EXPORT void hdUnschedule(unsigned long handle) {
  const std::lock_guard lock(schedule);
  const std::size_t index = handle - 0x100000000UL;
  if (index >= std::size(callbacks) || callbacks[index].function == nullptr) {
    return refuse(0x0101, "unscheduled what was not scheduled");
  }
  callbacks[index] = {};
}
