#include "cli/ultrasound_options.h"

#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "io/probe_library_file.h"

namespace bodkin::cli {

namespace {

std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  const char* cursor = text.data();
  const char* const end = text.data() + text.size();
  while (true) {
    double number = 0.0;
    const auto [next, failed] = std::from_chars(cursor, end, number);
    if (failed != std::errc() || !std::isfinite(number)) return {};
    numbers.push_back(number);
    if (next == end) return numbers;
    if (*next != ',' && *next != ' ') return {};
    cursor = next + 1;
  }
}

Vec3 outward_from(const std::string& side) {
  if (side == "back") return Vec3::UnitY();
  if (side == "front") return -Vec3::UnitY();
  if (side == "left") return Vec3::UnitX();
  if (side == "right") return -Vec3::UnitX();
  throw InputError(fmt::format("--from is '{}'; expected back, front, left or right", side));
}

std::pair<int, int> parse_size(const std::string& text) {
  int width = 0, height = 0;
  const char* const end = text.data() + text.size();
  const auto [cross, bad_width] = std::from_chars(text.data(), end, width);
  if (bad_width == std::errc() && cross != end && *cross == 'x') {
    const auto [last, bad_height] = std::from_chars(cross + 1, end, height);
    const bool fits = width >= 16 && width <= 4096 && height >= 16 && height <= 4096;
    if (bad_height == std::errc() && last == end && fits) return {width, height};
  }
  throw InputError(
      fmt::format("--size is '{}'; expected WIDTHxHEIGHT of 16 to 4096 pixels each such as 820x616", text));
}

// The pose that was given number by number or direction by direction; nothing when the view is to find one.
std::optional<Pose> given_pose(const UltrasoundOptions& options) {
  const bool directions = !options.face.empty() || !options.look.empty() || !options.marked.empty();
  const bool view = !options.view.empty() || !options.at.empty() || !options.from.empty();
  if (!options.pose.empty()) {
    if (directions || view) {
      throw InputError("--pose says where the probe is; leave out --face, --look, --marked, --view, --at and --from");
    }
    const std::vector<double> numbers = numbers_of(options.pose);
    if (numbers.size() != 12 && numbers.size() != 16) {
      throw InputError(fmt::format(
          "--pose is '{}'; expected 12 or 16 numbers, row by row, that take the probe's mm to LPS mm", options.pose));
    }
    return station::parse_pose(numbers, "--pose");
  }
  if (!directions) return std::nullopt;
  if (options.face.empty()) throw InputError("--look and --marked turn a probe whose --face x,y,z is missing");
  if (!options.view.empty() || !options.from.empty()) {
    throw InputError("--face says where the probe is; leave out --view and --from");
  }
  if (options.look.empty() == options.at.empty()) {
    throw InputError("--face needs either --look, the direction of view, or --at, a point to look at");
  }
  const Vec3 face = parse_point(options.face, "--face");
  const Vec3 look =
      options.look.empty() ? Vec3(parse_point(options.at, "--at") - face) : parse_point(options.look, "--look");
  const Vec3 marked = options.marked.empty() ? Vec3(Vec3::UnitZ()) : parse_point(options.marked, "--marked");
  return imaging::probe_pose(face, look, marked);
}

imaging::ScanRequest requested_view(const UltrasoundOptions& options, std::string& at_name) {
  imaging::ScanRequest request;
  if (!options.view.empty()) {
    const std::optional<imaging::ScanView> view = imaging::scan_view_from(options.view);
    if (!view) throw InputError(fmt::format("--view is '{}'; expected {}", options.view, imaging::scan_view_names()));
    request.view = *view;
  } else if (!options.at.empty()) {
    request.view = imaging::ScanView::sagittal;
  }
  if (!options.from.empty()) request.outward = outward_from(options.from);
  if (options.at.empty()) return request;
  if (options.at.find(',') != std::string::npos) {
    request.at = parse_point(options.at, "--at");
  } else {
    at_name = options.at;
  }
  return request;
}

anatomy::UltrasoundProbe chosen_probe(const UltrasoundOptions& options) {
  if (options.probes.empty()) return io::find_probe(options.probe);
  const std::vector<anatomy::UltrasoundProbe> probes = io::read_probes(options.probes);
  return io::find_probe(probes, options.probe);
}

}  // namespace

