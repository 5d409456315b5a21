#include "tracking/picture_source.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "tracking/footage_scene.h"
#include "tracking/live_camera.h"
#include "tracking/video_device.h"
#include "tracking/video_reader.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"

namespace bodkin::tracking {

namespace {

namespace fs = std::filesystem;

class FolderSource : public PictureSource {
 public:
  explicit FolderSource(Footage footage) : footage_(std::move(footage)) {}

  std::optional<SourcePicture> next() override {
    if (at_ == footage_.frames.size()) return std::nullopt;
    const FootageFrame& frame = footage_.frames[at_++];
    SourcePicture picture;
    picture.arrived = std::chrono::steady_clock::now();
    picture.colour = read_picture(footage_.folder / frame.file);
    picture.grey = grey_of(picture.colour);
    picture.time = frame.time;
    picture.camera_from_body = frame.camera_from_body;
    return picture;
  }
  int count() const override { return static_cast<int>(footage_.frames.size()); }
  double rate() const override {
    const double span = footage_.frames.back().time - footage_.frames.front().time;
    return span > 0.0 ? static_cast<double>(footage_.frames.size() - 1) / span : 30.0;
  }
  std::vector<std::string> bodies() const override { return footage_.bodies; }

 private:
  Footage footage_;
  std::size_t at_ = 0;
};

}  // namespace

std::string sentence_of(const std::vector<std::string>& notes) {
  return fmt::format("{}", fmt::join(notes, "; "));
}

std::unique_ptr<PictureSource> open_source(const std::string& name, const SourceOptions& options) {
  std::error_code code;
  if (fs::is_directory(name, code)) return std::make_unique<FolderSource>(open_footage(name, options.rate));
  if (name.starts_with("/dev/") || fs::is_character_file(name, code)) {
    return std::make_unique<LiveCamera>(name, options, system_video_device());
  }
  if (fs::is_regular_file(name, code)) return open_video(name);
  throw InputError(
      fmt::format("{}: there is nothing of that name; expected a folder of pictures, such as 'bodkin scene render' "
                  "makes, a video file or a camera such as /dev/video0",
                  name));
}

}  // namespace bodkin::tracking
