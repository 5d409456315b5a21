#include "simulation/display_thread.h"

#include <chrono>
#include <string>
#include <utility>

#include "core/error.h"

namespace bodkin::simulation {

namespace {

double checked_rate(double rate) {
  if (rate >= 1.0 && rate <= 1000.0) return rate;
  throw InputError("display: " + std::to_string(rate) + " snapshots a second, expected 1 to 1000");
}

}  // namespace

DisplayThread::DisplayThread(fem::DisplayField field, double rate)
    : field_(std::move(field)),
      snapshots_(DisplaySnapshot{0, std::vector<float>(3 * field_.points(), 0.0F), 0.0}),
      thread_([this, pace = checked_rate(rate)](const std::stop_token& stop) { run(stop, pace); }) {}

void DisplayThread::run(const std::stop_token& stop, double rate) {
  const auto interval =
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(1.0 / rate));
  DisplaySnapshot now{0, std::vector<float>(3 * field_.points(), 0.0F), 0.0};
  auto next = std::chrono::steady_clock::now();
  while (!stop.stop_requested()) {
    const fem::NodeForces& forces = forces_.read();
    field_.evaluate(forces, now.displacements);
    now.left_out = field_.left_out(forces);
    ++now.frame;
    snapshots_.write(now);
    next += interval;
    const auto time = std::chrono::steady_clock::now();
    if (next < time) next = time;  // a slow computer skips snapshots rather than falling behind
    std::this_thread::sleep_until(next);
  }
}

}  // namespace bodkin::simulation
