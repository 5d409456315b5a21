// Known parameters with noise: do the stated intervals contain them as often as they claim?
#include <cstdio>
#include <ostream>
#include <string>
#include <vector>

#include "tests/study/fitting/generated_curve.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::io;
using namespace bodkin::study;
namespace {

#if defined(BODKIN_ADDRESS_SANITIZER) || defined(BODKIN_THREAD_SANITIZER)
constexpr int trials = 10;
#else
constexpr int trials = 100;
#endif

struct Recovery {
  const char* model;
  std::vector<double> values;
  std::vector<Stretch> way;
  double noise;  // N

  friend std::ostream& operator<<(std::ostream& stream, const Recovery& one) { return stream << one.model; }
};

class Recovers : public ::testing::TestWithParam<Recovery> {};

// In, a rest, partly out, deeper at another speed.
const std::vector<Stretch> there_and_back = {{10.0, 0.9}, {0.0, 0.2}, {-15.0, 0.25}, {20.0, 0.45}};
// In, partly out, deeper, and out to the end.
const std::vector<Stretch> and_out = {{10.0, 0.9}, {-15.0, 0.25}, {20.0, 0.45}, {-20.0, 0.2}, {-8.0, 0.3}};
// Slow and fast, for friction that depends on speed.
const std::vector<Stretch> many_speeds = {{20.0, 0.5}, {3.0, 0.7}, {-4.0, 0.4}, {8.0, 0.4}, {2.0, 0.3}};

TEST_P(Recovers, the_parameters_within_the_stated_intervals) {
  const Recovery& known = GetParam();
  const MeasuredCurve clean = generated_curve(known.model, known.values, known.way);
  const FitModel& model = fit_model(known.model);
  int held = 0;
  std::vector<int> alone(known.values.size());
  for (int trial = 0; trial < trials; ++trial) {
    const MeasuredCurve curve = with_noise(clean, known.noise, 1000 + static_cast<std::uint64_t>(trial));
    const CurveFit fit = fit_curve(curve, {.model = known.model});
    bool all = true;
    for (std::size_t i = 0; i < known.values.size(); ++i) {
      if (!model.parameters[i].fitted) continue;
      const FittedParameter& one = fit.parameters[i];
      EXPECT_EQ(one.status, ParameterStatus::estimated) << one.name << ", trial " << trial << ": " << one.remark;
      const bool inside = one.low <= known.values[i] && known.values[i] <= one.high;
      alone[i] += inside ? 1 : 0;
      all = all && inside;
    }
    held += all ? 1 : 0;
    EXPECT_NEAR(fit.rmse, known.noise, 0.2 * known.noise) << "trial " << trial;
  }
  // 95 of 100; with fewer trials, a correct interval gives fewer than the limit at most once in a thousand runs.
  EXPECT_GE(held, trials == 100 ? 95 : trials - 4);
  if (trials < 100) std::printf("%d trials instead of 100: a sanitizer makes each ten times as slow\n", trials);
  std::string said;
  for (std::size_t i = 0; i < alone.size(); ++i)
    if (model.parameters[i].fitted) said += " " + model.parameters[i].name + " " + std::to_string(alone[i]);
  std::printf("%s: all held in %d of %d; alone:%s\n", known.model, held, trials, said.c_str());
}

INSTANTIATE_TEST_SUITE_P(
    Models, Recovers,
    ::testing::Values(Recovery{"spring_damper_wall", {0.6, 1.3, 0.01}, there_and_back, 0.02},
                      Recovery{"tracking_wall", {0.8, 1.2, 0.4, 0.0}, there_and_back, 0.02},
                      Recovery{"depth_profile", {0.3, 5.0, 0.4, 0.01, 2.0, 0.0}, there_and_back, 0.02},
                      Recovery{"layered", {0.05, 1.1, 0.02, 0.03, 0.002, 1.0, 0.5, 1.2, 0.0}, there_and_back, 0.01},
                      Recovery{"three_component",
                               {0.03, 0.02, 0.85, 0.3, 0.012, 0.0106, 0.0004, 0.0005, 1.0, 0.1, 0.0},
                               and_out,
                               0.01},
                      Recovery{"fracture", {0.05, 1.0, 0.3, 1.0, 1.0, 0.8, 1.0, 0.0}, there_and_back, 0.02},
                      Recovery{"shaft_friction", {0.015, 0.06, 0.0003, 0.03, 5.0, 0.0}, many_speeds, 0.005}),
    [](const auto& test) { return std::string(test.param.model); });

}  // namespace
}  // namespace bodkin
