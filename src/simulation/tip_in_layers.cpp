#include "simulation/tip_in_layers.h"

#include <algorithm>
#include <cmath>

#include "forces/needle_law.h"
#include "simulation/touching_tissue.h"

namespace bodkin::simulation {

namespace {

constexpr double sample = 0.25;          // mm between places where the tissues are looked up
constexpr double longest_step = 50.0;    // mm at rest in one tick; of a longer step only the end counts
constexpr double least_reported = 0.01;  // N; less is no resistance that gives way
constexpr double least_change = 0.2;     // mm on the way out before a change of tissue is an event

}  // namespace

TipInLayers::TipInLayers(const anatomy::Case& patient, bool passes_layers)
    : tissues_(patient.tissues), passes_layers_(passes_layers) {
  const anatomy::TissueLibrary felt = forces::effective_tissues(patient);
  for (const anatomy::TissueProperties& tissue : felt.tissues()) {
    rigid_[tissue.id] = tissue.layered.kind == anatomy::LayeredKind::rigid;
    if (!rigid_[tissue.id]) strength_[tissue.id] = tissue.deformable.puncture_force;
  }
}

void TipInLayers::begin(const Vec3& entry, const Vec3& direction) noexcept {
  entry_ = entry;
  direction_ = direction;
  depth_ = passed_ = deepest_ = resistance_ = announced_at_ = 0.0;
  announced_ = felt_ = anatomy::tissue::air;
}

void TipInLayers::enter(anatomy::TissueId tissue, double depth, forces::TickEvents& events) noexcept {
  announced_ = tissue;
  announced_at_ = passed_;
  events.push({forces::EventKind::tissue_entered, tissue, depth, 0.0});
}

// Of a model that reports the tip's tissue itself. Bone is at the hand.
anatomy::TissueId TipInLayers::step_known(double depth, anatomy::TissueId at_tip,
                                          const forces::ResistanceForce& found, forces::TickEvents& events) noexcept {
  const anatomy::TissueId inside = rigid_[at_tip] ? at_tip : found.inside;
  felt_ = found.pushed != anatomy::tissue::air ? found.pushed : inside;
  const bool returns = depth < depth_;
  depth_ = depth;
  const bool is_far = !returns || std::abs(announced_at_ - depth) > least_change;
  if (inside != announced_ && is_far) {
    enter(inside, depth, events);
    announced_at_ = depth;
  }
  return announced_;
}

anatomy::TissueId TipInLayers::step(double depth, anatomy::TissueId at_tip, const forces::ResistanceForce& found,
                                    forces::TickEvents& events) noexcept {
  const double before = std::max(resistance_, 0.0), material = found.material;
  resistance_ = found.along;
  for (forces::Event& event : events.all()) {
    if (event.kind == forces::EventKind::puncture && event.felt == 0.0) event.felt = std::max(before, event.value);
  }
  if (found.inside != anatomy::tissue::air) return step_known(depth, at_tip, found, events);
  const anatomy::TissueId inside = touching_tissue(tissues_, entry_, direction_, depth, material, at_tip);
  felt_ = pushed_tissue(tissues_, entry_, direction_, depth, material, at_tip);
  // A thin ligament that moves as a whole lies between the pushed tissue and the tip.
  if (at_tip == anatomy::tissue::ligamentum_flavum) felt_ = at_tip;
  // Up to the boundaries that have given way: a model detects a boundary slightly later than the voxels.
  const double reached = std::min(material, depth) - beside_boundary;
  const bool advances = depth >= depth_;
  depth_ = depth;
  if (reached <= 0.0) return inside;
  if (reached > passed_) {
    if (reached - passed_ > longest_step) passed_ = reached;
    while (passed_ < reached) {
      passed_ = std::min(passed_ + sample, reached);
      const auto here =
          anatomy::nearest<anatomy::TissueId>(tissues_, Vec3(entry_ + passed_ * direction_), anatomy::tissue::air);
      if (here == announced_ || here == anatomy::tissue::air) continue;
      const bool is_reported = std::any_of(events.begin(), events.end(), [here](const forces::Event& event) {
        return event.kind == forces::EventKind::puncture && event.tissue == here;
      });
      const double own = std::min(strength_[here], before);
      if (passes_layers_ && !is_reported && passed_ > deepest_ && own > least_reported)
        events.push({forces::EventKind::puncture, here, depth, own, before});
      enter(here, depth, events);
    }
  } else if (advances) {  // a stiffened spring reaches further back; punctured tissue stays open
    return announced_ == anatomy::tissue::air ? inside : announced_;
  } else {
    passed_ = reached;
    if (inside != announced_ && std::abs(announced_at_ - reached) > least_change) enter(inside, depth, events);
  }
  deepest_ = std::max(deepest_, passed_);
  // On the way in the voxels may show a boundary before a model presses on it. Tissue that must give way is not
  // entered there.
  const bool is_whole = advances && announced_ != anatomy::tissue::air && strength_[inside] > least_reported;
  return is_whole ? announced_ : inside;
}

}  // namespace bodkin::simulation
