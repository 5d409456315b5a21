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

// How well a body was seen in the newest picture.
struct BodyNews {
  std::string name;
  tracking::TrackingStatus status = tracking::TrackingStatus::lost;
  double deviation = 0.0;   // mm, standard deviation of its tip in the camera's frame; meaningless when lost
  double residual = 0.0;    // share of the pattern's contrast
  double edge_ratio = 1.0;  // residual at the edges over that of flat parts
  int markers = 0;
};

// What the window shows of a camera.
struct CameraNews {
  std::string stage, error;                          // what is being opened; why nothing more comes, a sentence
  std::string note;                                  // what a person should know of this picture, a sentence
  std::string source_note;                           // the same of all pictures of this source
  std::uint64_t number = 0;                          // of the picture; 0: none yet
  std::shared_ptr<const imaging::ImageRgb> picture;  // with what is drawn over it
  double time = 0.0;                                 // s, of the picture
  double rate = 0.0;                                 // pictures/s, of the last second
  std::chrono::steady_clock::time_point arrived;     // when the picture had come, not decoded yet
  std::vector<BodyNews> bodies;
  std::optional<Pose> needle, probe;  // LPS mm, third axis into the patient; none: not seen well in this picture
  std::string tip;                    // what the needle's tip is in; empty: outside, or no needle
  bool tip_on_bone = false;
  bool large_oval = false;  // so large that the patient in it is drawn at half the resolution
};

// Pictures of a camera, a video or a folder, with the patient drawn into the mannequin, on a thread of its own: each
// picture is drawn with its own poses. A video or a folder plays in its own time, again and again. A camera that is
// not calibrated gives its pictures alone. A session can follow the tools meanwhile (tracking::announce); it ends
// with a passage through video or folder. All calls from one thread; none waits for a picture.
class CameraWatch {
 public:
  // `registration`: of patient and mannequin (bodkin register); empty: as in rendered footage. `on_picture` is called
  // on that thread whenever news() has another picture.
  CameraWatch(std::shared_ptr<const OpenCase> patient, const tracking::FootageFiles& files,
              const std::filesystem::path& registration, const tracking::AugmentedLook& look,
              std::function<void()> on_picture = {});
  ~CameraWatch();
  CameraWatch(const CameraWatch&) = delete;
  CameraWatch& operator=(const CameraWatch&) = delete;

  // From the next picture on.
  void set_look(const tracking::AugmentedLook& look);
  // How the tissue has moved, in the pictures from the next one on; null: it rests.
  void set_moved_tissue(std::shared_ptr<const imaging::MovedTissue> moved);
  void pause(bool on) { paused_.store(on); }
  bool is_paused() const { return paused_.load(); }
  CameraNews news() const;

 private:
  class Show;

  void run(const std::stop_token& stop);
  // One passage through the source; false: it has no end that could be begun anew, or it was told to stop.
  bool play(const std::stop_token& stop, Show* show);
  bool show_pictures(const std::stop_token& stop, Show* show);

  std::shared_ptr<const OpenCase> patient_;
  tracking::FootageFiles files_;
  std::filesystem::path registration_;
  std::function<void()> on_picture_;
  std::atomic<bool> paused_{false};
  mutable std::mutex lock_;  // guards the three below
  CameraNews news_;
  std::optional<tracking::AugmentedLook> look_;  // not used yet
  std::shared_ptr<const imaging::MovedTissue> moved_;
  std::jthread thread_;
};

}  // namespace bodkin::app
