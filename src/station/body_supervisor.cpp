#include "station/body_supervisor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "patient/prepared_body.h"
#include <fmt/format.h>

#include "core/error.h"
#include "simulation/body_port.h"

namespace bodkin::station {

namespace {

constexpr std::chrono::milliseconds update_interval{100};
constexpr std::size_t most_node_corridors = 7;  // beside the first: each takes some 100 MB
constexpr double step_time_per_node = 2.5e-6;   // s on one core of 2.4 GHz (docs/corotational.md)
constexpr double slow_motion = 0.9;             // of the steps; fewer are reported

}  // namespace

std::string slow_motion_warning(std::size_t nodes) {
  const double step = step_time_per_node * static_cast<double>(nodes);
  if (step <= body_step_time) return {};
  return fmt::format(
      "the mesh has {} nodes, of which a step of the moving body takes about {:.0f} ms, and 60 steps a second leave "
      "{:.1f} ms: it will move in slow motion; a mesh of {:.0f} nodes keeps up",
      nodes, 1e3 * step, 1e3 * body_step_time, 1e3 * std::floor(1e-3 * body_step_time / step_time_per_node));
}

BodySupervisor::BodySupervisor(std::shared_ptr<const anatomy::Case> patient,
                               std::shared_ptr<const fem::BodyDescription> body, double length,
                               std::shared_ptr<const fem::ContactBody> kept)
    : patient_(std::move(patient)), body_(std::move(body)), whole_body_(std::move(kept)), length_(length) {
  const bool points = patient_->corridor.body != nullptr && patient_->corridor.body->has_contact_points();
  keeper_.emplace(patient_, body_, length, points ? simulation::BodyPort::most_corridors - 1 : most_node_corridors,
                  whole_body_);
}

BodySupervisor::BodySupervisor(std::shared_ptr<const anatomy::Case> patient, std::shared_ptr<PatientBody> moving)
    : patient_(std::move(patient)), moving_(std::move(moving)) {}

void BodySupervisor::stream_points(HandSession& session) {
  simulation::BodyPort* const port = session.body();
  if (port == nullptr || whole_body_ == nullptr) return;
  if (std::shared_ptr<fem::ContactLine> line = port->stream_points(false))
    stream_ = patient::contact_stream(*body_, patient_, length_, whole_body_, std::move(line));
}

std::vector<std::string> BodySupervisor::update(HandSession& session) {
  std::vector<std::string> news;
  const auto now = std::chrono::steady_clock::now();
  if (now - updated_ < update_interval) return news;
  updated_ = now;
  if (moving_ != nullptr) {
    update_moving(session, news);
  } else {
    update_static(session, news);
  }
  return news;
}

void BodySupervisor::update_static(HandSession& session, std::vector<std::string>& news) {
  if (stream_ != nullptr) return;  // the tick asks for its needle's line itself
  const HandSnapshot& now = session.snapshot();
  if (now.ticks == 0) return;
  CorridorKeeper::News found = keeper_->update(now.needle, now.ticks - 1);
  if (found.ready) session.body()->add_corridor(*found.ready);
  if (found.sentence) news.push_back(std::move(*found.sentence));
}

void BodySupervisor::update_moving(HandSession& session, std::vector<std::string>& news) {
  const fem::BodySnapshot& body = moving_->snapshot();
  steps_ = body.steps;
  most_probe_nodes_ = std::max(most_probe_nodes_, body.probe_nodes);
  if (moving_->failed()) {
    if (!std::exchange(failed_, true)) {
      news.emplace_back(
          "the moving body failed: the probe loses its force, and the needle meets the body at rest from now on");
    }
    return;
  }
  if (body.corridor_failed && !std::exchange(corridor_failed_, true))
    news.emplace_back("the corridor of the pressed body could not be made: the needle feels the one before");
  const HandSnapshot& needle = session.snapshot();
  if (needle.ticks > 0) {
    if (std::optional<std::string> sentence = moving_->follow(needle.needle, *patient_))
      news.push_back(std::move(*sentence));
  }
  const std::optional<anatomy::PreparedCorridor> corridor = moving_->take_corridor();
  if (!corridor) return;
  try {
    session.body()->refresh_corridor(*corridor);
    if (corridors_++ == 0) {
      news.emplace_back(
          "the body is pressed: the needle feels that, whether it is in or enters, as after every press");
    }
  } catch (const InputError& error) {
    news.push_back(fmt::format("the needle cannot enter the body as it is pressed: {}", error.what()));
  }
}

std::vector<std::string> BodySupervisor::summary(double time) const {
  if (moving_ == nullptr) return {};
  std::vector<std::string> sentences;
  if (most_probe_nodes_ == 0) {
    sentences.emplace_back(
        "the probe met no node of the mesh: it was not pressed in, or its face is smaller than the mesh is fine; "
        "give --body \"moving thickness_mm=30\", or make a finer mesh");
  }
  const double rate = static_cast<double>(steps_) / time;
  sentences.push_back(fmt::format("the body moved {:.0f} times a second{} and gave the needle {} corridor{}", rate,
                                  rate < slow_motion / body_step_time ? " instead of 60, in slow motion," : "",
                                  corridors_, corridors_ == 1 ? "" : "s"));
  return sentences;
}

}  // namespace bodkin::station
