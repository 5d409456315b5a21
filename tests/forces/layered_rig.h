#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "forces/layered.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;

// The parameters that docs/models/layered.md gives as examples.
inline LayeredTissue rig_skin() {
  return {.kind = LayeredKind::viscoelastic,
          .stiffness = 0.05,
          .viscosity = 0.001,
          .element_spacing = 1.0,
          .break_force = 1.0,
          .shaft_stiffness = 0.02,
          .shaft_spacing = 0.5,
          .static_friction = 0.024,
          .dynamic_friction = 0.02,
          .roughness = 0.0};
}
inline LayeredTissue rig_muscle() {
  return {.kind = LayeredKind::viscoelastic,
          .stiffness = 0.03,
          .viscosity = 0.001,
          .element_spacing = 1.0,
          .break_force = 0.5,
          .shaft_stiffness = 0.02,
          .shaft_spacing = 0.5,
          .static_friction = 0.018,
          .dynamic_friction = 0.015};
}
inline LayeredTissue rig_fat() {
  return {.kind = LayeredKind::viscous, .drag = 0.0004};
}
inline LayeredTissue rig_bone() {
  return {.kind = LayeredKind::rigid, .contact_stiffness = 3.16};
}

// A library of the above; every argument but `skin` has its usual place.
inline TissueLibrary rig_library(const LayeredTissue& skin = rig_skin()) {
  LayeredTissue flavum = rig_muscle();
  flavum.break_force = 3.0;
  flavum.stiffness = 0.5;
  std::vector<TissueProperties> tissues;
  const auto add = [&tissues](TissueId id, const char* name, const LayeredTissue& layered) {
    tissues.push_back({.id = id, .name = name, .title = name, .layered = layered});
  };
  add(tissue::air, "air", {});
  add(tissue::skin, "skin", skin);
  add(tissue::fat, "fat", rig_fat());
  add(tissue::muscle, "muscle", rig_muscle());
  add(tissue::cortical_bone, "bone", rig_bone());
  add(tissue::ligamentum_flavum, "flavum", flavum);
  add(tissue::epidural_fat, "epidural", rig_fat());
  return TissueLibrary(tissues);
}

struct Slab {
  TissueId tissue;
  double thickness;  // mm
};

// A needle on a straight line through slabs, moved by depth; motion is exact, not estimated.
class LayeredRig {
 public:
  explicit LayeredRig(const std::vector<Slab>& slabs, const TissueLibrary& library = rig_library(),
                      LayeredSettings settings = {}, double device_stiffness = 1e9, double step = 0.001)
      : dt(step), model(library, settings, device_stiffness, step, 400.0) {
    for (const Slab& slab : slabs) {
      layers_.insert(layers_.end(), static_cast<std::size_t>(std::lround(slab.thickness / settings.layer)),
                     slab.tissue);
    }
    model.begin();
  }

  // One tick to `depth`; without `velocity` it is the motion's own.
  LayeredForce to(double depth, std::optional<double> velocity = {}, bool stopped = false) {
    const double v = velocity.value_or((depth - depth_) / dt);
    const int direction = stopped || v == 0.0 ? 0 : (v > 0.0 ? 1 : -1);
    last = model.step({.depth = depth, .velocity = v, .direction = direction, .stopped = stopped || v == 0.0},
                      layers_, events);
    work += 0.5 * (last.resistance + resistance_) * (depth - depth_);
    resistance_ = last.resistance;
    depth_ = depth;
    return last;
  }
  // At constant speed (mm/s) to `depth`.
  LayeredForce move(double depth, double speed) {
    const int ticks = std::max(1, static_cast<int>(std::lround(std::abs(depth - depth_) / (speed * dt))));
    const double start = depth_;
    for (int tick = 1; tick <= ticks; ++tick) to(start + (depth - start) * tick / ticks);
    return last;
  }
  // At rest for some ticks.
  LayeredForce rest(int ticks = 1) {
    for (int tick = 0; tick < ticks; ++tick) to(depth_, 0.0, true);
    return last;
  }
  double depth() const { return depth_; }
  std::vector<Event> seen(EventKind kind) const {
    std::vector<Event> found;
    std::copy_if(events.begin(), events.end(), std::back_inserter(found),
                 [kind](const Event& e) { return e.kind == kind; });
    return found;
  }

  double dt;
  Layered model;
  TickEvents events;
  LayeredForce last;
  double work = 0.0;  // N mm done by the hand, trapezoidal

 private:
  std::vector<TissueId> layers_;
  double depth_ = 0.0, resistance_ = 0.0;
};

}  // namespace bodkin
