#include "station/body_supervisor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "patient/prepared_body.h"
#include <fmt/format.h>

#include "simulation/body_port.h"

namespace bodkin::station {

namespace {

constexpr double step_time_per_node = 2.5e-6;  // s on one core of 2.4 GHz (docs/corotational.md)
constexpr double slow_motion = 0.9;            // of the steps; fewer are reported

}  // namespace

std::string slow_motion_warning(std::size_t nodes) {
  const double step = step_time_per_node * static_cast<double>(nodes);
  if (step <= body_step_time) return {};
  return fmt::format(
      "with {} nodes in the mesh a step of the moving body takes about {:.0f} ms, but 60 steps a second allow only "
      "{:.1f} ms: it will move in slow motion; a mesh of {:.0f} nodes keeps up",
      nodes, 1e3 * step, 1e3 * body_step_time, 1e3 * std::floor(1e-3 * body_step_time / step_time_per_node));
}

BodySupervisor::BodySupervisor(std::shared_ptr<const anatomy::Case> patient,
                               std::shared_ptr<const fem::BodyDescription> body, double length,
                               std::shared_ptr<const fem::ContactBody> kept, std::shared_ptr<fem::BodyThread> moving)
    : patient_(std::move(patient)),
      body_(std::move(body)),
      whole_body_(std::move(kept)),
      length_(length),
      moving_(std::move(moving)) {}

void BodySupervisor::attach(HandSession& session) {
  simulation::BodyPort* const port = session.body();
  if (port == nullptr || whole_body_ == nullptr) return;
  if (moving_ != nullptr) session.move_with(moving_);
  stream_ = patient::contact_stream(*body_, patient_, length_, whole_body_,
                                    port->stream_points(simulation::BodyPort::PointTiming::as_known));
}

std::vector<std::string> BodySupervisor::failures_of_points() const {
  return stream_ == nullptr ? std::vector<std::string>() : stream_->take_failures();
}

std::vector<std::string> BodySupervisor::update() {
  std::vector<std::string> news = failures_of_points();
  if (moving_ == nullptr) return news;
  const fem::BodySnapshot& body = moving_->snapshot();
  steps_ = body.steps;
  most_probe_nodes_ = std::max(most_probe_nodes_, body.probe_nodes);
  if (moving_->failed() && !std::exchange(failed_, true)) {
    news.emplace_back(
        "the moving body failed: the probe loses its force, and the needle meets the body at rest from now on");
  }
  return news;
}

std::vector<std::string> BodySupervisor::summary(double time) const {
  std::vector<std::string> sentences = failures_of_points();
  if (moving_ == nullptr) return sentences;
  if (most_probe_nodes_ == 0) {
    sentences.emplace_back(
        "the probe met no node of the mesh: it was not pressed in, or its face is smaller than the mesh's elements; "
        "give --body \"moving thickness_mm=30\", or make a finer mesh");
  }
  const double rate = static_cast<double>(steps_) / time;
  sentences.push_back(fmt::format("the body moved {:.0f} times a second{}", rate,
                                  rate < slow_motion / body_step_time ? " instead of 60, in slow motion" : ""));
  return sentences;
}

}  // namespace bodkin::station
