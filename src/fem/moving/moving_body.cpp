#include "fem/moving/moving_body.h"

#include <chrono>
#include <exception>
#include <new>
#include <string_view>
#include <utility>

namespace bodkin {

namespace {

constexpr double pace_without_time = 1.0 / 60.0;  // s of a step of a body that has none of its own
constexpr std::chrono::milliseconds look_for_time{1};
constexpr std::chrono::milliseconds look_for_work{3};

struct Ended : std::exception {};  // the body is no longer wanted, nor is the corridor that is being made

BodyPicture empty_picture(std::size_t nodes) {
  BodyPicture picture;
  picture.displacements.assign(3 * nodes, 0.0F);
  return picture;
}

}  // namespace

MovingBody::MovingBody(const BodyDescription& body, const PressedBodySettings& settings, CorridorTaker take_corridor)
    : pressed_(body, settings),
      take_corridor_(std::move(take_corridor)),
      pace_(settings.motion.dt > 0.0 ? settings.motion.dt : pace_without_time),
      next_(empty_picture(body.mesh.nodes.size())),
      picture_(next_),
      maker_([this](const std::stop_token& stop) { make_corridors(stop); }),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void MovingBody::run(const std::stop_token& stop) noexcept {
  double done = 0.0;  // s
  while (!stop.stop_requested()) {
    const double now = time_.load(std::memory_order_relaxed);
    if (!(now - done >= pace_)) {
      if (now < done) done = now;  // time began anew
      std::this_thread::sleep_for(look_for_time);
      continue;
    }
    done = now - done < 2.0 * pace_ ? done + pace_ : now;
    make_step();
    ask_for_corridor();
    show();
  }
}

void MovingBody::make_corridors(const std::stop_token& stop) noexcept {
  while (!stop.stop_requested()) {
    if (corridor_.load(std::memory_order_acquire) == Corridor::wanted) {
      const bool made = make_corridor(stop);
      corridor_.store(made ? Corridor::made : Corridor::failed, std::memory_order_release);
    }
    std::this_thread::sleep_for(look_for_work);
  }
}

void MovingBody::make_step() noexcept {
  const std::optional<Pose>& probe = probe_.read();
  const bool fault = pressed_.step(probe, needle_.read()).fault;
  ++next_.steps;
  ProbeReading reading;
  reading.on_probe = pressed_.press().on_probe(pressed_.body());
  if (probe) reading.probe = probe->translation();
  reading.nodes = static_cast<std::uint32_t>(pressed_.press().held());
  reading.steps = next_.steps;
  reading_.write(reading);
  next_.on_probe = reading.on_probe;
  next_.probe_nodes = reading.nodes;
  if (fault) faults_.store(++next_.faults, std::memory_order_release);
}

// Hears of the corridor that was asked for before, and asks for the next when one is due.
void MovingBody::ask_for_corridor() noexcept {
  const Corridor now = corridor_.load(std::memory_order_acquire);
  if (now == Corridor::wanted) return;
  if (now != Corridor::idle) {
    next_.corridor_failed = now == Corridor::failed;
    if (now == Corridor::made) ++next_.corridors;
    corridor_.store(Corridor::idle, std::memory_order_relaxed);
  }
  const bool led = pressed_.settled() && led_.load(std::memory_order_acquire);
  if (!led && !pressed_.corridor_is_due()) return;
  try {
    pressed_.take_state(state_);
    led_.store(false, std::memory_order_relaxed);  // the maker sees the nodes: who has led it waits for none of us
    corridor_.store(Corridor::wanted, std::memory_order_release);
  } catch (const std::bad_alloc&) {
    next_.corridor_failed = true;
  }
}

bool MovingBody::make_corridor(const std::stop_token& stop) noexcept {
  bool led = false;
  try {
    std::vector<std::uint32_t> nodes;
    {
      const std::lock_guard lock(leading_);
      nodes.swap(led_to_);
    }
    led = !nodes.empty();
    const auto go_on = [&stop](std::string_view, double) {
      if (stop.stop_requested()) throw Ended();
    };
    std::shared_ptr<CondensedBody> corridor = pressed_.make_corridor(state_, go_on, std::move(nodes));
    if (corridor != nullptr) {
      take_corridor_(std::move(corridor));
      return true;
    }
  } catch (const std::exception&) {
  }
  if (led) lead_failed_.store(true, std::memory_order_release);
  return false;
}

void MovingBody::lead_corridor(std::vector<std::uint32_t> nodes) {
  const std::lock_guard lock(leading_);
  led_to_ = std::move(nodes);
  lead_failed_.store(false, std::memory_order_release);
  led_.store(true, std::memory_order_release);
}

void MovingBody::show() noexcept {
  const CorotationalBody& body = pressed_.body();
  for (std::uint32_t node = 0; node < body.nodes(); ++node) {
    const Vec3 moved = body.position(node) - body.at_rest(node);
    for (std::size_t i = 0; i < 3; ++i)
      next_.displacements[3 * node + i] = static_cast<float>(moved[static_cast<Eigen::Index>(i)]);
  }
  next_.settled = pressed_.settled();
  picture_.write(next_);
}

}  // namespace bodkin
