#include "cli/ultrasound_reference.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parse_numbers.h"
#include "imaging/png_file.h"
#include "io/image_worker.h"
#include "io/resources.h"
#include "io/sequence_header.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_png = std::size_t{256} << 20U;  // bytes
constexpr double largest_side = 400.0;                        // mm
constexpr int least_crop = 16;                                // pixels
constexpr double least_window = 12.0;                         // pixels, of a window that was not given
constexpr double square = 0.01;                               // share by which the sides of a pixel may differ

// Grey levels as stored in a file.
struct StoredImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
  double across = 0.0, down = 0.0;  // mm between columns, rows; 0: not given
  std::string orientation;          // as in SequenceHeader
  std::string caption;
};

// "FILE:3" as the file and its frame; a file with such a name is that file.
std::pair<fs::path, std::optional<std::size_t>> file_and_frame(const std::string& text) {
  std::error_code ignored;
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0 || fs::exists(text, ignored)) return {text, std::nullopt};
  std::size_t frame = 0;
  const char* const end = text.data() + text.size();
  const auto [last, failed] = std::from_chars(text.data() + colon + 1, end, frame);
  if (failed != std::errc() || last != end) {
    throw InputError(
        fmt::format("--beside is '{}', which is not a file; expected a picture, or a sequence and the number of a "
                    "frame from 0, such as scan.mha:3",
                    text));
  }
  return {text.substr(0, colon), frame};
}

StoredImage stored_png(const fs::path& file, const std::optional<std::size_t>& frame) {
  if (frame.value_or(0) != 0) {
    throw InputError(fmt::format("--beside asks for frame {} of {}, which is one picture; leave out ':{}'", *frame,
                                 file.string(), *frame));
  }
  const imaging::ImageRgb image = imaging::decode_png(io::read_text_file(file, largest_png), file.string());
  StoredImage stored{image.width, image.height, {}, 0.0, 0.0, "", file.filename().string()};
  stored.pixels.reserve(image.pixels.size());
  for (const imaging::Rgb& pixel : image.pixels) {  // luma of ITU-R BT.601
    stored.pixels.push_back(
        static_cast<std::uint8_t>((299 * pixel.red + 587 * pixel.green + 114 * pixel.blue + 500) / 1000));
  }
  return stored;
}

StoredImage stored_image(const fs::path& file, const std::optional<std::size_t>& asked) {
  const anatomy::LabelVolume volume = io::read_labels_isolated(file);  // whole numbers of 16 bits
  const std::array<int, 3>& size = volume.grid.size;
  const std::size_t frame = asked.value_or(0);
  if (frame >= static_cast<std::size_t>(size[2])) {
    throw InputError(fmt::format("--beside asks for frame {} of {}, which has {}; expected 0 to {}", frame,
                                 file.string(), size[2], size[2] - 1));
  }
  StoredImage stored{size[0], size[1], {}, 0.0, 0.0, "", file.filename().string()};
  if (size[2] > 1) stored.caption += fmt::format(", frame {}", frame);
  const std::size_t pixels = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]);
  stored.pixels.reserve(pixels);
  for (std::size_t at = frame * pixels; at < (frame + 1) * pixels; ++at) {
    if (volume.voxels[at] > 255) {
      throw InputError(fmt::format("{}: frame {} has the value {}, expected grey levels from 0 to 255", file.string(),
                                   frame, volume.voxels[at]));
    }
    stored.pixels.push_back(static_cast<std::uint8_t>(volume.voxels[at]));
  }
  const io::SequenceHeader header = io::read_sequence_header(file, frame);
  stored.orientation = header.orientation;
  const Vec3& spacing = volume.grid.spacing;
  if (header.calibrated()) {
    stored.across = header.across;
    stored.down = header.down;
  } else if (spacing.x() != 1.0 || spacing.y() != 1.0) {  // 1: as PLUS writes it, where it does not know
    stored.across = spacing.x();
    stored.down = spacing.y();
  }
  return stored;
}

