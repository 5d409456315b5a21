#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>

namespace mock {

// Faults of a simulated device. Environment: BODKIN_MOCK="unplug@100", from tick 100 on.
enum class Trouble : int {
  none,
  no_device,
  busy,
  wrong_version,
  uncalibrated,
  unplug,
  freeze,  // the loop stands still; a call of ours that takes part in it does not return
  not_a_number,
  late,  // every reply comes 5 ms late
  hot,
  emergency_stop,
  hand_off,
  too_fast,
  too_much_force,
  unknown_code,
  open_blocks,
  start_blocks,
  stop_blocks,
  needs_update,      // of its calibration, every now and then, which the servo does in one style
  other_controller,  // of a version that the library does not speak
  stuck,             // the library goes on, but its readings stand still
  device_fault,      // a frame does not reach the device
  no_scheduler,      // the vendor's loop does not start
  no_power           // the user's switch for the motors is off
};

// The hand's own behaviour. Environment: BODKIN_MOCK_HAND="swivel".
enum class Hand : int {
  still,   // it stays where Board::hand is
  wander,  // through a box of 80 x 60 x 100 mm (vendor's axes)
  swivel,  // the tool's tip, 50 mm along its third axis, stays in one place
  sweep,   // 80 mm along the vendor's second axis, and no way back
  loose,   // it stays there too, but yields to a force
  gone     // after three seconds it lets go, and the handle hangs down the vendor's third axis with 0.6 N
};

// The test's side of a mock: every library exports it as `extern "C" mock::Board* bodkin_mock()`. Numbers
// are in the vendor's own axes and units, exactly as they pass through the vendor's functions.
struct Board {
  std::atomic<Trouble> trouble{Trouble::none};
  std::atomic<std::int64_t> from_tick{0}, until_tick{std::numeric_limits<std::int64_t>::max()};
  std::atomic<bool> only_first{false};  // where a library has two devices, the second is well

  // The hand: where it means to be, and the tool's rotation (row by row, vendor's axes). A firm hand does not yield.
  std::array<std::atomic<double>, 3> hand{};
  std::array<std::atomic<double>, 9> turn{1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::atomic<bool> firm{true};
  std::atomic<Hand> habit{Hand::still};
  std::atomic<std::uint32_t> buttons{0};
  std::atomic<int> type{0};  // of the device, as the vendor numbers it; 0: the one that the library has by itself

  // Of calibration: the styles that the device supports, as the vendor writes them (0: those of a Touch), and by how
  // much the next update moves the pose along the vendor's first axis.
  std::atomic<int> calibration_styles{0};
  std::atomic<double> calibration_shift{0.0};
  std::atomic<bool> in_inkwell{false};  // the stylus

  // The device: what its motors apply now, and where it is.
  std::array<std::atomic<double>, 3> force{}, torque{}, position{};
  std::atomic<std::int64_t> ticks{0};
  std::atomic<std::int64_t> pushes{0};             // ticks with a force other than zero
  std::atomic<std::int64_t> pushes_in_trouble{0};  // such ticks while the trouble lasted
  std::atomic<int> open_devices{0};
  std::atomic<int> calibrations{0};  // so far, never cleared
  std::atomic<int> openings{0};      // so far, never cleared
  std::atomic<bool> motors_on{false};

  // Calls that break the vendor's rules; the first one's name.
  std::atomic<int> violations{0};
  std::atomic<const char*> first_violation{""};

  // Run on the vendor's thread around everything of ours that it calls; may be null.
  std::atomic<void (*)()> before_callback{nullptr}, after_callback{nullptr};

  // Times of the steady clock, ns; 0: not yet. While `watched`, from the tick `from_tick` on: the first of these
  // ticks, the first without force, and the longest time between two of them until then.
  std::atomic<bool> watched{false};
  std::atomic<std::int64_t> watched_at{0}, zero_at{0}, longest_gap{0};

  bool troubled_by(Trouble which) const noexcept {
    return trouble.load() == which && ticks.load() >= from_tick.load() && ticks.load() < until_tick.load();
  }
  // Resets to the state before a library's first use. Only while nobody uses it.
  void clear() noexcept;

  // For the mocks.
  void opened() noexcept {
    ++open_devices;
    ++openings;
  }
  void violation(const char* rule) noexcept;
  void wait_while(Trouble which) const noexcept;
};

inline void Board::clear() noexcept {
  trouble = Trouble::none;
  from_tick = 0;
  until_tick = std::numeric_limits<std::int64_t>::max();
  only_first = false;
  for (auto* triple : {&hand, &force, &torque, &position}) {
    for (auto& component : *triple) component = 0.0;
  }
  for (std::size_t i = 0; i < turn.size(); ++i) turn[i] = i % 4 == 0 ? 1.0 : 0.0;
  firm = true;
  habit = Hand::still;
  calibration_styles = 0;
  calibration_shift = 0.0;
  in_inkwell = false;
  buttons = 0;
  type = 0;
  ticks = pushes = pushes_in_trouble = 0;
  motors_on = false;
  violations = 0;
  first_violation = "";
  before_callback = after_callback = nullptr;
  watched = false;
  watched_at = zero_at = longest_gap = 0;
}

// The library's only board, with the environment's fault.
Board& board() noexcept;

}  // namespace mock
