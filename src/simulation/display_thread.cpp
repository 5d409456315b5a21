#include "simulation/display_thread.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "core/settings_check.h"

namespace bodkin::simulation {

namespace {

double checked_rate(double rate) {
  check_range("display", "rate", rate, {1.0, 1000.0}, "Hz");
  return rate;
}

}  // namespace

DisplayThread::DisplayThread(fem::DisplayField field, double rate)
    : DisplayThread(std::make_unique<fem::GrowingField>(std::move(field)), rate) {}

DisplayThread::DisplayThread(std::unique_ptr<fem::GrowingField> field, double rate)
    : field_(std::move(field)),
      snapshots_(DisplaySnapshot{0, 0, std::vector<float>(3 * field_->points(), 0.0F), 0.0}),
      thread_([this, pace = checked_rate(rate)](const std::stop_token& stop) { run(stop, pace); }) {}

void DisplayThread::hold(std::span<const std::uint32_t> nodes) {
  if (std::ranges::equal(nodes, reported_held_)) return;
  reported_held_.assign(nodes.begin(), nodes.end());
  held_.write(reported_held_);
}

void DisplayThread::show(std::unique_ptr<fem::GrowingField> field) {
  at_rest_.displacements.assign(3 * field->points(), 0.0F);
  ++at_rest_.field;
  const std::lock_guard guard(lock_);
  next_ = std::move(field);
  next_field_ = at_rest_.field;
}

const DisplaySnapshot& DisplayThread::snapshot() noexcept {
  const DisplaySnapshot& newest = snapshots_.read();
  return newest.field == at_rest_.field ? newest : at_rest_;
}

bool DisplayThread::take_next(DisplaySnapshot& now) {
  std::unique_ptr<fem::GrowingField> next;
  {
    const std::lock_guard guard(lock_);
    if (next_ == nullptr) return false;
    next = std::move(next_);
    now.field = next_field_;
  }
  field_ = std::move(next);
  now.displacements.assign(3 * field_->points(), 0.0F);
  return true;
}

void DisplayThread::run(const std::stop_token& stop, double rate) {
  const auto interval =
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(1.0 / rate));
  DisplaySnapshot now{0, 0, std::vector<float>(3 * field_->points(), 0.0F), 0.0};
  auto next = std::chrono::steady_clock::now();
  while (!stop.stop_requested()) {
    const fem::NodeForces& forces = forces_.read();
    const bool is_other = take_next(now);
    if (is_other || held_.is_fresh()) field_->hold(held_.read());
    field_->evaluate(forces, now.displacements);
    now.left_out = field_->left_out(forces);
    ++now.frame;
    snapshots_.write(now);
    next += interval;
    const auto time = std::chrono::steady_clock::now();
    if (next < time) next = time;  // a slow computer skips snapshots rather than falling behind
    std::this_thread::sleep_until(next);
  }
}

}  // namespace bodkin::simulation
