#include "cli/ultrasound_pane.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/machine_view.h"
#include "core/error.h"
#include "imaging/ultrasound/acoustic_volume.h"

namespace bodkin {

namespace {

using PaneSize = SdlScreen::Size;

constexpr double margin = 12.0, machine_top = 44.0, foot_top = 520.0;  // pixels
constexpr int machine_width = 536, machine_height = 462;
constexpr int frame_width = 400, frame_height = 400;  // pixels of the picture
constexpr double counting_time = 1.0;                 // s
constexpr double worth_a_word = 0.05;                 // N that the picture leaves out
constexpr Colour pane_ground{24, 31, 42}, pane_ink{232, 238, 245}, pane_faint{142, 156, 174}, pane_warn{245, 185, 66};

constexpr std::array<std::pair<std::string_view, std::string_view>, 8> pane_keys = {{
    {"I J K L", "slide"},
    {"U O", "tilt"},
    {"N M", "rotate"},
    {"F", "freeze"},
    {"G", "gain"},
    {"X", "depth"},
    {"R", "range"},
    {"T, 1 to 8", "TGC"},
}};

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double number_of(std::string_view name, std::string_view digits, const char* unit) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error == std::errc() && end == digits.data() + digits.size() && std::isfinite(number)) return number;
  throw InputError(fmt::format("--ultrasound: {} is '{}', expected a number of {}", name, digits, unit));
}

struct PaneNumber {
  std::string_view name;
  const char* unit;
  double low, high;
  std::optional<double> value;
};

// What the machine and the probe make of the keys here, where others belong to the needle.
std::optional<ScreenKey> machine_key(ScreenKey key) {
  switch (key) {
    case ScreenKey::u:
      return ScreenKey::up;
    case ScreenKey::o:
      return ScreenKey::down;
    case ScreenKey::n:
      return ScreenKey::left;
    case ScreenKey::m:
      return ScreenKey::right;
    case ScreenKey::x:
      return ScreenKey::d;
    case ScreenKey::i:
    case ScreenKey::j:
    case ScreenKey::k:
    case ScreenKey::l:
    case ScreenKey::f:
    case ScreenKey::g:
    case ScreenKey::r:
    case ScreenKey::t:
    case ScreenKey::zero:
    case ScreenKey::one:
    case ScreenKey::two:
    case ScreenKey::three:
    case ScreenKey::four:
    case ScreenKey::five:
    case ScreenKey::six:
    case ScreenKey::seven:
    case ScreenKey::eight:
      return key;
    default:
      return std::nullopt;
  }
}

// What the options of `bodkin ultrasound` refuse, said of the one here that holds them all.
template <typename Work>
auto named_pane(const Work& work) {
  try {
    return work();
  } catch (const InputError& refused) {
    throw InputError(fmt::format("--ultrasound: {}", refused.what()));
  }
}

LiveScan::Place pane_place(double x, double y) {
  return {x + margin,     y + machine_top, machine_width,
          machine_height, x + 150.0,       y + 452.0 - 8.0 * LiveScan::slider_row,
          200.0};
}

}  // namespace

UltrasoundChoice choose_pane(const std::string& words) {
  UltrasoundOptions options;
  options.view = "needle";
  options.size = fmt::format("{}x{}", frame_width, frame_height);
  options.lines = options.samples = 300;
  std::array<PaneNumber, 6> numbers = {{{"press_mm", "mm", -60.0, 40.0, {}},
                                        {"depth_mm", "mm", 10.0, 400.0, {}},
                                        {"gain_dB", "dB", -40.0, 40.0, {}},
                                        {"dynamic_range_dB", "dB", 20.0, 120.0, {}},
                                        {"focus_mm", "mm", 5.0, 400.0, {}},
                                        {"frequency_MHz", "MHz", 1.0, 30.0, {}}}};
  std::string_view rest = words;
  bool named = false;
  while (true) {
    const auto first = rest.find_first_not_of(" \t");
    if (first == std::string_view::npos) break;
    const auto end = std::min(rest.find_first_of(" \t", first), rest.size());
    const std::string_view word = rest.substr(first, end - first);
    rest.remove_prefix(end);
    const auto sign = word.find('=');
    if (sign == std::string_view::npos) {
      if (named) {
        throw InputError(
            fmt::format("--ultrasound: '{}' after the probe {}, expected SETTING=VALUE", word, options.probe));
      }
      named = true;
      options.probe = std::string(word);
      continue;
    }
    const std::string_view name = word.substr(0, sign), value = word.substr(sign + 1);
    if (name == "view") {
      options.view = std::string(value);
    } else if (name == "at") {
      options.at = std::string(value);
    } else if (name == "from") {
      options.from = std::string(value);
    } else {
      const auto number = std::find_if(numbers.begin(), numbers.end(), [&](const auto& n) { return n.name == name; });
      if (number == numbers.end()) {
        throw InputError(fmt::format(
            "--ultrasound: there is no setting '{}', expected view, at, from, press_mm, depth_mm, gain_dB, "
            "dynamic_range_dB, focus_mm or frequency_MHz",
            name));
      }
      number->value = number_of(name, value, number->unit);
      if (*number->value < number->low || *number->value > number->high) {
        throw InputError(
            fmt::format("--ultrasound: {} is '{}', expected {:g} to {:g}", name, value, number->low, number->high));
      }
    }
  }
  UltrasoundChoice choice = named_pane([&] { return choose_ultrasound(options); });
  UltrasoundSettings& settings = choice.settings;
  choice.press = numbers[0].value.value_or(choice.press);
  settings.depth = numbers[1].value.value_or(settings.depth);
  settings.gain = numbers[2].value.value_or(settings.gain);
  settings.dynamic_range = numbers[3].value.value_or(settings.dynamic_range);
  settings.focus = numbers[4].value.value_or(std::max(5.0, 0.5 * settings.depth));
  settings.frequency = numbers[5].value.value_or(settings.frequency);
  named_pane([&] {
    check(settings, choice.probe);
    return true;
  });
  return choice;
}

