#include "fem/contact_tissues.h"

#include <string>

#include "core/error.h"

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
  const auto require = [](double value, double most, std::size_t id, const char* what, const char* unit) {
    if (value >= 0.0 && value <= most) return;
    throw InputError("contact: the " + std::string(what) + " of tissue " + std::to_string(id) + " is " +
                     std::to_string(value) + " " + unit + ", expected 0 to " +
                     std::to_string(static_cast<int>(most)));
  };
  for (std::size_t id = 0; id < tissues.size(); ++id) {
    require(tissues[id].friction, 10.0, id, "friction", "N/mm");
    require(tissues[id].puncture_force, 100.0, id, "puncture force", "N");
    require(tissues[id].cutting_force, 100.0, id, "cutting force", "N");
    require(tissues[id].stiffness, 100.0, id, "contact stiffness", "N/mm");
  }
}

}  // namespace bodkin::fem
