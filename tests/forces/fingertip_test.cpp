#include "forces/fingertip.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

// A flat back: skin at z = 0, bone from 12 mm on where x < 0 and nowhere else, voxels of 1 mm.
TissueVolume half_a_process() {
  Grid grid;
  grid.size = {80, 80, 80};
  grid.origin = {-39.5, -39.5, 0.5};
  TissueVolume tissues(grid);
  for (int z = 0; z < 80; ++z) {
    for (int y = 0; y < 80; ++y) {
      for (int x = 0; x < 80; ++x)
        tissues.voxels[static_cast<std::size_t>((z * 80 + y) * 80 + x)] =
            z >= 12 && x < 40 ? tissue::cortical_bone : tissue::fat;
    }
  }
  return tissues;
}

struct Felt {
  FingertipState state;
  std::vector<Event> events;
};

// Holds the finger at `place` for 0.5 s.
Felt press(Fingertip& finger, const Vec3& place, int ticks = 500) {
  Felt felt;
  for (int tick = 0; tick < ticks; ++tick) {
    TickEvents events;
    felt.state = finger.step(place, Vec3::UnitZ(), events);
    felt.events.insert(felt.events.end(), events.begin(), events.end());
  }
  return felt;
}

TEST(Fingertip, presses_on_columns_of_tissue_over_bone) {
  const TissueVolume tissues = half_a_process();
  const FingertipSettings settings;
  Fingertip finger(tissues, settings, 1.0, 1e-3);
  const double area = std::numbers::pi * 36.0;
  const Felt hard = press(finger, Vec3(-20, 0, 4));
  EXPECT_NEAR(hard.state.force, area * 0.04 * 4.0 / 12.0, 0.03);
  EXPECT_NEAR(hard.state.firmness, area * 0.04 / 12.0, 0.01);
  EXPECT_NEAR(hard.state.cover, 12.0, 0.1);
  EXPECT_NEAR(hard.state.indentation, 4.0, 0.05);
  finger.reset();
  const Felt soft = press(finger, Vec3(20, 0, 4));
  EXPECT_NEAR(soft.state.force, area * 0.04 * 4.0 / settings.reach, 0.02);
  EXPECT_EQ(soft.state.cover, settings.reach);
}

TEST(Fingertip, tells_each_place_once_and_whether_bone_lies_under_it) {
  const TissueVolume tissues = half_a_process();
  Fingertip finger(tissues, {}, 1.0, 1e-3);
  const Felt hard = press(finger, Vec3(-20, 0, 4), 1500);
  ASSERT_EQ(hard.events.size(), 1U);
  EXPECT_EQ(hard.events[0].kind, EventKind::palpated);
  EXPECT_EQ(hard.events[0].tissue, tissue::cortical_bone);
  EXPECT_NEAR(hard.events[0].value, hard.state.firmness, 0.02);
  const Felt slid = press(finger, Vec3(20, 0, 4), 1500);  // without lifting
  ASSERT_EQ(slid.events.size(), 1U);
  EXPECT_EQ(slid.events[0].tissue, tissue::skin);
  press(finger, Vec3(20, 0, -3), 10);
  EXPECT_EQ(press(finger, Vec3(20, 0, 4)).events.size(), 1U) << "lifted and pressed again";
  press(finger, Vec3(20, 0, -3), 10);
  EXPECT_TRUE(press(finger, Vec3(20, 0, 1)).events.empty()) << "a touch feels nothing below the skin";
  EXPECT_TRUE(press(finger, Vec3(20, 0, 4), 200).events.empty()) << "too short";
}

TEST(Fingertip, never_pushes_harder_than_its_limit_or_firmer_than_the_device) {
  const TissueVolume tissues = half_a_process();
  for (const double stiffness : {0.2, 1.0, 5.0}) {
    Fingertip finger(tissues, {.modulus = 1.0, .limit = 5.0}, stiffness, 1e-3);
    double last = 0.0;
    for (double depth = 0.0; depth < 25.0; depth += 0.05) {
      TickEvents events;
      const double force = finger.step(Vec3(-20, 0, depth), Vec3::UnitZ(), events).force;
      EXPECT_LE(force, 5.0);
      EXPECT_LE(force - last, stiffness * 0.051) << depth;
      last = force;
    }
    EXPECT_GT(last, 0.0);
  }
}

TEST(Fingertip, refuses_settings_outside_their_ranges) {
  const TissueVolume tissues = half_a_process();
  EXPECT_THROW(Fingertip(tissues, {.modulus = 0.0}, 1.0, 1e-3), InputError);
  EXPECT_THROW(Fingertip(tissues, {.radius = 50.0}, 1.0, 1e-3), InputError);
}

}  // namespace
}  // namespace bodkin
