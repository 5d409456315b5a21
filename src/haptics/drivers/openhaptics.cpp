#include "haptics/drivers/openhaptics.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <string>

#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/driver_settings.h"
#include "haptics/drivers/openhaptics_session.h"
#include "haptics/drivers/vendor_frame.h"
#include "haptics/tick_clock.h"

namespace bodkin::haptics {

namespace {

using namespace openhaptics;

constexpr long temperature_every = 100;    // ticks between readings of the temperature
constexpr long fault_shown = 20;           // ticks for which a passing fault is reported
constexpr int longest_device_fault = 100;  // frames in a row
constexpr int oldest_version = 3;
constexpr double fastest_hand = 1000.0;  // mm/s
constexpr double least_shift = 1.0;      // mm beyond the hand's own motion by which a calibration moves the pose
constexpr int shift_frames = 3;          // after an update within which the pose moves
// s without ticks after a calibration has moved the pose: after 50 ms without one the guard ramps the force up anew.
constexpr double shift_pause = 0.060;

// For an error in the loop.
int result_of_openhaptics(unsigned code) noexcept {
  switch (code) {
    case success:
      return BODKIN_OK;
    case warm_motors:
      return BODKIN_OVERHEATED;
    case exceeded_force:
    case exceeded_impulse:
    case force_error:
      return BODKIN_FORCE_LIMIT;
    case exceeded_velocity:
      return BODKIN_VELOCITY_LIMIT;
    case comm_error:
    case comm_config_error:
      return BODKIN_COMMUNICATION_LOST;
    default:
      return BODKIN_VENDOR_ERROR;
  }
}

// The vendor's samples continue after these: its own limits, and a frame that did not reach the device, as long as
// the next ones do. Every other error ends the session.
bool passes(unsigned code, int device_faults) noexcept {
  if (code == device_fault) return device_faults <= longest_device_fault;
  return code >= exceeded_force && code <= force_error;
}

int result_of_opening(unsigned code) {
  switch (code) {
    case already_initiated:
      return BODKIN_BUSY;
    case device_fault:
    case comm_error:
    case comm_config_error:
      return BODKIN_NOT_CONNECTED;
    default:
      return BODKIN_VENDOR_ERROR;
  }
}

const char* openhaptics_advice(int result) {
  switch (result) {
    case BODKIN_BUSY:
      return "close the other program that uses the device, or unplug it and plug it in";
    case BODKIN_NOT_CONNECTED:
      return "connect it, run the vendor's Touch_Setup, and see that you are in the group dialout";
    default:
      return "see whether the vendor's Touch_Diagnostic works";
  }
}

using Session = std::shared_ptr<OpenHapticsSession>;

DriverSettings openhaptics_settings(const char* settings) {
  return {settings, {"library", "dead_man", "reset_encoders"}};
}

double number(const OpenHapticsLibrary& hd, unsigned parameter) {
  double value = 0.0;
  hd.hdGetDoublev(parameter, &value);
  return value;
}

int whole(const OpenHapticsLibrary& hd, unsigned parameter) {
  int value = 0;
  hd.hdGetIntegerv(parameter, &value);
  return value;
}

std::string text(const OpenHapticsLibrary& hd, unsigned parameter) {
  const char* value = hd.hdGetString(parameter);
  return value == nullptr ? "" : value;
}

// A device initialised by HD. Created, used and destroyed while the scheduler is stopped.
class Initialised {
 public:
  Initialised(OpenHapticsSession& session, const std::string& name) : session_(session) {
    session.newest_error(invalid_handle);  // left behind by others
    id_ = session.hd.hdInitDevice(name.empty() ? nullptr : name.c_str());
    const unsigned error = session.newest_error(id_);
    if (id_ != invalid_handle && error == success) return;
    if (id_ != invalid_handle) session.hd.hdDisableDevice(id_);
    const int result = result_of_opening(error);
    throw DriverFailure(result, "the device" + (name.empty() ? "" : " '" + name + "'") + " does not open (" +
                                    session.words(error) + "): " + openhaptics_advice(result));
  }
  ~Initialised() { session_.hd.hdDisableDevice(id_); }
  Initialised(const Initialised&) = delete;
  Initialised& operator=(const Initialised&) = delete;

  unsigned id() const noexcept { return id_; }

