#include "haptics/drivers/haply.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/driver_settings.h"
#include "haptics/drivers/haply_cause.h"
#include "haptics/drivers/haply_events.h"
#include "haptics/drivers/haply_messages.h"
#include "haptics/drivers/haply_service.h"
#include "haptics/drivers/vendor_frame.h"

namespace bodkin::haptics {

namespace {

using Clock = HaplyConnection::Clock;
using Cause = HaplyCause;
using namespace std::chrono_literals;

constexpr auto round_patience = 5ms;     // a round without an answer by then repeats the last state
constexpr auto inspected_every = 500ms;  // of the configuration, which another program may change
constexpr auto refused_after = 100ms;    // of forces that the service lets go idle
constexpr auto start_patience = 2000ms;  // for the answer to the first message
constexpr auto stop_patience = 500ms;    // for each of the answers at the end
constexpr double reach = 86.0;           // mm: half the cube inside the sphere of 150 mm
constexpr double shortest_rotation = 0.9, longest_rotation = 1.1;  // norm of a quaternion that is one

DriverSettings haply_settings(const char* settings) {
  return {settings,
          {"host", "port", "websocket_port", "events_port", "force_key", "grip", "tool_axis", "dead_man",
           "peak_force", "silence_ms"}};
}

HaplyForceKey force_key_of(const DriverSettings& settings, const HaplyVersion& version, bool older_format) {
  const std::string key = settings.text("force_key", "auto");
  if (key == "vector") return HaplyForceKey::vector;
  if (key == "values") return HaplyForceKey::values;
  if (key != "auto") {
    throw DriverFailure(BODKIN_BAD_SETTINGS,
                        "the setting force_key is '" + key + "', expected auto, vector or values");
  }
  const bool newer = version.major > 3 || (version.major == 3 && version.minor >= 5);
  return newer && !older_format ? HaplyForceKey::vector : HaplyForceKey::values;
}

// The bit of the button that must be held; 0 for none.
std::uint32_t dead_man_of(const DriverSettings& settings) {
  const std::string name = settings.text("dead_man", "none");
  if (name == "none") return 0;
  if (name.size() == 1 && name[0] >= 'a' && name[0] <= 'c') return 1U << (name[0] - 'a');
  throw DriverFailure(BODKIN_BAD_SETTINGS, "the setting dead_man is '" + name + "', expected none, a, b or c");
}

// X right, Y away, Z up, as the operator's; `axis`: the grip's axis that points out of the tool's tip.
VendorFrame frame_of(const DriverSettings& settings) {
  const std::string name = settings.text("tool_axis", "y");
  const bool negative = name.starts_with('-');
  const std::string letter = name.substr(negative ? 1 : 0);
  if (letter != "x" && letter != "y" && letter != "z") {
    throw DriverFailure(BODKIN_BAD_SETTINGS,
                        "the setting tool_axis is '" + name + "', expected x, y or z, or one of them after a '-'");
  }
  const Eigen::Index axis = letter[0] - 'x';
  const Vec3 tip = (negative ? -1.0 : 1.0) * Vec3::Unit(axis), side = Vec3::Unit((axis + 1) % 3);
  Mat3 tool;
  tool << side, tip.cross(side), tip;
  VendorFrame frame = metres({.to_operator = Mat3::Identity(), .tool = tool});
  frame.centre = Vec3(0.0, -0.15, 0.20);
  return frame;
}

struct Choice {
  HaplyInverse device;
  std::string grip;  // "" = none
};

Choice choose(const HaplyInventory& inventory, const std::string& identity, const DriverSettings& settings) {
  const auto& devices = inventory.devices;
  if (devices.empty()) {
    throw DriverFailure(BODKIN_NOT_CONNECTED,
                        "Haply's Inverse service finds no Inverse3: connect its USB cable and "
                        "its power supply, and see whether Haply Hub shows it");
  }
  const auto device = std::find_if(devices.begin(), devices.end(), [&](const HaplyInverse& one) {
    return identity.empty() || one.identity == identity;
  });
  if (device == devices.end()) {
    throw DriverFailure(BODKIN_NOT_CONNECTED, "no Inverse3 has the identity " + identity +
                                                  ": see `bodkin devices list` for those that are connected");
  }
  const auto& grips = inventory.grips;
  std::string grip = settings.text("grip", "auto");
  if (grip == "auto") grip = grips.empty() ? "" : grips.front();
  if (grip == "none") grip.clear();
  if (!grip.empty() && std::find(grips.begin(), grips.end(), grip) == grips.end()) {
    throw DriverFailure(BODKIN_NOT_CONNECTED,
                        "no VerseGrip has the identity " + grip + ": switch it on, or say grip=none");
  }
  return {*device, grip};
}

void must_be_fit(const HaplyInverse& device) {
  if (!device.calibrated) throw DriverFailure(BODKIN_NOT_CALIBRATED, words_of(Cause::uncalibrated));
  if (device.moved.empty()) return;
  throw DriverFailure(BODKIN_VENDOR_ERROR, "Haply's Inverse service gives the device " + device.moved +
                                               ", and forces would point the wrong way: take it back in Haply Hub");
}

struct InverseSettings {
  HaplyForceKey key;
  std::uint32_t dead_man;  // bit
  VendorFrame frame;
  Clock::duration silence;  // without an answer or a position: the device is lost
};

class InverseDevice : public OpenDevice {
 public:
  InverseDevice(HaplyService service, HaplySession session, const Choice& choice,
                const InverseSettings& inverse_settings)
      : service_(std::move(service)),
        connection_(std::move(session.connection)),
        identity_(choice.device.identity),
        inspects_(!session.older_format && (service_.version.major > 3 || service_.version.minor > 0)),
        has_grip_(!choice.grip.empty()),
        dead_man_(inverse_settings.dead_man),
        frame_(inverse_settings.frame),
        silence_(inverse_settings.silence),
        writer_(identity_, inverse_settings.key),
        reader_(identity_, choice.grip) {
    listen();
  }