// The columns and rows that --beside-crop leaves.
void crop(StoredImage& stored, const ReferenceOptions& options) {
  imaging::PixelWindow part{0, 0, stored.width, stored.height};
  if (!options.crop.empty()) {
    const std::vector<double> numbers = parse_numbers(options.crop, 4, "--beside-crop");
    const bool whole = std::all_of(numbers.begin(), numbers.end(), [](double n) { return n == std::floor(n); });
    const bool inside = numbers[0] >= 0.0 && numbers[1] >= 0.0 && numbers[2] > 0.0 && numbers[3] > 0.0 &&
                        numbers[0] + numbers[2] <= stored.width && numbers[1] + numbers[3] <= stored.height;
    if (!whole || !inside) {
      throw InputError(fmt::format(
          "--beside-crop is '{}'; expected left,top,width,height in whole pixels inside the picture, which "
          "has {} x {}",
          options.crop, stored.width, stored.height));
    }
    part = {static_cast<int>(numbers[0]), static_cast<int>(numbers[1]), static_cast<int>(numbers[2]),
            static_cast<int>(numbers[3])};
  }
  if (part.width < least_crop || part.height < least_crop) {
    throw InputError(fmt::format("{}: the picture has {} x {} pixels, expected at least {} x {}", stored.caption,
                                 part.width, part.height, least_crop, least_crop));
  }
  std::vector<std::uint8_t> pixels;
  for (int row = part.top; row < part.top + part.height; ++row) {
    const auto begin = stored.pixels.begin() + static_cast<std::ptrdiff_t>(row) * stored.width + part.left;
    pixels.insert(pixels.end(), begin, begin + part.width);
  }
  stored.pixels = std::move(pixels);
  stored.width = part.width;
  stored.height = part.height;
}

double pixel_of(const StoredImage& stored, const ReferenceOptions& options) {
  double pixel = options.pixel;
  if (!options.pixel_given.given()) {
    if (!(stored.across > 0.0)) {
      throw InputError(fmt::format(
          "{}: the file does not say how large its pixels are; say it with --beside-pixel, in mm", stored.caption));
    }
    if (std::abs(stored.across - stored.down) > square * stored.across) {
      throw InputError(
          fmt::format("{}: its pixels are {:.4g} x {:.4g} mm, expected square ones; resample it, or give with "
                      "--beside-pixel the size to assume",
                      stored.caption, stored.across, stored.down));
    }
    pixel = 0.5 * (stored.across + stored.down);
  }
  const double side = pixel * std::max(stored.width, stored.height);
  if (!(side <= largest_side)) {
    throw InputError(
        fmt::format("{}: {} x {} pixels of {:.4g} mm are {:.0f} mm, expected at most {:.0f}; say the size "
                    "of its pixels with --beside-pixel, in mm",
                    stored.caption, stored.width, stored.height, pixel, side, largest_side));
  }
  return pixel;
}

std::vector<std::uint8_t> turned(const imaging::GreyImage& picture, bool columns, bool rows) {
  std::vector<std::uint8_t> pixels;
  pixels.reserve(picture.pixels.size());
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column) {
      const int from_row = rows ? picture.height - 1 - row : row;
      const int from_column = columns ? picture.width - 1 - column : column;
      pixels.push_back(picture.pixels[static_cast<std::size_t>(from_row) * static_cast<std::size_t>(picture.width) +
                                      static_cast<std::size_t>(from_column)]);
    }
  }
  return pixels;
}

imaging::GreyWindow window_of(const std::string& text, const std::string& option) {
  const std::vector<double> numbers = parse_numbers(text, 4, option);
  if (!(numbers[2] > 0.0 && numbers[3] > 0.0)) {
    throw InputError(fmt::format(
        "{} is '{}'; expected across,depth,width,height in mm with a width and a height above 0", option, text));
  }
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

imaging::GreyStatistics statistics_in(const imaging::GreyImage& picture, const imaging::GreyWindow& window,
                                      const char* option, const char* which) {
  const std::optional<imaging::PixelWindow> pixels = imaging::pixels_in(picture, window);
  if (pixels) return imaging::grey_statistics(picture, *pixels);
  const double half = 0.5 * picture.width * picture.pixel;
  throw InputError(fmt::format(
      "the window {:g},{:g},{:g},{:g} (across, depth, width, height in mm) does not lie in the {} picture with 8 x 8 "
      "pixels or more; that reaches from {:.1f} to {:.1f} across and from {:.1f} to {:.1f} deep, say a window in it "
      "with "
      "{}",
      window.across, window.depth, window.width, window.height, which, -half, half, picture.top,
      picture.top + picture.pixel * picture.height, option));
}

double bottom_of(const imaging::GreyImage& picture) {
  return picture.top + picture.pixel * picture.height;
}

std::string half_width_words(const std::optional<double>& width) {
  return width ? fmt::format("{:.2f}", *width) : "none";
}

}  // namespace

