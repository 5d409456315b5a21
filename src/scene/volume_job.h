#pragma once

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "scene/camera.h"

#include "anatomy/case.h"
#include "imaging/volume_rendering/ray_caster.h"

namespace bodkin::scene {

// The rays of a camera's picture.
imaging::VolumeCamera volume_camera(const Projection& projection);

// A picture of the inside of a patient that is wanted.
struct VolumeOrder {
  Camera camera;
  imaging::VolumeLook look;
  int width = 0, height = 0;      // pixels
  double voxels = 1.0;            // that a step is long
  bool may_be_cut_short = false;  // by another order; one that follows a moving camera must not, or none is finished

  bool operator==(const VolumeOrder&) const = default;
};

struct VolumeResult {
  VolumeOrder order;
  std::vector<std::uint32_t> pixels;  // 0xffRRGGBB, row by row
  std::shared_ptr<const imaging::RayCaster> caster;
  double seconds = 0.0;  // that it took
};

// Prepares a patient's volume, then draws what is ordered, on threads of its own. One thread calls.
class VolumeJob {
 public:
  // `patient` is held until the volume is prepared. `threads`: that draw; 0: as many as the machine has cores.
  explicit VolumeJob(std::shared_ptr<const anatomy::Case> patient, int threads = 0);
  // Cancels, and waits for what cannot be interrupted: some tenths of a second.
  ~VolumeJob();
  VolumeJob(const VolumeJob&) = delete;
  VolumeJob& operator=(const VolumeJob&) = delete;

  struct Status {
    double fraction = 0.0;  // of the preparation, 0 to 1
    bool busy = true;       // it prepares or draws
    std::string error;      // why the preparation failed, one sentence
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
