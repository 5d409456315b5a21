#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tracking/picture_source.h"
#include "tracking/video_device.h"

namespace bodkin::tracking {

// A camera through Video4Linux 2. Focus, exposure, gain and white balance are locked, sharpening is switched off:
// refocusing changes the lens, and sharpening moves edges. A camera whose automatic focus cannot be switched off is
// rejected.
class LiveCamera : public PictureSource {
 public:
  // `name`: the device file. A camera in use by another program is tried again for options.busy_patience. Throws
  // InputError when it is missing, still busy, not permitted, not a camera, lacks the requested size or cannot be
  // locked as for its calibration.
  LiveCamera(std::string name, const SourceOptions& options, std::unique_ptr<VideoDevice> device);
  ~LiveCamera() override;
  LiveCamera(const LiveCamera&) = delete;
  LiveCamera& operator=(const LiveCamera&) = delete;

  // The newest image of the camera; older ones not read are dropped. `time`: of the driver's own time stamp. A
  // damaged image is skipped. Throws SystemError when none arrives for two seconds or it was unplugged.
  std::optional<SourcePicture> next() override;
  int count() const override { return 0; }
  double rate() const override { return rate_; }
  CameraControls controls() const override { return controls_; }
  std::vector<std::string> notes() const override;

  // Numbers of images not read in time, and of damaged ones.
  int dropped() const { return dropped_; }
  int damaged() const { return damaged_; }

 private:
  struct Buffer {
    void* at;
    std::size_t length;
  };

  void start(const SourceOptions& options);
  [[noreturn]] void refuse(int reason);
  void choose_format(const SourceOptions& options);
  void lock(const std::optional<CameraControls>& wanted);
  bool set(unsigned id, int value);
  std::optional<int> get(unsigned id);
  void begin();
  void release();
  bool decode(const Buffer& buffer, std::size_t used, SourcePicture& picture) const;

  std::string name_;
  std::unique_ptr<VideoDevice> device_;
  std::vector<Buffer> buffers_;
  CameraControls controls_;
  int width_ = 0, height_ = 0, row_bytes_ = 0;
  bool compressed_ = true;
  double rate_ = 30.0;
  int dropped_ = 0, damaged_ = 0;
  bool has_fixed_exposure_ = true;
  bool busy_ = false;  // the reason of the last refusal
};

}  // namespace bodkin::tracking
