#include "simulation/constraint.h"

#include <type_traits>
#include <variant>

namespace bodkin::simulation {

namespace {

std::unique_ptr<forces::AnyConstraint> make_constraint(const anatomy::Case& patient, double dt) {
  return std::visit(
      [&](const auto& settings) -> std::unique_ptr<forces::AnyConstraint> {
        if constexpr (std::is_same_v<decltype(settings), const anatomy::NoConstraint&>)
          return nullptr;
        else
          return forces::constraint_with(patient, settings, dt);
      },
      patient.description.haptics.constraint);
}

}  // namespace

Constraint::Constraint(const anatomy::Case& patient, double dt)
    : model_(make_constraint(patient, dt)), length_(patient.description.needle.length) {}

}  // namespace bodkin::simulation
