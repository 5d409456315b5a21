#include "app/models/recording.h"

#include <algorithm>
#include <utility>

#include "app/frame_maker.h"
#include "app/models/warnings.h"
#include "session/material_tip.h"
#include "station/left_needle_motion.h"
#include <fmt/format.h>

#include "core/error.h"
#include "training/attempt.h"
#include "training/case_score.h"
#include "training/expert_table.h"
#include "training/procedure_file.h"

namespace bodkin::app {

namespace {

constexpr double path_step = 0.25;  // mm between points of the way that is drawn

// The events to jump to; empty for technical ones.
std::string words_of(const forces::Event& event, const std::string& tissue) {
  using forces::EventKind;
  switch (event.kind) {
    case EventKind::contact:
      return "touches the skin";
    case EventKind::puncture:
      return fmt::format("{} gives", tissue);
    case EventKind::loss_of_resistance:
      return "loss of resistance";
    case EventKind::bone_contact:
      return "bone";
    case EventKind::fluid_returned:
      return "fluid";
    case EventKind::palpated:
      return "a place is felt";
    case EventKind::stylet_out:
      return "stylet out";
    case EventKind::pressure_read:
      return "pressure read";
    case EventKind::pressure_lost:
      return "plunger gives way";
    case EventKind::withdrawn:
      return "out of the body";
    case EventKind::fault:
      return "fault";
    default:
      return {};
  }
}

}  // namespace

Recording::Recording(std::filesystem::path file, session::Session session, std::shared_ptr<const OpenCase> patient,
                     bool is_same, std::string note, std::shared_ptr<ScanReplay> scan)
    : file_(std::move(file)),
      session_(std::move(session)),
      patient_(std::move(patient)),
      note_(std::move(note)),
      scan_(std::move(scan)) {
  if (session_.ticks.empty()) {
    throw InputError(fmt::format("{} holds no tick: the session ended before the device had answered; choose another",
                                 file_.string()));
  }
  for (const session::RecordedDiagnostic& each : session_.header.diagnostics)
    diagnostic_names_.push_back({each.name, each.title});
  samples_.reserve(size());
  in_body_.reserve(size());
  const auto dt = static_cast<float>(session_.header.dt);
  float in_body = 0.0F;
  for (std::size_t i = 0; i < size(); ++i) {
    const simulation::TickOutput& now = session_.ticks[i].output;
    const bool inside = now.depth > 0.0 && now.in_contact;
    if (inside) in_body += dt;
    in_body_.push_back(in_body);
    samples_.push_back({time(i), inside ? now.depth : 0.0, now.requested.force.norm(), now.resistance, now.constraint,
                        inside ? now.tissue : anatomy::tissue::air});
  }
  find_tissue_intervals();
  find_shown_events();
  judge(is_same);
}

std::size_t Recording::index_at(double time) const {
  const auto later = [&](double wanted, const simulation::TickRecord& record) {
    return wanted < static_cast<double>(record.tick) * session_.header.dt;
  };
  // Half a tick earlier or later counts as the same moment.
  const double wanted = time + 0.25 * session_.header.dt;
  const auto after = std::upper_bound(session_.ticks.begin(), session_.ticks.end(), wanted, later);
  return after == session_.ticks.begin() ? 0 : static_cast<std::size_t>(after - session_.ticks.begin()) - 1;
}

std::string Recording::tissue_title(anatomy::TissueId tissue) const {
  for (const session::TissueName& name : session_.header.tissues) {
    if (name.id == tissue) return name.title;
  }
  return fmt::format("tissue {}", tissue);
}

void Recording::find_tissue_intervals() {
  first_contact_ = begin();
  bool touched = false;
  const std::optional<anatomy::Breathing> breathing =
      patient_ == nullptr ? std::nullopt : patient_->description().breathing;
  session::MaterialTip material(breathing, session_.header.dt);
  for (std::size_t i = 0; i < size(); ++i) {
    const Vec3 tip = material.place_of(session_.ticks[i]);
    if (breathing) drawn_in_.push_back(static_cast<float>(material.drawn_in()));
    const anatomy::TissueId tissue = samples_[i].tissue;
    const bool inside = samples_[i].depth > 0.0;
    if (inside && !std::exchange(touched, true)) first_contact_ = time(i);
    const bool continues = !tissue_intervals_.empty() && tissue_intervals_.back().tissue == tissue &&
                           tissue_intervals_.back().last + 1 == i;
    if (continues) {
      tissue_intervals_.back().last = i;
    } else if (inside) {
      tissue_intervals_.push_back({i, i, tissue});
    }
    if (!inside) continue;
    if (!continues) {
      // Joined to the previous piece without a gap.
      const bool joined = tissue_intervals_.size() > 1 &&
                          tissue_intervals_[tissue_intervals_.size() - 2].last + 1 == i && !path_.empty();
      PathPiece piece{tissue, {}};
      if (joined) piece.points.push_back(path_.back().points.back());
      piece.points.push_back(tip);
      path_.push_back(std::move(piece));
    } else if ((tip - path_.back().points.back()).norm() >= path_step) {
      path_.back().points.push_back(tip);
    }
  }
}

void Recording::find_shown_events() {
  for (const session::SessionEvent& event : session_.events) {
    std::string words = words_of(event.event, tissue_title(event.event.tissue));
    if (words.empty()) continue;
    const double when = static_cast<double>(event.tick) * session_.header.dt;
    const bool bad =
        event.event.kind == forces::EventKind::bone_contact || event.event.kind == forces::EventKind::fault;
    shown_events_.push_back({index_at(when), when, event.event.depth, std::move(words), bad});
  }
}

void Recording::judge(bool is_same) {
  try {
    const anatomy::CaseDescription description = training::description_of(session_);
    if (!description.procedure.path) {
      not_judged_ = "This patient had no planned path, so there is nothing to judge by.";
      return;
    }
    plan_ = session_.header.path;
    if (is_same && patient_ != nullptr) {
      score_ = training::score_on_case(session_, patient_->patient);
      return;
    }
    const training::Procedure procedure = training::procedure_of_case(description.procedure.name);
    const auto experts = training::experts_of(procedure);
    score_ = training::score(session_, description, procedure, {}, experts ? &*experts : nullptr);
  } catch (const InputError& error) {
    not_judged_ = error.what();
  }
}

std::vector<LeftNeedle> Recording::left_needles(std::size_t index) const {
  const std::vector<anatomy::NeedlePath>& left = session_.header.left_needles;
  std::optional<anatomy::BreathField> breath;
  if (!drawn_in_.empty()) breath.emplace(*patient_->description().breathing);
  station::LeftNeedleMotion motion(left, breath);
  std::vector<LeftNeedle> found;
  for (const Pose& pose : motion.poses({}, drawn_in_.empty() ? 0.0 : static_cast<double>(drawn_in_[index])))
    found.push_back({pose, left[found.size()].length()});
  return found;
}

Frame Recording::frame(std::size_t index) const {
  const simulation::TickRecord& record = session_.ticks[index];
  StationUpdate news;
  news.time = time(index);
  news.needle.ticks = index + 1;
  news.needle.needle = record.input.needle;
  news.needle.output = record.output;
  if (!drawn_in_.empty()) news.needle.output.drawn_in = static_cast<double>(drawn_in_[index]);
  news.diagnostic_names = diagnostic_names_;
  // Punctured tissues and bone contact so far follow from the previous events.
  for (const session::SessionEvent& event : session_.events) {
    if (event.tick > record.tick) break;
    news.events.push_back(event);
  }
  FrameMaker maker;
  maker.begin(patient_, plan_);
  Frame frame;
  frame.follows_tip = true;
  maker.update(frame, news, nullptr, {});
  frame.state = State::ended;
  frame.time_in_body = in_body_[index];
  frame.crosshair = frame.needle.translation();
  frame.rate = 1.0 / session_.header.dt;
  frame.plan = plan_;
  frame.limits = record.output.limits;
  frame.samples = {};
  frame.events = {};
  frame.displacements = {};
  frame.diagnostic_names = diagnostic_names_;
  frame.timings = nullptr;
  frame.ultrasound = nullptr;
  if (patient_ == nullptr) {
    if (frame.depth > 0.0) frame.place = tissue_title(frame.tissue);
  } else if (maker.is_touching()) {
    frame.warning = warning_at(patient_->patient, frame.touched, frame.tissue, maker.is_on_bone());
  }
  return frame;
}

}  // namespace bodkin::app
