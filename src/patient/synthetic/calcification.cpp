#include "patient/synthetic/calcification.h"

#include "core/error.h"

namespace bodkin::patient {

anatomy::TissueLibrary with_calcified_ligament(const anatomy::TissueLibrary& library) {
  const anatomy::TissueProperties* const ligament = library.find(anatomy::tissue::interspinous_ligament);
  if (ligament == nullptr) {
    throw InputError(
        "synthetic patient: the tissue library has no interspinous ligament, expected one for calcified ligaments; "
        "add it to the library");
  }
  // Twice the 4.7 N at which the ligamentum flavum gives way (Sutherland et al. 2013, III.A).
  constexpr double force = 9.4;  // N
  anatomy::TissueProperties hard = *ligament;
  hard.id = calcified_ligament;
  hard.name = calcified_ligament_name;
  hard.title = "calcified ligament";
  hard.colour = 0xD9C7A3;
  hard.hounsfield = 220.0;
  hard.hounsfield_noise = 45.0;
  hard.layered.stiffness = 1.7;  // of the ligamentum flavum: the stiffness that a device of 1 N/mm renders
  hard.layered.element_spacing = 20.0;
  hard.layered.break_force = force;
  hard.layered.static_friction = 0.2;
  hard.layered.dynamic_friction = 0.16;
  hard.tracking_wall = {.stiffness = 1.0, .force = force};
  hard.volume_proxy.properties.penetrability = force;
  hard.volume_proxy.properties.friction = 3.0;
  hard.volume_proxy.field_value = 0.8;
  hard.syringe.resistance = 10.0;
  hard.deformable.young = 1.7;
  hard.deformable.puncture_force = force;
  hard.acoustic.impedance = 3.5;  // between ligament and cortical bone, so that it shadows deeper tissue
  hard.acoustic.attenuation = 8.0;
  hard.acoustic.echo = -20.0;
  hard.physical.puncture_force = force;
  hard.physical.young = 1.7;
  hard.source =
      "Bodkin default, no published value: twice the puncture force of the ligamentum flavum (4.7 N, Sutherland et "
      "al. 2013, III.A), ten times the modulus of the ligament; HU as cancellous bone. All else as the interspinous "
      "ligament.";
  std::vector<anatomy::TissueProperties> tissues = library.tissues();
  tissues.push_back(std::move(hard));
  return anatomy::TissueLibrary(std::move(tissues));
}

}  // namespace bodkin::patient
