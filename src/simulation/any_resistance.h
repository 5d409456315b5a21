#pragma once

#include <memory>
#include <utility>

#include "anatomy/case.h"
#include "fem/node_forces.h"
#include "forces/resistance_model.h"

namespace bodkin {

// Any resistance model behind one interface; made before the ticks begin, so that no tick allocates.
class AnyResistance {
 public:
  virtual ~AnyResistance() = default;

  virtual void begin(const Vec3& entry, const Vec3& direction) noexcept = 0;
  virtual ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept = 0;
  virtual void reset() noexcept = 0;

  virtual const ResistanceTraits& traits() const noexcept = 0;
  virtual double firm_stiffness() const noexcept = 0;
  virtual double stiffness_scale() const noexcept = 0;
  virtual ModelDiagnostics diagnostics() const noexcept = 0;

  // Of a deformable body; see Resistance.
  virtual bool add_corridor(const PreparedCorridor&) { return false; }
  virtual bool refresh_corridor(const PreparedCorridor&) { return false; }
  virtual void stay_at_rest() noexcept {}
  virtual NodeForces node_forces() const noexcept { return {}; }
  virtual Vec3 ahead() const noexcept { return Vec3::Zero(); }
};

template <ResistanceModel Model>
class ResistanceOf : public AnyResistance {
 public:
  ResistanceOf(const Case& patient, const typename Model::Settings& settings, double dt)
      : model_(patient, settings, dt) {}

  void begin(const Vec3& entry, const Vec3& direction) noexcept final { model_.begin(entry, direction); }
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept final {
    return model_.step(needle, events);
  }
  void reset() noexcept final { model_.reset(); }

  const ResistanceTraits& traits() const noexcept final { return Model::traits; }
  double firm_stiffness() const noexcept final { return model_.firm_stiffness(); }
  double stiffness_scale() const noexcept final { return model_.stiffness_scale(); }
  ModelDiagnostics diagnostics() const noexcept final { return model_.diagnostics(); }

 protected:
  Model model_;
};

// A resistance of a deformable body (Corridors).
template <ResistanceModel Model>
class BodyResistanceOf final : public ResistanceOf<Model> {
 public:
  using ResistanceOf<Model>::ResistanceOf;

  bool add_corridor(const PreparedCorridor& corridor) override { return this->model_.add(corridor); }
  bool refresh_corridor(const PreparedCorridor& corridor) override {
    if constexpr (Model::is_refreshable) this->model_.refresh(corridor);
    return Model::is_refreshable;
  }
  void stay_at_rest() noexcept override {
    if constexpr (Model::is_refreshable) this->model_.stay_at_rest();
  }
  NodeForces node_forces() const noexcept override { return this->model_.model().node_forces(); }
  Vec3 ahead() const noexcept override { return this->model_.model().ahead(); }
};

}  // namespace bodkin
