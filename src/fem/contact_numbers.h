#pragma once

#include <algorithm>

#include "fem/contact_tissues.h"

namespace bodkin::fem {

// Numbers of a needle's contact with a deformable body that may change during the contact: none that body or contact
// points are prepared with.
struct ContactNumbers {
  ContactTissues tissues{};
  double capture_radius = 1.5;  // mm
  double time = 0.030;          // s, in which the force of a puncture decays, or a punctured node returns
  double presliding = 1.0;      // N/mm, only of ClosestNodeContact
};

// Changes from one set of numbers to another in equal steps, one per tick, so that no force jumps. Allocates nothing.
class ContactChange {
 public:
  void begin(const ContactNumbers& from, const ContactNumbers& to, int steps) noexcept {
    from_ = from;
    to_ = to;
    steps_ = std::max(1, steps);
    step_ = 0;
  }
  bool is_active() const noexcept { return step_ < steps_; }
  // The numbers of the next tick.
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
  // The final numbers at once, for when nothing is touched.
  const ContactNumbers& last() noexcept {
    step_ = steps_;
    return to_;
  }

 private:
  ContactNumbers from_, to_, now_;
  int steps_ = 0, step_ = 0;
};

}  // namespace bodkin::fem
