#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "patient/segmentation/segment_filter.h"
#include "views/open_case.h"

namespace bodkin::app {

using namespace views;

// The structures of a patient during correction: labels with undo history, the table, and one slow task (a filter, or
// saving) on a separate thread. All calls from one thread.
class SegmentModel {
 public:
  struct Status {
    bool is_busy = false;
    std::string stage;               // the current step
    double fraction = 0.0;           // of it, 0 to 1
    std::string error;               // why the last task failed, a sentence
    std::vector<std::string> notes;  // of the last saving
    bool is_saved = false;           // the last task saved the case
  };

  // With the unsaved changes of the last time as one step. Throws InputError for a patient without a CT, and if the
  // procedure of the case cannot be read.
  explicit SegmentModel(std::shared_ptr<const OpenCase> patient);
  // Cancels the task in progress; unsaved changes are stored for the next time.
  ~SegmentModel();
  SegmentModel(const SegmentModel&) = delete;
  SegmentModel& operator=(const SegmentModel&) = delete;

  const OpenCase& patient() const { return *patient_; }
  patient::LabelEditor& editor() { return editor_; }
  const patient::LabelEditor& editor() const { return editor_; }
  const std::vector<anatomy::Structure>& table() const { return table_; }
  // Position in the table; -1: there is none.
  int active() const { return active_; }
  void choose(int position);
  std::uint16_t active_label() const;
  // Adds a structure of this name and tissue with a separate label and makes it active. Throws InputError for an
  // empty or used name, and for a tissue that is not in the library.
  void add(const std::string& name, const std::string& tissue, bool critical);

  // Renames the active structure. Throws InputError for an empty or used name, or without a structure.
  void rename(const std::string& name);
  // Whether the tip must not enter the active structure, for plans, warnings and verdicts.
  void set_critical(bool critical);
  // Removes all voxels of the active structure, as one step; saving drops empty structures.
  void remove();

  // Filters the active structure; poll() adds the result as a step. No effect during another task or without a
  // structure.
  void run(const patient::SegmentFilter& filter, patient::Overwriting over, bool only_add);
  void save();
  void cancel();
  // Collects results; true: there are some.
  bool poll();
  Status status() const;
  // There are changes since opening or saving.
  bool has_changes() const;
  // It began with unsaved changes of the last time.
  bool has_draft() const { return has_draft_; }
  // Stores unsaved changes beside the case, in case the program ends. Throws SystemError.
  void store_draft();

 private:
  struct Job;

  // A valid name for the table. Throws InputError for an empty name or one used by a structure other than `own`.
  std::string free_name(const std::string& name, int own) const;

  std::shared_ptr<const OpenCase> patient_;
  patient::LabelEditor editor_;
  std::vector<anatomy::Structure> table_;
  patient::PlanningRules rules_;
  int active_ = -1;
  std::uint64_t saved_version_ = 0;
  std::optional<std::uint64_t> kept_version_;  // of the draft beside the case; empty: none
  bool has_draft_ = false;
  std::vector<anatomy::Structure> saved_table_, kept_table_;
  std::shared_ptr<Job> job_;  // null: none yet
  std::vector<std::jthread> threads_;
};

}  // namespace bodkin::app
