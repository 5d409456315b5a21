#pragma once

#include "fem/moving/corotational_body.h"

namespace bodkin::checks {

using namespace bodkin::fem;

// A static body, whose steps are solved nearly exactly.
inline CorotationalSettings to_rest() {
  CorotationalSettings settings;
  settings.dt = 0.0;
  settings.gradients = {1e-6, 2000};
  return settings;
}

// Steps until the imbalance of every free node is at most `balance` N; returns their number.
inline int settle(CorotationalBody& body, double balance, int most_steps = 200) {
  for (int step = 1; step <= most_steps; ++step) {
    const CorotationalStep& told = body.step();
    if (told.fault) return -1;
    if (told.unbalance <= balance) return step;
  }
  return most_steps + 1;
}

}  // namespace bodkin::checks
