#include "haptics/drivers/spacemouse.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <numbers>
#include <string>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/driver_settings.h"
#include "haptics/drivers/vendor_frame.h"
#include "haptics/tick_clock.h"

namespace bodkin::haptics {

namespace {

constexpr double longest_step = 0.02;  // s; after a stall the pose does not jump
constexpr int most_events = 64;        // of one round

// The message of spacenavd: eight integers, the first of which is the type.
using Event = std::array<std::int32_t, 8>;
enum EventType { motion, press, release };

DriverSettings spacemouse_settings(const char* settings) {
  return {settings, {"socket", "axes", "full_scale", "dead_zone", "speed_mm_s", "turn_deg_s", "reach_mm"}};
}

std::string socket_of(const DriverSettings& settings) {
  const char* named = std::getenv("SPNAV_SOCKET");
  return settings.text("socket", named == nullptr || *named == '\0' ? "/var/run/spnav.sock" : named);
}

// A connection to the daemon, closed by the destructor.
class Socket {
 public:
  explicit Socket(const std::string& path) : file_(socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.size() >= sizeof address.sun_path) {
      close(file_);
      throw DriverFailure(BODKIN_BAD_SETTINGS, "the socket's path " + path + " is longer than the system allows");
    }
    std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
    if (connect(file_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return;
    const int error = errno;
    close(file_);
    const bool forbidden = error == EACCES || error == EPERM;
    throw DriverFailure(forbidden ? BODKIN_NO_PERMISSION : BODKIN_NOT_INSTALLED,
                        "spacenavd does not answer at " + path + " (" + std::strerror(error) +
                            "): install and start spacenavd, or say socket=PATH");
  }
  ~Socket() { close(file_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  // Reads what has arrived. False when the daemon is gone.
  template <typename Use>
  bool drain(Use use) noexcept {
    for (int event = 0; event < most_events; ++event) {
      const ssize_t size = recv(file_, bytes_.data() + got_, bytes_.size() - got_, MSG_DONTWAIT);
      if (size == 0) return false;
      if (size < 0) return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
      got_ += static_cast<std::size_t>(size);
      if (got_ < bytes_.size()) continue;
      got_ = 0;
      Event complete;
      std::memcpy(complete.data(), bytes_.data(), bytes_.size());
      use(complete);
    }
    return true;
  }

 private:
  int file_;
  std::array<char, sizeof(Event)> bytes_{};
  std::size_t got_ = 0;
};

// Rows of signed units, from "x,-z,y": the puck's axes to the operator's right, away from the operator, and up.
Mat3 axes_of(const std::string& text) {
  Mat3 axes = Mat3::Zero();
  int row = 0;
  double sign = 1.0;
  bool wrong = false, expected = true;  // expected: a letter comes next
  for (const char c : text) {
    if (c == '-' && expected && sign > 0.0) {
      sign = -1.0;
    } else if (c >= 'x' && c <= 'z' && expected && row < 3) {
      axes(row++, c - 'x') = sign;
      sign = 1.0;
      expected = false;
    } else if (c == ',' && !expected) {
      expected = true;
    } else {
      wrong = true;
    }
  }
  if (wrong || row != 3 || std::abs(std::abs(axes.determinant()) - 1.0) > 1e-9) {
    throw DriverFailure(BODKIN_BAD_SETTINGS, "the setting axes is '" + text +
                                                 "', expected each of x, y and z once with its sign, as in x,-z,y");
  }
  return axes;
}

struct PuckSettings {
  Mat3 axes;          // of the puck, in the operator's frame
  double full_scale;  // counts
  double dead_zone;   // part of full scale that counts as zero
  double speed;       // mm/s at full scale
  double turn;        // rad/s at full scale
  double reach;       // mm, from the middle along each axis

  // -1 to 1, 0 within the dead zone and growing from 0 at its edge.
  double deflection(std::int32_t counts) const noexcept {
    const double part = std::min(std::abs(static_cast<double>(counts)) / full_scale, 1.0);
    return std::copysign(std::max(0.0, part - dead_zone) / (1.0 - dead_zone), static_cast<double>(counts));
  }
};

class SpaceMouseDevice : public OpenDevice {
 public:
  SpaceMouseDevice(const std::string& path, const PuckSettings& puck) : socket_(path), path_(path), puck_(puck) {}

  void start(bodkin_tick, void*) override {
    state_ = blank_state();
    rotation_ = Eigen::Map<const RowMajor>(state_.rotation);
    position_.setZero();
    last_time_ = monotonic_seconds();
  }
  void stop() override {}

  int exchange(const bodkin_command&, bodkin_state& state) noexcept override {
    if (!gone_.load()) {
      gone_.store(!socket_.drain([this](const Event& event) { take(event); }));
    }
    const double time = monotonic_seconds();
    move(std::clamp(time - last_time_, 0.0, longest_step));
    last_time_ = time;
    state = state_;
    return gone_.load() ? BODKIN_COMMUNICATION_LOST : BODKIN_OK;
  }

  std::string explain() override {
    return gone_.load() ? "spacenavd has closed " + path_ + ": start it again, and then the session" : "";
  }

 private:
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

  void take(const Event& event) noexcept {
    if (event[0] == motion) {
      for (std::size_t i = 0; i < 3; ++i) {
        pull_[static_cast<Eigen::Index>(i)] = puck_.deflection(event[1 + i]);
        twist_[static_cast<Eigen::Index>(i)] = puck_.deflection(event[4 + i]);
      }
    } else if ((event[0] == press || event[0] == release) && event[1] >= 0 && event[1] < 31) {
      const std::uint32_t bit = 1U << event[1];
      state_.buttons = event[0] == press ? state_.buttons | bit : state_.buttons & ~bit;
    }
  }

  void move(double dt) noexcept {
    if (gone_.load()) dt = 0.0;
    const Vec3 before = position_;
    position_ = (position_ + puck_.axes * pull_ * (puck_.speed * dt)).cwiseMax(-puck_.reach).cwiseMin(puck_.reach);
    // Rotations change sign when the axes are mirrored.
    const Vec3 turn = puck_.axes.determinant() * (puck_.axes * twist_) * (puck_.turn * dt);
    if (const double angle = turn.norm(); angle > 0.0) {
      rotation_ = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() * rotation_;
      rotation_ = Eigen::Quaterniond(rotation_).normalized().toRotationMatrix();
    }
    Eigen::Map<Vec3>(state_.position) = position_;
    Eigen::Map<RowMajor>(state_.rotation) = rotation_;
    Eigen::Map<Vec3>(state_.velocity) = dt > 0.0 ? Vec3((position_ - before) / dt) : Vec3::Zero();
  }

  Socket socket_;
  std::string path_;
  PuckSettings puck_;
  bodkin_state state_ = blank_state();
  Vec3 pull_ = Vec3::Zero(), twist_ = Vec3::Zero();  // -1 to 1, the puck's axes
  Vec3 position_ = Vec3::Zero();
  Mat3 rotation_ = Mat3::Identity();
  double last_time_ = 0.0;  // s
  std::atomic<bool> gone_{false};
};

struct SpaceMouse {
  static constexpr const char* name = "spacemouse";
  static constexpr const char* summary = "SpaceMouse and other pucks (spacenavd); no force";

  static void list(const char* text, const DeviceSink& found) {
    const std::string path = socket_of(spacemouse_settings(text));
    const Socket connection(path);
    found("", "what spacenavd serves at " + path);
  }

  static std::unique_ptr<OpenDevice> open(const std::string&, const char* text, bodkin_abilities& abilities) {
    const DriverSettings settings = spacemouse_settings(text);
    const PuckSettings puck{.axes = axes_of(settings.text("axes", "x,-z,y")),
                            .full_scale = settings.number("full_scale", 350.0, 1.0, 1e6),
                            .dead_zone = settings.number("dead_zone", 0.05, 0.0, 0.9),
                            .speed = settings.number("speed_mm_s", 50.0, 0.1, 1000.0),
                            .turn = settings.number("turn_deg_s", 60.0, 0.0, 720.0) * (std::numbers::pi / 180.0),
                            .reach = settings.number("reach_mm", 100.0, 1.0, 1000.0)};
    auto device = std::make_unique<SpaceMouseDevice>(socket_of(settings), puck);
    copy_text("SpaceMouse", abilities.name, BODKIN_TEXT);
    abilities.rate = 1000.0;
    std::fill_n(abilities.workspace_low, 3, -puck.reach);
    std::fill_n(abilities.workspace_high, 3, puck.reach);
    abilities.measures_rotation = 1;
    return device;
  }
};

}  // namespace

const bodkin_driver& spacemouse_driver() noexcept {
  static constexpr bodkin_driver driver = driver_of<SpaceMouse>();
  return driver;
}

}  // namespace bodkin::haptics
