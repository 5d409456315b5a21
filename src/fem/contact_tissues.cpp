#include "fem/contact_tissues.h"

#include <string>

#include "anatomy/tissue_forces.h"
#include "core/settings_check.h"

namespace bodkin::fem {

ContactTissues default_contact_tissues() {
  ContactTissues tissues;
  const ContactTissue soft{.friction = 0.02, .puncture_force = 0.9, .stiffness = 0.3};
  const ContactTissue ligament{.friction = 0.2, .puncture_force = 4.7, .stiffness = 1.0};
  tissues.fill(soft);
  for (const anatomy::TissueId fluid :
       {anatomy::tissue::air, anatomy::tissue::gas, anatomy::tissue::cerebrospinal_fluid})
    tissues[fluid] = {};
  tissues[anatomy::tissue::epidural_fat] = {.friction = 0.02, .puncture_force = 0.0, .stiffness = 0.3};
  tissues[anatomy::tissue::skin] = {.friction = 0.02, .puncture_force = 1.5, .stiffness = 0.3};
  tissues[anatomy::tissue::ligamentum_flavum] = ligament;
  for (const anatomy::TissueId other :
       {anatomy::tissue::supraspinous_ligament, anatomy::tissue::interspinous_ligament}) {
    tissues[other] = {.friction = 0.2, .puncture_force = 0.9, .stiffness = 0.3};
  }
  for (const anatomy::TissueId hard :
       {anatomy::tissue::cortical_bone, anatomy::tissue::cancellous_bone, anatomy::tissue::metal}) {
    tissues[hard] = {.friction = 0.2, .puncture_force = 100.0, .stiffness = 1.0};
  }
  return tissues;
}

void check_contact_tissues(const ContactTissues& tissues) {
  using Declared = anatomy::DeformableTissue;
  for (std::size_t id = 0; id < tissues.size(); ++id) {
    const auto check_as = [id](double Declared::*member, double value) {
      const DeclaredParameter declared = declaration_of(member);
      check_range("contact with tissue " + std::to_string(id), declared.name, value, declared.range, declared.unit);
    };
    check_as(&Declared::friction, tissues[id].friction);
    check_as(&Declared::puncture_force, tissues[id].puncture_force);
    check_as(&Declared::cutting_force, tissues[id].cutting_force);
    check_as(&Declared::stiffness, tissues[id].stiffness);
  }
}

}  // namespace bodkin::fem
