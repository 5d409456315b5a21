#include "tests/haptics/driver_rig.h"

#include <cmath>
#include <stdexcept>

#include <dlfcn.h>

#include "haptics/drivers/drivers.h"

namespace bodkin {

using namespace std::chrono_literals;
using stand_in::Trouble;

namespace {

const std::string folder = BODKIN_STAND_INS;

Mat3 columns(const Vec3& x, const Vec3& y, const Vec3& z) {
  Mat3 matrix;
  matrix << x, y, z;
  return matrix;
}

DriverSubject force_dimension() {
  DriverSubject subject;
  subject.name = "force_dimension";
  subject.library = folder + "/force_dimension/libdrd.so";
  subject.library_without_symbol = folder + "/force_dimension_broken/libdrd.so";
  subject.missing_symbol = "dhdEnableForce";
  // X towards the operator, Y right, Z up; m, N m.
  subject.pushed_vendor = {0.01, 0.02, 0.03};
  subject.pushed = {20, -10, 30};
  subject.left_vendor = columns(Vec3::UnitY(), -Vec3::UnitX(), Vec3::UnitZ());
  subject.force_vendor = {-2, 1, 3};
  subject.torque_vendor = {-0.020, 0.010, 0.030};
  subject.at_open = {{Trouble::no_device, DeviceFault::not_connected},
                     {Trouble::busy, DeviceFault::busy},
                     {Trouble::wrong_version, DeviceFault::wrong_version},
                     {Trouble::uncalibrated, DeviceFault::not_calibrated}};
  subject.in_loop = {
      {Trouble::unplug, DeviceFault::communication_lost},     {Trouble::not_a_number, DeviceFault::bad_data},
      {Trouble::emergency_stop, DeviceFault::emergency_stop}, {Trouble::too_fast, DeviceFault::velocity_limit},
      {Trouble::uncalibrated, DeviceFault::not_calibrated},   {Trouble::unknown_code, DeviceFault::vendor_error}};
  return subject;
}

DriverSubject openhaptics() {
  DriverSubject subject;
  subject.name = "openhaptics";
  subject.library = folder + "/openhaptics/libHD.so";
  subject.library_without_symbol = folder + "/openhaptics_broken/libHD.so";
  subject.missing_symbol = "hdDisable";
  subject.settings = "dead_man=yes";
  // X right, Y up, Z towards the operator; mm, N mm; the middle of the workspace is at (0, 20, 0).
  subject.origin_vendor = {0, 20, 0};
  subject.pushed_vendor = {10, 40, 30};
  subject.pushed = {10, -30, 20};
  subject.left_vendor = columns(-Vec3::UnitZ(), Vec3::UnitY(), Vec3::UnitX());
  subject.force_vendor = {1, 3, -2};
  subject.torque_vendor = {10, 30, -20};
  subject.at_open = {{Trouble::no_device, DeviceFault::not_connected},
                     {Trouble::busy, DeviceFault::busy},
                     {Trouble::wrong_version, DeviceFault::wrong_version},
                     {Trouble::uncalibrated, DeviceFault::not_calibrated}};
  subject.in_loop = {{Trouble::unplug, DeviceFault::communication_lost},
                     {Trouble::not_a_number, DeviceFault::bad_data},
                     {Trouble::hot, DeviceFault::overheated},
                     {Trouble::too_fast, DeviceFault::velocity_limit},
                     {Trouble::too_much_force, DeviceFault::force_limit},
                     {Trouble::uncalibrated, DeviceFault::not_calibrated},
                     {Trouble::unknown_code, DeviceFault::vendor_error}};
  return subject;
}

DriverSubject haption() {
  DriverSubject subject;
  subject.name = "haption";
  subject.library = folder + "/haption/libVirtuoseAPI.so";
  subject.library_without_symbol = folder + "/haption_broken/libVirtuoseAPI.so";
  subject.missing_symbol = "virtStopLoop";
  subject.settings = "relays_s=0.02";
  // X towards the operator, Y right, Z up; m, N m.
  subject.pushed_vendor = {0.01, 0.02, 0.03};
  subject.pushed = {20, -10, 30};
  subject.left_vendor = columns(Vec3::UnitY(), -Vec3::UnitX(), Vec3::UnitZ());
  subject.force_vendor = {-2, 1, 3};
  subject.torque_vendor = {-0.020, 0.010, 0.030};
  subject.at_open = {{Trouble::no_device, DeviceFault::not_connected},
                     {Trouble::busy, DeviceFault::busy},
                     {Trouble::wrong_version, DeviceFault::wrong_version}};
  subject.in_loop = {{Trouble::unplug, DeviceFault::communication_lost},
                     {Trouble::not_a_number, DeviceFault::bad_data},
                     {Trouble::hot, DeviceFault::overheated},
                     {Trouble::emergency_stop, DeviceFault::emergency_stop},
                     {Trouble::unknown_code, DeviceFault::vendor_error}};
  return subject;
}

}  // namespace

const std::vector<DriverSubject>& driver_subjects() {
  static const std::vector<DriverSubject> all = [] {
    std::vector<DriverSubject> subjects = {openhaptics(), force_dimension(), haption()};
    for (DriverSubject& subject : subjects) {
      subject.driver = find_driver(subject.name);
      subject.force = {1, 2, 3};
      subject.torque = {10, 20, 30};
    }
    return subjects;
  }();
  return all;
}

stand_in::Board& DriverSubject::board() const {
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) throw std::runtime_error(dlerror());
  const auto entry = reinterpret_cast<stand_in::Board* (*)()>(dlsym(handle, "bodkin_stand_in"));
  return *entry();
}

