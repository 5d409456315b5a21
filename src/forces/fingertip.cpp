#include "forces/fingertip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "anatomy/tissue_surface.h"
#include "core/repeatable.h"
#include "forces/model_input.h"

namespace bodkin::forces {

namespace {

constexpr double stride = 1.0;         // mm between the sampled places
constexpr int halvings = 12;           // of the last stride
constexpr double most_pressed = 30.0;  // mm under the skin that are searched for a finger
constexpr double least_cover = 5.0;    // mm
constexpr double cover_time = 0.02;    // s
constexpr double wall_from = 2.0 / 3;  // of the cover
constexpr double least_press = 2.0;    // mm
constexpr double press_time = 0.3;     // s
constexpr double same_place = 5.0;     // mm that a pressing finger may slide

// Where a condition that holds at `from` but not at `to` ceases to hold, as a fraction of the way.
template <typename Holds>
double border(double from, double to, const Holds& holds) noexcept {
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (from + to);
    (holds(middle) ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

bool is_bone(anatomy::TissueId id) noexcept {
  static const anatomy::TissueSet bones = anatomy::bone_tissues();
  return bones[id];
}

}  // namespace

Fingertip::Fingertip(const anatomy::TissueVolume& tissues, const anatomy::FingertipSettings& settings,
                     double stiffness, double dt)
    : tissues_(tissues), settings_(settings), stiffness_(stiffness), dt_(dt) {
  constexpr auto model = "fingertip";
  check_tick(model, dt);
  check(settings, model);
  is_bone(anatomy::tissue::air);  // creates the set, outside the ticks
  reset();
}

void Fingertip::reset() noexcept {
  covers_.fill(settings_.reach);
  state_ = {};
  pressed_ = 0.0;
  reported_ = false;
}

bool Fingertip::is_air(const Vec3& place) const noexcept {
  return anatomy::nearest<anatomy::TissueId>(tissues_, place, anatomy::tissue::air) == anatomy::tissue::air;
}

double Fingertip::depth_under_skin(const Vec3& place, const Vec3& axis) const noexcept {
  if (is_air(place)) return 0.0;
  for (double back = stride; back <= most_pressed; back += stride) {
    if (is_air(place - back * axis))
      return border(back, back - stride, [&](double way) { return is_air(place - way * axis); });
  }
  return most_pressed;
}

double Fingertip::cover_of_bone(const Vec3& skin, const Vec3& axis) const noexcept {
  const auto soft = [&](double way) {
    return !is_bone(anatomy::nearest<anatomy::TissueId>(tissues_, Vec3(skin + way * axis), anatomy::tissue::air));
  };
  for (double way = stride; way <= settings_.reach; way += stride)
    if (!soft(way)) return std::max(least_cover, border(way - stride, way, soft));
  return settings_.reach;
}

void Fingertip::notice_place(const Vec3& tip, const Vec3& axis, TickEvents& events) noexcept {
  if (!(state_.indentation >= least_press)) {
    pressed_ = 0.0;
    reported_ = false;
    return;
  }
  const Vec3 way = tip - place_;
  const double slid = (way - way.dot(axis) * axis).norm();
  if (pressed_ == 0.0 || slid > same_place) {
    place_ = tip;
    pressed_ = 0.0;
    reported_ = false;
  }
  pressed_ += dt_;
  if (reported_ || pressed_ < press_time) return;
  reported_ = true;
  const bool bone = state_.cover < settings_.reach;
  events.push(
      {EventKind::palpated, bone ? anatomy::tissue::cortical_bone : anatomy::tissue::skin, 0.0, state_.firmness});
}

const FingertipState& Fingertip::step(const Vec3& tip, const Vec3& axis, TickEvents& events) noexcept {
  const Vec3 across = axis.unitOrthogonal(), other = axis.cross(across);
  const double area = std::numbers::pi * settings_.radius * settings_.radius / points;
  const double share = -repeatable::expm1(-dt_ / cover_time);
  const bool was_touching = state_.touching;
  state_ = {};
  double bent = 0.0, wall = 0.0;  // N at the columns, at the bones
  for (std::size_t i = 0; i < points; ++i) {
    Vec3 place = tip;
    if (i > 0) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / (points - 1);
      place += 0.8 * settings_.radius * (repeatable::cos(angle) * across + repeatable::sin(angle) * other);
    }
    const double depth = depth_under_skin(place, axis);
    if (depth == 0.0) continue;
    const double found = cover_of_bone(place - depth * axis, axis);
    covers_[i] = was_touching ? covers_[i] + share * (found - covers_[i]) : found;
    bent += area * settings_.modulus * depth / covers_[i];
    wall += std::max(0.0, depth - wall_from * covers_[i]) * 0.5 * stiffness_ / points;
    state_.firmness += area * settings_.modulus / covers_[i];
    state_.touching = true;
    if (i == 0) {
      state_.indentation = depth;
      state_.cover = found;
    }
  }
  // Stiffness beyond the device's stable range is limited to that range.
  if (state_.firmness > 0.5 * stiffness_) bent *= 0.5 * stiffness_ / state_.firmness;
  state_.force = std::min(bent + wall, settings_.limit);
  notice_place(tip, axis, events);
  return state_;
}

}  // namespace bodkin::forces
