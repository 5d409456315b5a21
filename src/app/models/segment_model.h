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

// The structures of a patient while they are corrected: labels with their steps, the table, one piece of work that
// takes time (a filter, or saving), which runs on a thread of its own. All calls from one thread.
class SegmentModel {
 public:
  struct Status {
    bool is_busy = false;
    std::string stage;               // what is being done
    double fraction = 0.0;           // of it, 0 to 1
    std::string error;               // why the last work came to nothing, a sentence
    std::vector<std::string> notes;  // of the last saving
    bool is_saved = false;           // the last work saved the case
  };

  // With what was changed and not saved the last time, as one step. Throws InputError for a patient without a CT, and
  // when the procedure of the case cannot be read.
  explicit SegmentModel(std::shared_ptr<const OpenCase> patient);
  // Cancels what runs; what was not saved is kept for the next time.
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
  // A structure of this name and tissue with a label of its own becomes the active one. Throws InputError for a name
  // that is empty or taken, and for a tissue that the library does not have.
  void add(const std::string& name, const std::string& tissue, bool critical);

  // The active structure has this name. Throws InputError for one that is empty or taken, or without a structure.
  void rename(const std::string& name);
  // The tip must not enter the active structure, as plans, warnings and verdicts see it.
  void set_critical(bool critical);
  // The active structure has no voxels any more, as one step; saving drops what has none.
  void remove();

  // The filter works on the active structure; poll() takes what came of it as a step. Nothing happens while another
  // work runs or without a structure.
  void run(const patient::SegmentFilter& filter, patient::Overwriting over, bool only_add);
  void save();
  void cancel();
  // Takes what has come; true: something is new.
  bool poll();
  Status status() const;
  // Something was changed since it was opened or saved.
  bool has_changes() const;
  // It began with what was not saved the last time.
  bool has_draft() const { return has_draft_; }
  // What was changed and not saved is kept beside the case, in case the program ends. Throws SystemError.
  void keep_draft();

 private:
  struct Job;

  // As the table has names. Throws InputError for one that is empty or taken by another than `own`.
  std::string free_name(const std::string& name, int own) const;

  std::shared_ptr<const OpenCase> patient_;
  patient::LabelEditor editor_;
  std::vector<anatomy::Structure> table_;
  patient::PlanningRules rules_;
  int active_ = -1;
  std::uint64_t saved_version_ = 0;
  std::optional<std::uint64_t> kept_version_;  // of the draft beside the case; nothing: there is none
  bool has_draft_ = false;
  std::vector<anatomy::Structure> saved_table_, kept_table_;
  std::shared_ptr<Job> job_;  // null: none ran yet
  std::vector<std::jthread> threads_;
};

}  // namespace bodkin::app