 private:
  OpenHapticsSession& session_;
  unsigned id_;
};

void check_version(const OpenHapticsLibrary& hd) {
  const std::string version_text = text(hd, version);
  const int major = std::atoi(version_text.c_str());
  if (major == 0 || major >= oldest_version) return;  // a version that is not a number is ignored
  throw DriverFailure(BODKIN_WRONG_VERSION, hd.library.path() + " is version " + version_text +
                                                ", expected 3.0 or newer: install a newer OpenHaptics");
}

// The style of a device's calibration, chosen from the supported ones as in the vendor's samples.
unsigned style_of(const OpenHapticsLibrary& hd) {
  const auto supported = static_cast<unsigned>(whole(hd, calibration_style));
  for (const unsigned style : {automatic, inkwell, encoder_reset}) {
    if ((supported & style) != 0) return style;
  }
  return inkwell;
}

// While the scheduler is stopped only encoders can be reset, and only when the user confirms that the arm is at the
// vendor's position: its present place becomes the origin. The servo performs the other styles, as in the vendor's
// Calibration.c: a stylus put into its inkwell during the run requests an update.
void check_calibration(const OpenHapticsLibrary& hd, unsigned style, bool may_reset_encoders) {
  if (style != encoder_reset) return;
  if (may_reset_encoders) hd.hdUpdateCalibration(style);
  if (hd.hdCheckCalibration() == calibration_ok) return;
  throw DriverFailure(BODKIN_NOT_CALIBRATED,
                      "the encoders of the device are not reset: hold its arm in the reset position that the "
                      "vendor's manual shows, and give --settings reset_encoders=yes");
}

class OpenHapticsDevice : public OpenDevice {
 public:
  OpenHapticsDevice(Session session, const std::string& name, bool dead_man, bool may_reset_encoders)
      : session_(std::move(session)), hd_(session_->hd) {
    session_->paused([&] {
      auto device = std::make_unique<Initialised>(*session_, name);  // ends in here when a check throws
      hd_.hdMakeCurrentDevice(device->id());
      check_version(hd_);
      style_ = style_of(hd_);
      check_calibration(hd_, style_, may_reset_encoders);
      session_->newest_error(device->id());
      // A quantity that a device does not report leaves an error on the stack that the tick reads, so read it here.
      double temperatures[6] = {};
      hd_.hdGetDoublev(motor_temperature, temperatures);
      has_temperature_ = session_->newest_error(device->id()) == success;
      has_dead_man_ = dead_man && hd_.hdGetBooleanv != nullptr;
      torques_ = whole(hd_, output_freedoms) >= 6;
      period_ = 1.0 / std::max(100, whole(hd_, update_rate));
      double box[6] = {};
      hd_.hdGetDoublev(usable_workspace, box);
      low_ = Vec3(box[0], box[1], box[2]);
      high_ = Vec3(box[3], box[4], box[5]);
      frame_.centre = 0.5 * (low_ + high_);
      device_ = std::move(device);
    });
  }

  ~OpenHapticsDevice() override {
    stop_quietly();
    try {
      session_->paused([&] { device_.reset(); });
    } catch (const DriverFailure&) {
      // For the scheduler of other devices, whose ticks then stop.
    }
  }

  void describe(bodkin_abilities& abilities) {
    session_->paused([&] {
      hd_.hdMakeCurrentDevice(device_->id());
      copy_text(text(hd_, model_type), abilities.name, BODKIN_TEXT);
      copy_text(text(hd_, serial_number), abilities.serial, BODKIN_TEXT);
      abilities.peak_force = number(hd_, nominal_max_force);
      abilities.continuous_force = number(hd_, nominal_max_continuous_force);
      abilities.peak_torque = torques_ ? number(hd_, nominal_max_torque) : 0.0;
      abilities.stiffness = number(hd_, nominal_max_stiffness);
      abilities.damping = number(hd_, nominal_max_damping);
      abilities.measures_rotation = whole(hd_, input_freedoms) >= 6 ? 1 : 0;
      session_->newest_error(device_->id());  // left by quantities that this model does not report
    });
    const Vec3 half = frame_.to_operator * (0.5 * (high_ - low_));
    Eigen::Map<Vec3>(abilities.workspace_low) = -half.cwiseAbs();
    Eigen::Map<Vec3>(abilities.workspace_high) = half.cwiseAbs();
    abilities.rate = 1.0 / period_;
    abilities.has_dead_man = has_dead_man_ ? 1 : 0;
    abilities.owns_loop = 1;
    abilities.delay = 0.001;
    copy_text("the vendor states none; hdEndFrame hands the force to the next 1 ms frame of the bus (USB 2.0, 5.11)",
              abilities.delay_source, BODKIN_TEXT);
  }

