#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "scene/surfaces.h"

#include "anatomy/case.h"

namespace bodkin::scene {

// surfaces_of_case(), divided by find_sections(), on its own thread. Called from one thread.
class SurfaceJob {
 public:
  // `patient` is kept until the work is done.
  SurfaceJob(std::shared_ptr<const anatomy::Case> patient, std::filesystem::path folder);
  // Cancels, and waits at most 1 s for a step that cannot be interrupted.
  ~SurfaceJob();
  SurfaceJob(const SurfaceJob&) = delete;
  SurfaceJob& operator=(const SurfaceJob&) = delete;

  struct Status {
    double fraction = 0.0;  // done, 0 to 1
    bool done = false;      // or failed
    std::string error;      // why it failed, one sentence
  };
  Status status() const;
  // The surfaces, once they are done; null before, and after a failure.
  std::shared_ptr<const PatientSurfaces> surfaces() const;

 private:
  struct Shared;

  std::shared_ptr<Shared> shared_;
  std::jthread thread_;
};

}  // namespace bodkin::scene
