#pragma once

#include <array>

#include "anatomy/case.h"
#include "forces/events.h"
#include "forces/resistance_model.h"

namespace bodkin::simulation {

// The layers that a needle passes in a tissue that moves before it is punctured: each is entered when the tip has
// passed its boundary, in their order, however many are punctured in one tick.
class TipInLayers {
 public:
  // `passes_layers`: the model does not itself detect punctures (ResistanceTraits).
  TipInLayers(const anatomy::Case& patient, bool passes_layers);

  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  // One tick in contact. `depth`: mm, of the tip; `at_tip`: tissue in the CT at the tip; `found`: of this tick.
  // Completes the punctures among `events`, and appends punctures for models that only pass layers, and
  // tissue_entered. Returns the tissue at the tip.
  anatomy::TissueId step(double depth, anatomy::TissueId at_tip, const forces::ResistanceForce& found,
                         forces::TickEvents& events) noexcept;
  // The tissue at the tip, or the one that the tip pushes: a ligament under pressure is being felt.
  anatomy::TissueId felt() const noexcept { return felt_; }

 private:
  anatomy::TissueId step_known(double depth, anatomy::TissueId at_tip, const forces::ResistanceForce& found,
                               forces::TickEvents& events) noexcept;
  void enter(anatomy::TissueId tissue, double depth, forces::TickEvents& events) noexcept;

  const anatomy::TissueVolume& tissues_;
  bool passes_layers_;
  std::array<bool, 256> rigid_{};       // 256, by TissueId
  std::array<double, 256> strength_{};  // N, F_p of the needle, 256, by TissueId
  Vec3 entry_ = Vec3::Zero(), direction_ = Vec3::UnitZ();
  double depth_ = 0.0;       // mm, of the tip in the last tick
  double passed_ = 0.0;      // mm at rest, depth to which the tissues have been entered
  double deepest_ = 0.0;     // mm at rest
  double resistance_ = 0.0;  // N, of the last tick
  double announced_at_ = 0.0;
  anatomy::TissueId announced_ = anatomy::tissue::air, felt_ = anatomy::tissue::air;
};

}  // namespace bodkin::simulation
