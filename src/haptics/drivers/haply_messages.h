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

// The JSON messages exchanged in every tick with Haply's Inverse service: states in, commands out. Nothing here
// allocates after construction. Lengths m, forces N, the service's axes.

// Content of one state message about the chosen device and grip. Every part of a message may be absent.
struct HaplyReading {
  bool lists_devices = false;  // the message has a list of devices
  bool device_listed = false;  // and ours is in it
  bool has_position = false, has_velocity = false;
  Vec3 position = Vec3::Zero(), velocity = Vec3::Zero();  // m, m/s
  bool calibrated = true, powered = true;                 // unless the message says otherwise
  bool idle = false;                                      // the service reports that nothing drives the device
  bool moved = false;         // the service reports that a transform changes the device's axes
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

// Reads state messages of one device and one grip; "" means no grip.
class HaplyStateReader {
 public:
  HaplyStateReader(const std::string& device, const std::string& grip);
  ~HaplyStateReader();
  HaplyStateReader(const HaplyStateReader&) = delete;
  HaplyStateReader& operator=(const HaplyStateReader&) = delete;

  // Memory for the next message: longest_haply_message bytes.
  std::span<char> buffer() noexcept;
  // Reads the first `size` bytes of the buffer. False if they are not a state message: not JSON, an invalid or too
  // large number, a vector without one of its components.
  bool read(std::size_t size, HaplyReading& reading) noexcept;

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

// The service's name for the vector of a force: `vector` from 3.5 on, `values` before.
enum class HaplyForceKey { vector, values };

// Writes messages about one device.
class HaplyCommandWriter {
 public:
  // `device`: letters, digits and . : _ - only.
  HaplyCommandWriter(const std::string& device, HaplyForceKey key);

  // The text is valid until the next call. A force that is not finite is written as zero.
  std::string_view force(const Vec3& force) noexcept { return write(force_, force); }  // N
  // Must be the first message of a session: our name, and no force.
  std::string_view introduction() noexcept { return write(introduction_, Vec3::Zero()); }
  // Requests a state without a command, so that the device goes idle.
  std::string_view probe() const noexcept { return probe_; }
  // N. As force(), and requests a state that includes the devices' configuration.
  std::string_view inspection(const Vec3& force) noexcept { return write(inspection_, force); }

 private:
  std::string_view write(const std::string& beginning, const Vec3& force) noexcept;

  std::string force_, introduction_, inspection_, probe_;
  std::string text_;  // with room for the longest command
};

}  // namespace bodkin::haptics
