#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/models/practice_patients.h"
#include "views/open_case.h"

#include "core/progress.h"

namespace bodkin::app {

using namespace views;

// Opens patients on a thread of its own: a case folder, a CT that becomes a case first, or one of the patients that
// come with Bodkin, which are made when they are wanted for the first time. One at a time; all calls from one thread.
class CaseModel {
 public:
  struct Status {
    bool is_busy = false;
    std::string stage;               // what is being done
    double fraction = 0.0;           // of it, 0 to 1
    double seconds = 0.0;            // since it began
    std::string error;               // why the last one failed; empty: it did not
    std::vector<std::string> notes;  // what was repaired or assumed
  };

  // `data`: where patients that are made here are kept.
  explicit CaseModel(std::filesystem::path data);
  // Waits for work that cannot be interrupted.
  ~CaseModel();
  CaseModel(const CaseModel&) = delete;
  CaseModel& operator=(const CaseModel&) = delete;

  // The patient on whom a procedure that comes with Bodkin is practised; made when it is wanted for the first time.
  void open_practice(const PracticePatient& patient);
  // A folder with case.xml is opened; a DICOM folder or an image file becomes a case first.
  void open(const std::filesystem::path& path);
  void cancel();

  Status status() const;
  // The patient that was opened, once; null while there is none.
  std::shared_ptr<const OpenCase> take();

  // Folders of cases that can be opened at once: those that were made here, newest first, without those of
  // practice_patients().
  std::vector<std::filesystem::path> known() const;
  void open_built_in() { open_practice(built_in_patient()); }
  std::filesystem::path built_in_folder() const { return folder_of(built_in_patient()); }
  std::filesystem::path folder_of(const PracticePatient& patient) const {
    return data_ / "patients" / patient.folder;
  }

 private:
  struct Job;

  void start(std::function<void(Job&)> work);

  std::filesystem::path data_;
  std::shared_ptr<Job> job_;  // the newest; may be null
  std::vector<std::jthread> threads_;
};

}  // namespace bodkin::app
