#include "tracking/video_reader.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"
#include "io/run_program.h"

namespace bodkin::tracking {

namespace {

constexpr double most_unevenness = 0.25;  // of a constant rate's intervals, against their middle

// Standard output of a program that runs beside this one.
class ProgramPipe {
 public:
  explicit ProgramPipe(std::vector<std::string> command) {
    int ends[2] = {-1, -1};
    if (pipe2(ends, O_CLOEXEC) != 0) throw SystemError("no pipe can be opened; too many files are open");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    std::vector<char*> arguments;
    for (std::string& word : command) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int refused = posix_spawnp(&child_, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    from_ = ends[0];
    if (refused != 0) {
      close(from_);
      throw SystemError(fmt::format("the program {} is missing; install the Debian package ffmpeg", command.front()));
    }
  }
  ~ProgramPipe() {
    close(from_);
    kill(child_, SIGTERM);
    int status = 0;
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
  }
  ProgramPipe(const ProgramPipe&) = delete;
  ProgramPipe& operator=(const ProgramPipe&) = delete;

  // As many bytes as are available, up to `size`.
  std::size_t read(char* to, std::size_t size) const {
    std::size_t done = 0;
    while (done < size) {
      const ssize_t got = ::read(from_, to + done, size - done);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) break;
      done += static_cast<std::size_t>(got);
    }
    return done;
  }

 private:
  pid_t child_ = -1;
  int from_ = -1;
};

class VideoSource : public PictureSource {
 public:
  VideoSource(std::string name, int width, int height, std::vector<double> times)
      : name_(std::move(name)),
        width_(width),
        height_(height),
        times_(std::move(times)),
        pipe_({"ffmpeg", "-v", "error", "-nostdin", "-noautorotate", "-i", "file:" + name_, "-map", "0:v:0", "-vsync",
               "passthrough", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"}) {}

  std::optional<SourcePicture> next() override {
    if (at_ == times_.size()) return std::nullopt;
    SourcePicture picture;
    picture.arrived = std::chrono::steady_clock::now();
    picture.colour = imaging::ImageRgb(width_, height_);
    static_assert(sizeof(imaging::Rgb) == 3);
    const std::size_t size = picture.colour.pixels.size() * sizeof(imaging::Rgb);
    if (pipe_.read(reinterpret_cast<char*>(picture.colour.pixels.data()), size) != size) {
      if (at_ == 0) throw InputError(fmt::format("{}: no picture of this video can be decoded", name_));
      at_ = times_.size();  // a packet without a picture, or the file ends early
      return std::nullopt;
    }
    picture.grey = grey_of(picture.colour);
    picture.time = times_[at_++];
    return picture;
  }
  int count() const override { return static_cast<int>(times_.size()); }
  double rate() const override {
    return times_.back() > 0.0 ? static_cast<double>(times_.size() - 1) / times_.back() : 30.0;
  }
  std::vector<std::string> notes() const override {
    if (times_.size() < 3) return {};
    std::vector<double> intervals;
    for (std::size_t i = 1; i < times_.size(); ++i) intervals.push_back(times_[i] - times_[i - 1]);
    std::sort(intervals.begin(), intervals.end());
    const double middle = intervals[intervals.size() / 2];
    const double low = intervals.front(), high = intervals.back();
    if (high - low <= most_unevenness * middle) return {};
    return {
        fmt::format("{}: the time between pictures varies from {:.0f} to {:.0f} ms; every picture keeps its own time",
                    name_, 1000.0 * low, 1000.0 * high)};
  }

 private:
  std::string name_;
  int width_, height_;
  std::vector<double> times_;
  ProgramPipe pipe_;
  std::size_t at_ = 0;
};

}  // namespace

std::unique_ptr<PictureSource> open_video(const std::filesystem::path& file) {
  const std::string name = file.string();
  const io::ProgramResult probed =
      io::run_program({"ffprobe", "-v", "error", "-select_streams", "v:0", "-show_entries",
                       "stream=width,height:packet=pts_time", "-of", "json", "file:" + name},
                      "", "ffmpeg");
  const nlohmann::json json = nlohmann::json::parse(probed.output, nullptr, false);
  const InputError no_video(
      fmt::format("{}: not a video that ffmpeg reads; expected a folder of pictures, a video "
                  "file or a camera such as /dev/video0",
                  name));
  if (probed.exit_code != 0 || !json.is_object() || !json.contains("streams") || !json["streams"].is_array() ||
      json["streams"].empty() || !json.contains("packets") || !json["packets"].is_array()) {
    throw no_video;
  }
  const int width = json["streams"][0].value("width", 0), height = json["streams"][0].value("height", 0);
  if (width < 16 || height < 16 || static_cast<double>(width) * height > 64e6) throw no_video;
  std::vector<double> times;
  for (const nlohmann::json& packet : json["packets"]) {
    const std::string text = packet.value("pts_time", std::string());
    char* end = nullptr;
    const double time = std::strtod(text.c_str(), &end);
    if (end != text.c_str()) times.push_back(time);
  }
  if (times.empty()) throw no_video;
  std::sort(times.begin(), times.end());
  const double first = times.front();
  for (double& time : times) time -= first;
  return std::make_unique<VideoSource>(name, width, height, std::move(times));
}

}  // namespace bodkin::tracking
