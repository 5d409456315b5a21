#include "tracking/registration_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace bodkin::tracking {

namespace {

// px of the picture
constexpr double picture_width = 1000.0, side_room = 64.0, between_room = 70.0, top_room = 92.0, axis_room = 58.0,
                 key_row = 24.0, key_sample = 44.0, first_column = 330.0, most_height = 520.0, least_panel = 200.0;
constexpr double ring_radius = 6.0, dot_radius = 2.6, arrow_head = 7.0, tick = 5.0, ticks_apart = 70.0;
constexpr double plain_size = 13.0, small_size = 12.0, title_size = 17.0, longest_label = 130.0;
constexpr double headroom = 0.08;  // of the largest extent, on each side
constexpr double most_share = 0.125, most_magnification = 1000.0;

constexpr std::uint32_t paper = 0xFFFFFF, text_ink = 0x26303A, title_ink = 0x12212E, frame_ink = 0x8A949C,
                        grid_ink = 0xE1E5E8, fixed_ink = 0x12385C, moved_ink = 0xD55E00, target_ink = 0x00795A;

using Place = Eigen::Vector2d;

// The view of one of the two panels.
struct View {
  const char* title;
  const char* across;  // the label of its horizontal axis
  int axis;            // of the fixed frame, to the right
};
constexpr std::array<View, 2> views = {{{"from the front", "x, mm", 0}, {"from the side", "y, mm", 1}}};
constexpr int up = 2;

// 1, 2 or 5 times a power of ten, at least `least`.
double round_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double times : {1.0, 2.0, 5.0})
    if (times * power >= least * (1.0 - 1e-9)) return times * power;
  return 10.0 * power;
}

// The same, at most `most`.
double round_down(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  return power * (most >= 5.0 * power ? 5.0 : most >= 2.0 * power ? 2.0 : 1.0);
}

// Limited to this width, cut between characters.
std::string cut_short(const std::string& name) {
  if (imaging::text_width(name, small_size) <= longest_label) return name;
  std::string cut = name;
  while (!cut.empty() && imaging::text_width(cut + "…", small_size) > longest_label) {
    unsigned char last = 0;
    do {
      last = static_cast<unsigned char>(cut.back());
      cut.pop_back();
    } while (!cut.empty() && (last & 0xC0U) == 0x80U);
  }
  return cut + "…";
}

struct Box {
  double left, top, right, bottom;
};

double overlap(const Box& one, const Box& other) {
  const double wide = std::min(one.right, other.right) - std::max(one.left, other.left),
               high = std::min(one.bottom, other.bottom) - std::max(one.top, other.top);
  return wide > 0.0 && high > 0.0 ? wide * high : 0.0;
}

class PictureArtist {
 public:
  PictureArtist(const Registration& registration, const std::vector<Vec3>& fixed, const std::vector<Vec3>& moving,
                const std::vector<std::string>& names)
      : registration_(registration), fixed_(fixed), names_(names), canvas_(picture_width, most_height) {
    for (const Vec3& point : moving) moved_.push_back(registration.fixed_from_moving * point);
    if (registration.at_target) target_ = registration.fixed_from_moving * registration.at_target->target;
    measure();
  }

  imaging::Canvas draw() {
    canvas_.fill_all(paper);
    canvas_.text({side_room, 38.0},
                 fmt::format("{} points, FRE {:.3f} mm RMS, scale {:.5f}", fixed_.size(), registration_.fre_rms,
                             registration_.fixed_from_moving.scale),
                 {.size = title_size, .ink = title_ink, .bold = true});
    double left = left_;
    for (const View& view : views) {
      panel(view, left);
      left += width_of(view) + between_room;
    }
    key();
    return std::move(canvas_);
  }

