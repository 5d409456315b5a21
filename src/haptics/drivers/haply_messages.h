#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/geometry.h"

namespace bodkin::haptics {

// The JSON that passes in every tick between Haply's Inverse service and us: state messages in, commands out. Nothing
// here allocates once an object is made. Lengths m, forces N, the service's axes.

// What one state message says of the chosen device and grip. Every part of a message may be absent.
struct HaplyReading {
  bool lists_devices = false;  // the message has a list of devices
  bool device_listed = false;  // and ours is in it
  bool has_position = false, has_velocity = false;
  Vec3 position = Vec3::Zero(), velocity = Vec3::Zero();  // m, m/s
  bool calibrated = true, powered = true;                 // unless the message says that it is not
  bool idle = false;                                      // the service says that nothing drives the device
  bool moved = false;         // the service says that a transform changes the device's axes
  bool has_config = false;    // the message holds the device's configuration
  bool config_moved = false;  // which has a basis, a preset or a mount that changes its axes

  bool grip_listed = false;
  bool grip_awake = true;  // connected and not asleep
  bool has_rotation = false, has_buttons = false;
  std::array<double, 4> rotation{1, 0, 0, 0};  // w, x, y, z, as sent
  std::uint32_t buttons = 0;                   // bit 0: a, or button_0
};

// Longest state message, bytes.
constexpr std::size_t longest_haply_message = 65536;

// Reads state messages of one device and one grip; "" stands for no grip.
class HaplyStateReader {
 public:
  HaplyStateReader(const std::string& device, const std::string& grip);
  ~HaplyStateReader();
  HaplyStateReader(const HaplyStateReader&) = delete;
  HaplyStateReader& operator=(const HaplyStateReader&) = delete;

  // Where the next message is to be put: longest_haply_message bytes.
  std::span<char> buffer() noexcept;
  // Reads the first `size` bytes of the buffer. False for what is not a state message: not JSON, not a number or one
  // too large, a vector without one of its components.
  bool read(std::size_t size, HaplyReading& reading) noexcept;

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

// How the service wants the vector of a force to be called: `vector` from 3.5 on, `values` before.
enum class HaplyForceKey { vector, values };

// Writes messages about one device.
class HaplyCommandWriter {
 public:
  // `device`: letters, digits and . : _ - only.
  HaplyCommandWriter(const std::string& device, HaplyForceKey key);

  // The text is good until the next call. A force that is not finite is written as zero.
  std::string_view force(const Vec3& force) noexcept { return write(force_, force); }  // N
  // Must come first in a session: our name, and no force.
  std::string_view introduction() noexcept { return write(introduction_, Vec3::Zero()); }
  // Asks for a state and commands nothing, so that the device goes idle.
  std::string_view probe() const noexcept { return probe_; }
  // N. The same as force(), and asks for a state that holds the devices' configuration, too.
  std::string_view inspection(const Vec3& force) noexcept { return write(inspection_, force); }

 private:
  std::string_view write(const std::string& beginning, const Vec3& force) noexcept;

  std::string force_, introduction_, inspection_, probe_;
  std::string text_;  // with room for the longest command
};

}  // namespace bodkin::haptics
