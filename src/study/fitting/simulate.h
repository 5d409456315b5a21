#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>

#include "study/fitting/fit_model.h"

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

// An element of numbers in the form of the tissue library and of case files: the shortest text that reads back alike.
io::XmlElement numbers_element(const std::string& name,
                               std::initializer_list<std::pair<const char*, double>> numbers);

// The force at a depth (mm, taken as 0.01 at least) of Voigt's cubic law with a stiffness of 1 N/mm: for the
// stiffness that a force at a depth implies.
double cubic_per_stiffness(double spacing, double depth);

inline constexpr anatomy::TissueId first_layer = 32;  // ids of a stack's tissues, free in the engine

// A value for each layer, as parameters `name_1`, `name_2` ...
void add_for_layers(FitModel& model, std::size_t layers, const FitParameter& one);
// Where each layer begins, as parameters `from_1`, `from_2` ..., always kept.
void add_tops(FitModel& model, std::span<const double> tops);

// What models do that have no limit of the device: it would bend the curve of the tissue.
inline constexpr double no_limit = 100.0;  // N, the highest that a setting allows

}  // namespace bodkin::study
