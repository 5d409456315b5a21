#include "app/models/plan_model.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "io/case_folder.h"
#include "io/case_soundness.h"
#include "training/planning_rules.h"
#include "training/procedure_file.h"

namespace bodkin::app {

PlanModel::PlanModel(std::shared_ptr<const OpenCase> patient)
    : patient_(std::move(patient)),
      rules_(training::planning_rules(training::procedure_of_case(patient_->description().procedure.name))) {
  if (const auto& path = patient_->description().procedure.path) points_ = {path->entry, path->target};
  steps_ = {points_};
}

std::optional<anatomy::NeedlePath> PlanModel::path() const {
  if (!points_.entry || !points_.target || (*points_.entry - *points_.target).norm() < 1.0) return std::nullopt;
  return anatomy::NeedlePath{*points_.entry, *points_.target};
}

void PlanModel::set_skin(std::shared_ptr<const std::vector<Eigen::Vector3f>> skin) {
  skin_ = std::move(skin);
  worked_target_.reset();
  if (working_) begin_work();
}

void PlanModel::work(bool on) {
  working_ = on;
  if (on) return begin_work();
  work_.reset();
  worked_target_.reset();
}

void PlanModel::begin_work() {
  if (!points_.target) {
    work_.reset();
    worked_target_.reset();
    result_ = {};
    report_.reset();
    return;
  }
  if (worked_target_ == points_.target) return;
  worked_target_ = points_.target;
  work_.reset();  // before the next one begins
  result_ = {};
  report_.reset();  // it refers to the previous obstacles
  work_ = std::make_unique<PlanWork>(
      PlanWork::Request{patient_, rules_, *points_.target, points_.entry.value_or(*points_.target), skin_});
}

bool PlanModel::poll() {
  if (work_ == nullptr || !work_->poll(result_.version, result_)) return false;
  look_again();
  return true;
}

// With the previous target's obstacles while a new target is being dragged: their margins are close enough.
void PlanModel::look_again() {
  report_.reset();
  trouble_.clear();
  const std::optional<anatomy::NeedlePath> now = path();
  if (!now) {
    if (!points_.target) {
      trouble_ = "Choose the target: click it in a slice.";
    } else if (!points_.entry) {
      trouble_ = "Choose where to go in: click the skin, or a proposal.";
    }
    return;
  }
  const patient::PatientView view = patient::view_of(patient_->patient);
  if (result_.obstacles) report_ = patient::report_on(view, *result_.obstacles, *now);
  if (!save_trouble_.empty()) {
    trouble_ = save_trouble_;
  } else if (const auto problem = patient::level_problem(view, rules_, now->target)) {
    trouble_ = fmt::format("This is no place for {}: {}.", patient_->procedure, *problem);
  } else if (report_ && report_->room.blocked) {
    const auto into = std::find_if(report_->near.begin(), report_->near.end(),
                                   [](const patient::Clearance& each) { return each.distance == 0.0; });
    trouble_ =
        fmt::format("The path goes into {}.",
                    into == report_->near.end() ? "something to avoid" : result_.obstacles->kinds[into->kind].title);
  }
}

void PlanModel::move_entry(const Vec3& entry) {
  points_.entry = entry;
  look_again();
}

void PlanModel::move_target(const Vec3& target) {
  points_.target = target;
  look_again();
}

void PlanModel::set_entry(const Vec3& entry) {
  points_.entry = entry;
  commit();
}

void PlanModel::set_target(const Vec3& target) {
  points_.target = target;
  commit();
}

void PlanModel::adopt(std::size_t proposal) {
  if (proposal >= result_.proposals.size()) return;
  const anatomy::NeedlePath& path = result_.proposals[proposal].report.path;
  points_ = {path.entry, path.target};
  commit();
}

void PlanModel::choose_structure(const std::string& name) {
  set_target(patient::target_in_structure(patient::view_of(patient_->patient), name));
}

void PlanModel::remove() {
  points_ = {};
  commit();
}

void PlanModel::commit() {
  if (points_ == steps_[now_]) return;
  steps_.resize(now_ + 1);
  steps_.push_back(points_);
  ++now_;
  take_step();
}

void PlanModel::undo() {
  if (!can_undo()) return;
  points_ = steps_[--now_];
  take_step();
}

void PlanModel::redo() {
  if (!can_redo()) return;
  points_ = steps_[++now_];
  take_step();
}

void PlanModel::take_step() {
  save();
  if (working_) begin_work();
  look_again();
}

void PlanModel::save() {
  save_trouble_.clear();
  saved_ = false;
  const std::optional<anatomy::NeedlePath> now = path();
  if (points_ != Points{} && !now) return;  // half a plan
  if (now) {
    const std::vector<std::string> problems = io::path_problems(patient_->patient, *now);
    if (!problems.empty()) {
      save_trouble_ = fmt::format("Not saved: {}.", problems.front());
      return;
    }
  }
  try {
    anatomy::CaseDescription description = patient_->description();
    description.procedure.path = now;
    io::write_case_description(description, patient_->folder);
    saved_ = true;
  } catch (const std::exception& error) {
    save_trouble_ = error.what();
  }
}

std::vector<PlanModel::Distance> PlanModel::distances() const {
  std::vector<Distance> all;
  if (!report_ || !result_.obstacles) return all;
  for (const patient::Clearance& each : report_->near) {
    const patient::Obstacle& kind = result_.obstacles->kinds[each.kind];
    all.push_back({kind.title, each.distance, kind.margin});
  }
  return all;
}

std::string PlanModel::crossed_text() const {
  std::string text, last;
  if (!report_) return text;
  for (const patient::Crossed& each : report_->crosses) {
    const std::string title = patient_->patient.library.title(each.tissue);
    if (title == last) continue;
    text += (text.empty() ? "" : ", ") + title;
    last = title;
  }
  return text;
}

std::string PlanModel::level() const {
  if (!points_.target || rules_.levels.empty()) return "";
  std::string name = patient::level_at(patient::view_of(patient_->patient), *points_.target);
  std::replace(name.begin(), name.end(), '_', '/');
  return name;
}

}  // namespace bodkin::app
