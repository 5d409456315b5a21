#include "views/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace bodkin::views {

double value_of(const Measure& measure) {
  const auto& [a, b, c] = measure.places;
  if (measure.kind == Measure::Kind::distance) return (b - a).norm();
  const Vec3 one = a - b, other = c - b;
  return std::atan2(one.cross(other).norm(), one.dot(other)) / degree;
}

std::string text_of(const Measure& measure) {
  return fmt::format("{:.1f}{}", value_of(measure), measure.kind == Measure::Kind::distance ? " mm" : "°");
}

void Measures::begin(Measure::Kind kind) {
  begun_ = Measure{.kind = kind};
  placed_ = 0;
}

void Measures::add(const Vec3& place) {
  if (!begun_) return;
  begun_->places[placed_++] = place;
  if (placed_ < begun_->count()) return;
  all_.push_back(*begun_);
  begun_.reset();
}

std::optional<std::vector<Vec3>> Measures::preview(const Vec3& pointer) const {
  if (!begun_ || placed_ == 0) return std::nullopt;
  const auto placed = begun_->places.begin();
  std::vector<Vec3> places(placed, placed + static_cast<std::ptrdiff_t>(placed_));
  places.push_back(pointer);
  return places;
}

std::optional<Measure> Measures::with_next(const Vec3& pointer) const {
  if (!begun_ || placed_ + 1 != begun_->count()) return std::nullopt;
  Measure finished = *begun_;
  finished.places[placed_] = pointer;
  return finished;
}

void Measures::remove(std::size_t index) {
  if (index < all_.size()) all_.erase(all_.begin() + static_cast<std::ptrdiff_t>(index));
}

std::optional<std::size_t> Measures::at(const Vec3& place, double reach) const {
  std::optional<std::size_t> nearest;
  double least = reach;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    for (std::size_t corner = 0; corner + 1 < all_[i].count(); ++corner) {
      const double distance = distance_to_segment(place, all_[i].places[corner], all_[i].places[corner + 1]);
      if (distance > least) continue;
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

double distance_to_segment(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  const double squared = way.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((point - from).dot(way) / squared, 0.0, 1.0) : 0.0;
  return (point - from - share * way).norm();
}

}  // namespace bodkin::views
