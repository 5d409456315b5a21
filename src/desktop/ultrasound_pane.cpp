#include "desktop/ultrasound_pane.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "desktop/machine_view.h"
#include <fmt/format.h>

namespace bodkin::desktop {

namespace {

using PaneSize = SdlScreen::Size;

constexpr double margin = 12.0, machine_top = 44.0, foot_top = 520.0;  // pixels
constexpr int machine_width = 536, machine_height = 462;
constexpr double counting_time = 1.0;     // s
constexpr double worth_reporting = 0.05;  // N that the picture omits
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

station::LiveScan::Place pane_place(double x, double y) {
  return {x + margin,     y + machine_top, machine_width,
          machine_height, x + 150.0,       y + 452.0 - 8.0 * station::LiveScan::slider_row,
          200.0};
}

}  // namespace

UltrasoundPane::UltrasoundPane(const anatomy::Case& patient, const station::UltrasoundChoice& choice, bool has_body,
                               double x, double y)
    : probe_(choice.probe),
      needle_(patient.description.needle),
      x_(x),
      y_(y),
      scan_(patient, choice, station::hold_probe(choice, patient), std::nullopt, pane_place(x, y)),
      has_body_(has_body) {}

bool UltrasoundPane::handle(const ScreenEvent& event) {
  if (event.kind == ScreenEvent::Kind::focus_lost) scan_.take(event);
  if (event.kind != ScreenEvent::Kind::key) return false;
  const std::optional<ScreenKey> key = machine_key(event.key);
  if (!key) return false;
  ScreenEvent of_machine = event;
  of_machine.key = *key;
  scan_.take(of_machine);
  return true;
}

void UltrasoundPane::update(const station::LivePicture& picture, bool probe_is_held) {
  const double now = seconds_now();
  if (updated_ >= 0.0) scan_.advance(now - updated_);
  updated_ = now;
  held_ = probe_is_held;
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
  const station::LiveScan::Place place = pane_place(x_, y_);
  draw_machine(screen, place, scan_.screen());
  if (scan_.sliders_shown()) {
    constexpr double aside = 92.0, above = 8.0;  // pixels
    screen.fill(place.sliders_x - aside, place.sliders_y - above, place.sliders_width + 2.0 * aside,
                8.0 * station::LiveScan::slider_row + 2.0 * above, pane_ground);
    draw_sliders(screen, place, scan_.settings().sliders, scan_.settings().depth);
  }
  std::string words = !has_body_ ? "This resistance moves no tissue in the picture"
                                 : fmt::format("Tissue here moved by up to {:.1f} mm", most_);
  if (left_out_ > worth_reporting)
    words += fmt::format("; {:.1f} N of the needle, off the path, not shown", left_out_);
  if (!scan_.message().empty()) words = scan_.message();
  const bool warn = left_out_ > worth_reporting || !scan_.message().empty();
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

}  // namespace bodkin::desktop
