// The force of every model falls to zero in an organ if the case requests it; otherwise no bit changes.
#include "simulation/organ_release.h"

#include <cmath>
#include <cstring>

#include "tests/simulation/model_pairs.h"
#include <gtest/gtest.h>

#include "simulation/haptic_tick.h"

namespace bodkin {
namespace {

constexpr double organ_from = 15.0, organ_to = 25.0;  // mm deep, in the muscle of the slabs

// The slabs with a critical structure in the muscle.
Case slabs_with_organ(const NamedResistance& resistance, ForceInOrgans force) {
  Case patient = patient_for(resistance, {"line_spring", LineSpringSettings{}});
  patient.structures = LabelVolume(patient.tissues.grid);
  const Grid& grid = patient.tissues.grid;
  std::size_t at = 0;
  for (int k = 0; k < grid.size[2]; ++k) {
    const double depth = grid.to_patient(Vec3(0.0, 0.0, k)).z();
    const bool is_inside = depth > organ_from && depth < organ_to;
    for (int i = 0; i < grid.size[0] * grid.size[1]; ++i, ++at) patient.structures.voxels[at] = is_inside ? 7 : 0;
  }
  patient.description.structures = {{7, "kidney_left", "organ", true}};
  patient.description.haptics.force_in_organs = force;
  return patient;
}

class ForceInOrgan : public testing::TestWithParam<NamedResistance> {};

TEST_P(ForceInOrgan, gives_no_force_while_the_tip_is_in_an_organ_and_never_jumps) {
  const Case felt_patient = slabs_with_organ(GetParam(), ForceInOrgans::felt);
  const Case none_patient = slabs_with_organ(GetParam(), ForceInOrgans::none);
  HapticTick felt(felt_patient), none(none_patient);
  double share = 1.0, largest_felt = 0.0;
  int ticks_in_organ = 0, ticks_behind = 0, at_zero = 0, whole_again = 0;
  // In at 40 mm/s to 30 mm, out again; a little off the line, so that the constraint works too.
  for (int tick = 0; tick < 1600; ++tick) {
    const double way = 0.04 * tick;
    const double depth = way < 32.0 ? way - 2.0 : 62.0 - way;
    const TickInput input = needle_at(Vec3(depth > 5.0 ? 0.3 : 0.0, 0.0, depth));
    const TickOutput all = felt.step(input), less = none.step(input);
    ASSERT_EQ(all.depth, less.depth);
    ASSERT_EQ(all.tissue, less.tissue);
    // The model itself continues as if the force were felt.
    ASSERT_EQ(0, std::memcmp(all.diagnostics.data(), less.diagnostics.data(), sizeof(all.diagnostics)));
    const double before = share;
    const bool is_inside =
        nearest<std::uint16_t>(none_patient.structures, Vec3(input.needle.translation()), std::uint16_t{0}) == 7;
    if (less.in_contact) {
      share = is_inside ? std::max(share - 0.001 / OrganRelease::fade, 0.0)
                        : std::min(share + 0.001 / OrganRelease::come_back, 1.0);
    } else {
      share = 1.0;
    }
    EXPECT_NEAR((less.requested.force - share * all.requested.force).norm(), 0.0, 1e-9) << depth;
    EXPECT_NEAR((less.requested.torque - share * all.requested.torque).norm(), 0.0, 1e-9) << depth;
    EXPECT_NEAR(less.resistance, share * all.resistance, 1e-9) << depth;
    if (less.in_contact) {
      EXPECT_LE(std::abs(share - before), 0.001 / OrganRelease::fade + 1e-12);
    }
    ticks_in_organ = is_inside ? ticks_in_organ + 1 : 0;
    ticks_behind = is_inside ? 0 : ticks_behind + 1;
    if (ticks_in_organ > 52) {
      EXPECT_EQ(less.requested.force.norm(), 0.0);
      EXPECT_EQ(less.requested.torque.norm(), 0.0);
      largest_felt = std::max(largest_felt, all.requested.force.norm());
      ++at_zero;
    }
    if (ticks_behind > 202 && less.in_contact) {
      EXPECT_EQ(less.requested.force, all.requested.force);
      ++whole_again;
    }
  }
  EXPECT_GT(at_zero, 200);
  EXPECT_GT(largest_felt, 0.01) << "without the setting there is a force";
  EXPECT_GT(whole_again, 100);
}

INSTANTIATE_TEST_SUITE_P(Models, ForceInOrgan, testing::ValuesIn(all_resistances()),
                         [](const auto& one) { return one.param.name; });

TEST(OrganRelease, spares_bone_and_what_the_target_lies_in) {
  Case patient = slabs_with_organ({"layered", LayeredSettings{}, {}}, ForceInOrgans::none);
  const auto share_at = [&](double depth, TissueId tissue) {
    OrganRelease organs(patient, 0.001);
    organs.begin();
    double share = 1.0;
    for (int tick = 0; tick < 60; ++tick) share = organs.step(Vec3(0.0, 0.0, depth), tissue);
    return share;
  };
  EXPECT_EQ(share_at(20.0, tissue::muscle), 0.0);
  EXPECT_EQ(share_at(20.0, tissue::cortical_bone), 1.0);
  EXPECT_EQ(share_at(10.0, tissue::muscle), 1.0);
  EXPECT_EQ(share_at(10.0, tissue::lung), 0.0);
  EXPECT_EQ(share_at(10.0, tissue::organ), 0.0);
  patient.description.procedure.target_tissue = "organ";
  EXPECT_EQ(share_at(10.0, tissue::organ), 1.0);
  patient.description.procedure.path = NeedlePath{Vec3::Zero(), Vec3(0.0, 0.0, 20.0)};
  EXPECT_EQ(share_at(20.0, tissue::muscle), 1.0) << "the target lies in it";
  patient.description.structures.front().critical = false;
  patient.description.procedure.path.reset();
  EXPECT_EQ(share_at(20.0, tissue::muscle), 1.0) << "not critical";
}

}  // namespace
}  // namespace bodkin