  void start(bodkin_tick tick, void* user) override {
    tick_ = tick;
    user_ = user;
    ticks_ = 0;
    frames_since_update_ = shift_frames;
    frame_time_ = paused_until_ = 0.0;
    lasting_ = passing_ = success;
    device_faults_ = 0;
    last_error_.store(success);
    state_ = blank_state();
    unsigned error = success;
    try {
      session_->paused([&] {
        hd_.hdMakeCurrentDevice(device_->id());
        session_->newest_error(device_->id());
        enabled_ = hd_.hdCheckCalibration() != calibration_needs_hand;  // otherwise by calibrate(), once it has
        if (enabled_) hd_.hdEnable(force_output);
        error = session_->newest_error(device_->id());
        if (error == success) callback_ = session_->schedule(&OpenHapticsDevice::run, this);
        scheduled_ = error == success;
      });
    } catch (const DriverFailure&) {
      stop_quietly();
      throw;
    }
    if (error != success) {
      throw DriverFailure(BODKIN_VENDOR_ERROR, "forces cannot be enabled (" + session_->words(error) +
                                                   "): " + openhaptics_advice(BODKIN_VENDOR_ERROR));
    }
  }

  // The vendor applies no force once the scheduler has stopped.
  void stop() override {
    session_->paused([&] {
      if (scheduled_) session_->unschedule(callback_);
      scheduled_ = false;
      hd_.hdMakeCurrentDevice(device_->id());
      hd_.hdDisable(force_output);
      session_->newest_error(device_->id());
    });
  }

  std::string explain() override {
    const unsigned code = last_error_.load();
    if (code == uncalibrated) return "the device is not calibrated: put the stylus into its inkwell, then arm";
    return code == success ? "" : "OpenHaptics says " + session_->words(code);
  }

 private:
  static constexpr unsigned uncalibrated = 0xFFFF0000;  // in addition to the vendor's errors

  void stop_quietly() noexcept {
    try {
      if (scheduled_) OpenHapticsDevice::stop();
    } catch (const DriverFailure&) {
      // stop() completes its work on this device before it can fail.
    }
  }

  static unsigned run(void* self) noexcept { return static_cast<OpenHapticsDevice*>(self)->round(); }

  // One tick in the scheduler's thread: one frame. A frame that sets no force exerts none.
  unsigned round() noexcept {
    const double time = monotonic_seconds();
    hd_.hdMakeCurrentDevice(device_->id());
    calibrate();
    hd_.hdBeginFrame(device_->id());
    const Vec3 before = Vec3(state_.position);
    read_state();
    const unsigned error = session_->newest_error(device_->id());
    if (error != device_fault) device_faults_ = 0;
    note(error);
    watch_for_shift(before, time);
    if (time < paused_until_) {
      hd_.hdEndFrame(device_->id());
      note(session_->newest_error(device_->id()));
      return 1;
    }
    const double dt = ticks_ == 0 ? period_ : time - last_time_;
    last_time_ = time;
    state_.fault = static_cast<std::uint32_t>(fault());
    bodkin_command command{};
    tick_(user_, &state_, dt, &command);
    if (state_.fault == BODKIN_OK) send(command);
    hd_.hdEndFrame(device_->id());
    note(session_->newest_error(device_->id()));
    ++ticks_;
    return 1;
  }

  // As in the vendor's samples, before the frame: a stylus put into its inkwell, or a device that refines its
  // calibration continuously, requests an update during the run. Encoders are never reset under a hand.
  void calibrate() noexcept {
    const unsigned state = hd_.hdCheckCalibration();
    calibrated_ = state != calibration_needs_hand;
    if (state == calibration_ok && !enabled_ && lasting_ == success) {
      hd_.hdEnable(force_output);
      enabled_ = true;
    }
    if (frames_since_update_ < shift_frames) ++frames_since_update_;
    if (state != calibration_needs_update || style_ == encoder_reset) return;
    hd_.hdUpdateCalibration(style_);
    session_->newest_error(device_->id());  // a failed update is requested again
    frames_since_update_ = 0;
  }

  // A calibration that moves the pose is not a motion of the hand. For a while no ticks are called, and the frames
  // carry no force; the guard, which would take the pose's jump for a fault, then begins at zero.
  void watch_for_shift(const Vec3& before, double time) noexcept {
    const double elapsed = time - frame_time_;
    frame_time_ = time;
    if (ticks_ == 0 || frames_since_update_ >= shift_frames) return;
    const double moved = (Vec3(state_.position) - before).norm();
    if (moved > least_shift + fastest_hand * elapsed) paused_until_ = time + shift_pause;
  }

