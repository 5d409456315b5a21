// A camera with a replaced driver, which keeps the rules of Video4Linux 2 and stores its settings.
#include "tracking/live_camera.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tracking/jpeg_file.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/videodev2.h>

#include "core/error.h"

namespace bodkin::tracking {
namespace {

using testing::HasSubstr;

// The state that the test inspects after the camera has taken its device.
struct CameraState {
  std::map<unsigned, int> controls = {{V4L2_CID_FOCUS_AUTO, 1},
                                      {V4L2_CID_FOCUS_ABSOLUTE, 30},
                                      {V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_APERTURE_PRIORITY},
                                      {V4L2_CID_EXPOSURE_ABSOLUTE, 156},
                                      {V4L2_CID_GAIN, 20},
                                      {V4L2_CID_AUTO_WHITE_BALANCE, 1},
                                      {V4L2_CID_WHITE_BALANCE_TEMPERATURE, 4600},
                                      {V4L2_CID_SHARPNESS, 128}};
  std::set<unsigned> stuck;  // controls that accept no value
  int open_refusal = 0, buffer_refusal = 0;
  int busy_tries = 0;  // tries for which another program still uses it
  bool captures = true, compressed = true;
  int width = 640, height = 480;
  bool streaming = false, is_open = false;
  std::size_t mapped = 0;
  // Images waiting to be read, oldest first, with their capture times.
  struct Waiting {
    std::string bytes;
    long milliseconds;  // NOLINT: the kernel's
    bool faulty = false;
  };
  std::vector<Waiting> waiting;
  int wait_result = ETIME;  // when no image waits
};

class ReplacedDevice : public VideoDevice {
 public:
  explicit ReplacedDevice(CameraState& state) : state_(state) {}

  int open(const std::string& /*name*/) override {
    state_.is_open = state_.open_refusal == 0;
    return state_.open_refusal;
  }
  void close() override { state_.is_open = false; }
  int wait(int /*milliseconds*/) override { return state_.waiting.empty() ? state_.wait_result : 0; }
  void* map(std::size_t length, long long offset) override {
    ++state_.mapped;
    std::vector<char>& buffer = buffers_[static_cast<unsigned>(offset)];
    buffer.resize(length);
    return buffer.data();
  }
  void unmap(void* /*at*/, std::size_t /*length*/) override { --state_.mapped; }

  int control(unsigned long request, void* argument) override {  // NOLINT
    switch (request) {
      case VIDIOC_QUERYCAP: {
        auto* able = static_cast<v4l2_capability*>(argument);
        able->capabilities = V4L2_CAP_DEVICE_CAPS;
        able->device_caps = state_.captures ? V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING : V4L2_CAP_META_CAPTURE;
        return 0;
      }
      case VIDIOC_S_FMT: {
        v4l2_pix_format& format = static_cast<v4l2_format*>(argument)->fmt.pix;
        format.width = static_cast<unsigned>(state_.width);
        format.height = static_cast<unsigned>(state_.height);
        format.pixelformat = state_.compressed ? V4L2_PIX_FMT_MJPEG : V4L2_PIX_FMT_YUYV;
        format.bytesperline = 2 * format.width;
        return 0;
      }
      case VIDIOC_S_PARM:
        static_cast<v4l2_streamparm*>(argument)->parm.capture.timeperframe = {1, 25};
        return 0;
      case VIDIOC_QUERYCTRL: {
        auto* asked = static_cast<v4l2_queryctrl*>(argument);
        asked->minimum = 0;
        return state_.controls.contains(asked->id) ? 0 : EINVAL;
      }
      case VIDIOC_G_CTRL: {
        auto* asked = static_cast<v4l2_control*>(argument);
        if (!state_.controls.contains(asked->id)) return EINVAL;
        asked->value = state_.controls[asked->id];
        return 0;
      }
      case VIDIOC_S_CTRL: {
        const auto* wanted = static_cast<v4l2_control*>(argument);
        if (!state_.controls.contains(wanted->id)) return EINVAL;
        if (state_.stuck.contains(wanted->id)) return EBUSY;
        state_.controls[wanted->id] = wanted->value;
        return 0;
      }
      case VIDIOC_REQBUFS:
        if (state_.busy_tries > 0) {
          --state_.busy_tries;
          return EBUSY;
        }
        if (state_.buffer_refusal != 0) return state_.buffer_refusal;
        static_cast<v4l2_requestbuffers*>(argument)->count = 3;
        return 0;
      case VIDIOC_QUERYBUF: {
        auto* buffer = static_cast<v4l2_buffer*>(argument);
        buffer->length = 2U * static_cast<unsigned>(state_.width * state_.height);
        buffer->m.offset = 4096U * buffer->index;
        return 0;
      }
      case VIDIOC_QBUF:
        free_.push_back(static_cast<v4l2_buffer*>(argument)->index);
        return 0;
      case VIDIOC_STREAMON:
        state_.streaming = true;
        return 0;
      case VIDIOC_STREAMOFF:
        state_.streaming = false;
        return 0;
      case VIDIOC_DQBUF: {
        if (state_.waiting.empty() || free_.empty()) return EAGAIN;
        const CameraState::Waiting picture = state_.waiting.front();
        state_.waiting.erase(state_.waiting.begin());
        auto* buffer = static_cast<v4l2_buffer*>(argument);
        buffer->index = free_.front();
        free_.erase(free_.begin());
        std::copy(picture.bytes.begin(), picture.bytes.end(), buffers_[4096U * buffer->index].begin());
        buffer->bytesused = static_cast<unsigned>(picture.bytes.size());
        buffer->flags = picture.faulty ? V4L2_BUF_FLAG_ERROR : 0U;
        buffer->timestamp = {picture.milliseconds / 1000, 1000 * (picture.milliseconds % 1000)};
        return 0;
      }
      default:
        return ENOTTY;
    }
  }

