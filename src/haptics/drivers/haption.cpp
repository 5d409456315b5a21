#include "haptics/drivers/haption.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <string>

#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/driver_settings.h"
#include "haptics/drivers/haption_library.h"
#include "haptics/drivers/vendor_frame.h"
#include "haptics/tick_clock.h"

namespace bodkin::haptics {

namespace {

using namespace haption;

constexpr float period = 0.001F;  // s
constexpr int oldest_api = 4;
constexpr int handle_buttons = 2;
constexpr double longest_without_power = 0.5;             // s after the hand has grasped the handle
constexpr const char* usual_address = "127.0.0.1#53210";  // the vendor's daemon on this machine

// For all types, the values of a Virtuose 6D Desktop, the smallest of the family: no source has numbers of each.
constexpr double peak_force = 10.0, continuous_force = 3.0;  // N
constexpr double peak_torque = 800.0;                        // N mm, where the handle's rotation has motors
constexpr double stiffness = 2.0, damping = 0.01;            // N/mm, N s/mm
constexpr double radius = 60.0;                              // mm

// As virtGetDeviceID numbers them.
struct Type {
  int number;
  const char* name;
  bool torques;  // false: three motors, none of which turns the handle
};
constexpr Type types[] = {{1, "Virtuose 3D", false}, {2, "Virtuose 3D Desktop", false},
                          {3, "Virtuose 6D", true},  {4, "Virtuose 6D Desktop", true},
                          {5, "Virtuose 7D", true},  {6, "MAT 6D", true},
                          {7, "MAT 7D", true},       {8, "Inca 6D", true},
                          {9, "Inca 3D", false},     {11, "Scale1", true}};

const Type* find_type(int number) noexcept {
  const auto* found =
      std::find_if(std::begin(types), std::end(types), [=](auto& one) { return one.number == number; });
  return found == std::end(types) ? nullptr : found;
}

int result_of_haption(int error) noexcept {
  switch (error) {
    case error_communication:
    case error_timeout:
      return BODKIN_COMMUNICATION_LOST;
    case error_discontinuity:
      return BODKIN_BAD_DATA;
    case error_version:
    case error_incompatible:
      return BODKIN_WRONG_VERSION;
    case error_already_called:
      return BODKIN_BUSY;
    default:
      return BODKIN_VENDOR_ERROR;
  }
}

using HaptionHandle = std::shared_ptr<const HaptionLibrary>;

std::string words(const HaptionLibrary& api, int error) {
  const char* text = api.virtGetErrorMessage(error);
  return "error " + std::to_string(error) + (text == nullptr ? "" : ", '" + std::string(text) + "'");
}

// Version of the library; the device's controller has its own.
std::string version_of(const HaptionLibrary& api) {
  int major = 0, minor = 0;
  api.virtAPIVersion(&major, &minor);
  return std::to_string(major) + "." + std::to_string(minor);
}

DriverSettings haption_settings(const char* settings) {
  return {settings, {"library", "address", "relays_s"}};
}

HaptionHandle load_haption(const DriverSettings& settings) {
  auto api = std::make_shared<const HaptionLibrary>(settings.text("library", ""));
  int major = 0, minor = 0;
  api->virtAPIVersion(&major, &minor);
  if (major < oldest_api) {
    throw DriverFailure(BODKIN_WRONG_VERSION, api->library.path() + " is version " + version_of(*api) +
                                                  ", expected 4 or newer: install a newer VirtuoseAPI");
  }
  return api;
}

// A connection, closed by the destructor.
class Connection {
 public:
  Connection(HaptionHandle api, const std::string& address)
      : api_(std::move(api)), context_(api_->virtOpen(address.c_str())) {
    if (context_ != nullptr) return;
    const int error = api_->virtGetErrorCode(nullptr);
    if (error == error_version || error == error_incompatible) {
      throw DriverFailure(BODKIN_WRONG_VERSION,
                          "the controller at " + address + " and " + api_->library.path() + ", version " +
                              version_of(*api_) + ", do not speak one version (" + words(*api_, error) +
                              "): install the VirtuoseAPI that came with the device, and say library=PATH");
    }
    int result = result_of_haption(error);
    if (result == BODKIN_COMMUNICATION_LOST) result = BODKIN_NOT_CONNECTED;
    const char* advice = result == BODKIN_BUSY ? "close the other program that uses it"
                                               : "switch it on, start the vendor's daemon, or say address=HOST#PORT";
    throw DriverFailure(result, "no Virtuose answers at " + address + " (" + words(*api_, error) + "): " + advice);
  }
  ~Connection() { api_->virtClose(context_); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  const HaptionLibrary& api() const noexcept { return *api_; }
  HaptionLibrary::Context context() const noexcept { return context_; }

  // Throws unless a call for this connection succeeded.
  void must(int result, const char* what) const {
    if (result == 0) return;
    const int error = api_->virtGetErrorCode(context_);
    throw DriverFailure(result_of_haption(error), std::string("the device refuses ") + what + " (" +
                                                      words(*api_, error) +
                                                      "): see whether the vendor's own test program works");
  }

  std::string name() const {
    const Type* type = find_type(type_number());
    return type == nullptr ? "Virtuose of type " + std::to_string(type_number()) : type->name;
  }
  // Whether its motors turn the handle: false if the type is unknown.
  bool renders_torques() const {
    const Type* type = find_type(type_number());
    return type != nullptr && type->torques;
  }
  // Of the library, and of the controller if it reports one.
  std::string versions() const {
    int major = 0, minor = 0;
    const bool known =
        api_->virtGetControlerVersion != nullptr && api_->virtGetControlerVersion(context_, &major, &minor) == 0;
    return "VirtuoseAPI " + version_of(*api_) +
           (known ? ", controller " + std::to_string(major) + "." + std::to_string(minor) : "");
  }
  std::string serial() const {
    int type = 0, serial = 0;
    must(api_->virtGetDeviceID(context_, &type, &serial), "to report its serial number");
    return std::to_string(serial);
  }

 private:
  int type_number() const {
    int type = 0, serial = 0;
    must(api_->virtGetDeviceID(context_, &type, &serial), "to report its type");
    return type;
  }

  HaptionHandle api_;
  HaptionLibrary::Context context_;
};

class HaptionDevice : public OpenDevice {
 public:
  HaptionDevice(std::unique_ptr<Connection> connection, double relays)
      : connection_(std::move(connection)),
        api_(connection_->api()),
        device_(connection_->context()),
        relays_(relays) {
    std::array<float, 7> origin = {0, 0, 0, 0, 0, 0, 1};
    const Connection& c = *connection_;
    c.must(api_.virtSetIndexingMode(device_, indexing_none), "the indexing mode");
    c.must(api_.virtSetForceFactor(device_, 1.0F), "the force factor");
    c.must(api_.virtSetSpeedFactor(device_, 1.0F), "the speed factor");
    c.must(api_.virtSetTimeStep(device_, period), "the time step");
    c.must(api_.virtSetBaseFrame(device_, origin.data()), "the base frame");
    c.must(api_.virtSetObservationFrame(device_, origin.data()), "the observation frame");
    // After time step and force factor: the vendor requires this order.
    c.must(api_.virtSetCommandType(device_, command_impedance), "the command type");
    c.must(api_.virtSaturateTorque(device_, static_cast<float>(peak_force), static_cast<float>(peak_torque / 1000.0)),
           "the limits of force");
  }

