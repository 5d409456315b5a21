#include "app/models/demo_footage.h"

#include <exception>
#include <string_view>
#include <system_error>
#include <utility>

#include "tracking/footage_scene.h"

namespace bodkin::app {

namespace fs = std::filesystem;

namespace {

constexpr int demo_pictures = 90, demo_width = 960, demo_height = 540;

// Thrown out of a Progress to end the work.
struct RenderingCancelled : std::exception {
  const char* what() const noexcept override { return "given up"; }
};

}  // namespace

DemoFootage::DemoFootage(fs::path folder)
    : folder_(std::move(folder)), thread_([this](const std::stop_token& stop) {
        std::string error;
        try {
          render(stop);
        } catch (const std::exception& failure) {
          error = failure.what();
        }
        const std::lock_guard guard(lock_);
        status_.error = error;
        status_.is_ready = error.empty();
      }) {}

DemoFootage::~DemoFootage() {
  thread_.request_stop();
  thread_.join();  // before what it uses goes
}

DemoFootage::Status DemoFootage::status() const {
  const std::lock_guard guard(lock_);
  return status_;
}

// First under a temporary name, so that a folder of the final name is always complete.
void DemoFootage::render(const std::stop_token& stop) {
  if (fs::exists(folder_ / "scene.json")) return;
  fs::path unfinished = folder_;
  unfinished += ".part";
  fs::remove_all(unfinished);
  fs::create_directories(folder_.parent_path());
  tracking::SceneOptions options;
  options.frames = demo_pictures;
  options.width = demo_width;
  options.height = demo_height;
  options.rate = 15.0;
  options.look.samples = 3;
  try {
    tracking::render_scene(unfinished, options, [&](std::string_view, double fraction) {
      if (stop.stop_requested()) throw RenderingCancelled();
      const std::lock_guard guard(lock_);
      status_.fraction = fraction;
    });
    fs::remove_all(folder_);
    fs::rename(unfinished, folder_);
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(unfinished, ignored);
    throw;
  }
}

}  // namespace bodkin::app
