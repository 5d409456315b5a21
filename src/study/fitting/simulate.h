#pragma once

#include <cstddef>
#include <span>

#include "study/fitting/fit_model.h"

#include "anatomy/resistance_settings.h"
#include "anatomy/tissue.h"
#include "forces/events.h"

namespace bodkin::study {

// Drives a model through a history. `begin()` opens a line when the tip meets the tissue at `contact` (mm), as the
// tick does; `step(motion, events)` returns the force, N, for depths below the contact; a line ends when the tip is
// out.
template <typename Begin, typename Step>
void simulate_axial(const NeedleHistory& history, double contact, std::span<double> force, Begin begin, Step step) {
  forces::TickEvents events;
  bool inside = false;
  for (std::size_t n = 0; n < history.ticks.size(); ++n) {
    AxialMotion motion = history.ticks[n];
    motion.depth -= contact;
    if (!inside && motion.depth > 0.0) begin();
    events.clear();
    force[n] = inside || motion.depth > 0.0 ? step(motion, events) : 0.0;
    inside = motion.depth > 0.0;
  }
}

// The force at a depth (mm, at least 0.01) of Voigt's cubic law with a stiffness of 1 N/mm: for the stiffness implied
// by a force at a depth.
double cubic_per_stiffness(double spacing, double depth);

inline constexpr anatomy::TissueId first_layer = 32;  // ids of a stack's tissues, free in the engine

// A value for each layer, as parameters `name_1`, `name_2` ...
void add_for_layers(FitModel& model, std::size_t layers, const FitParameter& one);
// Friction of a shaft in tissue, if nothing better is known: the tables' default is none, which has no scale.
inline const anatomy::KarnoppFriction usual_friction = anatomy::ThreeComponentSettings{}.inwards;

// Depth at which the needle meets the tissue: not a setting of a model, because a case has its skin there.
FitParameter contact_parameter();
// The top of each layer, as parameters `from_1`, `from_2` ..., always fixed.
void add_tops(FitModel& model, std::span<const double> tops);

// The highest `limit_N` allowed by a model's settings, N: a device's limit would distort the curve of the tissue.
template <Parameterized Settings>
double no_limit() {
  return fit_parameter(&Settings::limit).high;
}

}  // namespace bodkin::study
