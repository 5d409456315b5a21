#pragma once

#include <algorithm>

#include "fem/contact_tissues.h"

namespace bodkin::fem {

// What may change of a needle's contact with a deformable body while it goes on: nothing that body or contact points
// are prepared with.
struct ContactNumbers {
  ContactTissues tissues{};
  double capture_radius = 1.5;  // mm
  double time = 0.030;          // s, in which the force of a puncture goes, or a punctured node goes back
  double presliding = 1.0;      // N/mm, of ClosestNodeContact alone
};

// From numbers to others in equal steps, one a tick, so that no force jumps. Allocates nothing.
class ContactChange {
 public:
  void begin(const ContactNumbers& from, const ContactNumbers& to, int steps) noexcept {
    from_ = from;
    to_ = to;
    steps_ = std::max(1, steps);
    step_ = 0;
  }
  bool goes_on() const noexcept { return step_ < steps_; }
  // Of the next tick.
  const ContactNumbers& next() noexcept {
    if (++step_ >= steps_) return to_;
    const double share = static_cast<double>(step_) / steps_;
    const auto between = [share](double a, double b) { return a + share * (b - a); };
    for (std::size_t i = 0; i < now_.tissues.size(); ++i) {
      const ContactTissue &a = from_.tissues[i], &b = to_.tissues[i];
      now_.tissues[i] = {between(a.friction, b.friction), between(a.puncture_force, b.puncture_force),
                         between(a.cutting_force, b.cutting_force), between(a.stiffness, b.stiffness)};
    }
    now_.capture_radius = between(from_.capture_radius, to_.capture_radius);
    now_.time = between(from_.time, to_.time);
    now_.presliding = between(from_.presliding, to_.presliding);
    return now_;
  }
  // At once, where nothing is touched.
  const ContactNumbers& last() noexcept {
    step_ = steps_;
    return to_;
  }

 private:
  ContactNumbers from_, to_, now_;
  int steps_ = 0, step_ = 0;
};

}  // namespace bodkin::fem
