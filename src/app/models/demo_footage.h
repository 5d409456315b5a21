#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <thread>

namespace bodkin::app {

// Rendered footage of a teaching station, for those who have no camera: made once, on a thread of its own.
class DemoFootage {
 public:
  struct Status {
    bool is_ready = false;
    double fraction = 0.0;  // of the pictures
    std::string error;      // why there is none, a sentence
  };

  // `folder`: of the pictures; what stands there from before is taken as it is.
  explicit DemoFootage(std::filesystem::path folder);
  // Gives up what is not complete.
  ~DemoFootage();
  DemoFootage(const DemoFootage&) = delete;
  DemoFootage& operator=(const DemoFootage&) = delete;

  Status status() const;
  const std::filesystem::path& folder() const { return folder_; }

 private:
  void render(const std::stop_token& stop);

  std::filesystem::path folder_;
  mutable std::mutex lock_;  // guards the status
  Status status_;
  std::jthread thread_;
};

}  // namespace bodkin::app
