// The servo in real time for any duration: a hand on a simulated device goes into the slabs and out again, on
// ServoThread's own thread. `servo_soak SECONDS [DEVICE]` prints its timing and the guard's interventions.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>
#include <thread>

#include "tests/simulation/safety_rig.h"

#include "haptics/servo_thread.h"

namespace {

using namespace bodkin;
using namespace bodkin::anatomy;
using namespace bodkin::haptics;
using namespace bodkin::simulation;

struct Soak {
  explicit Soak(HandOnDevice& hand) : mechanism(hand) {}

  void exchange(const Wrench& command, DeviceState& state) {
    const double time = 0.001 * static_cast<double>(rounds++);
    const double depth = time < 2.0 ? -5.0 : 20.0 - 25.0 * std::cos(0.5 * (time - 2.0));
    mechanism.step(Vec3(0.0, 0.0, SafetyRig::middle - depth), command.force, 0.001);
    largest = std::max(largest, command.force.norm());
    finite = finite && command.force.allFinite();
    state.hand.linear() = Eigen::AngleAxisd(std::acos(-1.0), Vec3::UnitX()).toRotationMatrix();
    state.hand.translation() = mechanism.reading() + Vec3(1e-7 * static_cast<double>(rounds % 2), 0.0, 0.0);
  }

  HandOnDevice& mechanism;
  std::uint64_t rounds = 0;
  double largest = 0.0;
  bool finite = true;
};

void print(const char* what, const LatencyHistogram& times) {
  std::printf("%s: median %.1f us, 99 %% %.1f us, 99.9 %% %.1f us, maximum %.3f ms\n", what,
              1e6 * times.percentile(0.5), 1e6 * times.percentile(0.99), 1e6 * times.percentile(0.999),
              1e3 * times.maximum());
}

int run(double seconds, const std::string& name) {
  const auto devices = devices_with_force();
  const DeviceProfile* device = find_profile(devices, name);
  if (device == nullptr) {
    std::fprintf(stderr, "there is no device %s in share/bodkin/devices.csv\n", name.c_str());
    return 2;
  }
  // The rig's own servo has no clock; this one has.
  SafetyRig rig(all_resistances().front(), all_constraints().front(), *device, 1);
  const Case patient = patient_on(all_resistances().front(), all_constraints().front(), rig.abilities);
  HapticTick tissue(patient);
  ServoSettings settings;
  settings.guard = guard_settings(rig.abilities, 1000.0);
  settings.workspace.rotation = Eigen::AngleAxisd(std::acos(-1.0), Vec3::UnitX()).toRotationMatrix();
  settings.workspace.centre = Vec3(0.0, 0.0, SafetyRig::middle);
  const auto servo = std::make_shared<ServoTick>(settings, [&tissue](const ControlInput& input) {
    return Control{tissue.step({input.needle}).applied, 0.0};
  });
  const auto soak = std::make_shared<Soak>(rig.hand);
  ServoThread thread(
      {}, [soak](const Wrench& command, DeviceState& state) { soak->exchange(command, state); },
      [servo](const DeviceState& state, double dt, double late) { return servo->step(state, dt, late); });
  thread.start();
  for (const std::string& sentence : thread.refused()) std::printf("%s\n", sentence.c_str());
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  int events[static_cast<int>(GuardReason::count_of_reasons)] = {};
  while (std::chrono::steady_clock::now() < end) {
    const GuardState state = servo->snapshot().state;
    if (state == GuardState::disarmed || state == GuardState::faulted) {
      servo->command({.kind = ServoCommand::Kind::arm});
    }
    GuardEvent event;
    while (servo->next_event(event)) ++events[static_cast<int>(event.reason)];
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  if (!thread.stop()) return 1;
  const ServoTimings& timings = servo->timings();
  std::printf("%s: %llu ticks, %llu overruns, largest force %.3f N of %.3f N, %s\n", device->name.c_str(),
              static_cast<unsigned long long>(timings.ticks), static_cast<unsigned long long>(timings.overruns),
              soak->largest, rig.bound, soak->finite ? "all finite" : "NOT FINITE");
  print("lateness", timings.lateness);
  print("tick", timings.compute);
  for (int i = 1; i < static_cast<int>(GuardReason::count_of_reasons); ++i) {
    if (events[i] > 0) std::printf("%d times: %s\n", events[i], text_of(static_cast<GuardReason>(i)).data());
  }
  return soak->finite && soak->largest <= rig.bound ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  try {
    return run(count > 1 ? std::atof(words[1]) : 60.0, count > 2 ? words[2] : "Touch");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
