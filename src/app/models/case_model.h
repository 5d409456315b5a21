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

// Opens patients on a separate thread: a case folder, a CT that is converted to a case first, or one of the patients
// supplied with Bodkin, which are generated at their first use. One at a time; all calls from one thread.
class CaseModel {
 public:
  struct Status {
    bool is_busy = false;
    std::string stage;               // the current step
    double fraction = 0.0;           // of it, 0 to 1
    double seconds = 0.0;            // since it began
    std::string error;               // why the last one failed; empty: it did not
    std::vector<std::string> notes;  // repairs and assumptions
  };

  // `data`: the folder of generated patients.
  explicit CaseModel(std::filesystem::path data);
  // Waits for a step that cannot be interrupted.
  ~CaseModel();
  CaseModel(const CaseModel&) = delete;
  CaseModel& operator=(const CaseModel&) = delete;

  // The practice patient of a procedure supplied with Bodkin; generated at its first use.
  void open_practice(const PracticePatient& patient);
  // Opens a folder with case.xml; a DICOM folder or an image file is converted to a case first.
  void open(const std::filesystem::path& path);
  void cancel();

  Status status() const;
  // The opened patient, once; null: none.
  std::shared_ptr<const OpenCase> take();

  // Folders of cases that can be opened immediately: those generated here, newest first, without those of
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