  ~HaptionDevice() override { halt(); }

  // Power is requested before the loop, as in the vendor's samples. The device gives it while the hand is on the
  // handle and the user's switch is on.
  void start(bodkin_tick tick, void* user) override {
    ticking_.store(false);
    tick_ = tick;
    user_ = user;
    error_.store(0);
    ticks_ = 0;
    has_power_ = false;
    power_changed_ = monotonic_seconds();
    trouble_.store(nullptr);
    state_ = blank_state();
    try {
      const Connection& c = *connection_;
      if (api_.virtEnableForceFeedback != nullptr) {
        c.must(api_.virtEnableForceFeedback(device_, 1), "to enable the feedback of force");
      }
      powered_ = true;  // also if refused: switching off twice does no harm
      c.must(api_.virtSetPowerOn(device_, 1), "to switch the motors on");
      c.must(api_.virtSetPeriodicFunction(device_, &HaptionDevice::run, &period_, this), "a periodic function");
      c.must(api_.virtStartLoop(device_), "to start its loop");
      looping_ = true;
    } catch (...) {
      halt();
      throw;
    }
    ticking_.store(true);
  }

  void stop() override {
    const int failed = halt();
    if (failed != 0) {
      throw DriverFailure(BODKIN_COMMUNICATION_LOST, "the device did not stop (" + words(api_, failed) +
                                                         "): press its emergency stop before you touch it");
    }
  }

