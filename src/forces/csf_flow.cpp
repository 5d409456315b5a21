#include "forces/csf_flow.h"

#include <cmath>
#include <numbers>

#include "core/repeatable.h"
#include "forces/model_input.h"
#include "forces/syringe.h"

namespace bodkin::forces {
namespace {

constexpr double weight = 9.80665e-6;  // rho g, MPa/mm, of water

double opening(double open, bool stylet) noexcept {
  if (stylet || !(open > 0.0)) return 0.0;
  return open < 1.0 ? open : 1.0;
}

}  // namespace

CsfFlow::CsfFlow(const anatomy::CsfFlowSettings& settings, double dt)
    : settings_(settings), dt_(dt * settings.times_faster) {
  constexpr auto model = "csf_flow";
  check_tick(model, dt);
  check(settings, model);
  resistance_ = tube_resistance(settings.viscosity, settings.needle_length, settings.needle_bore);
}

double CsfFlow::drip(double height) const noexcept {
  return weight * height / resistance_;
}

double CsfFlow::time_constant() const noexcept {
  return resistance_ * section() / weight;
}

double CsfFlow::section() const noexcept {
  const double bore = settings_.manometer_bore;
  return std::numbers::pi * bore * bore / 4.0;
}

double CsfFlow::pressure() const noexcept {
  if (settings_.pressure_volume_index == 0.0) return settings_.opening_pressure;
  return settings_.opening_pressure *
         repeatable::pow(10.0, -1e-3 * state_.collected / settings_.pressure_volume_index);
}

void CsfFlow::empty_manometer() noexcept {
  state_.collected += state_.height * section();
  state_.height = 0.0;
}

// A bevel is mostly all in fluid or not at all, and so as far open as in the last tick.
double CsfFlow::faded_in_tick(double part) noexcept {
  if (part != faded_for_) {
    faded_for_ = part;
    faded_ = repeatable::expm1(-dt_ * part / time_constant());
  }
  return faded_;
}

const CsfState& CsfFlow::step_manometer(double open, bool stylet) noexcept {
  const double part = opening(open, stylet);
  const double before = state_.height;
  state_.height -= (pressure() - before) * faded_in_tick(part);
  state_.flow = (state_.height - before) * section() / dt_;
  return state_;
}

const CsfState& CsfFlow::step_drip(double open, bool stylet) noexcept {
  state_.flow = drip(pressure()) * opening(open, stylet);
  state_.collected += state_.flow * dt_;
  return state_;
}

}  // namespace bodkin::forces
