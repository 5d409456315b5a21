#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace bodkin::tracking {

// The requests to a camera's driver, in the system's format. Tests substitute a mock camera.
class VideoDevice {
 public:
  virtual ~VideoDevice() = default;

  // Each function returns 0, or the errno of the error.
  virtual int open(const std::string& name) = 0;
  // A request of Video4Linux 2 (linux/videodev2.h) and its argument.
  virtual int control(unsigned long request, void* argument) = 0;  // NOLINT: the kernel's type
  // Null on failure.
  virtual void* map(std::size_t length, long long offset) = 0;
  virtual void unmap(void* at, std::size_t length) = 0;
  // Waits for an image; ETIME when none came.
  virtual int wait(int milliseconds) = 0;
  virtual void close() = 0;
};

// The kernel's device.
std::unique_ptr<VideoDevice> system_video_device();

}  // namespace bodkin::tracking
