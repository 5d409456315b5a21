#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/models/plan_work.h"

namespace bodkin::app {

// The plan of a patient during editing: entry, target, their evaluation, and the undo history. A step is the result
// of one click or one drag; every step is saved in the case immediately. One thread; all calls are fast.
class PlanModel {
 public:
  // Either may be missing in an incomplete plan.
  struct Points {
    std::optional<Vec3> entry, target;  // LPS mm
    bool operator==(const Points&) const = default;
  };
  // A distance for display.
  struct Distance {
    std::string title;
    double distance = 0.0;  // mm; 0: the path enters it
    double margin = 0.0;    // mm, required
  };

  // Throws InputError when the procedure of the case cannot be read.
  explicit PlanModel(std::shared_ptr<const OpenCase> patient);

  // Points of the skin, for the map of entries; null: none.
  void set_skin(std::shared_ptr<const std::vector<Eigen::Vector3f>> skin);
  // Starts or stops computing for the present target.
  void work(bool on);
  // Collects new results. True: there are some.
  bool poll();

  // During dragging, without a step.
  void move_entry(const Vec3& entry);
  void move_target(const Vec3& target);
  // The same, as a step.
  void set_entry(const Vec3& entry);
  void set_target(const Vec3& target);
  void adopt(std::size_t proposal);
  // Sets the target to the centre of a segmented structure. Throws InputError.
  void choose_structure(const std::string& name);
  void remove();  // both points
  // Records the moves as a step.
  void commit();
  bool can_undo() const { return now_ > 0; }
  bool can_redo() const { return now_ + 1 < steps_.size(); }
  void undo();
  void redo();

  const Points& points() const { return points_; }
  std::optional<anatomy::NeedlePath> path() const;
  // Of the path, with the obstacles known so far; empty without a path or before the first result.
  const std::optional<patient::PathReport>& report() const { return report_; }
  // The smallest relative to its margin first.
  std::vector<Distance> distances() const;
  // "skin, fat, muscle" in order.
  std::string crossed_text() const;
  // The interspace, for a puncture of the spine: "L3/L4"; empty otherwise.
  std::string level() const;
  // Why the plan is not saved or should not be used, one sentence; empty: it is saved and valid.
  const std::string& trouble() const { return trouble_; }
  bool is_saved() const { return saved_; }
  const PlanWork::Result& result() const { return result_; }
  const OpenCase& patient() const { return *patient_; }

 private:
  void take_step();
  void begin_work();
  void look_again();
  void save();

  std::shared_ptr<const OpenCase> patient_;
  patient::PlanningRules rules_;
  std::shared_ptr<const std::vector<Eigen::Vector3f>> skin_;
  std::unique_ptr<PlanWork> work_;
  std::optional<Vec3> worked_target_;
  bool working_ = false;
  PlanWork::Result result_;
  Points points_;
  std::vector<Points> steps_;
  std::size_t now_ = 0;  // index of the present step
  std::optional<patient::PathReport> report_;
  std::string trouble_, save_trouble_;
  bool saved_ = true;
};

}  // namespace bodkin::app