  void start(bodkin_tick, void*) override {
    // The service may have been restarted since the session began.
    std::size_t size = 0;
    if (connection_ == nullptr || !begin(size)) {
      join_again();
      if (!begin(size)) {
        connection_.reset();
        throw DriverFailure(BODKIN_COMMUNICATION_LOST, words_of(Cause::silent));
      }
    }
    if (events_ != nullptr && !events_->listens()) listen();
    if (inspects_ && !ask(writer_.inspection(Vec3::Zero()), size, start_patience)) {
      connection_.reset();
      throw DriverFailure(BODKIN_COMMUNICATION_LOST, words_of(Cause::silent));
    }
    HaplyReading reading;
    const bool whole = reader_.read(size, reading);
    if (whole && inspects_) must_be_as_it_was(std::string_view(reader_.buffer().data(), size));
    state_ = blank_state();
    state_.held = dead_man_ == 0 ? 1 : 0;
    cause_ = Cause::none;
    owed_ = false;
    last_position_ = Clock::now();
    pushed_in_vain_ = {};
    config_moved_ = false;
    inspected_ = last_position_;
    const Cause cause = whole ? take(reading, last_position_, false) : Cause::damaged;
    if (cause != Cause::none) throw DriverFailure(result_of(cause), words_of(cause));
    started_ = true;
  }

  int exchange(const bodkin_command& command, bodkin_state& state) noexcept override {
    const Cause cause = round(command);
    cause_.store(cause);
    state = state_;
    return result_of(cause);
  }

  void stop() override {
    if (!std::exchange(started_, false)) return;
    // Silence has ended the session, and with it the force.
    if (cause_.load() == Cause::silent) return connection_.reset();
    std::size_t size = 0;
    const bool settled = !owed_ || receive(size, stop_patience);
    owed_ = false;
    if (settled && ask(writer_.force(Vec3::Zero()), size, stop_patience) &&
        ask(writer_.probe(), size, stop_patience)) {
      return;
    }
    connection_->abandon();
    connection_.reset();
    throw DriverFailure(BODKIN_COMMUNICATION_LOST,
                        "Haply's Inverse service does not answer the stop; its session has been ended: restart "
                        "haply-inverse-service");
  }

  std::string explain() override {
    const Cause cause = cause_.load();
    const std::string last_event = cause == Cause::none || events_ == nullptr ? "" : events_->last();
    return words_of(cause) + (last_event.empty() ? "" : " (its last event: '" + last_event + "')");
  }

 private:
  void listen() {
    events_.reset();
    if (service_.events == 0) return;
    events_ = std::make_unique<HaplyEventListener>(HaplyAddress{service_.address.host, service_.events}, identity_);
  }

