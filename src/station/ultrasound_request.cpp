#include "station/ultrasound_request.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/parse_numbers.h"
#include "io/probe_library_file.h"

namespace bodkin::station {

namespace {

Vec3 outward_from(const std::string& side) {
  if (side == "back") return Vec3::UnitY();
  if (side == "front") return -Vec3::UnitY();
  if (side == "left") return Vec3::UnitX();
  if (side == "right") return -Vec3::UnitX();
  throw InputError(fmt::format("--from is '{}'; expected back, front, left or right", side));
}

std::pair<int, int> parse_picture_size(const std::string& text) {
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

// The pose given by numbers or directions; nothing if the view shall find one.
std::optional<Pose> given_pose(const UltrasoundRequest& request) {
  const bool directions = !request.face.empty() || !request.look.empty() || !request.marked.empty();
  const bool view = !request.view.empty() || !request.at.empty() || !request.from.empty();
  if (!request.pose.empty()) {
    if (directions || view) {
      throw InputError("--pose says where the probe is; leave out --face, --look, --marked, --view, --at and --from");
    }
    const std::vector<double> numbers = numbers_in(request.pose);
    if (numbers.size() != 12 && numbers.size() != 16) {
      throw InputError(fmt::format(
          "--pose is '{}'; expected 12 or 16 numbers, row by row, that take the probe's mm to LPS mm", request.pose));
    }
    return parse_pose(numbers, "--pose");
  }
  if (!directions) return std::nullopt;
  if (request.face.empty()) throw InputError("--look and --marked turn a probe whose --face x,y,z is missing");
  if (!request.view.empty() || !request.from.empty()) {
    throw InputError("--face says where the probe is; leave out --view and --from");
  }
  if (request.look.empty() == request.at.empty()) {
    throw InputError("--face needs either --look, the direction of view, or --at, a point to look at");
  }
  const Vec3 face = parse_point(request.face, "--face");
  const Vec3 look =
      request.look.empty() ? Vec3(parse_point(request.at, "--at") - face) : parse_point(request.look, "--look");
  const Vec3 marked = request.marked.empty() ? Vec3(Vec3::UnitZ()) : parse_point(request.marked, "--marked");
  return imaging::probe_pose(face, look, marked);
}

imaging::ScanRequest requested_view(const UltrasoundRequest& request, std::string& at_name) {
  imaging::ScanRequest scan;
  if (!request.view.empty()) {
    const std::optional<imaging::ScanView> view = imaging::scan_view_from(request.view);
    if (!view) throw InputError(fmt::format("--view is '{}'; expected {}", request.view, imaging::scan_view_names()));
    scan.view = *view;
  } else if (!request.at.empty()) {
    scan.view = imaging::ScanView::sagittal;
  }
  if (!request.from.empty()) scan.outward = outward_from(request.from);
  if (request.at.empty()) return scan;
  if (request.at.find(',') != std::string::npos) {
    scan.at = parse_point(request.at, "--at");
  } else {
    at_name = request.at;
  }
  return scan;
}

anatomy::UltrasoundProbe chosen_probe(const UltrasoundRequest& request) {
  if (request.probes.empty()) return io::find_probe(request.probe);
  const std::vector<anatomy::UltrasoundProbe> probes = io::read_probes(request.probes);
  return io::find_probe(probes, request.probe);
}

// Calls field(name, value) for every value of a request that may be const or not.
template <typename Request, typename Field>
void for_each_field(Request& request, const Field& field) {
  field("probe", request.probe);
  field("probes", request.probes);
  field("pose", request.pose);
  field("face", request.face);
  field("look", request.look);
  field("marked", request.marked);
  field("view", request.view);
  field("at", request.at);
  field("from", request.from);
  field("tgc", request.tgc);
  field("size", request.size);
  field("mark", request.mark);
  field("gain_dB", request.gain);
  field("dynamic_range_dB", request.dynamic_range);
  field("press_mm", request.press);
  field("depth_mm", request.depth);
  field("focus_mm", request.focus);
  field("needle_depth_mm", request.needle_depth);
  field("frequency_MHz", request.frequency);
  field("lines", request.lines);
  field("samples", request.samples);
  field("slices", request.slices);
  field("threads", request.threads);
  field("no_gel", request.no_gel);
  field("needle", request.needle);
}

template <typename Value>
void read_field(const nlohmann::json& json, const char* name, Value& value) {
  if (json.contains(name)) json.at(name).get_to(value);
}
void read_field(const nlohmann::json& json, const char* name, std::optional<double>& value) {
  if (json.contains(name)) value = json.at(name).get<double>();
}

template <typename Value>
void write_field(nlohmann::json& json, const char* name, const Value& value) {
  json[name] = value;
}
void write_field(nlohmann::json& json, const char* name, const std::optional<double>& value) {
  if (value) json[name] = *value;
}

}  // namespace

UltrasoundChoice choose_ultrasound(const UltrasoundRequest& request) {
  constexpr double usual_press = 3.0;  // mm
  UltrasoundChoice choice;
  choice.pose = given_pose(request);
  if (!choice.pose) choice.request = requested_view(request, choice.at_name);
  choice.press = request.press.value_or(choice.pose ? 0.0 : usual_press);
  if (request.mark != "left" && request.mark != "right") {
    throw InputError(fmt::format("--mark is '{}'; expected left or right", request.mark));
  }
  choice.mark = request.mark == "left" ? imaging::OrientationMarkerSide::left : imaging::OrientationMarkerSide::right;
  const auto [width, height] = parse_picture_size(request.size);
  choice.detail.width = width;
  choice.detail.height = height;
  choice.detail.lines = static_cast<int>(request.lines);
  choice.detail.samples = static_cast<int>(request.samples);
  choice.detail.slices = static_cast<int>(request.slices);
  choice.detail.threads = static_cast<int>(request.threads);
  if (request.slices % 2 == 0) {
    throw InputError(fmt::format("--slices is '{}'; expected 1, 3, 5 or 7", request.slices));
  }
  imaging::UltrasoundSettings& settings = choice.settings;
  if (!request.tgc.empty()) {
    const std::vector<double> sliders = parse_numbers(request.tgc, settings.sliders.size(), "--tgc");
    std::copy(sliders.begin(), sliders.end(), settings.sliders.begin());
  }
  settings.gain = request.gain;
  settings.dynamic_range = request.dynamic_range;
  settings.gel = !request.no_gel;
  choice.probe = chosen_probe(request);
  settings.depth = request.depth.value_or(choice.probe.depth);
  settings.focus = request.focus.value_or(std::max(5.0, 0.5 * settings.depth));
  settings.frequency = request.frequency.value_or(settings.frequency);
  imaging::check(settings, choice.probe);
  return choice;
}

std::optional<imaging::NeedleInUltrasound> needle_of(const UltrasoundRequest& request, const anatomy::Case& patient) {
  if (!request.needle) return std::nullopt;
  return needle_on_path(patient, request.needle_depth);
}

std::string to_json(const UltrasoundRequest& request) {
  nlohmann::json json;
  for_each_field(request, [&json](const char* name, const auto& value) { write_field(json, name, value); });
  return json.dump();
}

UltrasoundRequest ultrasound_request(const std::string& text) {
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    UltrasoundRequest request;
    for_each_field(request, [&json](const char* name, auto& value) { read_field(json, name, value); });
    return request;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("the description of the ultrasound is not valid JSON: {}", error.what()));
  }
}

}  // namespace bodkin::station
