#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "app/models/recording.h"

namespace bodkin::app {

// Reads a session and its patient on a separate thread.
class RecordingJob {
 public:
  struct Status {
    bool is_done = false;
    std::string stage;
    double fraction = 0.0;  // of the stage, 0 to 1
    std::string error;      // why it failed, one sentence; empty: it did not
  };

  // `at_hand`: an already open patient, used if it is the session's; may be null.
  RecordingJob(std::filesystem::path file, std::shared_ptr<const OpenCase> at_hand);
  // Waits for the end of the present stage.
  ~RecordingJob();
  RecordingJob(const RecordingJob&) = delete;
  RecordingJob& operator=(const RecordingJob&) = delete;

  void cancel();
  Status status() const;
  // Null until it is done, and after an error.
  std::shared_ptr<const Recording> recording() const;

 private:
  void work(const std::filesystem::path& file, const std::shared_ptr<const OpenCase>& at_hand);

  mutable std::mutex lock_;  // guards the two below
  Status status_;
  std::shared_ptr<const Recording> recording_;
  std::atomic<bool> cancelled_{false};
  std::jthread thread_;
};

}  // namespace bodkin::app