 private:
  CameraState& state_;
  std::map<unsigned, std::vector<char>> buffers_;
  std::vector<unsigned> free_;
};

SourceOptions options_of(const CameraState& state) {
  SourceOptions options;
  options.width = state.width;
  options.height = state.height;
  options.busy_patience = 0.0;
  return options;
}

std::string refusal_of(CameraState& state, const SourceOptions& options) {
  try {
    const LiveCamera camera("/dev/video0", options, std::make_unique<ReplacedDevice>(state));
  } catch (const InputError& error) {
    EXPECT_FALSE(state.is_open);
    EXPECT_EQ(state.mapped, 0U);
    return error.what();
  }
  return "";
}

std::string picture_of(int level, const CameraState& state) {
  GreyImage picture(state.width, state.height);
  std::fill(picture.pixels.begin(), picture.pixels.end(), static_cast<std::uint8_t>(level));
  return encode_jpeg(picture, 95);
}

TEST(LiveCamera, locks_what_would_change_the_lens_or_the_light) {
  CameraState state;
  {
    const LiveCamera camera("/dev/video0", options_of(state), std::make_unique<ReplacedDevice>(state));
    EXPECT_EQ(state.controls[V4L2_CID_FOCUS_AUTO], 0);
    EXPECT_EQ(state.controls[V4L2_CID_EXPOSURE_AUTO], V4L2_EXPOSURE_MANUAL);
    EXPECT_EQ(state.controls[V4L2_CID_AUTO_WHITE_BALANCE], 0);
    EXPECT_EQ(state.controls[V4L2_CID_SHARPNESS], 0);
    const CameraControls expected{30, 156, 20, 4600, 0};
    EXPECT_EQ(camera.controls(), expected);
    EXPECT_DOUBLE_EQ(camera.rate(), 25.0);
    EXPECT_TRUE(camera.live());
    EXPECT_TRUE(state.streaming);
    EXPECT_EQ(state.mapped, 3U);
  }
  EXPECT_FALSE(state.streaming);
  EXPECT_FALSE(state.is_open);
  EXPECT_EQ(state.mapped, 0U);
}

TEST(LiveCamera, goes_back_to_what_it_was_calibrated_with_or_is_refused) {
  CameraState state;
  SourceOptions options = options_of(state);
  options.locks = CameraControls{45, 100, 8, 5000, 0};
  {
    const LiveCamera camera("/dev/video0", options, std::make_unique<ReplacedDevice>(state));
    EXPECT_EQ(camera.controls(), *options.locks);
    EXPECT_EQ(state.controls[V4L2_CID_FOCUS_ABSOLUTE], 45);
  }
  state.stuck = {V4L2_CID_FOCUS_ABSOLUTE};
  options.locks->focus = 60;
  EXPECT_THAT(refusal_of(state, options), HasSubstr("calibrated with focus 60, but has 45 now"));
  state.controls.erase(V4L2_CID_FOCUS_ABSOLUTE);
  EXPECT_THAT(refusal_of(state, options), HasSubstr("has no such control"));
}

TEST(LiveCamera, a_camera_that_focuses_by_itself_for_ever_is_refused) {
  CameraState state;
  state.stuck = {V4L2_CID_FOCUS_AUTO};
  EXPECT_THAT(refusal_of(state, options_of(state)), HasSubstr("automatic focus"));
  state.controls.erase(V4L2_CID_FOCUS_AUTO);  // a fixed lens
  EXPECT_EQ(refusal_of(state, options_of(state)), "");
}

TEST(LiveCamera, an_exposure_that_cannot_be_fixed_is_said) {
  CameraState state;
  state.stuck = {V4L2_CID_EXPOSURE_AUTO};
  const LiveCamera camera("/dev/video0", options_of(state), std::make_unique<ReplacedDevice>(state));
  ASSERT_EQ(camera.notes().size(), 1U);
  EXPECT_THAT(camera.notes().front(), HasSubstr("exposure"));
}

TEST(LiveCamera, says_why_there_is_no_camera) {
  CameraState state;
  const SourceOptions options = options_of(state);
  state.open_refusal = ENOENT;
  EXPECT_THAT(refusal_of(state, options), HasSubstr("no such camera"));
  state.open_refusal = EACCES;
  EXPECT_THAT(refusal_of(state, options), HasSubstr("group video"));
  state.open_refusal = 0;
  state.buffer_refusal = EBUSY;
  EXPECT_THAT(refusal_of(state, options), HasSubstr("another program"));
  state.buffer_refusal = 0;
  state.captures = false;
  EXPECT_THAT(refusal_of(state, options), HasSubstr("gives no pictures"));
  state.captures = true;
  SourceOptions larger = options;
  larger.width = 1280;
  EXPECT_THAT(refusal_of(state, larger), HasSubstr("nearest are 640 x 480"));
}

TEST(LiveCamera, waits_for_a_camera_that_another_program_is_letting_go) {
  CameraState state;
  SourceOptions options = options_of(state);
  state.busy_tries = 2;
  EXPECT_THAT(refusal_of(state, options), HasSubstr("another program"));
  EXPECT_EQ(state.busy_tries, 1) << "without patience it is tried once";
  options.busy_patience = 60.0;
  state.busy_tries = 2;
  EXPECT_EQ(refusal_of(state, options), "");
  EXPECT_EQ(state.busy_tries, 0);
  // Errors that waiting cannot cure are reported at once.
  state.open_refusal = EACCES;
  EXPECT_THAT(refusal_of(state, options), HasSubstr("group video"));
}

TEST(LiveCamera, gives_the_newest_picture_with_the_time_of_the_driver) {
  CameraState state;
  LiveCamera camera("/dev/video0", options_of(state), std::make_unique<ReplacedDevice>(state));
  state.waiting = {{picture_of(40, state), 2000}, {picture_of(90, state), 2040}, {picture_of(200, state), 2080}};
  const auto picture = camera.next();
  ASSERT_TRUE(picture);
  EXPECT_DOUBLE_EQ(picture->time, 2.08);
  EXPECT_NEAR(picture->grey.at(100, 100), 200, 1);
  EXPECT_NEAR(picture->colour.at(100, 100).green, 200, 2);
  EXPECT_EQ(camera.dropped(), 2);
}

TEST(LiveCamera, skips_damaged_pictures_and_says_when_no_more_come) {
  CameraState state;
  LiveCamera camera("/dev/video0", options_of(state), std::make_unique<ReplacedDevice>(state));
  state.waiting = {{picture_of(40, state).substr(0, 300), 1000}};
  state.wait_result = ENODEV;
  EXPECT_THROW(
      {
        try {
          camera.next();
        } catch (const SystemError& error) {
          EXPECT_THAT(error.what(), HasSubstr("gone"));
          throw;
        }
      },
      SystemError);
  EXPECT_EQ(camera.damaged(), 1);
  state.wait_result = ETIME;
  EXPECT_THROW(camera.next(), SystemError);
  state.waiting = {{picture_of(70, state), 3000, true}};
  EXPECT_THROW(camera.next(), SystemError);
  EXPECT_EQ(camera.damaged(), 2);
}

TEST(LiveCamera, reads_pictures_that_are_not_compressed) {
  CameraState state;
  state.compressed = false;
  LiveCamera camera("/dev/video0", options_of(state), std::make_unique<ReplacedDevice>(state));
  // Pure red of ITU-R BT.601: Y 81, U 90, V 240.
  std::string bytes;
  for (int i = 0; i < state.width * state.height / 2; ++i) bytes += std::string("\x51\x5A\x51\xF0", 4);
  state.waiting = {{bytes, 500}};
  const auto picture = camera.next();
  ASSERT_TRUE(picture);
  const imaging::Rgb pixel = picture->colour.at(320, 240);
  EXPECT_NEAR(pixel.red, 255, 2);
  EXPECT_NEAR(pixel.green, 0, 2);
  EXPECT_NEAR(pixel.blue, 0, 2);
  EXPECT_NEAR(picture->grey.at(320, 240), 76, 1);  // 255/219 (81 - 16)
}

}  // namespace
}  // namespace bodkin::tracking
