// Embeds the haptic engine without files, imaging libraries or the bodkin command: a slab of muscle behind skin, a
// needle pushed 30 mm in, and the force that the hand would feel. Then the same with a force model of this program's
// own, which it registers by name and which the case chooses by that name. Then in a deformable body, which it makes
// from a mesh.
#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "fem/solid/contact_body.h"
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

// A block of skin of 40 x 40 x 40 mm below z = 0, held at its far side: cubes of 5 mm in six tetrahedra each.
bodkin::fem::BodyDescription block_of_skin() {
  constexpr std::uint32_t n = 9;
  constexpr std::array<std::array<int, 2>, 6> turns = {{{0, 1}, {1, 2}, {2, 0}, {0, 2}, {2, 1}, {1, 0}}};
  bodkin::fem::BodyDescription body;
  const auto name = [](const std::array<std::uint32_t, 3>& at) { return (at[2] * n + at[1]) * n + at[0]; };
  for (std::uint32_t k = 0; k < n; ++k)
    for (std::uint32_t j = 0; j < n; ++j)
      for (std::uint32_t i = 0; i < n; ++i) {
        body.mesh.nodes.emplace_back(5.0 * i - 20.0, 5.0 * j - 20.0, 5.0 * k);
        if (k + 1 == n) body.fixed.push_back(name({i, j, k}));
      }
  for (std::uint32_t cube = 0; cube < (n - 1) * (n - 1) * (n - 1); ++cube) {
    const std::array<std::uint32_t, 3> low = {cube % (n - 1), cube / (n - 1) % (n - 1), cube / ((n - 1) * (n - 1))};
    for (const auto& [first, second] : turns) {
      std::array<std::uint32_t, 3> at = low;
      std::array<std::uint32_t, 4> element{name(at)};
      ++at[static_cast<std::size_t>(first)];
      element[1] = name(at);
      ++at[static_cast<std::size_t>(second)];
      element[2] = name(at);
      element[3] = name({low[0] + 1, low[1] + 1, low[2] + 1});
      if ((first + 1) % 3 != second) std::swap(element[1], element[2]);
      body.mesh.elements.push_back(element);
      body.mesh.tissues.push_back(bodkin::anatomy::tissue::skin);
    }
  }
  body.materials.set(bodkin::anatomy::tissue::skin, {0.2, 0.3});
  return body;
}

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
  skin.deformable.puncture_force = 1.0;
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

  const bodkin::anatomy::NeedlePath path{bodkin::Vec3::Zero(), bodkin::Vec3(0.0, 0.0, 30.0)};
  const bodkin::anatomy::EmbeddedNeedleSettings embedded;
  const bodkin::fem::ContactBody block(std::make_shared<const bodkin::fem::BodyDescription>(block_of_skin()));
  const auto stations = bodkin::fem::stations_along(path, path.length(), embedded.point_spacing, patient);
  patient.corridor.body = std::make_shared<const bodkin::anatomy::CondensedBody>(
      block.contact_points(stations, path.direction(), embedded.tip_radius));
  patient.corridor.path = path;
  patient.description.haptics.resistance = embedded;
  bodkin::simulation::HapticTick deformable(patient);
  double held = 0.0;
  for (int step = 0; step < 4000; ++step) {
    const bodkin::Vec3 tip(0.0, 0.0, -10.0 + 0.01 * step);
    const double now = deformable.step({bodkin::needle_pose(tip, bodkin::Vec3::UnitZ())}).resistance;
    if (now > held) held = now;
  }
  std::printf("deformable body %.3f N\n", held);
  return peak > 0.9 && peak < 2.0 && dragged == 0.7 && held > 0.1 ? 0 : 1;
}
