#include "tracking/live_camera.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string_view>
#include <thread>
#include <utility>

#include "tracking/jpeg_file.h"
#include <fmt/format.h>
#include <linux/videodev2.h>

#include "core/error.h"

namespace bodkin::tracking {

namespace {

constexpr unsigned buffer_count = 4;
constexpr int patience = 2000;    // ms without a picture
constexpr int most_damaged = 30;  // one after the other
constexpr std::chrono::milliseconds between_tries{100};

InputError refusal(const std::string& name, int reason) {
  switch (reason) {
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return InputError(fmt::format("{}: there is no such camera; plug it in, and see 'ls /dev/video*'", name));
    case EBUSY:
      return InputError(fmt::format("{}: another program uses this camera; close that program", name));
    case EACCES:
    case EPERM:
      return InputError(fmt::format(
          "{}: you may not use this camera; join the group video with 'sudo adduser $USER video' and log in again",
          name));
    default:
      return InputError(fmt::format("{}: the camera refuses: {}", name, std::strerror(reason)));
  }
}

}  // namespace

LiveCamera::LiveCamera(std::string name, const SourceOptions& options, std::unique_ptr<VideoDevice> device)
    : name_(std::move(name)), device_(std::move(device)) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::duration<double>(options.busy_patience);
  while (true) {
    busy_ = false;
    try {
      start(options);
      return;
    } catch (...) {
      release();
      if (!busy_ || Clock::now() >= until) throw;
    }
    std::this_thread::sleep_for(between_tries);  // an ending program keeps its camera for a moment
  }
}

void LiveCamera::start(const SourceOptions& options) {
  if (const int refused = device_->open(name_); refused != 0) refuse(refused);
  v4l2_capability able{};
  const int refused = device_->control(VIDIOC_QUERYCAP, &able);
  const unsigned has = (able.capabilities & V4L2_CAP_DEVICE_CAPS) != 0 ? able.device_caps : able.capabilities;
  if (refused != 0 || (has & V4L2_CAP_VIDEO_CAPTURE) == 0 || (has & V4L2_CAP_STREAMING) == 0) {
    throw InputError(fmt::format(
        "{}: this device gives no pictures; a camera often has two device files, so try the other one", name_));
  }
  choose_format(options);
  lock(options.locks);
  begin();
}

void LiveCamera::refuse(int reason) {
  busy_ = reason == EBUSY;
  throw refusal(name_, reason);
}

LiveCamera::~LiveCamera() {
  int kind = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  device_->control(VIDIOC_STREAMOFF, &kind);
  release();
}

void LiveCamera::release() {
  for (const Buffer& buffer : buffers_) device_->unmap(buffer.at, buffer.length);
  buffers_.clear();
  device_->close();
}

void LiveCamera::choose_format(const SourceOptions& options) {
  std::string other;
  for (const unsigned kind : {V4L2_PIX_FMT_MJPEG, V4L2_PIX_FMT_YUYV}) {
    v4l2_format format{};
    format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    format.fmt.pix.width = static_cast<unsigned>(options.width);
    format.fmt.pix.height = static_cast<unsigned>(options.height);
    format.fmt.pix.pixelformat = kind;
    format.fmt.pix.field = V4L2_FIELD_NONE;
    if (const int refused = device_->control(VIDIOC_S_FMT, &format); refused != 0) {
      if (refused == EBUSY) refuse(refused);
      continue;
    }
    if (format.fmt.pix.pixelformat != kind) continue;
    width_ = static_cast<int>(format.fmt.pix.width);
    height_ = static_cast<int>(format.fmt.pix.height);
    row_bytes_ = std::max(static_cast<int>(format.fmt.pix.bytesperline), 2 * width_);
    compressed_ = kind == V4L2_PIX_FMT_MJPEG;
    if (width_ == options.width && height_ == options.height) {
      v4l2_streamparm rate{};
      rate.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
      rate.parm.capture.timeperframe = {1000U, static_cast<unsigned>(1000.0 * options.rate)};
      const v4l2_fract& got = rate.parm.capture.timeperframe;
      if (device_->control(VIDIOC_S_PARM, &rate) == 0 && got.numerator > 0 && got.denominator > 0)
        rate_ = static_cast<double>(got.denominator) / got.numerator;
      return;
    }
    other = fmt::format("{} x {}", width_, height_);
  }
  if (other.empty()) {
    throw InputError(fmt::format("{}: the camera gives neither MJPEG nor YUYV pictures, which are expected", name_));
  }
  throw InputError(fmt::format("{}: the camera has no pictures of {} x {}, the nearest are {}; ask for that size",
                               name_, options.width, options.height, other));
}

