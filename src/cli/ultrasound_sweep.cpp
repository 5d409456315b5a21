#include "cli/ultrasound_sweep.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "core/error.h"
#include "core/files.h"
#include "core/parse_numbers.h"
#include "imaging/png_file.h"
#include "imaging/ultrasound_screen/scanner_image.h"
#include "imaging/ultrasound_screen/sequence_file.h"
#include "io/csv_rows.h"
#include "io/resources.h"
#include "io/run_program.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_sweep_file = std::size_t{64} << 20U;  // bytes
constexpr std::size_t largest_sweep = std::size_t{3} << 30U;        // bytes of pixels held in memory
constexpr std::array<const char*, 4> video_endings = {".mp4", ".webm", ".avi", ".gif"};

imaging::SweepAngle parse_angle(const std::string& text, const std::string& option) {
  if (text.empty()) return {};
  const std::vector<double> ends = parse_numbers(text, 2, option);
  return {ends[0] * degree, ends[1] * degree};
}

// "%04d" of a file's name as its position, its length and its digits; nothing if there is none.
struct NumberPlace {
  std::size_t begin = 0, length = 0;
  int digits = 0;
};

std::optional<NumberPlace> number_place(const std::string& name) {
  const std::size_t percent = name.find('%');
  if (percent == std::string::npos) return std::nullopt;
  std::size_t end = percent + 1;
  while (end < name.size() && std::isdigit(static_cast<unsigned char>(name[end])) != 0) ++end;
  const std::string digits = name.substr(percent + 1, end - percent - 1);
  if (end >= name.size() || name[end] != 'd' || digits.size() > 2 || name.find('%', end) != std::string::npos) {
    throw InputError(fmt::format("--output is '{}'; expected one number in it such as frame-%04d.png", name));
  }
  return NumberPlace{percent, end + 1 - percent, digits.empty() ? 1 : std::stoi(digits)};
}

std::string numbered(const std::string& pattern, std::size_t number) {
  const NumberPlace place = number_place(pattern).value();
  return pattern.substr(0, place.begin) + fmt::format("{:0{}}", number, place.digits) +
         pattern.substr(place.begin + place.length);
}

void require_ffmpeg() {
  if (io::run_program({"ffmpeg", "-hide_banner", "-version"}, "", "ffmpeg").exit_code != 0) {
    throw SystemError("the program 'ffmpeg' does not run; reinstall it with: apt-get install --reinstall ffmpeg");
  }
}

void require_memory(std::size_t frames, std::size_t bytes_a_frame) {
  if (frames <= largest_sweep / bytes_a_frame) return;
  throw InputError(
      fmt::format("a sweep of {} frames of this size does not fit into one file, expected at most {}; choose fewer "
                  "--frames, a smaller --size, or a folder of pictures",
                  frames, largest_sweep / bytes_a_frame));
}

double number_in(const io::CsvRow& row, std::size_t field, const std::string& file) {
  const std::string& text = row.fields.at(field);
  double number = 0.0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failed == std::errc() && end == text.data() + text.size() && std::isfinite(number)) return number;
  throw InputError(fmt::format("{}:{}: field {} is '{}', expected a finite number", file, row.line, field + 1, text));
}

bool is_header(const io::CsvRow& row) {
  return !row.fields.empty() && !row.fields[0].empty() &&
         std::isalpha(static_cast<unsigned char>(row.fields[0][0])) != 0;
}

class SweepPictures {
 public:
  explicit SweepPictures(const SweepScene& scene) : scene_(scene) {}

  imaging::ImageRgb picture(const imaging::UltrasoundFrame& frame, const Pose& pose) {
    const imaging::OrientationMarkerSide mark = scene_.choice->mark;
    if (scene_.plain) return imaging::grey_image(frame, mark);
    imaging::ScannerImage picture;
    picture.moment = {frame, pose, scene_.choice->probe, scene_.choice->settings, scene_.needle_words};
    picture.mark = mark;
    picture.patient = scene_.patient->description.name;
    picture.touch = false;
    if (scene_.ct) add_ct(picture);
    return imaging::draw_scanner_image(picture, scene_.patient->library).pixels(1.0);
  }

 private:
  void add_ct(imaging::ScannerImage& picture) {
    const imaging::OrientationMarkerSide mark = picture.mark;
    std::vector<Vec3> needle;
    if (scene_.needle) {
      needle = {scene_.patient->description.procedure.path->entry, scene_.needle->pose.translation()};
    }
    picture.ct = imaging::ct_panel(*scene_.patient, picture.moment, mark, needle);
    if (named_.empty()) {
      std::set<anatomy::TissueId> seen;
      for (const imaging::SweepPose& at : scene_.poses) {
        const imaging::SlicePlane plane = imaging::plane_of(picture.moment.frame, at.pose, mark);
        for (const anatomy::TissueId id :
             imaging::tissues_present(imaging::cut(plane, scene_.patient->ct, scene_.patient->tissues))) {
          seen.insert(id);
        }
      }
      named_.assign(seen.begin(), seen.end());
    }
    picture.ct->named = named_;
  }