void add_reference_options(CLI::App& command, ReferenceOptions& options) {
  add_text(command, "--beside", options.file,
           "A real picture to show next to it: FILE or FILE:FRAME, a PNG, a MetaImage (.mha), NRRD or NIfTI");
  options.pixel_given = add_number(command, "--beside-pixel", options.pixel, 0.001, 10.0,
                                   "mm between the real picture's pixels, 0.001 to 10 (default: as the file says)")
                            .without_default();
  add_text(command, "--beside-crop", options.crop,
           "The part of the file that is the picture, pixels: left,top,width,height");
  add_text(command, "--window", options.window,
           "With --beside: where grey levels are compared, mm: across,depth,width,height (default: the middle)");
  add_text(command, "--beside-window", options.real_window, "The same in the real picture (default: as --window)");
}

imaging::ReferenceImage read_reference_image(const ReferenceOptions& options, const anatomy::UltrasoundProbe& probe,
                                             imaging::OrientationMarkerSide mark) {
  const auto [file, frame] = file_and_frame(options.file);
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) {
    throw InputError(
        fmt::format("--beside is '{}', which is a folder; expected a picture or a sequence", options.file));
  }
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  StoredImage stored = ending == ".png" ? stored_png(file, frame) : stored_image(file, frame);
  crop(stored, options);
  imaging::ReferenceImage real;
  real.caption = stored.caption;
  imaging::GreyImage& picture = real.picture;
  picture = {stored.width, stored.height, pixel_of(stored, options), 0.0, std::move(stored.pixels)};
  for (const Eigen::Vector2d& corner : imaging::field_of_view(probe, 1.0))
    picture.top = std::min(picture.top, corner.y());
  const std::string& orientation = stored.orientation;
  if (orientation.size() < 2 || (orientation[0] != 'M' && orientation[0] != 'U') ||
      (orientation[1] != 'F' && orientation[1] != 'N')) {
    return real;
  }
  const bool stored_right = orientation[0] == 'M';  // the marked side: where the columns go
  picture.pixels =
      turned(picture, stored_right != (mark == imaging::OrientationMarkerSide::right), orientation[1] == 'N');
  real.mark = mark;
  return real;
}

void match_reference_image(const UltrasoundOptions& options, const imaging::ReferenceImage& real,
                           station::UltrasoundChoice& choice) {
  const double pixel = real.picture.pixel;
  if (!options.depth_given.given()) {
    const double depth = bottom_of(real.picture) - pixel;  // of the last row's centres
    if (!(depth >= 10.0)) {
      throw InputError(
          fmt::format("{}: the picture is {:.1f} mm deep, expected 10 or more; say the size of its pixels with "
                      "--beside-pixel, or the depth to be simulated with --depth",
                      real.caption, depth));
    }
    choice.settings.depth = depth;
    if (!options.focus_given.given()) choice.settings.focus = std::max(5.0, 0.5 * depth);
  }
  if (options.size_given.given()) return;
  Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = low;
  for (const Eigen::Vector2d& corner : imaging::field_of_view(choice.probe, choice.settings.depth)) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const auto pixels = [pixel](double side) {
    return static_cast<int>(std::lround(std::clamp(side / pixel + 1.0, 16.0, 4096.0)));
  };
  choice.detail.width = pixels(high.x() - low.x());
  choice.detail.height = pixels(high.y() - low.y());
}

GreyComparison compare_greys(const ReferenceOptions& options, const imaging::GreyImage& simulated,
                             const imaging::GreyImage& real) {
  GreyComparison compared;
  const double wide = std::min(simulated.width * simulated.pixel, real.width * real.pixel);
  const double deep = std::min(bottom_of(simulated), bottom_of(real));
  const double least = least_window * std::max(simulated.pixel, real.pixel);
  compared.simulated_window =
      options.window.empty()
          ? imaging::GreyWindow{0.0, 0.5 * deep, std::max(wide / 3.0, least), std::max(deep / 10.0, least)}
          : window_of(options.window, "--window");
  compared.real_window =
      options.real_window.empty() ? compared.simulated_window : window_of(options.real_window, "--beside-window");
  compared.simulated = statistics_in(simulated, compared.simulated_window, "--window", "simulated");
  compared.real = statistics_in(real, compared.real_window, "--beside-window", "real");
  return compared;
}

std::vector<std::string> statistics_words(const imaging::GreyStatistics& statistics) {
  const auto& p = statistics.percentiles;
  return {fmt::format("grey 5, 25, 50, 75, 95 %: {}, {}, {}, {}, {}", p[0], p[1], p[2], p[3], p[4]),
          fmt::format("half-width across {}, along {} mm", half_width_words(statistics.across),
                      half_width_words(statistics.along))};
}

}  // namespace bodkin::cli