 private:
  void measure() {
    const auto include = [&](const Vec3& place, double radius = 0.0) {
      low_ = low_.cwiseMin(place - Vec3::Constant(radius));
      high_ = high_.cwiseMax(place + Vec3::Constant(radius));
    };
    for (const Vec3& point : fixed_) include(point);
    for (const Vec3& point : moved_) include(point);
    if (target_) include(*target_);
    double largest = registration_.at_target ? registration_.at_target->tre.high : 0.0;
    for (const double residual : registration_.residuals) largest = std::max(largest, residual);
    magnified_ = error_magnification((high_ - low_).maxCoeff(), largest);
    for (std::size_t i = 0; i < fixed_.size(); ++i) include(tip_of(i));
    if (target_) include(*target_, magnified_ * registration_.at_target->tre.high);
    const double extent = (high_ - low_).maxCoeff();
    low_ -= Vec3::Constant(headroom * extent);
    high_ += Vec3::Constant(headroom * extent);
    const double room = picture_width - 2.0 * side_room - between_room;
    const Vec3 range = high_ - low_;
    scale_ = std::min(room / (range.x() + range.y()), most_height / range.z());
    // A narrow panel is widened about its middle.
    for (int axis = 0; axis < 3; ++axis) {
      const double more = 0.5 * std::max(0.0, least_panel / scale_ - (high_ - low_)[axis]);
      low_[axis] -= more;
      high_[axis] += more;
    }
    scale_ = std::min(scale_, room / ((high_ - low_).x() + (high_ - low_).y()));
    bottom_ = top_room + scale_ * (high_ - low_).z();
    left_ = 0.5 * (picture_width - width_of(views[0]) - width_of(views[1]) - between_room);
    canvas_.set_size(picture_width, 2.0 * std::ceil(0.5 * (bottom_ + axis_room + 4.0 * key_row)));
  }

  double width_of(const View& view) const { return scale_ * (high_ - low_)[view.axis]; }
  // The end of a pair's arrow, mm.
  Vec3 tip_of(std::size_t i) const { return fixed_[i] + magnified_ * (moved_[i] - fixed_[i]); }
  Place place_of(const View& view, double left, const Vec3& point) const {
    return {left + scale_ * (point - low_)[view.axis], bottom_ - scale_ * (point - low_)[up]};
  }
  static imaging::TextStyle style(imaging::TextAnchor anchor, double size = plain_size,
                                  std::uint32_t ink = text_ink) {
    return {.size = size, .ink = ink, .anchor = anchor};
  }

  void axes(const View& view, double left) {
    const double right = left + width_of(view), step = round_step(ticks_apart / scale_);
    imaging::Path grid, ticks;
    const auto each = [&](int axis, const auto& draw_at) {
      for (double n = std::ceil(low_[axis] / step); n * step <= high_[axis]; n += 1.0) draw_at(n * step + 0.0);
    };
    each(view.axis, [&](double value) {
      const double x = left + scale_ * (value - low_[view.axis]);
      grid.add(imaging::Path::segment({x, top_room}, {x, bottom_}));
      ticks.add(imaging::Path::segment({x, bottom_}, {x, bottom_ + tick}));
      canvas_.text({x, bottom_ + 19.0}, fmt::format("{:g}", value), style(imaging::TextAnchor::middle, small_size));
    });
    each(up, [&](double value) {
      const double y = bottom_ - scale_ * (value - low_[up]);
      grid.add(imaging::Path::segment({left, y}, {right, y}));
      ticks.add(imaging::Path::segment({left - tick, y}, {left, y}));
      canvas_.text({left - 9.0, y + 0.36 * small_size}, fmt::format("{:g}", value),
                   style(imaging::TextAnchor::end, small_size));
    });
    canvas_.stroke(grid, {grid_ink, 0.8});
    canvas_.stroke(ticks, {frame_ink});
    canvas_.stroke(imaging::Path::rectangle(left, top_room, width_of(view), bottom_ - top_room), {frame_ink});
    canvas_.text({0.5 * (left + right), bottom_ + 40.0}, view.across, style(imaging::TextAnchor::middle));
    imaging::TextStyle upright = style(imaging::TextAnchor::middle);
    upright.angle = 90.0;
    canvas_.text({left - 44.0, 0.5 * (top_room + bottom_)}, "z, mm", upright);
    canvas_.text({left, top_room - 14.0}, view.title, {.size = plain_size, .ink = title_ink, .bold = true});
  }

