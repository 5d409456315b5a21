#include "simulation/contact_settings.h"

#include <algorithm>
#include <string>
#include <variant>

#include "core/error.h"
#include "core/settings_check.h"
#include "forces/needle_law.h"

namespace bodkin::simulation {

namespace {

constexpr double least_friction_share = 0.1;  // of the device's stiffness, reserved for the friction's spring
constexpr double least_presliding = 0.01;     // N/mm, the limit of ClosestNodeContact

template <typename Settings>
void give_live_numbers(Settings& to, const Settings& from) {
  to.capture_radius = from.capture_radius;
  if constexpr (requires { to.puncture_time; }) to.puncture_time = from.puncture_time;
  if constexpr (requires { to.presliding; }) {
    to.presliding = from.presliding;
    to.relaxation = from.relaxation;
  }
}

bool same_but_contact(const anatomy::ResistanceSettings& a, const anatomy::ResistanceSettings& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&b](auto one) {
        using Settings = decltype(one);
        const auto& other = std::get<Settings>(b);
        if constexpr (
            requires { one.capture_radius; } && requires { one.body; }) {
          give_live_numbers(one, other);
          return same_parameters(one, other);
        } else {
          return false;
        }
      },
      a);
}

bool same_constraint(const anatomy::ConstraintSettings& a, const anatomy::ConstraintSettings& b) {
  return a.index() == b.index() &&
         std::visit([&b](const auto& one) { return same_parameters(one, std::get<std::decay_t<decltype(one)>>(b)); },
                    a);
}

}  // namespace

fem::ContactTissues contact_tissues(const anatomy::Case& patient) {
  fem::ContactTissues tissues;
  const anatomy::TissueLibrary library = forces::effective_tissues(patient);
  for (const anatomy::TissueProperties& tissue : library.tissues()) {
    const anatomy::DeformableTissue& here = tissue.deformable;
    tissues[tissue.id] = {.friction = here.friction,
                          .puncture_force = here.puncture_force,
                          .cutting_force = here.cutting_force,
                          .stiffness = here.stiffness};
  }
  return tissues;
}

// Tissue too stiff for the device becomes as stiff as the device can render, minus a share for the friction.
fem::ContactNumbers contact_numbers(const anatomy::Case& patient, const anatomy::ClosestNodeSettings& settings) {
  bodkin::check(settings, "closest_node");
  fem::ContactNumbers numbers;
  numbers.tissues = contact_tissues(patient);
  fem::check_contact_tissues(numbers.tissues);
  const double device = patient.description.device.stiffness;
  double firm = 0.0;
  for (fem::ContactTissue& tissue : numbers.tissues) {
    tissue.stiffness = std::min(tissue.stiffness, device);
    firm = std::max(firm, tissue.stiffness);
  }
  numbers.capture_radius = settings.capture_radius;
  numbers.time = settings.relaxation;
  numbers.presliding =
      std::min(settings.presliding, std::max({device - firm, least_friction_share * device, least_presliding}));
  return numbers;
}

fem::ContactNumbers contact_numbers(const anatomy::Case& patient) {
  const anatomy::ResistanceSettings& resistance = patient.description.haptics.resistance;
  fem::ContactNumbers numbers;
  numbers.tissues = contact_tissues(patient);
  fem::check_contact_tissues(numbers.tissues);
  if (const auto* const embedded = std::get_if<anatomy::EmbeddedNeedleSettings>(&resistance)) {
    bodkin::check(*embedded, "embedded_needle");
    numbers.capture_radius = embedded->capture_radius;
    numbers.time = embedded->puncture_time;
    return numbers;
  }
  const auto* const closest = std::get_if<anatomy::ClosestNodeSettings>(&resistance);
  if (closest == nullptr) {
    throw InputError(std::string(anatomy::name_of(resistance)) +
                     " has no deformable body, expected embedded_needle or closest_node");
  }
  return contact_numbers(patient, *closest);
}

bool differ_in_contact_alone(const anatomy::HapticSettings& a,
                             const std::vector<anatomy::TissueProperties>& tissues_a,
                             const anatomy::HapticSettings& b,
                             const std::vector<anatomy::TissueProperties>& tissues_b) {
  if (!same_but_contact(a.resistance, b.resistance) || !same_constraint(a.constraint, b.constraint)) return false;
  if (!same_parameters(a.parts, b.parts) || !same_parameters(a.compensation, b.compensation)) return false;
  if (tissues_a.size() != tissues_b.size()) return false;
  return std::equal(tissues_a.begin(), tissues_a.end(), tissues_b.begin(), [](auto one, const auto& other) {
    one.deformable.friction = other.deformable.friction;
    one.deformable.puncture_force = other.deformable.puncture_force;
    one.deformable.cutting_force = other.deformable.cutting_force;
    one.deformable.stiffness = other.deformable.stiffness;
    return same_parameters(one, other);
  });
}

}  // namespace bodkin::simulation
