#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/simulation/model_pairs.h"
#include <gtest/gtest.h>

#include "forces/model_settings.h"
#include "forces/needle_law.h"
#include "simulation/haptic_tick.h"
#include "simulation/needle_bow.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::simulation;
namespace {

constexpr int spine_width = 30;  // voxels of 1 mm across the path

// Skin 2, fat 6, muscle 8, interspinous ligament 12, flavum 4, epidural space 6, dura 1, fluid 20 mm.
Case described_spine(const ResistanceSettings& resistance) {
  const std::vector<std::pair<TissueId, int>> layers = {{tissue::air, 8},
                                                        {tissue::skin, 2},
                                                        {tissue::fat, 6},
                                                        {tissue::muscle, 8},
                                                        {tissue::interspinous_ligament, 12},
                                                        {tissue::ligamentum_flavum, 4},
                                                        {tissue::epidural_fat, 6},
                                                        {tissue::dura, 1},
                                                        {tissue::cerebrospinal_fluid, 20}};
  Case patient;
  patient.library = io::default_tissue_library();
  std::vector<TissueId> along;
  for (const auto& [id, thickness] : layers) along.insert(along.end(), static_cast<std::size_t>(thickness), id);
  Grid grid;
  grid.size = {spine_width, spine_width, static_cast<int>(along.size())};
  grid.origin = Vec3(-0.5 * spine_width, -0.5 * spine_width, -7.5);
  patient.tissues = TissueVolume(grid);
  patient.ct = CtVolume(grid);
  for (int k = 0; k < grid.size[2]; ++k) {
    const TissueId id = along[static_cast<std::size_t>(k)];
    for (int j = 0; j < spine_width; ++j) {
      for (int i = 0; i < spine_width; ++i) {
        patient.tissues.at(i, j, k) = id;
        patient.ct.at(i, j, k) = static_cast<std::int16_t>(patient.library.find(id)->hounsfield);
      }
    }
  }
  patient.description.haptics.resistance = resistance;
  patient.description.haptics.mechanics = Mechanics::physical;
  return patient;
}

struct PushedIn {
  std::vector<Event> events;
  std::vector<double> resistance, depth;
  std::vector<TissueId> tissue;

