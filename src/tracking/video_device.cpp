#include "tracking/video_device.h"

#include <cerrno>

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace bodkin::tracking {

namespace {

class SystemVideoDevice : public VideoDevice {
 public:
  ~SystemVideoDevice() override {
    if (file_ >= 0) ::close(file_);
  }
  int open(const std::string& name) override {
    file_ = ::open(name.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    return file_ < 0 ? errno : 0;
  }
  int control(unsigned long request, void* argument) override {  // NOLINT
    int done = 0;
    do {
      done = ioctl(file_, request, argument);
    } while (done < 0 && errno == EINTR);
    return done < 0 ? errno : 0;
  }
  void* map(std::size_t length, long long offset) override {
    void* const at = mmap(nullptr, length, PROT_READ | PROT_WRITE, MAP_SHARED, file_, offset);
    return at == MAP_FAILED ? nullptr : at;
  }
  void unmap(void* at, std::size_t length) override { munmap(at, length); }
  int wait(int milliseconds) override {
    pollfd asked{file_, POLLIN, 0};
    const int ready = poll(&asked, 1, milliseconds);
    if (ready < 0) return errno;
    if (ready == 0) return ETIME;
    return (asked.revents & (POLLERR | POLLHUP | POLLNVAL)) != 0 ? ENODEV : 0;
  }
  void close() override {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
  }

 private:
  int file_ = -1;
};

}  // namespace

std::unique_ptr<VideoDevice> system_video_device() {
  return std::make_unique<SystemVideoDevice>();
}

}  // namespace bodkin::tracking
