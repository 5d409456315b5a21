#pragma once

#include <algorithm>
#include <vector>

namespace bodkin::patient {

// A smooth function through knots: cubic Hermite with the slopes of the neighbours' chords. Linear beyond the ends.
class Curve {
 public:
  // Knots may come in any order; no two may share a position.
  void add(double position, double value) {
    const auto place = std::lower_bound(knots_.begin(), knots_.end(), position,
                                        [](const Knot& knot, double z) { return knot.z < z; });
    knots_.insert(place, {position, value});
  }

  double operator()(double z) const {
    if (knots_.size() == 1) return knots_.front().value;
    const auto above = std::upper_bound(knots_.begin(), knots_.end(), z,
                                        [](double position, const Knot& knot) { return position < knot.z; });
    const std::size_t last = knots_.size() - 2;
    const std::size_t i =
        above == knots_.begin() ? 0 : std::min(static_cast<std::size_t>(above - knots_.begin()) - 1, last);
    const Knot &a = knots_[i], &b = knots_[i + 1];
    const double span = b.z - a.z, t = (z - a.z) / span;
    if (t < 0.0) return a.value + slope(i) * (z - a.z);
    if (t > 1.0) return b.value + slope(i + 1) * (z - b.z);
    const double t2 = t * t, t3 = t2 * t;
    return (2.0 * t3 - 3.0 * t2 + 1.0) * a.value + (t3 - 2.0 * t2 + t) * span * slope(i) +
           (3.0 * t2 - 2.0 * t3) * b.value + (t3 - t2) * span * slope(i + 1);
  }

 private:
  struct Knot {
    double z, value;
  };
  double slope(std::size_t i) const {
    const std::size_t low = i == 0 ? 0 : i - 1, high = std::min(i + 1, knots_.size() - 1);
    return (knots_[high].value - knots_[low].value) / (knots_[high].z - knots_[low].z);
  }
  std::vector<Knot> knots_;  // ascending z
};

}  // namespace bodkin::patient
