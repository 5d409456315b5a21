#include "forces/voigt_law.h"

#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::forces;
namespace {

constexpr double k = 0.05, rho = 0.001, dx = 1.0;
const VoigtLaw cubic(VoigtSum::cubic, k, rho, dx);
const VoigtLaw piecewise(VoigtSum::piecewise, k, rho, dx);

TEST(VoigtLaw, equation_2_at_rest_has_the_tabulated_values) {
  const double a[] = {0.5, 1, 1.5, 2, 3, 5, 10};
  const double printed[] = {0.015625, 0.05, 0.109375, 0.2, 0.5, 1.75, 11};
  const double summed[] = {0.025, 0.05, 0.1, 0.15, 0.3, 0.75, 2.75};
  for (int i = 0; i < 7; ++i) {
    EXPECT_NEAR(cubic.push(a[i] * dx, 0.0), printed[i], 1e-9 * printed[i]);
    EXPECT_NEAR(piecewise.push(a[i] * dx, 0.0), summed[i], 1e-9 * summed[i]);
  }
}

// Eq. 2 exactly as it is printed, not simplified.
TEST(VoigtLaw, equation_2_as_printed_is_what_is_computed) {
  for (const double x : {0.1, 0.7, 2.3, 6.0}) {
    for (const double v : {0.0, 4.0, 30.0}) {
      for (const double spacing : {0.3, 1.0, 2.5}) {
        const double printed = x *
                               (6 * rho * v * spacing + k * x * x + 3 * k * x * spacing + 2 * k * spacing * spacing) /
                               (6 * spacing * spacing);
        EXPECT_NEAR(VoigtLaw(VoigtSum::cubic, k, rho, spacing).push(x, v), printed, 1e-9 * printed);
      }
    }
  }
}

TEST(VoigtLaw, the_tangent_stiffens_from_a_third_of_k) {
  EXPECT_NEAR(cubic.tangent(0.0), 0.016667, 5e-7);
  EXPECT_NEAR(cubic.tangent(3.0), 0.391667, 5e-7);
  EXPECT_NEAR(cubic.tangent(5.0), 0.891667, 5e-7);
  EXPECT_NEAR(cubic.tangent(0.0), k / 3.0, 1e-15);
}

TEST(VoigtLaw, the_tangent_is_the_derivative_of_the_elastic_force) {
  for (const VoigtLaw& law : {cubic, piecewise}) {
    for (const double x : {0.2, 0.7, 1.4, 3.3}) {
      const double h = 1e-5;
      EXPECT_NEAR((law.elastic(x + h) - law.elastic(x - h)) / (2 * h), law.tangent(x), 1e-8);
    }
  }
}

TEST(VoigtLaw, motion_adds_a_damper_to_every_element) {
  EXPECT_NEAR(cubic.push(3.0, 10.0), 0.53, 1e-12);
  EXPECT_NEAR(cubic.damping(3.0), 0.003, 1e-15);
  EXPECT_NEAR(piecewise.damping(2.5), 0.003, 1e-15);  // three elements
}

TEST(VoigtLaw, a_surface_pushes_but_never_holds) {
  EXPECT_EQ(cubic.push(1.0, -300.0), 0.0);
  EXPECT_EQ(cubic.push(-0.5, 0.0), 0.0);
  EXPECT_EQ(cubic.push(-0.5, 100.0), 0.0);
}

TEST(VoigtLaw, equation_4_is_odd_in_x_and_its_damping_even) {
  EXPECT_NEAR(cubic.grip(2.0, 0.0), 0.2, 1e-12);
  EXPECT_NEAR(cubic.grip(-2.0, 0.0), -0.2, 1e-12);
  EXPECT_NEAR(cubic.grip(-2.0, 10.0), -0.18, 1e-12);
  EXPECT_NEAR(cubic.grip(-2.0, -10.0), -0.22, 1e-12);
  EXPECT_EQ(cubic.grip(0.0, 0.0), 0.0);
}

TEST(VoigtLaw, the_inverse_has_the_tabulated_values) {
  const VoigtLaw shaft(VoigtSum::cubic, 0.02, 0.0, 0.5);
  EXPECT_NEAR(shaft.inverse(0.005), 0.33585, 5e-6);
  EXPECT_NEAR(shaft.inverse(0.01), 0.5, 1e-12);
  EXPECT_NEAR(shaft.inverse(0.02), 0.717421, 5e-7);
  EXPECT_NEAR(shaft.inverse(0.04), 1.0, 1e-12);
}

TEST(VoigtLaw, the_inverse_is_exact_over_ten_decades_for_both_sums) {
  for (const VoigtLaw& law : {cubic, piecewise}) {
    EXPECT_EQ(law.inverse(0.0), 0.0);
    EXPECT_EQ(law.inverse(-1.0), 0.0);
    for (double force = 1e-6; force < 1e4; force *= 1.7) {
      EXPECT_NEAR(law.elastic(law.inverse(force)), force, 1e-9 * force + 1e-15);
    }
  }
}

TEST(VoigtLaw, a_softened_law_breaks_at_the_same_force_and_is_softer_there_by_the_factor) {
  for (const double factor : {0.5, 0.1}) {
    const VoigtLaw soft = cubic.softened(factor);
    for (const double x : {0.5, 2.0, 4.0}) {
      EXPECT_NEAR(soft.elastic(x / factor), cubic.elastic(x), 1e-12);
      EXPECT_NEAR(soft.tangent(x / factor), factor * cubic.tangent(x), 1e-12);
    }
  }
}

}  // namespace
}  // namespace bodkin
