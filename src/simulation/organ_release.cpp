#include "simulation/organ_release.h"

#include <algorithm>

namespace bodkin::simulation {

OrganRelease::OrganRelease(const anatomy::Case& patient, double dt)
    : patient_(patient),
      is_on_(patient.description.haptics.force_in_organs == anatomy::ForceInOrgans::none),
      falling_(dt / fade),
      rising_(dt / come_back) {
  if (!is_on_) return;
  organ_tissue_[anatomy::tissue::organ] = organ_tissue_[anatomy::tissue::lung] = true;
  bone_[anatomy::tissue::cortical_bone] = bone_[anatomy::tissue::cancellous_bone] = true;
  for (const anatomy::Structure& structure : patient.description.structures) {
    if (!structure.critical) continue;
    critical_.resize(std::max<std::size_t>(critical_.size(), structure.label + std::size_t{1}), false);
    critical_[structure.label] = true;
  }
  // The structure that contains the target is meant to be entered.
  const anatomy::Procedure& procedure = patient.description.procedure;
  if (const anatomy::TissueProperties* aim = patient.library.find(procedure.target_tissue))
    organ_tissue_[aim->id] = false;
  if (!procedure.path) return;
  const Vec3& target = procedure.path->target;
  organ_tissue_[anatomy::nearest<anatomy::TissueId>(patient.tissues, target, anatomy::tissue::air)] = false;
  if (patient.structures.empty()) return;
  const std::uint16_t label = anatomy::nearest<std::uint16_t>(patient.structures, target, 0);
  if (label < critical_.size()) critical_[label] = false;
}

bool OrganRelease::is_organ(const Vec3& tip, anatomy::TissueId tissue) const noexcept {
  if (organ_tissue_[tissue]) return true;
  if (bone_[tissue] || patient_.structures.empty()) return false;
  const std::uint16_t label = anatomy::nearest<std::uint16_t>(patient_.structures, tip, 0);
  return label < critical_.size() && critical_[label];
}

double OrganRelease::step(const Vec3& tip, anatomy::TissueId tissue) noexcept {
  if (!is_on_) return 1.0;
  share_ = is_organ(tip, tissue) ? std::max(share_ - falling_, 0.0) : std::min(share_ + rising_, 1.0);
  return share_;
}

}  // namespace bodkin::simulation