  void arrow(const Place& from, const Place& to) {
    const Place along = to - from;
    const double length = along.norm();
    if (length < 1.0) return;
    const Place ahead = along / length, aside(-ahead.y(), ahead.x());
    const double head = std::min(arrow_head, 0.6 * length);
    canvas_.stroke(imaging::Path::segment(from, to - 0.7 * head * ahead), {moved_ink, 2.0});
    canvas_.fill(imaging::Path::polygon(
                     {to, to - head * ahead + 0.45 * head * aside, to - head * ahead - 0.45 * head * aside}),
                 moved_ink);
  }

  void ring(const Place& at) { canvas_.stroke(imaging::Path::circle(at, ring_radius), {fixed_ink, 1.8}); }

  void error_circles(const Place& at, double low, double estimate, double high) {
    canvas_.fill(imaging::Path::circle(at, estimate), {target_ink, 0.16});
    canvas_.stroke(imaging::Path::circle(at, estimate), {target_ink, 1.4});
    for (const double radius : {low, high})
      canvas_.stroke(imaging::Path::circle(at, radius), {target_ink, 1.0, {4.0, 3.0}});
  }

  void panel(const View& view, double left) {
    axes(view, left);
    // Areas that no name should cover.
    std::vector<Box> taken;
    const auto take = [&](const Place& one, const Place& other, double margin) {
      const Place low = one.cwiseMin(other), high = one.cwiseMax(other);
      taken.push_back({low.x() - margin, low.y() - margin, high.x() + margin, high.y() + margin});
    };
    const double pixels = magnified_ * scale_;  // per mm of an error
    if (target_) {
      const ErrorInterval& tre = registration_.at_target->tre;
      const Place at = place_of(view, left, *target_);
      error_circles(at, pixels * tre.low, pixels * tre.estimate, pixels * tre.high);
      canvas_.stroke(imaging::Path::cross(at, 7.0), {target_ink, 2.0});
      take(at, at, std::max(8.0, pixels * tre.estimate));
    }
    for (std::size_t i = 0; i < fixed_.size(); ++i) {
      const Place at = place_of(view, left, fixed_[i]), tip = place_of(view, left, tip_of(i)),
                  moved = place_of(view, left, moved_[i]);
      arrow(at, tip);
      ring(at);
      canvas_.fill(imaging::Path::circle(moved, dot_radius), moved_ink);
      take(at, at, ring_radius + 1.0);
      // An arrow at a slant covers little of the box around it.
      for (int part = 1; part <= 4; ++part) {
        const Place end = at + 0.25 * part * (tip - at);
        take(end - 0.25 * (tip - at), end, 2.0);
      }
    }
    const Box panel_box{left, top_room, left + width_of(view), bottom_};
    if (target_) name(place_of(view, left, *target_), "target", target_ink, panel_box, taken);
    for (std::size_t i = 0; i < fixed_.size(); ++i)
      name(place_of(view, left, fixed_[i]), cut_short(names_[i]), text_ink, panel_box, taken);
  }

