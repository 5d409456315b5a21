#include "fem/moving/moving_body.h"

#include <chrono>
#include <exception>
#include <utility>

namespace bodkin {

namespace {

constexpr double pace_without_time = 1.0 / 60.0;  // s of a step of a body that has none of its own
constexpr std::chrono::milliseconds look_for_time{1};

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
    show();
    if (!pressed_.corridor_is_due()) continue;
    next_.corridor_failed = !make_corridor();
    if (!next_.corridor_failed) ++next_.corridors;
    show();
  }
}

void MovingBody::make_step() noexcept {
  if (pressed_.step(probe_.read(), needle_.read()).fault) ++next_.faults;
  ++next_.steps;
}

bool MovingBody::make_corridor() noexcept {
  try {
    std::shared_ptr<const CondensedBody> corridor = pressed_.make_corridor();
    if (corridor == nullptr) return false;
    take_corridor_(std::move(corridor));
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

void MovingBody::show() noexcept {
  const CorotationalBody& body = pressed_.body();
  for (std::uint32_t node = 0; node < body.nodes(); ++node) {
    const Vec3 moved = body.position(node) - body.at_rest(node);
    for (std::size_t i = 0; i < 3; ++i)
      next_.displacements[3 * node + i] = static_cast<float>(moved[static_cast<Eigen::Index>(i)]);
  }
  next_.on_probe = pressed_.press().on_probe(body);
  next_.probe_nodes = static_cast<std::uint32_t>(pressed_.press().held());
  next_.settled = pressed_.settled();
  picture_.write(next_);
}

}  // namespace bodkin
