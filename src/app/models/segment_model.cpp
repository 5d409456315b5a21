#include "app/models/segment_model.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <utility>

#include "app/models/label_draft.h"

#include "core/error.h"
#include "training/planning_rules.h"
#include "training/procedure_file.h"

namespace bodkin::app {

namespace {

struct SegmentCancelled : std::exception {};

anatomy::LabelVolume labels_to_correct(const anatomy::Case& patient) {
  if (patient.ct.empty()) throw InputError("This patient has no CT, so there is nothing to find structures in.");
  if (patient.structures.empty()) return anatomy::LabelVolume(patient.ct.grid);
  return patient.structures;
}

bool same_table(const std::vector<anatomy::Structure>& some, const std::vector<anatomy::Structure>& others) {
  const auto same = [](const anatomy::Structure& one, const anatomy::Structure& other) {
    return one.label == other.label && one.name == other.name && one.tissue == other.tissue &&
           one.critical == other.critical;
  };
  return std::equal(some.begin(), some.end(), others.begin(), others.end(), same);
}

}  // namespace

struct SegmentModel::Job {
  mutable std::mutex lock;  // guards all but `cancelled`
  Status status;
  std::optional<patient::SegmentMask> mask;
  std::atomic<bool> cancelled{false};
  std::uint16_t label = 0;
  patient::Overwriting over = patient::Overwriting::all;
  bool only_add = false, taken = false;
  std::uint64_t version = 0;  // of what was saved
  std::vector<anatomy::Structure> table;

