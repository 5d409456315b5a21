#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/models/plan_work.h"

namespace bodkin::app {

// The plan of a patient while it is being made: where in, where to, what that means, what was tried before. A step is
// what one click or one drag has done; every step is saved in the case at once. One thread; nothing here takes long.
class PlanModel {
 public:
  // Either may be missing while the plan is begun.
  struct Points {
    std::optional<Vec3> entry, target;  // LPS mm
    bool operator==(const Points&) const = default;
  };
  // A distance that a person should see.
  struct Distance {
    std::string title;
    double distance = 0.0;  // mm; 0: the path goes into it
    double margin = 0.0;    // mm that it should be
  };

  // Throws InputError when the procedure of the case cannot be read.
  explicit PlanModel(std::shared_ptr<const OpenCase> patient);

  // Points of the skin, for the map of entries; null: none.
  void set_skin(std::shared_ptr<const std::vector<Eigen::Vector3f>> skin);
  // Computes for the present target, or stops doing so.
  void work(bool on);
  // Takes what has been computed meanwhile. True: something is new.
  bool poll();

  // Live, without a step: while a point is dragged.
  void move_entry(const Vec3& entry);
  void move_target(const Vec3& target);
  // The same as a step.
  void set_entry(const Vec3& entry);
  void set_target(const Vec3& target);
  void adopt(std::size_t proposal);
  // The middle of a structure of the segmentation. Throws InputError.
  void choose_structure(const std::string& name);
  void remove();  // both points
  // What was moved becomes a step.
  void commit();
  bool can_undo() const { return now_ > 0; }
  bool can_redo() const { return now_ + 1 < steps_.size(); }
  void undo();
  void redo();

  const Points& points() const { return points_; }
  std::optional<anatomy::NeedlePath> path() const;
  // Of the path, with what must be avoided as far as it is known; nothing without a path or before that.
  const std::optional<patient::PathReport>& report() const { return report_; }
  // The worst for its margin first.
  std::vector<Distance> distances() const;
  // "skin, fat, muscle" in order.
  std::string crossed_text() const;
  // The interspace, for a puncture of the spine: "L3/L4"; empty otherwise.
  std::string level() const;
  // Why the plan is not saved or should not be used, one sentence; empty: it is saved and sound.
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
  std::size_t now_ = 0;  // of the steps
  std::optional<patient::PathReport> report_;
  std::string trouble_, save_trouble_;
  bool saved_ = true;
};

}  // namespace bodkin::app
