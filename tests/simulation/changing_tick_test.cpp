// Changes of numbers during an insertion: another tick takes over.
#include "simulation/changing_tick.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/simulation/slab_patient.h"
#include <gtest/gtest.h>

namespace bodkin {
namespace {

// 20 mm/s from 5 mm above the skin along z; in the skin's spring after half a second.
TickInput input_at(int tick) {
  TickInput input;
  input.needle.translation() = Vec3(0.0, 0.0, -5.0 + 0.02 * tick);
  return input;
}

Case patient_with_skin(double stiffness) {
  Case patient = slab_patient();
  std::vector<TissueProperties> tissues = patient.library.tissues();
  for (TissueProperties& tissue : tissues) {
    if (tissue.id == tissue::skin) tissue.layered.stiffness = stiffness;
  }
  patient.library = TissueLibrary(tissues);
  return patient;
}

class Changing : public ::testing::Test {
 protected:
  static constexpr int taken_at = 450, blend = 100, end = 900;

  Case soft_ = patient_with_skin(0.05), firm_ = patient_with_skin(0.1);
  HapticTick soft_tick_{soft_}, firm_tick_{firm_};
};

TEST_F(Changing, force_goes_over_in_a_tenth_of_a_second_and_then_is_that_of_an_insertion_with_the_new_numbers) {
  HapticTick only_soft(soft_), only_firm(firm_);
  ChangingTick felt(soft_tick_);
  for (int tick = 0; tick < taken_at; ++tick) firm_tick_.step(input_at(tick));
  double greatest_step = 0.0, last = 0.0, difference = 0.0;
  for (int tick = 0; tick < end; ++tick) {
    if (tick == taken_at) {
      ASSERT_TRUE(felt.switch_to(firm_tick_));
    }
    const TickOutput now = felt.step(input_at(tick));
    const TickOutput soft = only_soft.step(input_at(tick)), firm = only_firm.step(input_at(tick));
    const double share = std::clamp((tick - taken_at + 1.0) / blend, 0.0, 1.0);
    EXPECT_NEAR(now.resistance, share * firm.resistance + (1.0 - share) * soft.resistance, 1e-12) << tick;
    EXPECT_NEAR((now.applied.force - share * firm.applied.force - (1.0 - share) * soft.applied.force).norm(), 0.0,
                1e-12)
        << tick;
    if (tick >= taken_at + blend) {
      EXPECT_EQ(now.resistance, firm.resistance) << "to the bit, " << tick;
    }
    if (tick >= taken_at) difference = std::max(difference, firm.resistance - soft.resistance);
    if (tick > taken_at && tick < taken_at + blend)
      greatest_step = std::max(greatest_step, std::abs(now.resistance - last));
    last = now.resistance;
  }
  EXPECT_GT(difference, 0.03) << "N; else nothing was tested";
  EXPECT_LT(greatest_step, 0.05 * difference + 0.01) << "no jump";
}

TEST_F(Changing, another_one_waits_until_the_first_has_settled) {
  ChangingTick felt(soft_tick_);
  EXPECT_TRUE(felt.switch_to(firm_tick_));
  HapticTick third(soft_);
  EXPECT_FALSE(felt.switch_to(third));
  for (int tick = 0; tick < blend - 1; ++tick) felt.step(input_at(tick));
  EXPECT_TRUE(felt.is_settling());
  felt.step(input_at(blend - 1));
  EXPECT_FALSE(felt.is_settling());
  EXPECT_TRUE(felt.switch_to(third));
}

}  // namespace
}  // namespace bodkin