  const SweepScene& scene_;
  std::vector<anatomy::TissueId> named_;  // the tissues of every CT of the sweep
};

static_assert(sizeof(imaging::Rgb) == 3, "the pixels of a picture are what ffmpeg calls rgb24");

void append_pixels(std::string& bytes, const imaging::ImageRgb& image) {
  bytes.append(reinterpret_cast<const char*>(image.pixels.data()), sizeof(imaging::Rgb) * image.pixels.size());
}

std::vector<std::string> codec_of(const std::string& ending) {
  const std::string even = "pad=ceil(iw/2)*2:ceil(ih/2)*2";
  if (ending == ".gif") return {"-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse"};
  if (ending == ".webm") return {"-vf", even, "-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-pix_fmt", "yuv420p"};
  if (ending == ".avi") return {"-c:v", "mjpeg", "-q:v", "2", "-pix_fmt", "yuvj420p"};
  return {"-vf", even, "-c:v", "libx264", "-crf", "16", "-pix_fmt", "yuv420p", "-movflags", "+faststart"};
}

// Written to a temporary file first, then renamed, as core/files.h does.
void write_video(const std::string& file, const std::string& pixels, int width, int height, double rate) {
  const fs::path place(file);
  const fs::path temporary = place.parent_path() / fmt::format(".part-{}", place.filename().string());
  std::vector<std::string> command = {"ffmpeg",    "-hide_banner",
                                      "-loglevel", "error",
                                      "-nostdin",  "-y",
                                      "-f",        "rawvideo",
                                      "-pix_fmt",  "rgb24",
                                      "-s",        fmt::format("{}x{}", width, height),
                                      "-r",        fmt::format("{:g}", rate),
                                      "-i",        "pipe:0"};
  for (const std::string& word : codec_of(place.extension().string())) command.push_back(word);
  command.push_back("file:" + temporary.string());
  const io::ProgramResult result = io::run_program(command, pixels, "ffmpeg");
  std::error_code failed;
  if (result.exit_code == 0) fs::rename(temporary, place, failed);
  if (result.exit_code == 0 && !failed) return;
  std::error_code ignored;
  fs::remove(temporary, ignored);
  const std::string words = failed ? failed.message() : result.errors.substr(0, result.errors.find('\n'));
  throw SystemError(fmt::format("{}: ffmpeg could not write the video ({})", file, words));
}

}  // namespace

void add_sweep_options(CLI::App& command, SweepOptions& options) {
  add_text(command, "--sweep", options.file, "A file of poses: rows of time in s and 12 numbers, comma-separated");
  add_text(command, "--sweep-to", options.to, "Where the middle of the face ends, x,y,z in LPS mm");
  add_switch(command, "--on-skin", options.on_skin, "During the motion the face follows the skin");
  add_text(command, "--tilt", options.tilt, "From,to in degrees: the slice fans about the marked axis");
  add_text(command, "--rock", options.rock, "From,to in degrees: the probe rocks within its slice");
  add_text(command, "--rotate", options.rotate, "From,to in degrees: the slice turns about the depth axis");
  options.frames_given = add_whole_number(command, "--frames", options.frames, 1, 100000, "Frames of a sweep");
  options.rate_given = add_number(command, "--rate", options.rate, 1.0, 200.0, "Frames a second of a sweep");
}

SweepTarget sweep_target(const std::string& output) {
  const fs::path file(output);
  const std::string ending = file.extension().string();
  const bool video = std::find(video_endings.begin(), video_endings.end(), ending) != video_endings.end();
  if (ending == ".mha" || video) {
    require_writable(file, "--output");
    if (video) require_ffmpeg();
    return {video ? SweepKind::video : SweepKind::sequence, output};
  }
  if (ending == ".png") {
    if (!number_place(file.filename().string())) {
      throw InputError(fmt::format("--output is '{}'; expected a number in it such as frame-%04d.png", output));
    }
    if (file.parent_path().string().find('%') != std::string::npos) {
      throw InputError(fmt::format("--output is '{}'; expected the number in the name of the file", output));
    }
    require_writable(file, "--output");
    return {SweepKind::pictures, output};
  }
  std::error_code ignored;
  if (!ending.empty() && !fs::is_directory(file, ignored)) {
    throw InputError(fmt::format(
        "--output is '{}'; a sweep becomes .mha, .mp4, .webm, .avi, .gif, frame-%04d.png, or a folder of pictures",
        output));
  }
  if (fs::exists(file, ignored) && !fs::is_directory(file, ignored)) {
    throw InputError(fmt::format("--output is '{}', which is a file; expected a folder for the pictures", output));
  }
  if (output.find('%') != std::string::npos) {
    throw InputError(fmt::format("--output is '{}'; expected a folder without a percent sign", output));
  }
  return {SweepKind::pictures, (file / "frame-%04d.png").string()};
}

