// Embeds the haptic engine without files, imaging libraries or the bodkin command: a slab of muscle behind skin, a
// needle pushed 30 mm in, and the force that the hand would feel.
#include <cstdio>
#include <vector>

#include "simulation/haptic_tick.h"

int main() {
  bodkin::Case patient;
  bodkin::TissueProperties air{.id = bodkin::tissue::air, .name = "air", .title = "air"};
  bodkin::TissueProperties skin{.id = bodkin::tissue::skin, .name = "skin", .title = "skin"};
  skin.layered = {.kind = bodkin::LayeredKind::viscoelastic,
                  .stiffness = 0.05,
                  .viscosity = 0.001,
                  .break_force = 1.0,
                  .shaft_stiffness = 0.02,
                  .static_friction = 0.024,
                  .dynamic_friction = 0.02};
  patient.library = bodkin::TissueLibrary({air, skin});
  bodkin::Grid grid;
  grid.size = {40, 40, 60};
  grid.origin = {-20.0, -20.0, 0.0};
  patient.tissues = bodkin::TissueVolume(grid, bodkin::tissue::skin);

  bodkin::HapticTick tick(patient);
  double peak = 0.0;
  for (int step = 0; step < 4000; ++step) {
    const bodkin::Vec3 tip(0.0, 0.0, -10.0 + 0.01 * step);
    const bodkin::TickOutput output = tick.step({bodkin::needle_pose(tip, bodkin::Vec3::UnitZ())});
    if (output.resistance > peak) peak = output.resistance;
  }
  std::printf("peak resistance %.3f N\n", peak);
  return peak > 0.9 && peak < 2.0 ? 0 : 1;
}
