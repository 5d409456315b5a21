#include "app/models/case_model.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <system_error>
#include <utility>

#include "app/models/opened_images.h"
#include "app/models/procedure_title.h"
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "io/case_folder.h"
#include "io/image_worker.h"

namespace bodkin::app {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

namespace {

// Thrown out of a Progress to end the work.
struct Cancelled : std::exception {
  const char* what() const noexcept override { return "cancelled"; }
};

// The name of a folder of one of practice_patients().
bool is_for_practice(const std::string& folder) {
  return std::any_of(practice_patients().begin(), practice_patients().end(),
                     [&](const PracticePatient& patient) { return patient.folder == folder; });
}

}  // namespace

struct CaseModel::Job {
  mutable std::mutex lock;  // guards the three below
  Status status;
  std::shared_ptr<const OpenCase> opened;
  std::atomic<bool> cancelled{false};
  Clock::time_point begin = Clock::now();

  Progress progress() {
    return [this](std::string_view stage, double fraction) {
      if (cancelled.load()) throw Cancelled();
      const std::lock_guard guard(lock);
      status.stage = stage;
      status.fraction = fraction;
    };
  }

  void make(const std::string& verb, const nlohmann::json& request, const std::string& subject) {
    keep(io::run_image_worker(verb, request.dump(), subject, progress()).notes);
  }

  void keep(const std::vector<std::string>& notes) {
    const std::lock_guard guard(lock);
    status.notes.insert(status.notes.end(), notes.begin(), notes.end());
  }

  void load(const fs::path& folder) {
    progress()("reading the patient", 0.0);
    auto read = std::make_shared<OpenCase>();
    read->patient = io::load_case(folder, progress());
    read->folder = folder;
    read->title = read->description().name;
    read->procedure = procedure_title(read->description().procedure.name);
    const std::lock_guard guard(lock);
    opened = std::move(read);
  }
};

CaseModel::CaseModel(fs::path data) : data_(std::move(data)) {}

CaseModel::~CaseModel() {
  cancel();
}

void CaseModel::cancel() {
  if (job_ == nullptr) return;
  job_->cancelled.store(true);
  job_.reset();
}

void CaseModel::start(std::function<void(Job&)> work) {
  cancel();
  job_ = std::make_shared<Job>();
  job_->status.is_busy = true;
  threads_.emplace_back([job = job_, work = std::move(work)] {
    std::string error;
    try {
      work(*job);
    } catch (const std::exception& failure) {
      error = failure.what();
    }
    const std::lock_guard guard(job->lock);
    job->status.error = error;
    job->status.is_busy = false;
  });
}

void CaseModel::open_practice(const PracticePatient& patient) {
  start([&patient, folder = folder_of(patient)](Job& job) {
    if (!fs::exists(folder / "case.xml")) job.keep(make_practice_patient(patient, folder, job.progress()));
    job.load(folder);
  });
}

void CaseModel::open(const fs::path& path) {
  const fs::path data = data_;
  start([path, data](Job& job) {
    const fs::path whole = path.has_filename() ? path : path.parent_path();
    if (fs::exists(whole / "case.xml")) return job.load(whole);
    if (!fs::exists(whole)) throw InputError("there is no " + whole.string() + "; choose a folder or an image file");
    const OpenedImages images(data / "patients", is_for_practice);
    const fs::path folder = images.folder_of(whole);
    if (!fs::exists(folder / "case.xml")) {
      fs::create_directories(folder.parent_path());
      const nlohmann::json request = {{"folder", io::path_text(folder)},
                                      {"overwrite", false},
                                      {"name", folder.filename().string()},
                                      {"needle_gauge", 22},
                                      {"ct", io::path_text(whole)},
                                      {"resample_labels", false},
                                      {"fill_missing", false},
                                      {"assume_hu", false}};
      job.make("case-new", request, whole.string());
      images.keep(whole, folder);
    }
    job.load(folder);
  });
}

CaseModel::Status CaseModel::status() const {
  if (job_ == nullptr) return {};
  const std::lock_guard guard(job_->lock);
  Status status = job_->status;
  status.seconds = std::chrono::duration<double>(Clock::now() - job_->begin).count();
  return status;
}

std::shared_ptr<const OpenCase> CaseModel::take() {
  if (job_ == nullptr) return nullptr;
  const std::lock_guard guard(job_->lock);
  return std::exchange(job_->opened, nullptr);
}

std::vector<fs::path> CaseModel::known() const {
  std::vector<std::pair<fs::file_time_type, fs::path>> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(data_ / "patients", ignored)) {
    const fs::path file = entry.path() / "case.xml";
    if (!is_for_practice(entry.path().filename().string()) && fs::exists(file, ignored))
      found.emplace_back(fs::last_write_time(file, ignored), entry.path());
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<fs::path> folders;
  for (auto& [time, folder] : found) folders.push_back(std::move(folder));
  return folders;
}

}  // namespace bodkin::app
