// Embeds the haptic engine without files, imaging libraries or the bodkin command: a slab of muscle behind skin, a
// needle pushed 30 mm in, and the force that the hand would feel. Then the same with a force model of this program's
// own, which it registers by name and which the case chooses by that name. Then in a deformable body, which it makes
// from a mesh and whose factor it keeps in a file: on the planned line, and on another one whose points are computed
// while the needle comes. At last the same body moves by itself for one step.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "fem/moving/corotational_body.h"
#include "fem/solid/contact_stream.h"
#include "fem/solid/factor_cache.h"
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

// The same force against every motion, independent of the tissue.
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

// N, the largest resistance on a straight way 30 mm in along z.
double largest_resistance(bodkin::simulation::HapticTick& tick, const bodkin::Vec3& entry) {
  double largest = 0.0;
  for (int step = 0; step < 4000; ++step) {
    const bodkin::Vec3 tip = entry + (-10.0 + 0.01 * step) * bodkin::Vec3::UnitZ();
    largest = std::max(largest, tick.step({bodkin::needle_pose(tip, bodkin::Vec3::UnitZ())}).resistance);
  }
  return largest;
}

// mm, motion of the middle of the surface under 1 N in one step at 60 steps per second.
double first_step(const bodkin::fem::BodyDescription& body) {
  bodkin::fem::CorotationalBody moving(body, {});
  constexpr std::uint32_t middle = 4 * 9 + 4;
  moving.load(middle, bodkin::Vec3::UnitZ());
  if (moving.step().fault) return 0.0;
  return moving.position(middle).z() - moving.at_rest(middle).z();
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
  const double peak = largest_resistance(tick, bodkin::Vec3::Zero());
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
  const auto body = std::make_shared<const bodkin::fem::BodyDescription>(block_of_skin());
  const std::filesystem::path file = "block.factor";
  std::filesystem::remove(file);
  int notes = 0;  // of a file that could not be used
  const auto count_note = [&notes](const std::string&) { ++notes; };
  const auto made = bodkin::fem::contact_body_with_cache(file, body, {}, count_note);
  const bool kept = std::filesystem::exists(file);
  const auto block = bodkin::fem::contact_body_with_cache(file, body, {}, count_note);
  const auto sites = bodkin::fem::contact_sites_along(path, path.length(), embedded.point_spacing, patient);
  patient.prepared.body = std::make_shared<const bodkin::anatomy::CondensedBody>(
      block->contact_points(sites, path.direction(), embedded.tip_radius));
  const bool same = made->contact_points(sites, path.direction(), embedded.tip_radius).compliance ==
                    patient.prepared.body->compliance;
  std::printf("factor kept %d, read back to the bit %d, notes %d\n", kept ? 1 : 0, same ? 1 : 0, notes);
  patient.prepared.path = path;
  patient.description.haptics.resistance = embedded;
  bodkin::simulation::HapticTick deformable(patient);
  const double held = largest_resistance(deformable, bodkin::Vec3::Zero());
  std::printf("deformable body %.3f N\n", held);

  bodkin::simulation::HapticTick elsewhere(patient);
  const auto line = elsewhere.body()->stream_points(bodkin::simulation::BodyPort::PointTiming::in_time);
  const auto shared = std::make_shared<const bodkin::anatomy::Case>(patient);
  bodkin::fem::ContactStream stream(block, shared, {.length = path.length()}, line);
  const double beside = largest_resistance(elsewhere, {7.0, -4.0, 0.0});
  for (const std::string& failure : stream.take_failures()) std::printf("%s\n", failure.c_str());
  const std::size_t points = line->progress().points;
  std::printf("on a line that was not planned %.3f N at %zu points\n", beside, points);

  const double moved = first_step(*body);
  std::printf("a body that moves by itself went %.6f mm\n", moved);

  const bool rigid = peak > 0.9 && peak < 2.0 && dragged == 0.7;
  const bool cached = kept && same && notes == 0;
  const bool anywhere = held > 0.1 && beside > 0.1 && beside != held && points > 10;
  return rigid && cached && anywhere && moved > 0.0 && moved < 5.0 ? 0 : 1;
}
