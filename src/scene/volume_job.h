#pragma once

#include <memory>
#include <string>
#include <thread>

#include "scene/volume_order.h"

#include "anatomy/case.h"

namespace bodkin::scene {

// Prepares a patient's volume, then draws what is ordered, on threads of its own. One thread calls.
class VolumeJob {
 public:
  // `patient` is held until the volume is prepared. `threads`: that draw on the processor; 0: as many as the machine
  // has cores.
  explicit VolumeJob(std::shared_ptr<const anatomy::Case> patient, int threads = 0);
  // Cancels, and waits for what cannot be interrupted: some tenths of a second.
  ~VolumeJob();
  VolumeJob(const VolumeJob&) = delete;
  VolumeJob& operator=(const VolumeJob&) = delete;

  struct Status {
    double fraction = 0.0;  // of the preparation, 0 to 1
    bool busy = true;       // it prepares or draws
    std::string error;      // why the preparation failed, one sentence
    std::string card;       // the graphics card that draws; empty: none
    std::string refusal;    // why the one that was wished for does not, one sentence; may be empty
  };
  Status status() const;
  // Null until it is prepared.
  std::shared_ptr<const imaging::PreparedVolume> volume() const;
  // Takes the place of an order that waits.
  void order(const VolumeOrder& order);
  // The newest picture; null before the first.
  std::shared_ptr<const VolumeResult> newest() const;

 private:
  struct Shared;

  std::shared_ptr<Shared> shared_;
  std::jthread thread_;
};

}  // namespace bodkin::scene
