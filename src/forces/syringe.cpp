#include "forces/syringe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/repeatable.h"
#include "forces/model_input.h"

namespace bodkin::forces {
namespace {

constexpr double atmosphere = 0.1013;       // MPa
constexpr double highest_pressure = 2.0;    // MPa: beyond any thumb
constexpr double lowest_pressure = -0.099;  // MPa gauge: short of vacuum

}  // namespace

double tube_resistance(double viscosity, double length, double bore) {
  const double square = bore * bore;
  return 128.0 * viscosity * length / (std::numbers::pi * square * square);
}

Syringe::Syringe(const anatomy::TissueLibrary& library, const anatomy::SyringeSettings& settings, double dt)
    : settings_(settings), tissues_(library.by_id(&anatomy::TissueProperties::syringe)), dt_(dt) {
  constexpr auto model = "syringe";
  check_tick(model, dt);
  check(settings, model);
  check_tissues(library, &anatomy::TissueProperties::syringe, model);
  area_ = std::numbers::pi * settings.bore * settings.bore / 4.0;
  needle_resistance_ = tube_resistance(settings.viscosity, settings.needle_length, settings.needle_bore);
}

double Syringe::relax(double pressure, double outside, double inflow, double compliance, double resistance,
                      double dt) noexcept {
  const double steady = outside + resistance * inflow;
  return pressure - (steady - pressure) * repeatable::expm1(-dt / (resistance * compliance));
}

const SyringeState& Syringe::step(double plunger_speed, anatomy::TissueId tissue) noexcept {
  const double speed = std::abs(plunger_speed) <= 1e4 ? plunger_speed : 0.0;  // NaN too
  const anatomy::SyringeTissue& here = tissues_[tissue];
  const double resistance = needle_resistance_ + here.resistance;
  const double compliance = settings_.filling == anatomy::SyringeFilling::saline
                                ? settings_.saline_compliance
                                : settings_.air_volume / (atmosphere + state_.pressure);
  state_.pressure = std::clamp(relax(state_.pressure, here.pressure, area_ * speed, compliance, resistance, dt_),
                               lowest_pressure, highest_pressure);
  state_.flow = (state_.pressure - here.pressure) / resistance;
  // The seal's friction opposes the motion; below 1 mm/s it falls continuously instead of switching.
  state_.force = area_ * state_.pressure + settings_.friction * std::clamp(speed, -1.0, 1.0);
  return state_;
}

}  // namespace bodkin::forces
