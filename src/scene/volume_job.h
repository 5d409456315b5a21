#pragma once

#include <memory>
#include <string>
#include <thread>

#include "scene/volume_request.h"

#include "anatomy/case.h"

namespace bodkin::scene {

// Prepares a patient's volume, then executes drawing orders, on its own threads. Called from one thread.
class VolumeJob {
 public:
  // `patient` is kept until the volume is prepared. `threads`: for drawing on the processor; 0: one per core.
  explicit VolumeJob(std::shared_ptr<const anatomy::Case> patient, int threads = 0);
  // Cancels, and waits some tenths of a second for work that cannot be interrupted.
  ~VolumeJob();
  VolumeJob(const VolumeJob&) = delete;
  VolumeJob& operator=(const VolumeJob&) = delete;

  struct Status {
    double fraction = 0.0;  // of the preparation, 0 to 1
    bool busy = true;       // preparing or drawing
    std::string error;      // why the preparation failed, one sentence
    std::string card;       // the graphics card that draws; empty: none
    std::string refusal;    // why the requested one does not, one sentence; may be empty
  };
  Status status() const;
  // Null until it is prepared.
  std::shared_ptr<const imaging::PreparedVolume> volume() const;
  // Replaces a waiting request.
  void request(const VolumeRequest& request);
  // The newest image; null before the first.
  std::shared_ptr<const VolumeResult> newest() const;

 private:
  struct Shared;

  std::shared_ptr<Shared> shared_;
  std::jthread thread_;
};

}  // namespace bodkin::scene