std::vector<imaging::SweepPose> read_sweep(const std::string& file) {
  const std::vector<io::CsvRow> rows =
      io::read_csv_rows(io::read_text_file(file, largest_sweep_file), file, {.separator = ',', .comments = true});
  std::vector<imaging::SweepPose> poses;
  for (const io::CsvRow& row : rows) {
    if (poses.empty() && is_header(row)) continue;
    if (row.fields.size() != 13 && row.fields.size() != 17) {
      throw InputError(
          fmt::format("{}:{}: the row has {} fields, expected 13: the time in s and 12 numbers row by row that take "
                      "the probe's mm "
                      "to LPS mm",
                      file, row.line, row.fields.size()));
    }
    std::vector<double> numbers;
    for (std::size_t field = 0; field < row.fields.size(); ++field) numbers.push_back(number_in(row, field, file));
    const double time = numbers.front();
    numbers.erase(numbers.begin());
    if (!poses.empty() && time < poses.back().time) {
      throw InputError(
          fmt::format("{}:{}: the time {} s is before the row above, expected rising times", file, row.line, time));
    }
    poses.push_back({time, station::parse_pose(numbers, fmt::format("{}:{}", file, row.line))});
  }
  if (poses.empty())
    throw InputError(fmt::format("{}: the file contains no pose, expected rows of 13 numbers", file));
  return poses;
}

imaging::SweepMotion motion_of(const SweepOptions& options) {
  imaging::SweepMotion motion;
  if (!options.to.empty()) motion.to = parse_point(options.to, "--sweep-to");
  motion.tilt = parse_angle(options.tilt, "--tilt");
  motion.rock = parse_angle(options.rock, "--rock");
  motion.rotate = parse_angle(options.rotate, "--rotate");
  motion.on_skin = options.on_skin;
  motion.frames = static_cast<int>(options.frames);
  motion.rate = options.rate;
  return motion;
}

SweepMade write_sweep(const SweepScene& scene, imaging::Ultrasound& machine, const SweepTarget& target,
                      const Progress& progress) {
  SweepMade made;
  SweepPictures pictures(scene);
  imaging::TrackedSequence sequence;
  std::string video;
  int width = 0, height = 0;
  for (std::size_t i = 0; i < scene.poses.size(); ++i) {
    if (progress) progress("scanning", static_cast<double>(i) / static_cast<double>(scene.poses.size()));
    const imaging::SweepPose& at = scene.poses[i];
    const imaging::UltrasoundFrame& frame = machine.image(at.pose, scene.needle);
    if (frame.why != imaging::NoImage::none && made.black++ == 0) made.why = imaging::reason(frame.why);
    if (target.kind == SweepKind::sequence) {
      if (i == 0) {
        require_memory(scene.poses.size(), frame.pixels.size());
        sequence = {frame.width,
                    frame.height,
                    frame.pixel,
                    frame.corner,
                    scene.choice->probe.name,
                    scene.choice->settings.depth,
                    {}};
      }
      imaging::TrackedFrame tracked{at.time, at.pose, true, std::nullopt, frame.pixels};
      if (scene.needle) tracked.needle = scene.needle->pose;
      sequence.frames.push_back(std::move(tracked));
      continue;
    }
    const imaging::ImageRgb image = pictures.picture(frame, at.pose);
    if (target.kind == SweepKind::pictures) {
      made.files.push_back(numbered(target.file, i));
      write_file(made.files.back(), imaging::encode_png(image));
      continue;
    }
    if (i == 0) require_memory(scene.poses.size(), sizeof(imaging::Rgb) * image.pixels.size());
    width = image.width;
    height = image.height;
    append_pixels(video, image);
  }
  if (progress) progress("scanning", 1.0);
  if (target.kind == SweepKind::pictures) return made;
  if (target.kind == SweepKind::sequence) {
    write_file(target.file, imaging::sequence_bytes(sequence, true));
  } else {
    write_video(target.file, video, width, height, scene.rate);
  }
  made.files = {target.file};
  return made;
}

}  // namespace bodkin::cli