UltrasoundPane::UltrasoundPane(const Case& patient, const UltrasoundChoice& choice, ScanBody body, double x, double y,
                               const Progress& progress)
    : probe_(choice.probe),
      needle_(patient.description.needle),
      x_(x),
      y_(y),
      scan_(patient, choice, named_pane([&] { return hold_probe(choice, patient); }), std::nullopt, pane_place(x, y)),
      moves_(body.mesh != nullptr) {
  const std::shared_ptr<const AcousticVolume> sounding = acoustic_volume(patient, progress);
  Ultrasound machine(sounding, choice.probe, choice.settings, choice.detail);
  thread_ = std::make_shared<ScanThread>(sounding, std::move(machine), needle_, std::move(body),
                                         ScanOrder{scan_.pose(), scan_.settings()});
}

bool UltrasoundPane::take(const ScreenEvent& event) {
  if (event.kind == ScreenEvent::Kind::focus_lost) scan_.take(event);
  if (event.kind != ScreenEvent::Kind::key) return false;
  const std::optional<ScreenKey> key = machine_key(event.key);
  if (!key) return false;
  ScreenEvent of_machine = event;
  of_machine.key = *key;
  scan_.take(of_machine);
  return true;
}

void UltrasoundPane::follow(SecondHand* second, PressedPatient* moving) {
  if (second != nullptr && second->role() == SecondRole::probe) hold(second->tool());
  if (moving != nullptr) thread_->tell_nodes(moving->picture().displacements);
}

std::string UltrasoundPane::tell(double seconds) const {
  return fmt::format("{} ultrasound pictures, {:.0f} a second", made_, static_cast<double>(made_) / seconds);
}

// Third axis out of its face, LPS.
void UltrasoundPane::hold(const Pose& tool) {
  // The tool's third axis is the machine's second; both have the array along the first.
  Pose probe = tool;
  probe.linear().col(1) = tool.linear().col(2);
  probe.linear().col(2) = -tool.linear().col(1);
  held_ = probe;
}

void UltrasoundPane::look() {
  const double now = seconds_now();
  if (looked_ >= 0.0) scan_.advance(now - looked_);
  looked_ = now;
  thread_->order({held_.value_or(scan_.pose()), scan_.settings()});
  const LivePicture& picture = thread_->picture();
  if (counting_ < 0.0) counting_ = now;
  if (now - counting_ >= counting_time) {
    rate_ = static_cast<double>(picture.number - counted_) / (now - counting_);
    counted_ = picture.number;
    counting_ = now;
  }
  if (picture.number == made_) return;
  made_ = picture.number;
  most_ = picture.most;
  left_out_ = picture.left_out;
  milliseconds_ = picture.milliseconds;
  scan_.screen().take({picture.frame, picture.order.probe, probe_, picture.order.settings,
                       picture.needle ? fmt::format("{} G", needle_.gauge) : std::string()});
}

void UltrasoundPane::draw(SdlScreen& screen) const {
  screen.fill(x_, y_ + 24.0, width - 24.0 + margin, height - 48.0, pane_ground);
  screen.text(x_ + margin, y_ + 27.0, held_ ? "Ultrasound, the probe in the second hand" : "Ultrasound",
              PaneSize::small, pane_faint);
  screen.text(x_ + width - 24.0, y_ + 27.0, fmt::format("{:.1f} ms, {:.0f} pictures/s", milliseconds_, rate_),
              PaneSize::small, pane_faint, SdlScreen::Align::right);
  const LiveScan::Place place = pane_place(x_, y_);
  draw_machine(screen, place, scan_.screen());
  if (scan_.sliders_shown()) {
    constexpr double aside = 92.0, above = 8.0;  // pixels
    screen.fill(place.sliders_x - aside, place.sliders_y - above, place.sliders_width + 2.0 * aside,
                8.0 * LiveScan::slider_row + 2.0 * above, pane_ground);
    draw_sliders(screen, place, scan_.settings().sliders, scan_.settings().depth);
  }
  std::string words = !moves_ ? "This resistance moves no tissue in the picture"
                              : fmt::format("Tissue here moved by up to {:.1f} mm", most_);
  if (left_out_ > worth_a_word) words += fmt::format("; {:.1f} N of the needle, off the path, not shown", left_out_);
  if (!scan_.message().empty()) words = scan_.message();
  const bool warn = left_out_ > worth_a_word || !scan_.message().empty();
  screen.text(x_ + margin, y_ + foot_top - 8.0, words, PaneSize::small, warn ? pane_warn : pane_ink);
  constexpr std::size_t columns = 4;
  for (std::size_t i = 0; i < pane_keys.size(); ++i) {
    const double x = x_ + margin + 134.0 * static_cast<double>(i % columns);
    const std::size_t row = i / columns;
    const double y = y_ + foot_top + 16.0 + 20.0 * static_cast<double>(row);
    screen.text(x, y, std::string(pane_keys[i].first), PaneSize::small, pane_ink);
    screen.text(x + 66.0, y, std::string(pane_keys[i].second), PaneSize::small, pane_faint);
  }
}

}  // namespace bodkin