  std::string explain() override {
    if (const int error = error_.load(); error != 0) return "VirtuoseAPI says " + words(api_, error);
    const char* trouble = trouble_.load();
    return trouble == nullptr ? "" : trouble;
  }

 private:
  // The vendor's code of the first failed call; 0: none failed.
  int halt() noexcept {
    if (!powered_) return 0;
    ticking_.store(false);
    int failed = !looping_ || api_.virtStopLoop(device_) == 0 ? 0 : api_.virtGetErrorCode(device_);
    float nothing[6] = {};
    api_.virtSetForce(device_, nothing);
    if (api_.virtSetPowerOn(device_, 0) != 0 && failed == 0) failed = api_.virtGetErrorCode(device_);
    looping_ = powered_ = false;
    return failed;
  }

  static void run(HaptionLibrary::Context, void* self) noexcept { static_cast<HaptionDevice*>(self)->round(); }

  void round() noexcept {
    float force[6] = {};
    if (!ticking_.load()) {
      api_.virtSetForce(device_, force);
      return;
    }
    const double time = monotonic_seconds();
    const double dt = ticks_ == 0 ? static_cast<double>(period) : time - last_time_;
    last_time_ = time;
    ++ticks_;
    state_.fault = static_cast<std::uint32_t>(read_state(time));
    bodkin_command command{};
    tick_(user_, &state_, dt, &command);
    if (state_.fault == BODKIN_OK && state_.held != 0) {
      const Vec3 f = frame_.force_of(command), t = frame_.torque_of(command);
      for (int i = 0; i < 3; ++i) {
        force[i] = static_cast<float>(f[i]);
        force[i + 3] = static_cast<float>(t[i]);
      }
    }
    if (api_.virtSetForce(device_, force) != 0) keep_error();
  }

  int keep_error() noexcept {
    const int error = api_.virtGetErrorCode(device_);
    error_.store(error);
    return result_of_haption(error);
  }

  int report(int result, const char* trouble) noexcept {
    trouble_.store(trouble);
    return result;
  }

  // The hand on the handle switches the motors' power; until their relays have closed, the device counts as not held,
  // so that no force builds up and jumps out.
  int result_of_power(bool held, bool power, double time) noexcept {
    if (power != has_power_ || held != was_held_) power_changed_ = time;
    has_power_ = power;
    was_held_ = held;
    const double lasts = time - power_changed_;
    state_.held = held && power && lasts >= relays_ ? 1 : 0;
    if (!held || power || lasts < longest_without_power) return BODKIN_OK;
    return report(BODKIN_EMERGENCY_STOP,
                  "the motors have no power although the handle is held: press the button of the motors' power");
  }

