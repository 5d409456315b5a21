#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace bodkin::tracking {

// What a camera's driver is asked for, as the system has it. Tests put a camera of their own in its place.
class VideoDevice {
 public:
  virtual ~VideoDevice() = default;

  // Each returns 0, or the errno of what went wrong.
  virtual int open(const std::string& name) = 0;
  // A request of Video4Linux 2 (linux/videodev2.h) and its argument.
  virtual int control(unsigned long request, void* argument) = 0;  // NOLINT: the kernel's type
  // Null on failure.
  virtual void* map(std::size_t length, long long offset) = 0;
  virtual void unmap(void* at, std::size_t length) = 0;
  // Waits for a picture; ETIME when none came.
  virtual int wait(int milliseconds) = 0;
  virtual void close() = 0;
};

// That of the kernel.
std::unique_ptr<VideoDevice> system_video_device();

}  // namespace bodkin::tracking
