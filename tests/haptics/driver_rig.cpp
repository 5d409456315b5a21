#include "tests/haptics/driver_rig.h"

#include <cmath>
#include <stdexcept>

#include "tests/haptics/mocks/haply.h"
#include <dlfcn.h>

#include "haptics/drivers/drivers.h"

namespace bodkin {

using namespace bodkin::haptics;

using namespace std::chrono_literals;
using mock::Trouble;

namespace {

const std::string mocks = BODKIN_MOCKS;

Mat3 columns(const Vec3& x, const Vec3& y, const Vec3& z) {
  Mat3 matrix;
  matrix << x, y, z;
  return matrix;
}

void without_symbol(DriverSubject& subject, const std::string& library, const std::string& symbol) {
  subject.absent = "library=/nowhere/lib.so";
  subject.absent_message = {"/nowhere/lib.so"};
  subject.unfit = "library=" + library;
  subject.unfit_message = {library, symbol};
}

DriverSubject force_dimension() {
  DriverSubject subject;
  subject.name = "force_dimension";
  subject.library = mocks + "/force_dimension/libdrd.so";
  without_symbol(subject, mocks + "/force_dimension_broken/libdrd.so", "dhdEnableForce");
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
  subject.library = mocks + "/openhaptics/libHD.so";
  without_symbol(subject, mocks + "/openhaptics_broken/libHD.so", "hdDisable");
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
                     {Trouble::wrong_version, DeviceFault::wrong_version}};
  subject.in_loop = {{Trouble::unplug, DeviceFault::communication_lost},
                     {Trouble::not_a_number, DeviceFault::bad_data},
                     {Trouble::hot, DeviceFault::overheated},
                     {Trouble::too_fast, DeviceFault::velocity_limit},
                     {Trouble::too_much_force, DeviceFault::force_limit},
                     {Trouble::uncalibrated, DeviceFault::not_calibrated},
                     {Trouble::device_fault, DeviceFault::vendor_error},
                     {Trouble::unknown_code, DeviceFault::vendor_error}};
  return subject;
}

DriverSubject haption() {
  DriverSubject subject;
  subject.name = "haption";
  subject.library = mocks + "/haption/libVirtuoseAPI.so";
  without_symbol(subject, mocks + "/haption_broken/libVirtuoseAPI.so", "virtStopLoop");
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
                     {Trouble::no_power, DeviceFault::emergency_stop},
                     {Trouble::unknown_code, DeviceFault::vendor_error}};
  return subject;
}

DriverSubject haply() {
  static mock::Board other_board;
  static const mock::HaplyService service(mock::board());
  static const mock::HaplyService old_service(other_board, {.version = "2.9.1"});
  DriverSubject subject;
  subject.name = "haply";
  subject.service = &mock::board();
  subject.settings =
      "port=" + std::to_string(service.port()) + " dead_man=c silence_ms=1000";  // a busy machine is no fault
  subject.absent = "port=1";
  subject.absent_message = {"localhost:1", "haply-inverse-service"};
  subject.unfit = "port=" + std::to_string(old_service.port());
  subject.unfit_message = {"2.9.1", "3.0 or newer"};
  // X right, Y away, Z up; m; the middle of the workspace is at (0, -0.15, 0.2).
  subject.origin_vendor = {0.0, -0.15, 0.20};
  subject.pushed_vendor = {0.01, -0.13, 0.23};
  subject.pushed = {10, 20, 30};
  subject.left_vendor = columns(Vec3::UnitY(), -Vec3::UnitX(), Vec3::UnitZ());
  subject.force_vendor = {1, 2, 3};
  subject.torque_vendor = Vec3::Zero();
  subject.reports_freeze = true;
  subject.at_open = {{Trouble::no_device, DeviceFault::not_connected},
                     {Trouble::wrong_version, DeviceFault::wrong_version},
                     {Trouble::uncalibrated, DeviceFault::not_calibrated}};
  subject.in_loop = {{Trouble::unplug, DeviceFault::communication_lost},
                     {Trouble::not_a_number, DeviceFault::bad_data},
                     {Trouble::emergency_stop, DeviceFault::emergency_stop},
                     {Trouble::uncalibrated, DeviceFault::not_calibrated},
                     {Trouble::unknown_code, DeviceFault::vendor_error}};
  return subject;
}

}  // namespace

void PrintTo(const DriverSubject& subject, std::ostream* to) {
  *to << subject.name;
}

const std::vector<DriverSubject>& driver_subjects() {
  static const std::vector<DriverSubject> all = [] {
    std::vector<DriverSubject> subjects = {openhaptics(), force_dimension(), haption(), haply()};
    for (DriverSubject& subject : subjects) {
      subject.driver = find_driver(subject.name);
      subject.force = {1, 2, 3};
      subject.torque = {10, 20, 30};
    }
    return subjects;
  }();
  return all;
}

const DriverSubject& driver_subject(const std::string& name) {
  for (const DriverSubject& one : driver_subjects()) {
    if (one.name == name) return one;
  }
  throw std::out_of_range(name);
}

mock::Board& DriverSubject::board() const {
  if (service != nullptr) return *service;
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) throw std::runtime_error(dlerror());
  const auto entry = reinterpret_cast<mock::Board* (*)()>(dlsym(handle, "bodkin_mock"));
  return *entry();
}

DriverRig::DriverRig(const DriverSubject& subject, std::chrono::milliseconds patience)
    : DeviceLoop(DevicePort(*subject.driver, "", subject.words(), patience)), subject_(subject) {}

DriverRig::~DriverRig() {
  close();
}

void DriverRig::close() {
  DeviceLoop::close(subject_.board().troubled_by(Trouble::freeze));
}

bool DriverRig::ticks(int count) {
  const mock::Board& board = subject_.board();
  const std::int64_t goal = board.ticks.load() + count;
  return comes_true([&] { return board.ticks.load() >= goal; });
}

bool DriverRig::fault(DeviceFault fault) {
  return comes_true([&] { return last().fault == fault; });
}

}  // namespace bodkin