void add_ultrasound_options(CLI::App& command, UltrasoundOptions& options) {
  add_text(command, "--probe", options.probe, "Name of the probe");
  add_text(command, "--probes", options.probes, "A file of probes (default: those that come with Bodkin)");
  add_text(command, "--view", options.view,
           "How it is put on the skin: " + imaging::scan_view_names() + " (default: paramedian)");
  add_text(command, "--at", options.at,
           "What it looks at: x,y,z in LPS mm, a landmark or a structure (default: the planned target)");
  add_text(command, "--from", options.from, "The side that it looks from: back, front, left, right");
  add_text(command, "--face", options.face, "The middle of its face, x,y,z in LPS mm, instead of a view");
  add_text(command, "--look", options.look, "Direction into the patient, x,y,z");
  add_text(command, "--marked", options.marked, "Direction of its marked side, x,y,z (default: 0,0,1, the head)");
  add_text(command, "--pose", options.pose, "12 or 16 numbers row by row, probe to LPS mm, instead of all that");
  options.press_given = add_number(command, "--press", options.press, -60.0, 40.0,
                                   "mm that it is pressed in, -60 to 40 (default: 3, or 0 with --face or --pose)")
                            .without_default();
  options.depth_given =
      add_number(command, "--depth", options.depth, 10.0, 400.0, "mm shown, 10 to 400 (default: the probe's)")
          .without_default();
  add_number(command, "--gain", options.gain, -40.0, 40.0, "dB, -40 to 40");
  add_number(command, "--dynamic-range", options.dynamic_range, 20.0, 120.0, "dB from black to white, 20 to 120");
  options.focus_given =
      add_number(command, "--focus", options.focus, 5.0, 400.0, "mm, 5 to 400 (default: half the depth)")
          .without_default();
  options.frequency_given = add_number(command, "--frequency", options.frequency, 1.0, 30.0,
                                       "MHz in the probe's band (default: its centre)")
                                .without_default();
  add_text(command, "--tgc", options.tgc, "The eight sliders of the time-gain compensation, dB: a,b,c,d,e,f,g,h");
  add_switch(command, "--no-gel", options.no_gel, "Nothing fills the gaps between face and skin");
  add_whole_number(command, "--lines", options.lines, 16, 2048, "Scanlines, 16 to 2048");
  add_whole_number(command, "--samples", options.samples, 32, 4096, "Samples along a line, 32 to 4096");
  options.size_given = add_text(command, "--size", options.size, "Pixels of the picture, WIDTHxHEIGHT");
  add_whole_number(command, "--slices", options.slices, 1, 7, "Rays across the thickness of the slice: 1, 3, 5 or 7");
  add_whole_number(command, "--threads", options.threads, 1, 64, "Threads, 1 to 64");
  add_text(command, "--mark", options.mark, "Where the marked side stands in the picture: left, right");
  add_switch(command, "--needle", options.needle, "The case's needle along the planned path");
  options.needle_depth_given = add_number(command, "--needle-depth", options.needle_depth, 0.0, 300.0,
                                          "mm from the entry to its tip, 0 to 300 (default: to the target)")
                                   .without_default();
}

station::UltrasoundChoice choose_ultrasound(const UltrasoundOptions& options) {
  station::UltrasoundChoice choice;
  choice.pose = given_pose(options);
  if (!choice.pose) choice.request = requested_view(options, choice.at_name);
  choice.press = options.press_given.given() || !choice.pose ? options.press : 0.0;
  if (options.mark != "left" && options.mark != "right") {
    throw InputError(fmt::format("--mark is '{}'; expected left or right", options.mark));
  }
  choice.mark = options.mark == "left" ? imaging::MarkSide::left : imaging::MarkSide::right;
  const auto [width, height] = parse_size(options.size);
  choice.detail.width = width;
  choice.detail.height = height;
  choice.detail.lines = static_cast<int>(options.lines);
  choice.detail.samples = static_cast<int>(options.samples);
  choice.detail.slices = static_cast<int>(options.slices);
  choice.detail.threads = static_cast<int>(options.threads);
  if (options.slices % 2 == 0) {
    throw InputError(fmt::format("--slices is '{}'; expected 1, 3, 5 or 7", options.slices));
  }
  imaging::UltrasoundSettings& settings = choice.settings;
  if (!options.tgc.empty()) {
    const std::vector<double> sliders = parse_numbers(options.tgc, settings.sliders.size(), "--tgc");
    std::copy(sliders.begin(), sliders.end(), settings.sliders.begin());
  }
  settings.gain = options.gain;
  settings.dynamic_range = options.dynamic_range;
  settings.gel = !options.no_gel;
  choice.probe = chosen_probe(options);
  settings.depth = options.depth_given.given() ? options.depth : choice.probe.depth;
  settings.focus = options.focus_given.given() ? options.focus : std::max(5.0, 0.5 * settings.depth);
  if (options.frequency_given.given()) settings.frequency = options.frequency;
  imaging::check(settings, choice.probe);
  return choice;
}

std::vector<double> parse_numbers(const std::string& text, std::size_t count, const std::string& option) {
  std::vector<double> numbers = numbers_of(text);
  if (numbers.size() == count) return numbers;
  throw InputError(
      fmt::format("{} is '{}'; expected {} finite numbers with commas between them", option, text, count));
}

}  // namespace bodkin::cli