bool LiveCamera::set(unsigned id, int value) {
  v4l2_control control{id, value};
  return device_->control(VIDIOC_S_CTRL, &control) == 0;
}

std::optional<int> LiveCamera::get(unsigned id) {
  v4l2_queryctrl asked{};
  asked.id = id;
  if (device_->control(VIDIOC_QUERYCTRL, &asked) != 0 || (asked.flags & V4L2_CTRL_FLAG_DISABLED) != 0)
    return std::nullopt;
  v4l2_control control{id, 0};
  if (device_->control(VIDIOC_G_CTRL, &control) != 0) return std::nullopt;
  return control.value;
}

void LiveCamera::lock(const std::optional<CameraControls>& wanted) {
  if (get(V4L2_CID_FOCUS_AUTO)) {
    set(V4L2_CID_FOCUS_AUTO, 0);
    if (get(V4L2_CID_FOCUS_AUTO).value_or(1) != 0) {
      throw InputError(fmt::format(
          "{}: the automatic focus of this camera cannot be switched off, and every focus is another lens; use a "
          "camera with fixed focus",
          name_));
    }
  }
  if (const auto mode = get(V4L2_CID_EXPOSURE_AUTO)) {
    set(V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_MANUAL);
    // Some cameras support only shutter priority, which serves as well.
    if (get(V4L2_CID_EXPOSURE_AUTO) != V4L2_EXPOSURE_MANUAL)
      set(V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_SHUTTER_PRIORITY);
    const int now = get(V4L2_CID_EXPOSURE_AUTO).value_or(V4L2_EXPOSURE_AUTO);
    has_fixed_exposure_ = now == V4L2_EXPOSURE_MANUAL || now == V4L2_EXPOSURE_SHUTTER_PRIORITY;
  }
  if (get(V4L2_CID_AUTOGAIN)) set(V4L2_CID_AUTOGAIN, 0);
  if (get(V4L2_CID_AUTO_WHITE_BALANCE)) set(V4L2_CID_AUTO_WHITE_BALANCE, 0);
  if (get(V4L2_CID_HFLIP)) set(V4L2_CID_HFLIP, 0);
  v4l2_queryctrl sharpness{};
  sharpness.id = V4L2_CID_SHARPNESS;
  if (device_->control(VIDIOC_QUERYCTRL, &sharpness) == 0) set(V4L2_CID_SHARPNESS, sharpness.minimum);

  struct Lock {
    unsigned id;
    std::optional<int> CameraControls::*value;
    const char* name;
  };
  for (const Lock& lock : {Lock{V4L2_CID_FOCUS_ABSOLUTE, &CameraControls::focus, "focus"},
                           Lock{V4L2_CID_EXPOSURE_ABSOLUTE, &CameraControls::exposure, "exposure"},
                           Lock{V4L2_CID_GAIN, &CameraControls::gain, "gain"},
                           Lock{V4L2_CID_WHITE_BALANCE_TEMPERATURE, &CameraControls::white_balance, "white balance"},
                           Lock{V4L2_CID_SHARPNESS, &CameraControls::sharpness, "sharpness"}}) {
    const std::optional<int> value = wanted ? (*wanted).*lock.value : std::nullopt;
    if (value) set(lock.id, *value);
    controls_.*lock.value = get(lock.id);
    if (!value || controls_.*lock.value == value) continue;
    throw InputError(
        fmt::format("{}: this camera was calibrated with {} {}, but {}; use the camera that was "
                    "calibrated, or calibrate this one with 'bodkin camera calibrate'",
                    name_, lock.name, *value,
                    controls_.*lock.value ? fmt::format("has {} now", *(controls_.*lock.value))
                                          : std::string("has no such control")));
  }
}

void LiveCamera::begin() {
  v4l2_requestbuffers request{};
  request.count = buffer_count;
  request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  request.memory = V4L2_MEMORY_MMAP;
  if (const int refused = device_->control(VIDIOC_REQBUFS, &request); refused != 0) refuse(refused);
  for (unsigned n = 0; n < request.count; ++n) {
    v4l2_buffer buffer{};
    buffer.type = request.type;
    buffer.memory = V4L2_MEMORY_MMAP;
    buffer.index = n;
    if (const int refused = device_->control(VIDIOC_QUERYBUF, &buffer); refused != 0) refuse(refused);
    void* const at = device_->map(buffer.length, buffer.m.offset);
    if (at == nullptr) throw SystemError(fmt::format("{}: there is no memory for its pictures", name_));
    buffers_.push_back({at, buffer.length});
    if (const int refused = device_->control(VIDIOC_QBUF, &buffer); refused != 0) refuse(refused);
  }
  int kind = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (const int refused = device_->control(VIDIOC_STREAMON, &kind); refused != 0) refuse(refused);
}

