#include "session/body_displacement.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "fem/solid/body_digests.h"

namespace bodkin::session {

std::string moving_body_text(const fem::BodySolverSettings& settings, std::size_t nodes) {
  const fem::ProbeFace& face = settings.probe;
  nlohmann::ordered_json json{{"nodes", nodes},           {"width_mm", face.width}, {"thickness_mm", face.thickness},
                              {"radius_mm", face.radius}, {"reach_mm", face.reach}, {"step_s", settings.motion.dt}};
  if (!settings.left_needles.empty()) json["left_needles"] = settings.left_needles.size();
  return json.dump();
}

fem::BodySolverSettings moving_body_settings(const std::string& text, const std::vector<anatomy::NeedlePath>& left) {
  fem::BodySolverSettings settings;
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    json.at("width_mm").get_to(settings.probe.width);
    json.at("thickness_mm").get_to(settings.probe.thickness);
    json.at("radius_mm").get_to(settings.probe.radius);
    json.at("reach_mm").get_to(settings.probe.reach);
    json.at("step_s").get_to(settings.motion.dt);
    if (json.value("left_needles", std::size_t{0}) > 0) settings.left_needles = left;
  } catch (const nlohmann::json::exception&) {
    throw InputError(
        fmt::format("the session's moving_body is '{}', expected JSON with width_mm, thickness_mm, radius_mm, "
                    "reach_mm and step_s; "
                    "record it again",
                    text));
  }
  return settings;
}

void check_moved_body(const Session& session) {
  const auto moved = [](const SessionEvent& event) {
    return event.event.kind == forces::EventKind::moving_body_met ||
           event.event.kind == forces::EventKind::moving_body_failed;
  };
  const auto first = std::find_if(session.events.begin(), session.events.end(), moved);
  if (session.applied_body_steps.empty() && first == session.events.end()) return;
  const std::vector<AppliedBodyStep>& applied = session.applied_body_steps;
  bool complete = !applied.empty() && applied.back().step <= session.body_steps.size();
  for (std::size_t i = 0; complete && i < applied.size(); ++i) complete = applied[i].number == i;
  for (std::size_t i = 0; complete && i < applied.back().step; ++i) complete = session.body_steps[i].step == i + 1;
  if (complete) return;
  const std::uint64_t tick = first != session.events.end() ? first->tick : applied.front().tick;
  throw InputError(
      fmt::format("the session cannot be recomputed: at {:.3f} s its needle met a moving body (--body moving), of "
                  "which not every step was kept; 'bodkin report' and 'bodkin export' show what was felt",
                  static_cast<double>(tick) * session.header.dt));
}

BodyDisplacement::BodyDisplacement(const Session& session, const fem::BodyDescription* body,
                                   simulation::BodyPort* port)
    : session_(session), next_(session.applied_body_steps.begin()) {
  check_moved_body(session);
  if (session.applied_body_steps.empty()) return;
  if (body == nullptr || port == nullptr) {
    throw InputError(
        "the session's needle met a moving body, but there is no deformable body here; replay it with its own case");
  }
  solver_ = std::make_unique<fem::DeformableBodySolver>(
      *body, moving_body_settings(session.header.moving_body, session.header.left_needles));
  field_ = fem::field_at_rest(*solver_);
  motion_ = std::make_shared<fem::BodyMotion>(field_);
  if (!port->move_with(motion_)) {
    throw InputError(
        "the session's needle met a moving body, which its resistance does not feel here; record it again");
  }
}

void BodyDisplacement::step() noexcept {
  const fem::BodyStep& recorded = session_.body_steps[field_.step];
  failed_ = solver_->step(recorded.probe).fault || failed_;
  fem::read_field(*solver_, failed_, field_);
  if (different_ == 0 && fem::digest_of(field_.moved) != recorded.digest) different_ = field_.step;
}

void BodyDisplacement::prepare_for(std::uint64_t tick) noexcept {
  if (solver_ == nullptr || next_ == session_.applied_body_steps.end() || next_->tick != tick) return;
  while (field_.step < next_->step) step();
  motion_->write(field_);
  ++next_;
}

std::string BodyDisplacement::difference() const {
  if (different_ == 0) return {};
  return fmt::format(
      "the body that a probe pressed moved differently from the session from its step {} on: it was computed by "
      "another version of Bodkin",
      different_);
}

}  // namespace bodkin::session