  void read_state() noexcept {
    double transform[16] = {}, velocity[3] = {};
    int buttons = 0;
    hd_.hdGetDoublev(current_transform, transform);
    hd_.hdGetDoublev(current_velocity, velocity);
    hd_.hdGetIntegerv(current_buttons, &buttons);
    const Eigen::Map<const Eigen::Matrix4d> pose(transform);  // column by column
    frame_.put_position(pose.topRightCorner<3, 1>(), state_);
    frame_.put_rotation(pose.topLeftCorner<3, 3>(), state_);
    frame_.put_velocity(Vec3(velocity), state_);
    state_.buttons = static_cast<std::uint32_t>(buttons);
    if (has_dead_man_) {
      unsigned char held = 0;
      hd_.hdGetBooleanv(current_safety_switch, &held);
      state_.held = held != 0 ? 1 : 0;
    }
    if (has_temperature_ && ticks_ % temperature_every == 0) {
      double temperatures[6] = {};
      hd_.hdGetDoublev(motor_temperature, temperatures);
      state_.temperature = *std::max_element(std::begin(temperatures), std::end(temperatures));
    }
  }

  void send(const bodkin_command& command) noexcept {
    const Vec3 force = frame_.force_of(command);
    hd_.hdSetDoublev(current_force, force.data());
    if (!torques_) return;
    const Vec3 torque = frame_.torque_of(command);
    hd_.hdSetDoublev(current_torque, torque.data());
  }

  void note(unsigned code) noexcept {
    if (code == success) return;
    last_error_.store(code);
    if (code == device_fault) ++device_faults_;
    if (passes(code, device_faults_)) {
      passing_ = code;
      passing_until_ = ticks_ + fault_shown;
      return;
    }
    if (lasting_ != success) return;
    lasting_ = code;
    hd_.hdMakeCurrentDevice(device_->id());
    hd_.hdDisable(force_output);  // until the next start
  }

  int fault() noexcept {
    if (lasting_ != success) return result_of_openhaptics(lasting_);
    if (!calibrated_) {
      last_error_.store(uncalibrated);
      return BODKIN_NOT_CALIBRATED;
    }
    return passing_ != success && ticks_ < passing_until_ ? result_of_openhaptics(passing_) : BODKIN_OK;
  }

  Session session_;
  const OpenHapticsLibrary& hd_;
  std::unique_ptr<Initialised> device_;
  VendorFrame frame_ = y_up_frame();
  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();  // of the usable workspace, vendor's axes, mm
  unsigned style_ = inkwell;                       // of calibration
  bool has_temperature_ = false, has_dead_man_ = false, torques_ = false;
  double period_ = 0.001;  // s

  // Of the vendor's loop.
  bodkin_tick tick_ = nullptr;
  void* user_ = nullptr;
  unsigned long callback_ = 0;
  bool scheduled_ = false;
  bodkin_state state_{};
  long ticks_ = 0;
  double last_time_ = 0.0;  // s
  bool calibrated_ = true;
  int frames_since_update_ = shift_frames;        // of the calibration, up to shift_frames
  double frame_time_ = 0.0, paused_until_ = 0.0;  // s
  bool enabled_ = false;                          // the motors
  int device_faults_ = 0;                         // frames in a row
  unsigned lasting_ = success, passing_ = success;
  long passing_until_ = 0;
  std::atomic<unsigned> last_error_{success};
};

struct OpenHaptics {
  static constexpr const char* name = "openhaptics";
  static constexpr const char* summary = "Touch and PHANTOM devices (OpenHaptics)";

  // HD provides no list: the default device is opened without force, asked for its name, and closed.
  static void list(const char* words, const DeviceSink& found) {
    const DriverSettings settings = openhaptics_settings(words);
    const Session session = OpenHapticsSession::join(settings.text("library", ""));
    session->paused([&] {
      const Initialised device(*session, "");
      session->hd.hdMakeCurrentDevice(device.id());
      found("", text(session->hd, model_type) + ", serial number " + text(session->hd, serial_number) +
                    ", the default device");
    });
  }

  static std::unique_ptr<OpenDevice> open(const std::string& device, const char* words, bodkin_abilities& abilities) {
    const DriverSettings settings = openhaptics_settings(words);
    const bool dead_man = settings.flag("dead_man", false), reset = settings.flag("reset_encoders", false);
    auto opened = std::make_unique<OpenHapticsDevice>(OpenHapticsSession::join(settings.text("library", "")), device,
                                                      dead_man, reset);
    opened->describe(abilities);
    return opened;
  }
};

}  // namespace

const bodkin_driver& openhaptics_driver() noexcept {
  static constexpr bodkin_driver driver = driver_of<OpenHaptics>();
  return driver;
}

}  // namespace bodkin::haptics