bool LiveCamera::decode(const Buffer& buffer, std::size_t used, SourcePicture& picture) const {
  const auto* const bytes = static_cast<const unsigned char*>(buffer.at);
  if (compressed_) {
    try {
      const std::string_view text(reinterpret_cast<const char*>(bytes), used);
      picture.colour = decode_jpeg(text, name_);
      // The luma as sent; conversion through colours would lose a level or two.
      picture.grey = decode_jpeg_grey(text, name_);
    } catch (const InputError&) {
      return false;
    }
    return picture.grey.width == width_ && picture.grey.height == height_;
  }
  if (used < static_cast<std::size_t>(row_bytes_) * static_cast<std::size_t>(height_)) return false;
  picture.grey = GreyImage(width_, height_);
  picture.colour = imaging::ImageRgb(width_, height_);
  const auto level = [](double value) { return static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0)); };
  for (int y = 0; y < height_; ++y) {
    const unsigned char* const row = bytes + static_cast<std::size_t>(y) * static_cast<std::size_t>(row_bytes_);
    for (int x = 0; x < width_; ++x) {
      // Two pixels share their chroma: Y U Y V, of the range 16 to 235 (ITU-R BT.601).
      const unsigned char* const pair = row + static_cast<std::ptrdiff_t>(4) * (x / 2);
      const double luma = 255.0 / 219.0 * (row[2 * x] - 16.0);
      const double u = 255.0 / 224.0 * (pair[1] - 128.0), v = 255.0 / 224.0 * (pair[3] - 128.0);
      picture.grey.at(x, y) = level(luma);
      picture.colour.at(x, y) = {level(luma + 1.402 * v), level(luma - 0.344 * u - 0.714 * v),
                                 level(luma + 1.772 * u)};
    }
  }
  return true;
}

std::optional<SourcePicture> LiveCamera::next() {
  for (int bad = 0; bad < most_damaged;) {
    if (const int refused = device_->wait(patience); refused == EINTR) {
      continue;
    } else if (refused != 0) {
      throw SystemError(refused == ETIME
                            ? fmt::format("{}: no picture came for two seconds; is the cable intact?", name_)
                            : fmt::format("{}: the camera is gone; plug it in again", name_));
    }
    // The newest: a display slower than the camera must not fall behind.
    std::optional<v4l2_buffer> newest;
    for (;;) {
      v4l2_buffer buffer{};
      buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
      buffer.memory = V4L2_MEMORY_MMAP;
      const int refused = device_->control(VIDIOC_DQBUF, &buffer);
      if (refused == EAGAIN) break;
      if (refused != 0 || buffer.index >= buffers_.size())
        throw SystemError(fmt::format("{}: the camera is gone; plug it in again", name_));
      if (newest) {
        device_->control(VIDIOC_QBUF, &*newest);
        ++dropped_;
      }
      newest = buffer;
    }
    if (!newest) continue;
    SourcePicture picture;
    picture.arrived = std::chrono::steady_clock::now();
    picture.time =
        static_cast<double>(newest->timestamp.tv_sec) + 1e-6 * static_cast<double>(newest->timestamp.tv_usec);
    const Buffer& buffer = buffers_[newest->index];
    const bool sound = (newest->flags & V4L2_BUF_FLAG_ERROR) == 0 &&
                       decode(buffer, std::min<std::size_t>(newest->bytesused, buffer.length), picture);
    device_->control(VIDIOC_QBUF, &*newest);
    if (sound) return picture;
    ++damaged_;
    ++bad;
  }
  throw SystemError(fmt::format("{}: {} pictures one after the other were damaged; try another cable or socket",
                                name_, most_damaged));
}

std::vector<std::string> LiveCamera::notes() const {
  std::vector<std::string> warnings;
  if (!has_fixed_exposure_)
    warnings.push_back(name_ + ": the exposure of this camera cannot be fixed; keep the light steady");
  return warnings;
}

}  // namespace bodkin::tracking