bool comes_true(const std::function<bool()>& condition) {
  for (int wait = 0; wait < 30000; ++wait) {
    if (condition()) return true;
    std::this_thread::sleep_for(1ms);
  }
  return false;
}

Wrench DriverRig::Hand::tick(const DeviceState& state, double) noexcept {
  const std::lock_guard lock(mutex_);
  last_ = state;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(state.velocity[i]) > std::abs(fastest_[i])) fastest_[i] = state.velocity[i];
  }
  return wrench_;
}

void DriverRig::Hand::push(const Wrench& wrench) {
  const std::lock_guard lock(mutex_);
  wrench_ = wrench;
}

DeviceState DriverRig::Hand::last() const {
  const std::lock_guard lock(mutex_);
  return last_;
}

Vec3 DriverRig::Hand::fastest() const {
  const std::lock_guard lock(mutex_);
  return fastest_;
}

DriverRig::DriverRig(const DriverSubject& subject, std::chrono::milliseconds patience)
    : subject_(subject), port_(std::make_unique<DevicePort>(*subject.driver, "", subject.words(), patience)) {}

DriverRig::~DriverRig() {
  close();
  ended_ = true;
  if (servo_.joinable()) servo_.join();
}

void DriverRig::start() {
  port_->start(&hand_);
  if (port_->abilities().owns_loop) return;
  servo_ = std::thread([this, &port = *port_] {
    DeviceState state;
    Wrench wrench;
    while (!ended_) {
      port.exchange(wrench, state);
      if (state.fault == DeviceFault::not_connected) break;
      wrench = hand_.tick(state, 0.001);
      std::this_thread::sleep_for(50us);
    }
  });
}

void DriverRig::stop() {
  port_->stop();
  ended_ = true;
  if (servo_.joinable()) servo_.join();
  ended_ = false;
}

void DriverRig::close() {
  if (port_ == nullptr) return;
  ended_ = true;
  // A servo that hangs in a vendor's call is joined at the end, when the test has let the call return.
  if (servo_.joinable() && !subject_.board().troubled_by(Trouble::freeze)) servo_.join();
  port_.reset();
}

bool DriverRig::ticks(int count) {
  const stand_in::Board& board = subject_.board();
  const std::int64_t goal = board.ticks.load() + count;
  return comes_true([&] { return board.ticks.load() >= goal; });
}

bool DriverRig::fault(DeviceFault fault) {
  return comes_true([&] { return last().fault == fault; });
}

}  // namespace bodkin
