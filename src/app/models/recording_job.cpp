#include "app/models/recording_job.h"

#include <exception>
#include <fstream>
#include <iterator>
#include <utility>

#include "app/models/procedure_title.h"
#include "session/case_digest.h"
#include <fmt/format.h>

#include "core/error.h"
#include "io/case_folder.h"

namespace bodkin::app {

namespace {

namespace fs = std::filesystem;

// Thrown out of a Progress to end the work.
struct ReadingCancelled : std::exception {
  const char* what() const noexcept override { return "cancelled"; }
};

std::string whole_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::shared_ptr<const OpenCase> read_patient(const fs::path& folder, const Progress& progress) {
  auto read = std::make_shared<OpenCase>();
  read->patient = io::load_case(folder, progress);
  read->folder = folder;
  read->title = read->description().name;
  read->procedure = procedure_title(read->description().procedure.name);
  return read;
}

}  // namespace

RecordingJob::RecordingJob(fs::path file, std::shared_ptr<const OpenCase> at_hand) {
  thread_ = std::jthread([this, file = std::move(file), at_hand = std::move(at_hand)] { work(file, at_hand); });
}

RecordingJob::~RecordingJob() {
  cancel();
}

void RecordingJob::cancel() {
  cancelled_.store(true);
}

RecordingJob::Status RecordingJob::status() const {
  const std::lock_guard guard(lock_);
  return status_;
}

std::shared_ptr<const Recording> RecordingJob::recording() const {
  const std::lock_guard guard(lock_);
  return recording_;
}

void RecordingJob::work(const fs::path& file, const std::shared_ptr<const OpenCase>& at_hand) {
  const Progress progress = [this](std::string_view stage, double fraction) {
    if (cancelled_.load()) throw ReadingCancelled();
    const std::lock_guard guard(lock_);
    status_.stage = stage;
    status_.fraction = fraction;
  };
  std::string error;
  std::shared_ptr<const Recording> made;
  try {
    progress("reading the session", 0.0);
    session::Session session = session::read_session(file);
    const fs::path folder = session.header.case_folder;
    std::shared_ptr<const OpenCase> patient;
    bool is_same = false;
    std::string note;
    try {
      progress("reading the patient", 0.0);
      patient = at_hand != nullptr && at_hand->folder == folder ? at_hand : read_patient(folder, progress);
      progress("comparing the patient with the session's", 0.0);
      is_same =
          session::is_digest_of_case(session.header.case_digest, patient->patient, whole_text(folder / "case.xml"),
                                     session::mesh_digest(folder, session.header.haptics.resistance));
      if (!is_same) {
        note = fmt::format("The patient in {} has changed since this session: slices and 3-D show its present state.",
                           folder.string());
      }
    } catch (const InputError& missing) {
      patient.reset();
      note = fmt::format("The patient of this session is not available, so its path is shown without anatomy ({}).",
                         missing.what());
    }
    std::shared_ptr<ScanReplay> scan;
    if (patient != nullptr && !session.scans.empty()) {
      progress("preparing the ultrasound", 0.0);
      try {
        scan = std::make_shared<ScanReplay>(session, patient->patient, progress);
      } catch (const InputError& no_picture) {
        note = fmt::format("The ultrasound of this session cannot be shown ({}).", no_picture.what());
      }
    }
    progress("judging the session", 0.0);
    made = std::make_shared<const Recording>(file, std::move(session), std::move(patient), is_same, std::move(note),
                                             std::move(scan));
  } catch (const std::exception& failure) {
    error = failure.what();
  }
  const std::lock_guard guard(lock_);
  recording_ = std::move(made);
  status_.error = std::move(error);
  status_.is_done = true;
}

}  // namespace bodkin::app