  std::vector<TissueId> told(EventKind kind) const {
    std::vector<TissueId> found;
    for (const Event& event : events)
      if (event.kind == kind) found.push_back(event.tissue);
    return found;
  }
};

PushedIn pushed_through(const Case& patient, double to, double speed = 10.0, const Vec3& axis = Vec3::UnitZ()) {
  HapticTick tick(patient);
  PushedIn found;
  for (double depth = -2.0; depth < to; depth += speed * tick.dt()) {
    const TickOutput output = tick.step({needle_pose(depth * axis, axis)});
    found.events.insert(found.events.end(), output.events.begin(), output.events.end());
    found.resistance.push_back(output.resistance);
    found.depth.push_back(output.depth);
    found.tissue.push_back(output.tissue);
  }
  return found;
}

TrackingWallSettings wall_on_leash() {
  TrackingWallSettings settings;
  settings.leash = true;
  return settings;
}

TEST(PhysicalMechanics, every_model_that_knows_layers_tells_the_same_events_in_the_same_order) {
  const std::vector<TissueId> expected = {tissue::skin, tissue::muscle, tissue::interspinous_ligament,
                                          tissue::ligamentum_flavum, tissue::dura};
  for (const ResistanceSettings& resistance :
       std::vector<ResistanceSettings>{LayeredSettings{}, TrackingWallSettings{}, wall_on_leash(),
                                       DepthProfileSettings{}, VolumeProxySettings{}}) {
    const std::string name(name_of(resistance));
    const PushedIn found = pushed_through(described_spine(resistance), 55.0);
    EXPECT_EQ(found.told(EventKind::puncture), expected) << name;
    EXPECT_EQ(found.told(EventKind::loss_of_resistance).size(), 1U) << name;
    const std::vector<TissueId> entered = found.told(EventKind::tissue_entered);
    EXPECT_EQ(entered, (std::vector<TissueId>{tissue::skin, tissue::fat, tissue::muscle,
                                              tissue::interspinous_ligament, tissue::ligamentum_flavum,
                                              tissue::epidural_fat, tissue::dura, tissue::cerebrospinal_fluid}))
        << name;
  }
}

// Obliquely, so that no boundary lies where a model has one. A tip that jumps is not in the thin dura at any tick.
TEST(PhysicalMechanics, the_tip_is_in_one_tissue_after_another_and_never_in_one_again) {
  const std::vector<TissueId> expected = {tissue::skin,
                                          tissue::fat,
                                          tissue::muscle,
                                          tissue::interspinous_ligament,
                                          tissue::ligamentum_flavum,
                                          tissue::epidural_fat,
                                          tissue::dura,
                                          tissue::cerebrospinal_fluid};
  for (const ResistanceSettings& resistance :
       std::vector<ResistanceSettings>{LayeredSettings{}, TrackingWallSettings{}, wall_on_leash(),
                                       DepthProfileSettings{}, VolumeProxySettings{}}) {
    for (const double tilt : {0.1, 0.17, 0.23}) {
      const Vec3 axis(0.0, std::sin(tilt), std::cos(tilt));
      std::vector<TissueId> passed = pushed_through(described_spine(resistance), 55.0, 10.0, axis).tissue;
      std::erase(passed, tissue::air);
      passed.erase(std::unique(passed.begin(), passed.end()), passed.end());
      // The ids of these tissues are in their order.
      EXPECT_TRUE(std::is_sorted(passed.begin(), passed.end()) &&
                  std::includes(expected.begin(), expected.end(), passed.begin(), passed.end()))
          << name_of(resistance) << ", tilted by " << tilt << ": " << testing::PrintToString(passed);
      EXPECT_GE(passed.size(), expected.size() - 1) << name_of(resistance) << ", tilted by " << tilt;
    }
  }
}

// Changes of numbers begin with these.
TEST(PhysicalMechanics, the_numbers_that_follow_from_the_description_feel_as_the_description_does) {
  for (const ResistanceSettings& resistance : std::vector<ResistanceSettings>{
           LayeredSettings{}, TrackingWallSettings{}, wall_on_leash(), DepthProfileSettings{}, VolumeProxySettings{},
           ThreeComponentSettings{}, ShaftFrictionSettings{}, FractureSettings{}}) {
    Case patient = described_spine(resistance);
    patient.description.needle = {
        .gauge = 18, .outer_diameter = 1.27, .inner_diameter = 0.838, .tip = NeedleTip::tuohy};
    const PushedIn described = pushed_through(patient, 55.0);
    const ModelSettings settings = model_settings(patient);
    patient.description.haptics = settings.haptics;
    patient.library = TissueLibrary(settings.tissues);
    const PushedIn numbers = pushed_through(patient, 55.0);
    const std::string name(name_of(resistance));
    EXPECT_EQ(numbers.resistance, described.resistance) << name;
    EXPECT_EQ(numbers.tissue, described.tissue) << name;
    EXPECT_EQ(numbers.told(EventKind::puncture), described.told(EventKind::puncture)) << name;
  }
}

TEST(PhysicalMechanics, the_tip_is_in_the_fluid_only_after_the_dura_has_given_way) {
  for (const ResistanceSettings& resistance :
       std::vector<ResistanceSettings>{LayeredSettings{}, TrackingWallSettings{}, VolumeProxySettings{}}) {
    const PushedIn found = pushed_through(described_spine(resistance), 55.0);
    bool gave_way = false;
    for (const Event& event : found.events) {
      if (event.kind == EventKind::puncture && event.tissue == tissue::dura) gave_way = true;
      if (event.kind == EventKind::tissue_entered && event.tissue == tissue::cerebrospinal_fluid) {
        EXPECT_TRUE(gave_way) << name_of(resistance);
      }
    }
    EXPECT_TRUE(gave_way) << name_of(resistance);
  }
}

TEST(PhysicalMechanics, a_puncture_says_what_the_hand_felt_and_what_of_it_was_the_tissue) {
  const PushedIn found = pushed_through(described_spine(LayeredSettings{}), 55.0);
  for (const Event& event : found.events) {
    if (event.kind != EventKind::puncture) continue;
    EXPECT_GE(event.felt, event.value);
    const auto peak = std::max_element(found.resistance.begin(), found.resistance.end());
    EXPECT_LE(event.felt, *peak + 0.1);
  }
}

TEST(PhysicalMechanics, forces_grow_with_the_needle) {
  double last = 0.0;
  for (const auto& [gauge, tip] : {std::pair(30, NeedleTip::filiform), std::pair(25, NeedleTip::quincke),
                                   std::pair(22, NeedleTip::quincke), std::pair(18, NeedleTip::tuohy)}) {
    Case patient = described_spine(LayeredSettings{});
    const GaugeSize size = *gauge_size(gauge);
    patient.description.needle = {.gauge = gauge, .outer_diameter = size.outer_diameter, .length = 90.0, .tip = tip};
    patient.description.needle.inner_diameter = 0.0;  // the stylet is in
    patient.description.device.peak_force = 20.0;
    const PushedIn found = pushed_through(patient, 36.0);
    const double peak = *std::max_element(found.resistance.begin(), found.resistance.end());
    EXPECT_GT(peak, 1.15 * last) << gauge;
    last = peak;
  }
}

TEST(PhysicalMechanics, gives_no_energy_on_closed_paths) {
  for (const ResistanceSettings& resistance :
       std::vector<ResistanceSettings>{LayeredSettings{}, TrackingWallSettings{}, DepthProfileSettings{},
                                       ThreeComponentSettings{}, FractureSettings{}, ShaftFrictionSettings{}}) {
    for (const int gauge : {18, 22, 27}) {
      Case patient = described_spine(resistance);
      const GaugeSize size = *gauge_size(gauge);
      patient.description.needle = {
          .gauge = gauge, .outer_diameter = size.outer_diameter, .inner_diameter = size.inner_diameter};
      patient.description.device.peak_force = 30.0;
      HapticTick tick(patient);
      Random random(static_cast<std::uint64_t>(gauge));
      double depth = -2.0, work = 0.0, last = 0.0;
      const auto go = [&](double to, double speed) {
        const double step = (to < depth ? -1.0 : 1.0) * speed * tick.dt();
        while (std::abs(to - depth) > 1e-9) {
          const double advance = std::abs(to - depth) < std::abs(step) ? to - depth : step;
          depth += advance;
          const double force = tick.step({needle_pose(Vec3(0.0, 0.0, depth), Vec3::UnitZ())}).resistance;
          work += 0.5 * (force + last) * advance;
          last = force;
        }
      };
      for (int turn = 0; turn < 40; ++turn) {
        const double to = 52.0 * random.uniform();
        const double speed = 5.0 + 95.0 * random.uniform();
        go(to, speed);
      }
      go(-2.0, 20.0);
      EXPECT_GE(work, -1e-3) << name_of(resistance) << " " << gauge << " G";
    }
  }
}

TEST(NeedleBow, a_needle_pushed_harder_than_it_bears_bows_and_its_tip_stays) {
  Case patient = described_spine(SpringDamperWallSettings{.stiffness = 0.5, .limit = 50.0});
  patient.description.needle = {.gauge = 27, .outer_diameter = 0.4128, .inner_diameter = 0.21, .length = 120.0};
  const double rigidity = bending_stiffness(patient.description.needle);
  EXPECT_NEAR(rigidity, 256.67, 0.5) << "reference table";
  const PushedIn found = pushed_through(patient, 20.0);
  const double euler = std::pow(std::numbers::pi / (0.7 * 120.0), 2) * rigidity;
  const auto buckled = std::find_if(found.events.begin(), found.events.end(),
                                    [](const Event& event) { return event.kind == EventKind::needle_buckled; });
  ASSERT_NE(buckled, found.events.end());
  EXPECT_NEAR(buckled->value, euler, 0.05 * euler);
  EXPECT_LT(*std::max_element(found.resistance.begin(), found.resistance.end()), 1.1 * euler);
  EXPECT_LT(found.depth.back(), 3.0) << "the hand is at 20 mm";
}

TEST(NeedleBow, gives_back_no_more_work_than_it_took) {
  Case patient = described_spine(LayeredSettings{});
  patient.description.needle = {.gauge = 27, .outer_diameter = 0.4128, .inner_diameter = 0.21, .length = 150.0};
  HapticTick tick(patient);
  double work = 0.0, last = -2.0;
  for (int i = 0; i < 20000; ++i) {
    const double depth = -2.0 + 22.0 * (1.0 - std::cos(i * 2e-3 * std::numbers::pi / 10.0));
    work += tick.step({needle_pose(Vec3(0.0, 0.0, depth), Vec3::UnitZ())}).resistance * (depth - last);
    last = depth;
    if (i % 10000 == 9999) {
      EXPECT_GT(work, 0.0);
    }
  }
}

TEST(NeedleBow, a_case_of_tables_has_a_rigid_needle) {
  Case patient = described_spine(SpringDamperWallSettings{});
  patient.description.haptics.mechanics = Mechanics::tables;
  NeedleBow bow(patient, 0.001);
  bow.begin();
  TickEvents events;
  EXPECT_DOUBLE_EQ(bow.tip_motion({30.0, 5.0, 1, false}).depth, 30.0);
  EXPECT_DOUBLE_EQ(bow.limited(100.0, tissue::skin, events), 100.0);
}

}  // namespace
}  // namespace bodkin