  // Haply Hub restores the last basis and mount of a program that it knows by name, so the inventory from before the
  // introduction may be outdated.
  void must_be_as_it_was(std::string_view state) const {
    for (const HaplyInverse& device : parse_haply_inventory(state).devices) {
      if (device.identity == identity_) must_be_fit(device);
    }
  }

  void join_again() {
    introduced_ = false;
    connection_.reset();
    HaplySession session = open_haply_session(service_);
    const auto& devices = session.inventory.devices;
    const auto device = std::find_if(devices.begin(), devices.end(),
                                     [&](const HaplyInverse& one) { return one.identity == identity_; });
    if (device == devices.end()) throw DriverFailure(BODKIN_NOT_CONNECTED, words_of(Cause::unplugged));
    must_be_fit(*device);
    connection_ = std::move(session.connection);
  }

  // Sends the first message of a start; false when no answer arrives.
  bool begin(std::size_t& size) {
    const std::string_view message = introduced_ ? writer_.force(Vec3::Zero()) : writer_.introduction();
    introduced_ = true;
    return ask(message, size, start_patience);
  }

  bool ask(std::string_view message, std::size_t& size, Clock::duration patience) noexcept {
    return connection_->send(message, Clock::now() + patience) && receive(size, patience);
  }

  bool receive(std::size_t& size, Clock::duration patience) noexcept {
    return connection_->receive(reader_.buffer(), size, Clock::now() + patience);
  }

  // Sends a message and receives its answer. At most one is in flight, so that no force waits in a queue.
  Cause round(const bodkin_command& command) noexcept {
    const Cause before = cause_.load();
    if (before == Cause::silent || before == Cause::refused) return before;
    const Clock::time_point now = Clock::now();
    if (!owed_) {
      const Vec3 force = frame_.force_of(command);
      pushes_ = !force.isZero();
      sent_ = now;
      const bool inspect = inspects_ && now - inspected_ > inspected_every;
      if (inspect) inspected_ = now;
      if (!connection_->send(inspect ? writer_.inspection(force) : writer_.force(force), now + round_patience))
        return lose();
      owed_ = true;
    }
    if (!connection_->arrives(now + round_patience)) return Clock::now() - sent_ > silence_ ? lose() : before;
    std::size_t size = 0;
    if (!connection_->receive(reader_.buffer(), size, std::max(now + round_patience, sent_ + silence_)))
      return lose();
    owed_ = false;
    HaplyReading reading;
    return reader_.read(size, reading) ? take(reading, now, pushes_) : Cause::damaged;
  }

  Cause lose() noexcept {
    connection_->abandon();
    return Cause::silent;
  }

  // Updates the state by a message. `pushed`: a force other than zero was sent.
  Cause take(const HaplyReading& reading, Clock::time_point now, bool pushed) noexcept {
    if (has_grip_) update_grip(reading);
    if (reading.lists_devices && !reading.device_listed) return Cause::unplugged;
    if (reading.has_position) {
      frame_.put_position(reading.position, state_);
      last_position_ = now;
    }
    for (double& component : state_.velocity) component = std::numeric_limits<double>::quiet_NaN();
    if (reading.has_velocity) frame_.put_velocity(reading.velocity, state_);
    if (events_ != nullptr && events_->is_disconnected()) return Cause::unplugged;
    if (now - last_position_ > silence_) return Cause::without_position;
    if (reading.has_config) config_moved_ = reading.config_moved;
    if (reading.moved || config_moved_) return Cause::moved;
    if (!reading.calibrated) return Cause::uncalibrated;
    if (!reading.powered) return Cause::unpowered;
    if (events_ != nullptr && events_->is_braked()) return Cause::braked;
    if (!put_rotation(reading)) return Cause::damaged;
    if (!reading.idle || !pushed) {
      pushed_in_vain_ = {};
    } else if (pushed_in_vain_ == Clock::time_point{}) {
      pushed_in_vain_ = now;
    } else if (now - pushed_in_vain_ > refused_after) {
      return Cause::refused;
    }
    return Cause::none;
  }