  // Beside its point, where it covers least; a thin line connects one that is not close, except from the target's
  // circles.
  void name(const Place& at, const std::string& text, std::uint32_t ink, const Box& within, std::vector<Box>& taken) {
    const double wide = imaging::text_width(text, small_size), high = small_size;
    Box best{};
    double least = std::numeric_limits<double>::infinity();
    for (const double away : {ring_radius + 4.0, ring_radius + 16.0, ring_radius + 30.0}) {
      for (int turn = 0; turn < 8; ++turn) {
        const double angle = -45.0 * degree * turn;  // the first to the right, then upwards
        const Place middle = at + Place((away + 0.5 * wide) * std::cos(angle), (away + 0.5 * high) * std::sin(angle));
        const Box box{middle.x() - 0.5 * wide, middle.y() - 0.5 * high, middle.x() + 0.5 * wide,
                      middle.y() + 0.5 * high};
        double cost = 0.05 * (away - ring_radius) + 0.01 * turn;
        for (const Box& other : taken) cost += overlap(box, other);
        cost += 10.0 * (wide * high - overlap(box, within));
        if (cost >= least) continue;
        least = cost;
        best = box;
      }
    }
    taken.push_back(best);
    const Place nearest(std::clamp(at.x(), best.left - 2.0, best.right + 2.0),
                        std::clamp(at.y(), best.top - 1.0, best.bottom + 1.0));
    const double away = (nearest - at).norm();
    if (ink != target_ink && away > ring_radius + 6.0) {
      const Place rim = at + ring_radius / away * (nearest - at);
      canvas_.stroke(imaging::Path::segment(rim, nearest), {frame_ink, 0.8});
    }
    canvas_.text({best.left, best.bottom - 0.14 * high}, text, style(imaging::TextAnchor::start, small_size, ink));
  }

  void key() {
    const double second = side_room + first_column;
    const auto sample = [&](double x, int row) { return Place(x, bottom_ + axis_room + 12.0 + key_row * row); };
    const auto words = [&](const Place& at, const std::string& text) {
      canvas_.text(at + Place(key_sample + 10.0, 0.36 * plain_size), text, style(imaging::TextAnchor::start));
    };
    const Place middle(0.5 * key_sample, 0.0);
    const Place fixed_at = sample(side_room, 0), moved_at = sample(side_room, 1), arrow_at = sample(second, 0),
                target_at = sample(second, 1);
    ring(fixed_at + middle);
    words(fixed_at, "fixed point");
    canvas_.fill(imaging::Path::circle(moved_at + middle, dot_radius), moved_ink);
    words(moved_at, "moving point after registration");
    const double shown = round_down(key_sample / (magnified_ * scale_));  // mm
    arrow(arrow_at, arrow_at + Place(magnified_ * scale_ * shown, 0.0));
    words(arrow_at, fmt::format("residual, drawn {:g} times as long: this is {:g} mm", magnified_, shown));
    if (!target_) return;
    const ErrorInterval& tre = registration_.at_target->tre;
    error_circles(target_at + middle, 4.0, 6.5, 10.0);
    words(target_at,
          fmt::format("target; circle: its TRE, {:.2f} mm RMS, drawn {:g} times as large", tre.estimate, magnified_));
    words(sample(second, 2),
          fmt::format("dashed: {:.2f} and {:.2f} mm, the interval in which that RMS lies", tre.low, tre.high));
  }

  const Registration& registration_;
  const std::vector<Vec3>& fixed_;
  const std::vector<std::string>& names_;
  std::vector<Vec3> moved_;     // mm, fixed frame
  std::optional<Vec3> target_;  // mm, fixed frame
  imaging::Canvas canvas_;
  Vec3 low_ = Vec3::Constant(std::numeric_limits<double>::infinity()), high_ = -low_;  // mm, what is shown
  double magnified_ = 1.0;
  double scale_ = 1.0;                // px per mm
  double left_ = 0.0, bottom_ = 0.0;  // px, of the panels
};

}  // namespace

double error_magnification(double extent, double largest) {
  const double most = most_share * extent / std::max(largest, 1e-9);
  if (most >= most_magnification) return most_magnification;
  if (most <= 1.0) return 1.0;
  return round_down(most);
}

imaging::Canvas registration_picture(const Registration& registration, const std::vector<Vec3>& fixed,
                                     const std::vector<Vec3>& moving, const std::vector<std::string>& names) {
  return PictureArtist(registration, fixed, moving, names).draw();
}

}  // namespace bodkin::tracking
