#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "haptics/bodkin_driver.h"

namespace bodkin::haptics {

// Thrown by built-in drivers: a result of bodkin_driver.h and one sentence.
class DriverFailure : public std::runtime_error {
 public:
  DriverFailure(int result, const std::string& message) : std::runtime_error(message), result_(result) {}
  int result() const noexcept { return result_; }

 private:
  int result_;
};

// An open device of a built-in driver. Destroying it closes the device.
class OpenDevice {
 public:
  OpenDevice() = default;
  virtual ~OpenDevice() = default;
  OpenDevice(const OpenDevice&) = delete;
  OpenDevice& operator=(const OpenDevice&) = delete;

  // As the functions of bodkin_driver. After a start() that throws, the device renders no force.
  virtual void start(bodkin_tick tick, void* user) = 0;
  virtual int exchange(const bodkin_command&, bodkin_state&) noexcept { return BODKIN_NOT_CONNECTED; }
  virtual void stop() = 0;
  virtual std::string explain() = 0;
};

// Receives each device: identity and title.
using DeviceSink = std::function<void(const std::string&, const std::string&)>;

// Copies as much of `text` as fits, with the final zero.
void copy_text(const std::string& text, char* to, std::size_t size) noexcept;

// Runs `call`; an exception becomes a result and a message (BODKIN_MESSAGE bytes, or null).
int guarded(char* message, const std::function<void()>& call) noexcept;

// Turns a class into a driver. Family has
//   static constexpr const char *name, *summary;
//   static void list(const char* settings, const DeviceSink& found);
//   static std::unique_ptr<OpenDevice> open(const std::string& identity, const char* settings, bodkin_abilities&);
template <typename Family>
constexpr bodkin_driver driver_of() {
  bodkin_driver driver{};
  driver.abi = BODKIN_DRIVER_ABI;
  driver.name = Family::name;
  driver.summary = Family::summary;
  driver.list = [](const char* settings, bodkin_found found, void* user, char* message) {
    return guarded(message, [&] {
      Family::list(settings, [&](const std::string& identity, const std::string& title) {
        found(user, identity.c_str(), title.c_str());
      });
    });
  };
  driver.open = [](const char* identity, const char* settings, void** handle, bodkin_abilities* abilities,
                   char* message) {
    *handle = nullptr;
    return guarded(message, [&] {
      *abilities = bodkin_abilities{};
      *handle = Family::open(identity, settings, *abilities).release();
    });
  };
  driver.start = [](void* handle, bodkin_tick tick, void* user, char* message) {
    return guarded(message, [&] { static_cast<OpenDevice*>(handle)->start(tick, user); });
  };
  driver.exchange = [](void* handle, const bodkin_command* command, bodkin_state* state) {
    return static_cast<OpenDevice*>(handle)->exchange(*command, *state);
  };
  driver.stop = [](void* handle) { return guarded(nullptr, [&] { static_cast<OpenDevice*>(handle)->stop(); }); };
  driver.close = [](void* handle) { const std::unique_ptr<OpenDevice> last(static_cast<OpenDevice*>(handle)); };
  driver.explain = [](void* handle, char* message) {
    guarded(message, [&] { copy_text(static_cast<OpenDevice*>(handle)->explain(), message, BODKIN_MESSAGE); });
  };
  return driver;
}

}  // namespace bodkin::haptics
