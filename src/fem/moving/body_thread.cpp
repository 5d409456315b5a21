#include "fem/moving/body_thread.h"

#include <chrono>

#include "fem/solid/body_digests.h"

namespace bodkin::fem {

namespace {

constexpr double default_step_time = 1.0 / 60.0;  // s, of a static body (dt = 0)
constexpr std::chrono::milliseconds time_poll{1};
constexpr std::size_t kept_steps = 4096;  // a minute's worth, for the recorder of steps

BodySnapshot empty_snapshot(std::size_t nodes, std::size_t most_held) {
  BodySnapshot snapshot;
  snapshot.displacements.assign(3 * nodes, 0.0F);
  snapshot.held.assign(most_held, 0);
  return snapshot;
}

}  // namespace

BodyThread::BodyThread(const BodyDescription& body, const BodySolverSettings& settings,
                       const std::optional<anatomy::BreathField>& breath)
    : solver_(body, settings),
      step_time_(settings.motion.dt > 0.0 ? settings.motion.dt : default_step_time),
      breath_(breath),
      next_(empty_snapshot(body.mesh.nodes.size(), solver_.press().surface().size())),
      snapshots_(next_),
      field_(field_at_rest(solver_)),
      motion_(std::make_shared<BodyMotion>(field_)),
      steps_(std::make_shared<BodySteps>(kept_steps)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void BodyThread::run(const std::stop_token& stop) noexcept {
  double done = 0.0;  // s
  while (!stop.stop_requested()) {
    const double now = time_.load(std::memory_order_relaxed);
    if (!(now - done >= step_time_)) {
      if (now < done) done = now;  // the clock was set back
      std::this_thread::sleep_for(time_poll);
      continue;
    }
    done = now - done < 2.0 * step_time_ ? done + step_time_ : now;
    make_step();
    publish();
  }
}

void BodyThread::make_step() noexcept {
  const std::optional<Pose>& probe = probe_.read();
  probe_of_step_ = probe;
  if (probe && breath_ && probe->matrix().allFinite()) {
    probe_of_step_->translation() =
        breath_->material(probe->translation(), drawn_in_.load(std::memory_order_relaxed));
  }
  const bool fault = solver_.step(probe_of_step_).fault;
  ++next_.steps;
  ProbeReading reading;
  reading.on_probe = solver_.press().on_probe(solver_.body());
  reading.by_needle = solver_.press().from_middle(by_needle_.read(), solver_.body());
  reading.on_probe.force += reading.by_needle.force;
  reading.on_probe.torque += reading.by_needle.torque;
  if (probe) reading.probe = probe->translation();
  reading.nodes = static_cast<std::uint32_t>(solver_.press().held());
  reading.steps = next_.steps;
  readings_.write(reading);
  next_.on_probe = reading.on_probe;
  next_.probe_nodes = reading.nodes;
  if (!fault) return;
  ++next_.faults;
  failed_.store(true, std::memory_order_release);
}

void BodyThread::publish() noexcept {
  const bool failed = failed_.load(std::memory_order_relaxed);
  read_field(solver_, failed, field_);
  if (!failed) next_.displacements = field_.moved;
  next_.held = field_.held;
  next_.held_count = field_.held_count;
  snapshots_.write(next_);
  steps_->push({field_.step, probe_of_step_, digest_of(field_.moved)});
  motion_->write(field_);
}

}  // namespace bodkin::fem
