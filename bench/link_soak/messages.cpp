#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <span>
#include <thread>
#include <vector>

#include "bench/link_soak/measurements.h"
#include "bench/link_soak/parts.h"
#include "link/contents.h"

namespace link_soak {

using namespace bodkin::link;
using namespace std::chrono_literals;
using Steady = std::chrono::steady_clock;

// The messages of a session, 60 times a second.
std::array<Message, 5> frame_of_a_session() {
  const std::vector<double> ticks(17 * 6, 1.0), state(24, 1.0), force(3, 1.0);
  const auto energy = std::span(force).first(1);
  return {{{"TRANSFORM", "NeedleTipToReference", 0.0, transform_content(bodkin::Pose::Identity())},
           {"NDARRAY", "NeedleState", 0.0, array_content(state, 24)},
           {"NDARRAY", "Force", 0.0, array_content(ticks, 6)},
           {"SENSOR", "ForceOnHand", 0.0, sensor_content(force, SensorUnit::newton)},
           {"SENSOR", "EnergyOfHand", 0.0, sensor_content(energy, SensorUnit::millijoule)}}};
}

int measure_messages(std::uint64_t count) {
  Server server(free_port());
  std::atomic<std::uint64_t> taken{0};
  const Client client(client_of(server.port()), {.message = [&](const Message& message) {
                        if (message.type != "STATUS") taken.fetch_add(1, std::memory_order_relaxed);
                      }});
  while (server.counts().clients == 0) std::this_thread::sleep_for(1ms);
  const std::array<Message, 5> frame = frame_of_a_session();
  const auto begin = Steady::now();
  double early = 0.0;
  for (std::uint64_t sent = 0; sent < count; ++sent) {
    constexpr std::uint64_t ahead = 4000;
    while (sent > taken.load(std::memory_order_relaxed) + ahead) std::this_thread::sleep_for(1ms);
    server.publish(frame[sent % frame.size()], false);
    if (sent == count / 20) early = memory_held();
    if (sent % (count / 10) == count / 10 - 1) {
      std::printf("%llu messages, %.1f MiB\n", static_cast<unsigned long long>(sent + 1), memory_held());
      std::fflush(stdout);
    }
  }
  while (taken < count && Steady::now() - begin < 3600s) std::this_thread::sleep_for(1ms);
  const double seconds = std::chrono::duration<double>(Steady::now() - begin).count(), late = memory_held();
  std::printf(
      "%llu messages in %.1f s (%.1f hours of a session at 300 a second), %llu arrived; memory %.1f MiB after a "
      "twentieth, %.1f MiB at the end\n",
      static_cast<unsigned long long>(count), seconds, static_cast<double>(count) / 300.0 / 3600.0,
      static_cast<unsigned long long>(taken.load()), early, late);
  return taken == count && late < early + 1.0 ? 0 : 1;
}

}  // namespace link_soak
