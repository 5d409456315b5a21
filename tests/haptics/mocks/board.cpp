#include "tests/haptics/mocks/board.h"

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <thread>

namespace mock {

namespace {

constexpr const char* names[] = {
    "none",           "no_device",    "busy",         "wrong_version",  "uncalibrated",
    "unplug",         "freeze",       "nan",          "late",           "hot",
    "emergency_stop", "hand_off",     "too_fast",     "too_much_force", "unknown_code",
    "open_blocks",    "start_blocks", "stop_blocks",  "needs_update",   "other_controller",
    "stuck",          "device_fault", "no_scheduler", "no_power"};

constexpr const char* habits[] = {"still", "wander", "swivel", "sweep", "loose", "gone"};

void read_habit(Board& to) {
  const char* value = std::getenv("BODKIN_MOCK_HAND");
  if (value == nullptr) return;
  int number = 0;
  for (const char* habit : habits) {
    if (std::strcmp(habit, value) == 0) to.habit = static_cast<Hand>(number);
    ++number;
  }
}

void read_environment(Board& to) {
  read_habit(to);
  const char* value = std::getenv("BODKIN_MOCK");
  if (value == nullptr) return;
  const std::string_view text = value;
  const std::size_t at = text.find('@');
  int number = 0;
  for (const char* name : names) {
    if (text.substr(0, at) == name) to.trouble = static_cast<Trouble>(number);
    ++number;
  }
  if (at != std::string_view::npos) to.from_tick = std::atoll(value + at + 1);
}

}  // namespace

void Board::violation(const char* rule) noexcept {
  if (violations.fetch_add(1) == 0) first_violation = rule;
}

void Board::wait_while(Trouble which) const noexcept {
  while (troubled_by(which)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

Board& board() noexcept {
  static Board one;
  [[maybe_unused]] static const bool read = (read_environment(one), true);
  return one;
}

}  // namespace mock

extern "C" __attribute__((visibility("default"))) mock::Board* bodkin_mock() {
  return &mock::board();
}
