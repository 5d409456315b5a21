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

namespace bodkin {

namespace {

// The needle is free to leave its line.
struct FreeNeedle {
  using Settings = NoConstraint;
  static constexpr ConstraintTraits traits = {.name = "none"};

  FreeNeedle(const Case&, const NoConstraint&, double) {}
  void begin(const Vec3&, const Vec3&, const Vec3&) noexcept {}
  Wrench step(const HeldNeedle&) const noexcept { return {}; }
};

template <ConstraintModel Model>
class ConstraintOf final : public AnyConstraint {
 public:
  ConstraintOf(const Case& patient, const typename Model::Settings& settings, double dt)
      : model_(patient, settings, dt) {}

  void begin(const Vec3& entry, const Vec3& direction, const Vec3& tip) noexcept override {
    model_.begin(entry, direction, tip);
  }
  Wrench step(const HeldNeedle& needle) noexcept override { return model_.step(needle); }
  const Rail* rail() const noexcept override {
    if constexpr (std::is_same_v<Model, Rail>) return &model_;
    return nullptr;
  }

 private:
  Model model_;
};

struct ConstraintEntry {
  std::string_view name;
  std::unique_ptr<AnyConstraint> (*make)(const Case& patient, double dt);
};

template <ConstraintModel Model>
constexpr ConstraintEntry entry_of() {
  return {Model::traits.name, [](const Case& patient, double dt) -> std::unique_ptr<AnyConstraint> {
            const auto& settings = std::get<typename Model::Settings>(patient.description.haptics.constraint);
            return std::make_unique<ConstraintOf<Model>>(patient, settings, dt);
          }};
}

constexpr ConstraintEntry constraint_models[] = {
    entry_of<LineSpring>(), entry_of<Pivot>(), entry_of<Rail>(), entry_of<Beam>(), entry_of<FreeNeedle>(),
};

std::unique_ptr<AnyConstraint> make_constraint(const Case& patient, double dt) {
  const std::string_view name = name_of(patient.description.haptics.constraint);
  const auto* found = std::find_if(std::begin(constraint_models), std::end(constraint_models),
                                   [&](const ConstraintEntry& entry) { return entry.name == name; });
  if (found != std::end(constraint_models)) return found->make(patient, dt);
  std::string names;
  for (const ConstraintEntry& entry : constraint_models)
    names += (names.empty() ? "" : ", ") + std::string(entry.name);
  throw InputError("there is no constraint '" + std::string(name) + "', expected one of " + names);
}

}  // namespace

Constraint::Constraint(const Case& patient, double dt)
    : model_(make_constraint(patient, dt)), length_(patient.description.needle.length) {}

}  // namespace bodkin