  int read_state(double time) noexcept {
    std::array<float, 7> pose{};
    std::array<float, 6> speed{};
    int held = 0, chain = 0, power = 0;
    unsigned alarm = 0;
    state_.buttons = 0;
    const bool answered = api_.virtGetPosition(device_, pose.data()) == 0 &&
                          api_.virtGetSpeed(device_, speed.data()) == 0 && api_.virtGetDeadMan(device_, &held) == 0 &&
                          api_.virtGetEmergencyStop(device_, &chain) == 0 &&
                          api_.virtGetPowerOn(device_, &power) == 0 && api_.virtGetAlarm(device_, &alarm) == 0;
    if (!answered) return keep_error();
    for (int button = 1; button <= handle_buttons; ++button) {
      int pressed = 0;
      if (api_.virtGetButton(device_, button, &pressed) == 0 && pressed != 0) state_.buttons |= 1U << (button - 1);
    }
    state_.temperature = (alarm & alarm_overheated) != 0 ? 1.0 : 0.0;
    frame_.put_position(Vec3(pose[0], pose[1], pose[2]), state_);
    frame_.put_velocity(Vec3(speed[0], speed[1], speed[2]), state_);
    const Eigen::Quaterniond turn(pose[6], pose[3], pose[4], pose[5]);
    frame_.put_rotation(turn.normalized().toRotationMatrix(), state_);
    if (chain == 0) return report(BODKIN_EMERGENCY_STOP, "the emergency stop is open: close it and start again");
    if ((alarm & alarm_overheated) != 0) return report(BODKIN_OVERHEATED, "the motors are hot: let the device cool");
    if ((alarm & alarm_position) != 0) return report(BODKIN_BAD_DATA, "the device reports an error of its position");
    return result_of_power(held != 0, power != 0, time);
  }

  std::unique_ptr<Connection> connection_;
  const HaptionLibrary& api_;
  HaptionLibrary::Context device_;
  double relays_;  // s
  bool has_power_ = false, was_held_ = false;
  double power_changed_ = 0.0;  // s: when one of these changed
  float period_ = period;       // the vendor keeps its address
  VendorFrame frame_ = metres(x_near_frame());

  // Of the vendor's loop.
  bool looping_ = false, powered_ = false;
  std::atomic<bool> ticking_{false};
  bodkin_tick tick_ = nullptr;
  void* user_ = nullptr;
  bodkin_state state_{};
  long ticks_ = 0;
  double last_time_ = 0.0;  // s
  std::atomic<int> error_{0};
  std::atomic<const char*> trouble_{nullptr};
};

struct Haption {
  static constexpr const char* name = "haption";
  static constexpr const char* summary = "Virtuose devices (Haption VirtuoseAPI)";

  // The vendor provides no list: only the one address is asked.
  static void list(const char* text, const DeviceSink& found) {
    const DriverSettings settings = haption_settings(text);
    const std::string address = settings.text("address", usual_address);
    const Connection connection(load_haption(settings), address);
    found(address, connection.name() + " at " + address + ", serial number " + connection.serial() + ", " +
                       connection.versions());
  }

  static std::unique_ptr<OpenDevice> open(const std::string& identity, const char* text,
                                          bodkin_abilities& abilities) {
    const DriverSettings settings = haption_settings(text);
    const double relays = settings.number("relays_s", 3.0, 0.0, 10.0);
    const std::string address = identity.empty() ? settings.text("address", usual_address) : identity;
    auto connection = std::make_unique<Connection>(load_haption(settings), address);
    copy_text(connection->name(), abilities.name, BODKIN_TEXT);
    copy_text(connection->serial(), abilities.serial, BODKIN_TEXT);
    abilities.peak_force = peak_force;
    abilities.continuous_force = continuous_force;
    abilities.peak_torque = connection->renders_torques() ? peak_torque : 0.0;
    abilities.stiffness = stiffness;
    abilities.damping = damping;
    abilities.rate = 1.0 / static_cast<double>(period);
    std::fill_n(abilities.workspace_low, 3, -radius);
    std::fill_n(abilities.workspace_high, 3, radius);
    abilities.measures_rotation = abilities.has_dead_man = abilities.owns_loop = 1;
    abilities.delay = static_cast<double>(period);
    copy_text("the vendor states none; virtSetForce is taken up by the controller's next cycle of 1 ms",
              abilities.delay_source, BODKIN_TEXT);
    return std::make_unique<HaptionDevice>(std::move(connection), relays);
  }
};

}  // namespace

const bodkin_driver& haption_driver() noexcept {
  static constexpr bodkin_driver driver = driver_of<Haption>();
  return driver;
}

}  // namespace bodkin::haptics
