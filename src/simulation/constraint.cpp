#include "simulation/constraint.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "core/error.h"
#include "forces/beam.h"
#include "forces/line_spring.h"
#include "forces/pivot.h"

namespace bodkin::simulation {

namespace {

// The needle is free to leave its line.
struct FreeNeedle {
  using Settings = anatomy::NoConstraint;
  static constexpr forces::ConstraintTraits traits = {.name = "none"};

  FreeNeedle(const anatomy::Case&, const anatomy::NoConstraint&, double) {}
  void begin(const Vec3&, const Vec3&, const Vec3&) noexcept {}
  Wrench step(const forces::HeldNeedle&) const noexcept { return {}; }
};

template <forces::ConstraintModel Model>
class ConstraintOf final : public AnyConstraint {
 public:
  ConstraintOf(const anatomy::Case& patient, const typename Model::Settings& settings, double dt)
      : model_(patient, settings, dt) {}

  void begin(const Vec3& entry, const Vec3& direction, const Vec3& tip) noexcept override {
    model_.begin(entry, direction, tip);
  }
  Wrench step(const forces::HeldNeedle& needle) noexcept override { return model_.step(needle); }
  const forces::Rail* rail() const noexcept override {
    if constexpr (std::is_same_v<Model, forces::Rail>) return &model_;
    return nullptr;
  }

 private:
  Model model_;
};

struct ConstraintEntry {
  std::string_view name;
  std::unique_ptr<AnyConstraint> (*make)(const anatomy::Case& patient, double dt);
};

template <forces::ConstraintModel Model>
constexpr ConstraintEntry entry_of() {
  return {Model::traits.name, [](const anatomy::Case& patient, double dt) -> std::unique_ptr<AnyConstraint> {
            const auto& settings = std::get<typename Model::Settings>(patient.description.haptics.constraint);
            return std::make_unique<ConstraintOf<Model>>(patient, settings, dt);
          }};
}

constexpr ConstraintEntry constraint_models[] = {
    entry_of<forces::LineSpring>(), entry_of<forces::Pivot>(), entry_of<forces::Rail>(),
    entry_of<forces::Beam>(),       entry_of<FreeNeedle>(),
};

std::unique_ptr<AnyConstraint> make_constraint(const anatomy::Case& patient, double dt) {
  const std::string_view name = anatomy::name_of(patient.description.haptics.constraint);
  const auto* found = std::find_if(std::begin(constraint_models), std::end(constraint_models),
                                   [&](const ConstraintEntry& entry) { return entry.name == name; });
  if (found != std::end(constraint_models)) return found->make(patient, dt);
  std::string names;
  for (const ConstraintEntry& entry : constraint_models)
    names += (names.empty() ? "" : ", ") + std::string(entry.name);
  throw InputError("there is no constraint '" + std::string(name) + "', expected one of " + names);
}

}  // namespace

Constraint::Constraint(const anatomy::Case& patient, double dt)
    : model_(make_constraint(patient, dt)), length_(patient.description.needle.length) {}

}  // namespace bodkin::simulation
