// Embeds the haptic engine without files, imaging libraries or the bodkin command: a slab of muscle behind skin, a
// needle pushed 30 mm in, and the force that the hand would feel. Then the same with a force model of this program's
// own, which it registers by name and which the case chooses by that name.
#include <cstdio>
#include <tuple>
#include <vector>

#include "simulation/haptic_tick.h"
#include "simulation/resistance_models.h"

namespace {

struct ConstantDragSettings {
  double force = 0.4;

  static constexpr auto parameters() {
    return std::tuple{bodkin::Parameter{"force_N", &ConstantDragSettings::force, bodkin::Range{0.0, 5.0}, "N",
                                        "against every motion", bodkin::Origin::choice}};
  }
};

// The same force against every motion, whatever the tissue.
class ConstantDrag : public bodkin::forces::ResistanceDefaults {
 public:
  using Settings = ConstantDragSettings;
  static constexpr bodkin::forces::ResistanceTraits traits = {.name = "constant_drag"};

  ConstantDrag(const bodkin::anatomy::Case&, const Settings& settings, double) : force_(settings.force) {}
  void begin(const bodkin::Vec3&, const bodkin::Vec3&) noexcept {}
  bodkin::forces::ResistanceForce step(const bodkin::forces::NeedleInTissue& needle,
                                       bodkin::forces::TickEvents&) noexcept {
    return {.along = needle.motion.direction * force_, .in_contact = needle.motion.depth > 0.0};
  }
  void reset() noexcept {}

 private:
  double force_;
};

}  // namespace

int main() {
  bodkin::anatomy::Case patient;
  bodkin::anatomy::TissueProperties air{.id = bodkin::anatomy::tissue::air, .name = "air", .title = "air"};
  bodkin::anatomy::TissueProperties skin{.id = bodkin::anatomy::tissue::skin, .name = "skin", .title = "skin"};
  skin.layered = {.kind = bodkin::anatomy::LayeredKind::viscoelastic,
                  .stiffness = 0.05,
                  .viscosity = 0.001,
                  .break_force = 1.0,
                  .shaft_stiffness = 0.02,
                  .static_friction = 0.024,
                  .dynamic_friction = 0.02};
  patient.library = bodkin::anatomy::TissueLibrary({air, skin});
  bodkin::anatomy::Grid grid;
  grid.size = {40, 40, 60};
  grid.origin = {-20.0, -20.0, 0.0};
  patient.tissues = bodkin::anatomy::TissueVolume(grid, bodkin::anatomy::tissue::skin);

  bodkin::simulation::HapticTick tick(patient);
  double peak = 0.0;
  for (int step = 0; step < 4000; ++step) {
    const bodkin::Vec3 tip(0.0, 0.0, -10.0 + 0.01 * step);
    const bodkin::simulation::TickOutput output = tick.step({bodkin::needle_pose(tip, bodkin::Vec3::UnitZ())});
    if (output.resistance > peak) peak = output.resistance;
  }
  std::printf("peak resistance %.3f N\n", peak);

  bodkin::simulation::register_resistance<ConstantDrag>();
  patient.description.haptics.resistance =
      bodkin::anatomy::RegisteredSettings{.name = "constant_drag", .values = {{"force_N", "0.7"}}, .children = {}};
  bodkin::simulation::HapticTick own(patient);
  double dragged = 0.0;
  for (int step = 0; step < 4000; ++step) {
    const bodkin::Vec3 tip(0.0, 0.0, -10.0 + 0.01 * step);
    dragged = own.step({bodkin::needle_pose(tip, bodkin::Vec3::UnitZ())}).resistance;
  }
  std::printf("constant drag %.3f N\n", dragged);
  return peak > 0.9 && peak < 2.0 && dragged == 0.7 ? 0 : 1;
}