  // A grip that is absent, asleep or silent about its buttons does not hold the dead-man's switch.
  void update_grip(const HaplyReading& reading) noexcept {
    const bool awake = reading.grip_listed && reading.grip_awake;
    if (awake && reading.has_buttons) grip_buttons_ = reading.buttons;
    if (!awake) grip_buttons_ = 0;
    state_.buttons = grip_buttons_ & ~dead_man_;
    state_.held = dead_man_ == 0 || (grip_buttons_ & dead_man_) != 0 ? 1 : 0;
  }

  bool put_rotation(const HaplyReading& reading) noexcept {
    if (!reading.has_rotation) return true;
    const auto& [w, x, y, z] = reading.rotation;
    const Eigen::Quaterniond rotation(w, x, y, z);
    const double norm = rotation.norm();
    if (!(norm > shortest_rotation && norm < longest_rotation)) return false;
    frame_.put_rotation(rotation.normalized().toRotationMatrix(), state_);
    return true;
  }

  HaplyService service_;
  std::unique_ptr<HaplyConnection> connection_;
  std::unique_ptr<HaplyEventListener> events_;  // null: the service is not asked for any
  std::string identity_;
  bool inspects_;  // the service can be asked for its configuration
  bool has_grip_;
  std::uint32_t dead_man_;
  VendorFrame frame_;
  Clock::duration silence_;
  HaplyCommandWriter writer_;
  HaplyStateReader reader_;
  bool introduced_ = false, started_ = false;

  bodkin_state state_ = blank_state();
  std::uint32_t grip_buttons_ = 0;
  bool owed_ = false;    // an answer
  bool pushes_ = false;  // the message that it answers
  Clock::time_point sent_, last_position_, pushed_in_vain_, inspected_;
  bool config_moved_ = false;
  std::atomic<Cause> cause_{Cause::none};
};

struct Haply {
  static constexpr const char* name = "haply";
  static constexpr const char* summary = "Inverse3, Inverse3x, Minverse with VerseGrip (Haply's Inverse service)";

  static void list(const char* text, const DeviceSink& found) {
    const HaplySession session = open_haply_session(find_haply_service(haply_settings(text)));
    for (const HaplyInverse& device : session.inventory.devices) {
      found(device.identity, device.model + ", identity " + device.identity);
    }
  }

  static std::unique_ptr<OpenDevice> open(const std::string& identity, const char* text,
                                          bodkin_abilities& abilities) {
    const DriverSettings settings = haply_settings(text);
    const double peak = settings.number("peak_force", 10.0, 0.1, 10.0);
    const double silence = settings.number("silence_ms", 20.0, 5.0, 1000.0);
    const std::uint32_t dead_man = dead_man_of(settings);
    const VendorFrame frame = frame_of(settings);
    force_key_of(settings, {}, false);  // a wrong one is refused before the service is asked
    const HaplyService service = find_haply_service(settings);
    HaplySession session = open_haply_session(service);
    const Choice choice = choose(session.inventory, identity, settings);
    must_be_fit(choice.device);
    if (dead_man != 0 && choice.grip.empty()) {
      throw DriverFailure(BODKIN_NOT_CONNECTED,
                          "there is no VerseGrip whose button could be the dead-man's switch: switch the grip on, or "
                          "say dead_man=none");
    }
    copy_text(choice.device.model, abilities.name, BODKIN_TEXT);
    copy_text(choice.device.identity, abilities.serial, BODKIN_TEXT);
    abilities.peak_force = peak;
    abilities.stiffness = 1.0;
    abilities.damping = 0.006;
    abilities.rate = 1000.0;
    abilities.delay = 0.002;
    copy_text("the vendor states none; one pass through the service and one 1 ms frame of the bus (USB 2.0, 5.11)",
              abilities.delay_source, BODKIN_TEXT);
    std::fill_n(abilities.workspace_low, 3, -reach);
    std::fill_n(abilities.workspace_high, 3, reach);
    abilities.measures_rotation = choice.grip.empty() ? 0 : 1;
    abilities.has_dead_man = dead_man == 0 ? 0 : 1;
    const InverseSettings inverse_settings{force_key_of(settings, service.version, session.older_format), dead_man,
                                           frame, std::chrono::microseconds(static_cast<long>(1000.0 * silence))};
    return std::make_unique<InverseDevice>(service, std::move(session), choice, inverse_settings);
  }
};

}  // namespace

const bodkin_driver& haply_driver() noexcept {
  static constexpr bodkin_driver driver = driver_of<Haply>();
  return driver;
}

}  // namespace bodkin::haptics
