#include "station/live_scan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace bodkin::station {

namespace {

constexpr double turn_speed = 30.0 * degree;  // a second
constexpr double needle_speed = 15.0;         // mm/s
constexpr double slide_speed = 20.0;          // mm/s
constexpr double slider_step = 2.0;           // dB a key
constexpr double wheel_press = 0.5;           // mm a step
constexpr double wheel_depth = 5.0;           // mm a step
constexpr double longest_slide = 4.0;         // mm at once: a longer way is split, so that no fold is missed
constexpr double hand_room = 200.0;           // mm: a longer drag is ignored

}  // namespace

LiveScan::LiveScan(const anatomy::Case& patient, const UltrasoundChoice& choice, const imaging::ProbeOnSkin& hand,
                   const std::optional<imaging::NeedleInUltrasound>& needle, const Place& place)
    : patient_(patient),
      probe_(choice.probe),
      hand_(hand),
      settings_(choice.settings),
      screen_(place.width, place.height, choice.mark),
      place_(place),
      needle_in_(needle.has_value()),
      mark_(choice.mark) {
  if (const auto& path = patient.description.procedure.path) {
    needle_depth_ = needle ? path->direction().dot(needle->pose.translation() - path->entry) : 0.5 * path->length();
  }
}

std::optional<imaging::NeedleInUltrasound> LiveScan::needle() const {
  if (!needle_in_) return std::nullopt;
  return needle_on_path(patient_, needle_depth_);
}

std::string LiveScan::needle_words() const {
  return needle_in_ ? fmt::format("{} G {:.0f} mm", patient_.description.needle.gauge, needle_depth_) : std::string();
}

bool LiveScan::take_save() {
  return std::exchange(save_, false);
}

void LiveScan::set_place(const Place& place) {
  place_ = place;
  screen_.resize(place.width, place.height);
}

void LiveScan::take(const ScreenEvent& event) {
  using Kind = ScreenEvent::Kind;
  shift_ = event.shift;
  switch (event.kind) {
    case Kind::motion:
      if (!event.button) held_slider_.reset();
      if (held_slider_) {
        set_slider(*held_slider_, slider_most * (2.0 * (event.x - place_.sliders_x) / place_.sliders_width - 1.0));
      } else if (event.button && !calipers_) {
        drag(event.x, event.y);
      }
      pointer_ = Eigen::Vector2d(event.x, event.y);
      break;
    case Kind::button: {
      pointer_ = Eigen::Vector2d(event.x, event.y);
      const Eigen::Vector2d at = *pointer_ - Eigen::Vector2d(place_.x, place_.y);
      held_slider_ = event.down ? slider_at(*pointer_) : std::nullopt;
      if (held_slider_) {
        set_slider(*held_slider_, slider_most * (2.0 * (event.x - place_.sliders_x) / place_.sliders_width - 1.0));
      } else if (event.down && calipers_ && screen_.holds(at))
        screen_.measure(screen_.to_probe(at));
      break;
    }
    case Kind::wheel:
      if (const auto slider = pointer_ ? slider_at(*pointer_) : std::nullopt) {
        turn_slider(*slider, event.steps);
      } else if (event.shift) {
        settings_.depth = std::clamp(settings_.depth + wheel_depth * event.steps, 10.0, 400.0);
      } else {
        hand_.press(hand_.press() + wheel_press * event.steps);
      }
      break;
    case Kind::key:
      if (event.down) {
        held_.insert(event.key);
        press(event.key, event.shift);
      } else {
        held_.erase(event.key);
      }
      break;
    case Kind::leave:
    case Kind::focus_lost:
      held_.clear();
      pointer_.reset();
      held_slider_.reset();
      break;
    case Kind::close:
      ended_ = true;
      break;
  }
}

void LiveScan::advance(double seconds) {
  const double share = std::clamp(seconds, 0.0, 0.1);  // a stall of the machine is no jerk of the hand
  const auto held = [&](ScreenKey key) { return held_.contains(key) ? 1.0 : 0.0; };
  const double aside = held(ScreenKey::right) - held(ScreenKey::left),
               fan = held(ScreenKey::up) - held(ScreenKey::down);
  const double angle = turn_speed * share * (mark_ == imaging::OrientationMarkerSide::left ? -1.0 : 1.0);
  if (aside != 0.0 && shift_) hand_.rock(angle * aside);
  if (aside != 0.0 && !shift_) hand_.rotate(angle * aside);
  if (fan != 0.0) hand_.tilt(turn_speed * share * fan);
  const double right = held(ScreenKey::l) - held(ScreenKey::j), down = held(ScreenKey::k) - held(ScreenKey::i);
  const double way = slide_speed * share;
  if (right != 0.0 || down != 0.0)
    slide((mark_ == imaging::OrientationMarkerSide::left ? -way : way) * right, way * down);
  const double in = held(ScreenKey::page_down) - held(ScreenKey::page_up);
  if (in != 0.0 && needle_in_) {
    needle_depth_ = std::clamp(needle_depth_ + needle_speed * share * in, 0.0, patient_.description.needle.length);
  }
}

