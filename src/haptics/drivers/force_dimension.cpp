#include "haptics/drivers/force_dimension.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <sstream>
#include <string>
#include <thread>

#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/driver_settings.h"
#include "haptics/drivers/force_dimension_library.h"
#include "haptics/drivers/vendor_frame.h"
#include "haptics/tick_clock.h"

namespace bodkin::haptics {

namespace {

using namespace force_dimension;

constexpr int oldest_sdk = 314;                // 3.14
constexpr unsigned char watchdog_steps = 160;  // 20 ms without a command, then the controller brakes on its own
constexpr int status_every = 4;                // rounds between two checks of the status vector
constexpr int stop_attempts = 10;

// By the SDK's numbers of models. N, N mm, N/mm, N s/mm, half the workspace's width (and height) and depth in mm, mm,
// s. The numbers are those of share/bodkin/devices.csv; related models without published numbers have those of the
// device named beside them.
struct Model {
  int first, last;  // system types
  double force, torque, stiffness, damping, half_width, half_depth, resolution, delay;
};
constexpr Model models[] = {
    {33, 37, 12.0, 0.0, 5.0, 0.03, 80.0, 55.0, 0.01, 0.00025},        // omega.3, .6, .7
    {60, 60, 8.0, 0.0, 3.0, 0.02, 51.0, 51.0, 0.0635, 0.001},         // Falcon
    {63, 63, 20.0, 0.0, 5.0, 0.03, 200.0, 130.0, 0.02, 0.00025},      // delta.3
    {64, 64, 20.0, 200.0, 5.0, 0.03, 200.0, 130.0, 0.02, 0.00025},    // delta.6
    {104, 107, 12.0, 200.0, 4.0, 0.03, 75.0, 75.0, 0.01, 0.00025},    // sigma.7, .6+
    {206, 206, 12.0, 0.0, 4.0, 0.03, 75.0, 75.0, 0.01, 0.00025},      // sigma.3
    {108, 109, 12.0, 200.0, 8.0, 0.03, 112.0, 112.0, 0.01, 0.00025},  // lambda.7
    {203, 203, 12.0, 0.0, 8.0, 0.03, 112.0, 112.0, 0.01, 0.00025},    // lambda.3
};
constexpr int falcon = 60;
constexpr Model unknown_model{0, 0, 5.0, 0.0, 1.0, 0.01, 0.0, 0.0, 0.0, 0.001};

const Model& model_of(int type) {
  for (const Model& model : models) {
    if (type >= model.first && type <= model.last) return model;
  }
  return unknown_model;
}

int result_of_force_dimension(int error) {
  switch (error) {
    case error_com:
      return BODKIN_COMMUNICATION_LOST;
    case error_busy:
    case error_device_in_use:
      return BODKIN_BUSY;
    case error_no_driver:
    case error_no_device:
      return BODKIN_NOT_CONNECTED;
    default:
      return BODKIN_VENDOR_ERROR;
  }
}

const char* force_dimension_advice(int result) {
  switch (result) {
    case BODKIN_BUSY:
      return "close the other program that uses the device";
    case BODKIN_NOT_CONNECTED:
    case BODKIN_COMMUNICATION_LOST:
      return "connect it and switch it on, and see that you may open USB devices (the SDK's udev rules)";
    default:
      return "see whether the vendor's own test program works";
  }
}

using ForceDimensionHandle = std::shared_ptr<const ForceDimensionLibrary>;

std::string words(const ForceDimensionLibrary& sdk, int error) {
  const char* text = sdk.dhdErrorGetLastStr();
  return "error " + std::to_string(error) + (text == nullptr ? "" : ", '" + std::string(text) + "'");
}

[[noreturn]] void fail(const ForceDimensionLibrary& sdk, const std::string& what) {
  const int error = sdk.dhdErrorGetLast();
  const int result = result_of_force_dimension(error);
  throw DriverFailure(result, what + " (" + words(sdk, error) + "): " + force_dimension_advice(result));
}

ForceDimensionHandle load_force_dimension(const DriverSettings& settings) {
  auto sdk = std::make_shared<const ForceDimensionLibrary>(settings.text("library", ""));
  int major = 0, minor = 0, release = 0, revision = 0;
  sdk->dhdGetSDKVersion(&major, &minor, &release, &revision);
  if (major * 100 + minor < oldest_sdk) {
    throw DriverFailure(BODKIN_WRONG_VERSION, sdk->library.path() + " is version " + std::to_string(major) + "." +
                                                  std::to_string(minor) +
                                                  ", expected 3.14 or newer: install a newer Force Dimension SDK");
  }
  return sdk;
}

DriverSettings force_dimension_settings(const char* settings) {
  return {settings, {"library", "initialise", "move_s", "gravity", "peak_force"}};
}

// A device that is open in the SDK, closed by the destructor. DRD, if present, answers only for devices that it has
// opened itself.
class Handle {
 public:
  // `index`: among the devices that are connected. Null when the SDK refuses.
  static std::unique_ptr<Handle> open(const ForceDimensionHandle& sdk, int index) {
    const auto number = static_cast<char>(index);
    const int id = sdk->has_drd() ? sdk->drdOpenID(number) : sdk->dhdOpenID(number);
    if (id < 0) return nullptr;
    return std::make_unique<Handle>(sdk, id);
  }
  Handle(ForceDimensionHandle sdk, int id) : sdk_(std::move(sdk)), id_(static_cast<char>(id)) {}
  ~Handle() { sdk_->has_drd() ? sdk_->drdClose(id_) : sdk_->dhdClose(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  const ForceDimensionLibrary& sdk() const noexcept { return *sdk_; }
  char id() const noexcept { return id_; }
  std::string serial() const {
    unsigned short number = 0;
    return sdk_->dhdGetSerialNumber(&number, id_) < 0 ? "" : std::to_string(number);
  }
  std::string name() const {
    const char* name = sdk_->dhdGetSystemName(id_);
    return name == nullptr ? "device of type " + std::to_string(sdk_->dhdGetSystemType(id_)) : name;
  }

 private:
  ForceDimensionHandle sdk_;
  char id_;
};

std::unique_ptr<Handle> open_handle(const ForceDimensionHandle& sdk, const std::string& serial) {
  const int count = sdk->dhdGetDeviceCount();
  if (count <= 0) {
    throw DriverFailure(BODKIN_NOT_CONNECTED, std::string("no Force Dimension device is found: ") +
                                                  force_dimension_advice(BODKIN_NOT_CONNECTED));
  }
  for (int index = 0; index < count; ++index) {
    auto handle = Handle::open(sdk, index);
    if (handle != nullptr && (serial.empty() || handle->serial() == serial)) return handle;
  }
  if (serial.empty()) fail(*sdk, "the device does not open");
  throw DriverFailure(BODKIN_NOT_CONNECTED, "no free Force Dimension device has the serial number " + serial +
                                                ": see `bodkin devices list` for those that are connected");
}

class ForceDimensionDevice : public OpenDevice {
 public:
  ForceDimensionDevice(std::unique_ptr<Handle> handle, bool torques, double peak_force)
      : handle_(std::move(handle)), sdk_(handle_->sdk()), id_(handle_->id()), torques_(torques), peak_(peak_force) {}
  ~ForceDimensionDevice() override { sdk_.dhdStop(id_); }

  void start(bodkin_tick, void*) override {
    set_watchdog();
    if (sdk_.dhdSetMaxForce != nullptr) sdk_.dhdSetMaxForce(peak_, id_);
    const bodkin_command nothing{};
    if (sdk_.dhdSetBrakes(0, id_) < 0 || sdk_.dhdEnableForce(1, id_) < 0 || send(nothing) < 0) {
      sdk_.dhdStop(id_);
      fail(sdk_, "forces cannot be enabled");
    }
    round_ = 0;
    error_ = 0;
    cause_ = no_cause;
  }

  int exchange(const bodkin_command& command, bodkin_state& state) noexcept override {
    state = blank_state();
    Vec3 position = Vec3::Zero(), velocity = Vec3::Zero();
    double rotation[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (send(command) < 0) return failed();
    if (sdk_.dhdGetPositionAndOrientationFrame(&position.x(), &position.y(), &position.z(), rotation, id_) < 0) {
      return failed();
    }
    if (sdk_.dhdGetLinearVelocity(&velocity.x(), &velocity.y(), &velocity.z(), id_) < 0) return failed();
    frame_.put_position(position, state);
    frame_.put_velocity(velocity, state);
    frame_.put_rotation(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&rotation[0][0]), state);
    state.buttons = sdk_.dhdGetButtonMask(id_);
    if (round_++ % status_every == 0 || cause_.load() != no_cause) look_at_status();
    state.held = cause_.load() == dead_man ? 0 : 1;
    return fault_of(cause_.load());
  }

  void stop() override {
    send(bodkin_command{});
    for (int attempt = 1; sdk_.dhdStop(id_) < 0; ++attempt) {
      if (attempt == stop_attempts) fail(sdk_, "the device does not stop");
    }
  }

  std::string explain() override {
    static constexpr const char* causes[] = {"",
                                             "the force button was pressed",
                                             "the device was moved too fast",
                                             "the device got no command for 20 ms",
                                             "forces were switched off",
                                             "the USB cable was unplugged",
                                             "the hand let go"};
    const int cause = cause_.load(), error = error_.load();
    if (error != 0) return "the Force Dimension SDK says error " + std::to_string(error);
    if (cause > 0 && cause <= dead_man) return std::string("forces are off: ") + causes[cause];
    return cause == no_cause ? "" : "forces are off for reason " + std::to_string(cause);
  }

 private:
  // Expert functions are enabled only for this one call.
  void set_watchdog() const {
    if (sdk_.dhdEnableExpertMode == nullptr || sdk_.dhdSetWatchdog == nullptr) return;
    sdk_.dhdEnableExpertMode();
    sdk_.dhdSetWatchdog(watchdog_steps, id_);
    if (sdk_.dhdDisableExpertMode != nullptr) sdk_.dhdDisableExpertMode();
  }

  // A force is sent every round, even zero: the SDK adds the device's own weight to it.
  int send(const bodkin_command& command) const noexcept {
    const Vec3 force = frame_.force_of(command);
    if (!torques_) return sdk_.dhdSetForce(force.x(), force.y(), force.z(), id_);
    const Vec3 torque = frame_.torque_of(command);
    return sdk_.dhdSetForceAndTorque(force.x(), force.y(), force.z(), torque.x(), torque.y(), torque.z(), id_);
  }

  int failed() noexcept {
    const int error = sdk_.dhdErrorGetLast();
    error_.store(error);
    sdk_.dhdStop(id_);
    const int result = result_of_force_dimension(error);
    return result == BODKIN_NOT_CONNECTED ? BODKIN_COMMUNICATION_LOST : result;
  }

  void look_at_status() noexcept {
    int status[17] = {};
    if (sdk_.dhdGetStatus(status, id_) < 0 || status[connected] == 0) {
      cause_.store(usb);
    } else if (status[needs_reset] != 0) {
      cause_.store(uncalibrated);
    } else {
      cause_.store(status[force_on] != 0 ? no_cause : status[force_off_cause]);
    }
  }

  static int fault_of(int cause) noexcept {
    switch (cause) {
      case no_cause:
      case dead_man:
        return BODKIN_OK;
      case button:
        return BODKIN_EMERGENCY_STOP;
      case velocity:
        return BODKIN_VELOCITY_LIMIT;
      case watchdog:
      case usb:
        return BODKIN_COMMUNICATION_LOST;
      case uncalibrated:
        return BODKIN_NOT_CALIBRATED;
      default:
        return BODKIN_VENDOR_ERROR;
    }
  }

  static constexpr int uncalibrated = 100;  // in addition to the vendor's causes

  std::unique_ptr<Handle> handle_;
  const ForceDimensionLibrary& sdk_;
  char id_;
  bool torques_;
  double peak_;  // N
  VendorFrame frame_ = metres(x_near_frame());
  long round_ = 0;
  std::atomic<int> cause_{no_cause};
  std::atomic<int> error_{0};
};

struct ForceDimension {
  static constexpr const char* name = "force_dimension";
  static constexpr const char* summary = "omega, delta, sigma, lambda (Force Dimension SDK)";

  static void list(const char* text, const DeviceSink& found) {
    const ForceDimensionHandle sdk = load_force_dimension(force_dimension_settings(text));
    const int count = sdk->dhdGetDeviceCount();
    for (int index = 0; index < count; ++index) {
      const auto handle = Handle::open(sdk, index);
      if (handle == nullptr) continue;  // another program's
      found(handle->serial(), handle->name() + ", serial number " + handle->serial());
    }
  }

  static std::unique_ptr<OpenDevice> open(const std::string& serial, const char* text, bodkin_abilities& abilities) {
    const DriverSettings settings = force_dimension_settings(text);
    const bool initialise = settings.flag("initialise", false);
    const double move = settings.number("move_s", 15.0, 0.1, 18.0);
    const int gravity = settings.flag("gravity", true) ? 1 : 0;
    const double least = settings.number("peak_force", 100.0, 0.1, 100.0);
    const ForceDimensionHandle library = load_force_dimension(settings);
    auto handle = open_handle(library, serial);
    const ForceDimensionLibrary& sdk = *library;
    const char id = handle->id();
    calibrate(sdk, id, initialise, move);
    if (sdk.dhdSetGravityCompensation != nullptr) sdk.dhdSetGravityCompensation(gravity, id);
    // As in the SDK's examples. A gripper without it has no button.
    const bool has_gripper = sdk.dhdHasActiveGripper != nullptr && sdk.dhdHasActiveGripper(id);
    if (has_gripper && sdk.dhdEmulateButton != nullptr) sdk.dhdEmulateButton(1, id);

    const Model& model = model_of(sdk.dhdGetSystemType(id));
    const bool wrist = sdk.dhdHasWrist(id), torques = sdk.dhdHasActiveWrist(id);
    copy_text(handle->name(), abilities.name, BODKIN_TEXT);
    copy_text(handle->serial(), abilities.serial, BODKIN_TEXT);
    abilities.peak_force = std::min(least, model.force);
    abilities.peak_torque = torques ? model.torque : 0.0;
    abilities.stiffness = model.stiffness;
    abilities.damping = model.damping;
    abilities.resolution = model.resolution;
    abilities.rate = 1000.0;
    abilities.delay = model.delay;
    copy_text(model.delay < 0.001 ? "Force Dimension data sheets: up to 4000 exchanges a second; one exchange"
                                  : "the vendor states none; one 1 ms frame of the bus (USB 2.0, 5.11)",
              abilities.delay_source, BODKIN_TEXT);
    const Vec3 half(model.half_width, model.half_depth, model.half_width);
    Eigen::Map<Vec3>(abilities.workspace_low) = -half;
    Eigen::Map<Vec3>(abilities.workspace_high) = half;
    abilities.measures_rotation = wrist ? 1 : 0;
    return std::make_unique<ForceDimensionDevice>(std::move(handle), torques, abilities.peak_force);
  }

 private:
  static bool is_calibrated(const ForceDimensionLibrary& sdk, char id) {
    if (sdk.has_drd() && sdk.drdIsInitialized != nullptr) return sdk.drdIsInitialized(id);
    int status[17] = {};
    return sdk.dhdGetStatus(status, id) >= 0 && status[needs_reset] == 0;
  }

  // Moves the device only with the user's permission. `move`: s.
  static void calibrate(const ForceDimensionLibrary& sdk, char id, bool may_move, double move) {
    if (is_calibrated(sdk, id)) return;
    if (sdk.dhdGetSystemType(id) == falcon) return wait_for_falcon(sdk, id, may_move, move);
    if (may_move && sdk.has_drd() && sdk.drdAutoInit != nullptr) {
      if (sdk.drdAutoInit(id) < 0) fail(sdk, "the device cannot calibrate itself");
      if (sdk.drdStop != nullptr) sdk.drdStop(false, id);
      if (is_calibrated(sdk, id)) return;
    }
    throw DriverFailure(
        BODKIN_NOT_CALIBRATED,
        "the device is not calibrated: run the vendor's HapticInit, or keep your hands off the device "
        "and say initialise=yes (it then moves by itself)");
  }

  // A Falcon finds its position when its knob is moved through its reach; as in the SDK's samples, forces of zero are
  // sent meanwhile, without which it does not search.
  static void wait_for_falcon(const ForceDimensionLibrary& sdk, char id, bool asked, double move) {
    if (!asked) {
      throw DriverFailure(BODKIN_NOT_CALIBRATED,
                          "the Falcon is not calibrated: say initialise=yes, and pull its knob out and push it in "
                          "while it is opened");
    }
    const double end = monotonic_seconds() + move;
    while (monotonic_seconds() < end) {
      if (sdk.dhdSetForce(0.0, 0.0, 0.0, id) < 0) fail(sdk, "the Falcon does not take a force of zero");
      if (is_calibrated(sdk, id)) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    std::ostringstream text;
    text << "the Falcon was not calibrated within " << move
         << " s: pull its knob out as far as it goes and push it in, and try again";
    throw DriverFailure(BODKIN_NOT_CALIBRATED, text.str());
  }
};

}  // namespace

const bodkin_driver& force_dimension_driver() noexcept {
  static constexpr bodkin_driver driver = driver_of<ForceDimension>();
  return driver;
}

}  // namespace bodkin::haptics
