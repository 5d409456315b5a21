#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <thread>

namespace bodkin::app {

// Rendered footage of a teaching station, for users without a camera: rendered once, on a separate thread.
class DemoFootage {
 public:
  struct Status {
    bool is_ready = false;
    double fraction = 0.0;  // of the images
    std::string error;      // why there is no footage, a sentence
  };

  // `folder`: of the images; existing footage in it is used unchanged.
  explicit DemoFootage(std::filesystem::path folder);
  // Discards incomplete footage.
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
