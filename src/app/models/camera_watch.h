#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tracking/augmented_view.h"
#include "tracking/station_footage.h"
#include "views/open_case.h"

namespace bodkin::app {

using namespace views;

// How well a body is seen in the newest image.
struct BodyDetection {
  std::string name;
  tracking::TrackingStatus status = tracking::TrackingStatus::lost;
  double deviation = 0.0;   // mm, standard deviation of its tip in the camera's frame; meaningless when lost
  double residual = 0.0;    // share of the pattern's contrast
  double edge_ratio = 1.0;  // residual at the edges over that of flat parts
  int markers = 0;
};

// The state of a camera for the window.
struct CameraStatus {
  std::string stage, error;                          // what is being opened; why the images have ended, a sentence
  std::string note;                                  // remark about this image, a sentence
  std::string source_note;                           // remark about all images of this source
  std::uint64_t number = 0;                          // of the image; 0: none yet
  std::shared_ptr<const imaging::ImageRgb> picture;  // with the overlay
  double time = 0.0;                                 // s, of the image
  double rate = 0.0;                                 // images/s, over the last second
  std::chrono::steady_clock::time_point arrived;     // when the image arrived, before decoding
  std::vector<BodyDetection> bodies;
  std::optional<Pose> needle, probe;  // LPS mm, third axis into the patient; none: not detected well in this image
  std::string tip;                    // tissue at the needle's tip; empty: outside, or no needle
  bool tip_on_bone = false;
  bool large_oval = false;  // so large that the patient is drawn at half the resolution in it
};

// Images of a camera, a video or a folder with the patient drawn into the mannequin, on a separate thread: each image
// uses its own poses. A video or a folder plays in real time, repeatedly. An uncalibrated camera gives only its
// images. A session can follow the tools meanwhile (tracking::announce); it ends after one pass through video or
// folder. All calls from one thread; none waits for an image.
class CameraWatch {
 public:
  // `registration`: of patient and mannequin (bodkin register); empty: as in rendered footage. `on_picture` is called
  // on that thread for each new image of status().
  CameraWatch(std::shared_ptr<const OpenCase> patient, const tracking::FootageFiles& files,
              const std::filesystem::path& registration, const tracking::AugmentedLook& look,
              std::function<void()> on_picture = {});
  ~CameraWatch();
  CameraWatch(const CameraWatch&) = delete;
  CameraWatch& operator=(const CameraWatch&) = delete;

  // From the next image on.
  void set_look(const tracking::AugmentedLook& look);
  // The displacement of the tissue, from the next image on; null: at rest.
  void set_moved_tissue(std::shared_ptr<const imaging::TissueDisplacement> moved);
  void pause(bool on) { paused_.store(on); }
  bool is_paused() const { return paused_.load(); }
  CameraStatus status() const;

 private:
  class Show;

  void run(const std::stop_token& stop);
  // One pass through the source; false: it cannot be restarted, or stop was requested.
  bool play(const std::stop_token& stop, Show* show);
  bool show_pictures(const std::stop_token& stop, Show* show);

  std::shared_ptr<const OpenCase> patient_;
  tracking::FootageFiles files_;
  std::filesystem::path registration_;
  std::function<void()> on_picture_;
  std::atomic<bool> paused_{false};
  mutable std::mutex lock_;  // guards the three below
  CameraStatus status_;
  std::optional<tracking::AugmentedLook> look_;  // not used yet
  std::shared_ptr<const imaging::TissueDisplacement> moved_;
  std::jthread thread_;
};

}  // namespace bodkin::app