  Progress progress() {
    return [this](std::string_view stage, double fraction) {
      if (cancelled.load()) throw SegmentCancelled();
      const std::lock_guard guard(lock);
      status.stage = stage;
      status.fraction = fraction;
    };
  }
  // The end of the work, for any reason.
  template <typename Work>
  void run(const Work& work) {
    std::string error;
    try {
      work();
    } catch (const SegmentCancelled&) {
      error = "Cancelled; nothing was changed.";
    } catch (const std::exception& failure) {
      error = failure.what();
    }
    const std::lock_guard guard(lock);
    status.error = error;
    status.is_busy = false;
  }
};

SegmentModel::SegmentModel(std::shared_ptr<const OpenCase> patient)
    : patient_(std::move(patient)),
      editor_(labels_to_correct(patient_->patient)),
      table_(patient_->description().structures),
      rules_(training::planning_rules(training::procedure_of_case(patient_->description().procedure.name))),
      active_(table_.empty() ? -1 : 0),
      saved_table_(table_) {
  std::optional<LabelDraft> draft = kept_label_draft(*patient_);
  if (!draft) return;
  editor_.take(draft->labels);
  table_ = std::move(draft->table);
  active_ = table_.empty() ? -1 : 0;
  has_draft_ = true;
  kept_table_ = table_;
  kept_version_ = editor_.version();
}

SegmentModel::~SegmentModel() {
  cancel();
  try {
    store_draft();
  } catch (const std::exception&) {
    // A full disk: the user can no longer be notified.
  }
}

void SegmentModel::store_draft() {
  editor_.commit();
  if (!has_changes()) {
    if (kept_version_) forget_label_draft(*patient_);
    return kept_version_.reset();
  }
  if (kept_version_ == editor_.version() && same_table(table_, kept_table_)) return;
  keep_label_draft(*patient_, {editor_.labels(), table_});
  kept_version_ = editor_.version();
  kept_table_ = table_;
}

void SegmentModel::choose(int position) {
  editor_.commit();
  active_ = position >= 0 && position < static_cast<int>(table_.size()) ? position : -1;
}

std::uint16_t SegmentModel::active_label() const {
  return active_ < 0 ? std::uint16_t{0} : table_[static_cast<std::size_t>(active_)].label;
}

std::string SegmentModel::free_name(const std::string& name, int own) const {
  std::string plain = name;
  std::replace(plain.begin(), plain.end(), ' ', '_');
  if (plain.empty()) throw InputError("Give the structure a name.");
  for (int i = 0; i < static_cast<int>(table_.size()); ++i) {
    if (i != own && table_[static_cast<std::size_t>(i)].name == plain)
      throw InputError("There is a structure '" + name + "' already; choose another name.");
  }
  return plain;
}

void SegmentModel::rename(const std::string& name) {
  if (active_ < 0) throw InputError("Make a structure first, or choose one.");
  table_[static_cast<std::size_t>(active_)].name = free_name(name, active_);
}

void SegmentModel::set_critical(bool critical) {
  if (active_ >= 0) table_[static_cast<std::size_t>(active_)].critical = critical;
}

void SegmentModel::remove() {
  if (active_ < 0 || status().is_busy) return;
  editor_.commit();
  editor_.replace(patient::SegmentMask(editor_.labels().grid), active_label(), patient::Overwriting::all, false);
}

void SegmentModel::add(const std::string& name, const std::string& tissue, bool critical) {
  const std::string plain = free_name(name, -1);
  int largest = 0;
  for (const anatomy::Structure& each : table_) largest = std::max(largest, static_cast<int>(each.label));
  if (!tissue.empty() && patient_->patient.library.find(tissue) == nullptr)
    throw InputError("The tissue library has no '" + tissue + "'.");
  for (const std::uint16_t label : editor_.labels().voxels) largest = std::max(largest, static_cast<int>(label));
  if (largest >= 65535) throw InputError("All labels are taken.");
  table_.push_back({static_cast<std::uint16_t>(largest + 1), plain, tissue, critical});
  choose(static_cast<int>(table_.size()) - 1);
}

void SegmentModel::run(const patient::SegmentFilter& filter, patient::Overwriting over, bool only_add) {
  if (active_ < 0 || status().is_busy) return;
  editor_.commit();
  job_ = std::make_shared<Job>();
  job_->status.is_busy = true;
  job_->status.stage = "looking at the voxels";
  job_->label = active_label();
  job_->over = over;
  job_->only_add = only_add;
  threads_.clear();
  threads_.emplace_back([job = job_, patient = patient_, filter, mask = editor_.mask_of(active_label())] {
    job->run([&] {
      patient::SegmentMask found = patient::run_segment_filter(patient->patient.ct, mask, filter, job->progress());
      const std::lock_guard guard(job->lock);
      job->mask = std::move(found);
    });
  });
}

void SegmentModel::save() {
  if (status().is_busy) return;
  editor_.commit();
  job_ = std::make_shared<Job>();
  job_->status.is_busy = true;
  job_->status.stage = "saving";
  job_->version = editor_.version();
  job_->table = table_;
  threads_.clear();
  threads_.emplace_back([job = job_, patient = patient_, labels = editor_.labels(), table = table_, rules = rules_] {
    job->run([&] {
      const patient::CorrectedCase saved =
          patient::save_corrected_labels(patient->folder, labels, table, rules, job->progress());
      const std::lock_guard guard(job->lock);
      job->status.notes = saved.notes;
      job->status.is_saved = true;
    });
  });
}

bool SegmentModel::has_changes() const {
  return editor_.version() != saved_version_ || !same_table(table_, saved_table_);
}

void SegmentModel::cancel() {
  if (job_ != nullptr) job_->cancelled.store(true);
}

bool SegmentModel::poll() {
  if (job_ == nullptr || job_->taken) return false;
  std::optional<patient::SegmentMask> mask;
  {
    const std::lock_guard guard(job_->lock);
    if (job_->status.is_busy) return true;  // progress
    mask = std::exchange(job_->mask, std::nullopt);
    job_->taken = true;
    if (job_->status.is_saved) {
      saved_version_ = job_->version;
      saved_table_ = job_->table;
      forget_label_draft(*patient_);
      kept_version_.reset();
    }
  }
  if (mask) editor_.replace(*mask, job_->label, job_->over, job_->only_add);
  return true;
}

SegmentModel::Status SegmentModel::status() const {
  if (job_ == nullptr) return {};
  const std::lock_guard guard(job_->lock);
  return job_->status;
}

}  // namespace bodkin::app
