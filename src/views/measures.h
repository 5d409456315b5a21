#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "imaging/slice.h"

namespace bodkin::views {

// A distance between two places of the patient, or the angle at the second of three.
struct Measure {
  enum class Kind { distance, angle };
  Kind kind = Kind::distance;
  std::array<Vec3, 3> places{};  // LPS mm; a distance has two

  std::size_t count() const { return kind == Kind::distance ? 2 : 3; }
};

// mm of a distance; degrees of an angle, 0 to 180, and 0 where two places coincide.
double value_of(const Measure& measure);
// "50.0 mm", "90.0°"
std::string text_of(const Measure& measure);

// The measures of a patient, and the one in progress. All slices show the same list.
class Measures {
 public:
  // The next click is the first place of a measure of this kind; an unfinished one is dropped.
  void begin(Measure::Kind kind);
  void cancel() { begun_.reset(); }
  // Whether a measure is in progress.
  bool waiting() const { return begun_.has_value(); }
  // Adds a place to the measure in progress; the last one completes it. No effect without one.
  void add(const Vec3& place);
  // The places so far and `pointer` as the next one, for drawing during the measurement.
  std::optional<std::vector<Vec3>> preview(const Vec3& pointer) const;

  // The measure with `pointer` as its last place; empty while more than one is missing.
  std::optional<Measure> with_next(const Vec3& pointer) const;

  const std::vector<Measure>& all() const { return all_; }
  void set(std::vector<Measure> all) { all_ = std::move(all); }
  void remove(std::size_t index);
  void clear() { all_.clear(); }

  // The measure whose line passes within `reach` mm of a place, the nearest one.
  std::optional<std::size_t> at(const Vec3& place, double reach) const;

 private:
  std::vector<Measure> all_;
  std::optional<Measure> begun_;
  std::size_t placed_ = 0;  // known places of `begun_`
};

// mm from a point to a segment.
double distance_to_segment(const Vec3& point, const Vec3& from, const Vec3& to);

}  // namespace bodkin::views
