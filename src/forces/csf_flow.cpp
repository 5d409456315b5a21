#include "forces/csf_flow.h"

#include <cmath>
#include <numbers>

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

CsfFlow::CsfFlow(const anatomy::CsfFlowSettings& settings, double dt) : settings_(settings), dt_(dt) {
  constexpr auto model = "csf_flow";
  check_tick(model, dt);
  check(settings, model);
  check_range(model, "needle bore", settings.needle_bore, {0.05, 3.0}, "mm");
  check_range(model, "needle length", settings.needle_length, {10.0, 300.0}, "mm");
  resistance_ = tube_resistance(settings.viscosity, settings.needle_length, settings.needle_bore);
}

double CsfFlow::drip(double height) const noexcept {
  return weight * height / resistance_;
}

double CsfFlow::time_constant() const noexcept {
  const double bore = settings_.manometer_bore;
  return resistance_ * std::numbers::pi * bore * bore / 4.0 / weight;
}

const CsfState& CsfFlow::step_manometer(double open, bool stylet) noexcept {
  const double part = opening(open, stylet);
  const double before = state_.height;
  state_.height -= (settings_.opening_pressure - before) * std::expm1(-dt_ * part / time_constant());
  const double bore = settings_.manometer_bore;
  state_.flow = (state_.height - before) * std::numbers::pi * bore * bore / 4.0 / dt_;
  return state_;
}

const CsfState& CsfFlow::step_drip(double open, bool stylet) noexcept {
  state_.flow = drip(settings_.opening_pressure) * opening(open, stylet);
  state_.collected += state_.flow * dt_;
  return state_;
}

}  // namespace bodkin::forces