// The probe follows the pointer: sideways within its slice, up and down across it.
void LiveScan::drag(double x, double y) {
  if (!pointer_ || screen_.empty()) return;
  const Eigen::Vector2d way = Eigen::Vector2d(x, y) - *pointer_;
  const double scale = (screen_.to_probe({0.0, 1.0}) - screen_.to_probe({0.0, 0.0})).norm();  // mm a pixel
  const double along = (mark_ == imaging::OrientationMarkerSide::left ? -1.0 : 1.0) * way.x() * scale,
               across = way.y() * scale;
  slide(along, across);
}

// mm over the skin.
void LiveScan::slide(double along, double across) {
  const double length = std::hypot(along, across);
  if (!(length < hand_room)) return;
  message_.clear();
  const int steps = std::max(1, static_cast<int>(std::ceil(length / longest_slide)));
  for (int step = 0; step < steps && length > 0.0; ++step) {
    if (hand_.slide(patient_.tissues, along / steps, across / steps)) continue;
    message_ = "There is no skin further on: the CT ends here, or the body does.";
    return;
  }
}

// Half a row above and below each counts as its area, and some more to its left and right.
std::optional<std::size_t> LiveScan::slider_at(const Eigen::Vector2d& at) const {
  constexpr double beside = 12.0;  // pixels
  if (!sliders_ || at.x() < place_.sliders_x - beside || at.x() > place_.sliders_x + place_.sliders_width + beside)
    return std::nullopt;
  const double row = std::floor((at.y() - place_.sliders_y) / slider_row);
  if (!(row >= 0.0 && row < static_cast<double>(settings_.sliders.size()))) return std::nullopt;
  return static_cast<std::size_t>(row);
}

// In steps of half a dB, so that the middle can be set again.
void LiveScan::set_slider(std::size_t slider, double decibels) {
  settings_.sliders[slider] = std::clamp(0.5 * std::round(2.0 * decibels), -slider_most, slider_most);
  sliders_ = true;
}

void LiveScan::turn_knob(double& value, double step, bool shift, double low, double high) {
  value = std::clamp(value + (shift ? -step : step), low, high);
  message_.clear();
}

void LiveScan::press(ScreenKey key, bool shift) {
  switch (key) {
    case ScreenKey::d:
      turn_knob(settings_.depth, 10.0, shift, 10.0, 400.0);
      return;
    case ScreenKey::g:
      turn_knob(settings_.gain, 2.0, shift, -40.0, 40.0);
      return;
    case ScreenKey::r:
      turn_knob(settings_.dynamic_range, 5.0, shift, 20.0, 120.0);
      return;
    case ScreenKey::o:
      turn_knob(settings_.focus, 5.0, shift, 5.0, 400.0);
      return;
    case ScreenKey::q: {
      double frequency = settings_.frequency > 0.0 ? settings_.frequency : probe_.frequency;
      turn_knob(frequency, 0.5, shift, probe_.lowest, probe_.highest);
      settings_.frequency = frequency;
      return;
    }
    case ScreenKey::f:
    case ScreenKey::space:
      screen_.freeze(!screen_.frozen());
      return;
    case ScreenKey::c:
      calipers_ = !calipers_;
      if (calipers_) screen_.freeze(true);
      return;
    case ScreenKey::m: {
      if (!pointer_) return;
      const Eigen::Vector2d at = *pointer_ - Eigen::Vector2d(place_.x, place_.y);
      if (!screen_.holds(at)) return set_message("Put the pointer into the picture to mark a place.");
      screen_.freeze(true);
      screen_.mark(screen_.to_probe(at), fmt::format("M{}", screen_.markers().size() + 1));
      return;
    }
    case ScreenKey::x:
      screen_.clear_measurements();
      return;
    case ScreenKey::n:
      if (!patient_.description.procedure.path) return set_message("The case has no planned path for a needle.");
      needle_in_ = !needle_in_;
      return;
    case ScreenKey::s:
      save_ = true;
      return;
    case ScreenKey::t:
      sliders_ = !sliders_;
      return;
    case ScreenKey::zero:
      settings_.sliders = {};
      return;
    case ScreenKey::one:
    case ScreenKey::two:
    case ScreenKey::three:
    case ScreenKey::four:
    case ScreenKey::five:
    case ScreenKey::six:
    case ScreenKey::seven:
    case ScreenKey::eight:
      turn_slider(static_cast<std::size_t>(key) - static_cast<std::size_t>(ScreenKey::one),
                  shift ? -slider_step : slider_step);
      return;
    case ScreenKey::h:
    case ScreenKey::question:
      help_ = !help_;
      return;
    case ScreenKey::escape:
      if (help_) {
        help_ = false;
      } else {
        ended_ = true;
      }
      return;
    default:
      return;
  }
}

}  // namespace bodkin::station
