#include "fem/moving/body_thread.h"

#include <chrono>
#include <exception>
#include <new>
#include <string_view>
#include <utility>

namespace bodkin::fem {

namespace {

constexpr double default_step_time = 1.0 / 60.0;  // s, of a static body (dt = 0)
constexpr std::chrono::milliseconds time_poll{1};
constexpr std::chrono::milliseconds work_poll{3};

struct Ended : std::exception {};  // thrown from the progress of a corridor when the object is destroyed

BodySnapshot empty_snapshot(std::size_t nodes) {
  BodySnapshot snapshot;
  snapshot.displacements.assign(3 * nodes, 0.0F);
  return snapshot;
}

}  // namespace

BodyThread::BodyThread(const BodyDescription& body, const BodySolverSettings& settings, CorridorTaker take_corridor)
    : solver_(body, settings),
      take_corridor_(std::move(take_corridor)),
      step_time_(settings.motion.dt > 0.0 ? settings.motion.dt : default_step_time),
      next_(empty_snapshot(body.mesh.nodes.size())),
      snapshots_(next_),
      maker_([this](const std::stop_token& stop) { make_corridors(stop); }),
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
    request_corridor();
    publish_snapshot();
  }
}

void BodyThread::make_corridors(const std::stop_token& stop) noexcept {
  while (!stop.stop_requested()) {
    if (corridor_.load(std::memory_order_acquire) == Corridor::wanted) {
      const bool made = make_corridor(stop);
      corridor_.store(made ? Corridor::made : Corridor::failed, std::memory_order_release);
    }
    std::this_thread::sleep_for(work_poll);
  }
}

void BodyThread::make_step() noexcept {
  const std::optional<Pose>& probe = probe_.read();
  const bool fault = solver_.step(probe, needle_.read()).fault;
  ++next_.steps;
  ProbeReading reading;
  reading.on_probe = solver_.press().on_probe(solver_.body());
  if (probe) reading.probe = probe->translation();
  reading.nodes = static_cast<std::uint32_t>(solver_.press().held());
  reading.steps = next_.steps;
  readings_.write(reading);
  next_.on_probe = reading.on_probe;
  next_.probe_nodes = reading.nodes;
  if (fault) faults_.store(++next_.faults, std::memory_order_release);
}

// Records the result of the last request, and requests the next corridor when one is due.
void BodyThread::request_corridor() noexcept {
  const Corridor now = corridor_.load(std::memory_order_acquire);
  if (now == Corridor::wanted) return;
  if (now != Corridor::idle) {
    next_.corridor_failed = now == Corridor::failed;
    if (now == Corridor::made) ++next_.corridors;
    corridor_.store(Corridor::idle, std::memory_order_relaxed);
  }
  const bool moves = solver_.settled() && move_asked_.load(std::memory_order_acquire);
  if (!moves && !solver_.corridor_is_due()) return;
  try {
    solver_.take_state(state_);
    move_asked_.store(false, std::memory_order_relaxed);  // the maker sees nodes_
    corridor_.store(Corridor::wanted, std::memory_order_release);
  } catch (const std::bad_alloc&) {
    next_.corridor_failed = true;
  }
}

bool BodyThread::make_corridor(const std::stop_token& stop) noexcept {
  bool moves = false;
  try {
    std::vector<std::uint32_t> nodes;
    {
      const std::lock_guard lock(moving_);
      nodes.swap(nodes_);
    }
    moves = !nodes.empty();
    const auto check_stop = [&stop](std::string_view, double) {
      if (stop.stop_requested()) throw Ended();
    };
    std::shared_ptr<anatomy::CondensedBody> corridor = solver_.make_corridor(state_, check_stop, std::move(nodes));
    if (corridor != nullptr) {
      take_corridor_(std::move(corridor));
      return true;
    }
  } catch (const std::exception&) {
  }
  if (moves) move_failed_.store(true, std::memory_order_release);
  return false;
}

void BodyThread::move_corridor(std::vector<std::uint32_t> nodes) {
  const std::lock_guard lock(moving_);
  nodes_ = std::move(nodes);
  move_failed_.store(false, std::memory_order_release);
  move_asked_.store(true, std::memory_order_release);
}

void BodyThread::publish_snapshot() noexcept {
  const CorotationalBody& body = solver_.body();
  for (std::uint32_t node = 0; node < body.nodes(); ++node) {
    const Vec3 moved = body.position(node) - body.at_rest(node);
    for (std::size_t i = 0; i < 3; ++i)
      next_.displacements[3 * node + i] = static_cast<float>(moved[static_cast<Eigen::Index>(i)]);
  }
  next_.settled = solver_.settled();
  snapshots_.write(next_);
}

}  // namespace bodkin::fem
