#pragma once

#include <memory>
#include <type_traits>

#include "anatomy/case.h"
#include "forces/resistance_model.h"
#include "simulation/body_port.h"

namespace bodkin::simulation {

// Any resistance model behind one interface; made before the ticks begin, so that no tick allocates.
class AnyResistance {
 public:
  virtual ~AnyResistance() = default;

  virtual void begin(const Vec3& entry, const Vec3& direction) noexcept = 0;
  virtual forces::ResistanceForce step(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept = 0;
  virtual void reset() noexcept = 0;

  virtual const forces::ResistanceTraits& traits() const noexcept = 0;
  virtual double firm_stiffness() const noexcept = 0;
  virtual double stiffness_scale() const noexcept = 0;
  virtual forces::ModelDiagnostics diagnostics() const noexcept = 0;

  // The deformable body of the model; null for a model without one.
  virtual BodyPort* body() noexcept = 0;
};

template <forces::ResistanceModel Model>
class ResistanceOf final : public AnyResistance {
 public:
  ResistanceOf(const anatomy::Case& patient, const typename Model::Settings& settings, double dt)
      : model_(patient, settings, dt) {}

  void begin(const Vec3& entry, const Vec3& direction) noexcept final { model_.begin(entry, direction); }
  forces::ResistanceForce step(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept final {
    return model_.step(needle, events);
  }
  void reset() noexcept final { model_.reset(); }

  const forces::ResistanceTraits& traits() const noexcept final { return Model::traits; }
  double firm_stiffness() const noexcept final { return model_.firm_stiffness(); }
  double stiffness_scale() const noexcept final { return model_.stiffness_scale(); }
  forces::ModelDiagnostics diagnostics() const noexcept final { return model_.diagnostics(); }
  BodyPort* body() noexcept final {
    if constexpr (std::is_base_of_v<BodyPort, Model>) return &model_;
    return nullptr;
  }

 private:
  Model model_;
};

}  // namespace bodkin::simulation
