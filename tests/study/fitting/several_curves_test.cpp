// Several curves, stacks, needles and models at once, on curves computed from the papers' equations by a script in
// another language (measured_by_others.py).
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "study/fitting/gauge_law.h"
#include "tests/study/fitting/curves_of_others.h"
#include "tests/study/fitting/generated_curve.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::io;
using namespace bodkin::study;
using ::testing::HasSubstr;
namespace {

TEST_F(CurvesOfOthers, a_tracking_wall_has_the_truth_in_its_intervals) {
  int held = 0;
  double catch_up = 0.0;
  constexpr int trials = 20;
  for (int trial = 0; trial < trials; ++trial) {
    const CurveFit fit = fit_curve(curve_of({"tracking_wall", std::to_string(trial)}), {.model = "tracking_wall"});
    held += within(fit, "stiffness", 0.8) && within(fit, "force", 1.2) && within(fit, "catch_up", 0.4) ? 1 : 0;
    catch_up += fit.find("catch_up")->value / trials;
  }
  EXPECT_GE(held, trials - 2);
  EXPECT_NEAR(catch_up, 0.4, 0.004) << "the fitted catch-up time has no bias";
}

TEST_F(CurvesOfOthers, the_nine_layers_of_the_shoulder_come_back_at_once) {
  const double forces[] = {1.5, 1.0, 1.8, 2.0, 3.0, 3.5, 2.5, 4.0, 4.5};  // Alamilla 2018, section 3.4
  FitRequest request{.model = "tracking_wall"};
  for (int i = 0; i < 9; ++i) request.layers.push_back(150.0 / 9.0 * i);
  const CurveFit fit = fit_curve(curve_of({"shoulder", "5"}), request);
  for (int i = 0; i < 9; ++i)
    EXPECT_NEAR(fit.find("force_" + std::to_string(i + 1))->value, forces[i], 0.05) << "layer " << i + 1;
  EXPECT_NEAR(fit.find("stiffness")->value, 0.5, 0.02);
  EXPECT_NEAR(fit.find("catch_up")->value, 0.5, 0.02);
  ASSERT_TRUE(fit.elements.resistance.has_value());
  EXPECT_EQ(fit.elements.resistance->children.size(), 9U);
}

TEST_F(CurvesOfOthers, the_friction_of_each_layer_comes_back) {
  FitRequest request{
      .model = "shaft_friction", .fix = {{"static_ratio", 1.0}, {"viscous_ratio", 0.0}}, .layers = {0.0, 8.0, 15.0}};
  const CurveFit fit = fit_curve(curve_of({"dahl", "4"}), request);
  EXPECT_NEAR(fit.find("coulomb_1")->value, 0.01, 0.001);
  EXPECT_NEAR(fit.find("coulomb_2")->value, 0.05, 0.001);
  EXPECT_NEAR(fit.find("coulomb_3")->value, 0.002, 0.001);
  EXPECT_NEAR(fit.find("stiffness_ratio")->value, 3.0, 0.3);
  ASSERT_EQ(fit.elements.tissues.size(), 3U) << "a tissue for each layer";
}

TEST_F(CurvesOfOthers, the_spring_of_each_layer_comes_back) {
  FitRequest request{.model = "depth_profile", .fix = {{"trailing", 2.0}}, .layers = {0.0, 12.0, 20.0}};
  const CurveFit fit = fit_curve(curve_of({"profile", "4"}), request);
  EXPECT_NEAR(fit.find("skin_stiffness")->value, 0.3, 0.01);
  EXPECT_NEAR(fit.find("puncture_depth")->value, 5.0, 0.15);
  EXPECT_NEAR(fit.find("stiffness_1")->value, 0.4, 0.02);
  EXPECT_NEAR(fit.find("stiffness_2")->value, 0.9, 0.02);
  EXPECT_NEAR(fit.find("stiffness_3")->value, 0.2, 0.02);
  ASSERT_EQ(fit.elements.tissues.size(), 3U);
  EXPECT_EQ(fit.elements.tissues[1].name, "depth_profile");
}

TEST_F(CurvesOfOthers, the_force_of_puncture_goes_with_the_diameter) {
  std::vector<PunctureOfNeedle> points;
  for (const double diameter : {0.4, 0.7, 1.2, 1.6}) {
    const CurveFit fit = fit_curve(curve_of({"layered", std::to_string(diameter), "3"}),
                                   {.model = "layered", .fix = {{"viscosity", 0.0}}});
    points.push_back({"needle", diameter, puncture_force_of(fit, "needle")});
    EXPECT_NEAR(points.back().force, 2.0 * diameter, 0.15) << diameter << " mm";
  }
  const GaugeLaw law = fit_gauge_law(points);  // the script breaks at 2 N per mm of diameter
  EXPECT_NEAR(law.exponent, 1.0, 0.05);
  EXPECT_NEAR(law.at(1.0), 2.0, 0.1);
  EXPECT_TRUE(law.exponent_low <= 1.02 && law.exponent_high >= 0.98)
      << law.exponent_low << " to " << law.exponent_high;
}

TEST_F(CurvesOfOthers, the_criterion_chooses_the_model_that_drew_the_curve) {
  const MeasuredCurve curve = curve_of({"tracking_wall", "7"});
  const ModelChoice choice = choose_model({&curve, 1}, {});
  EXPECT_EQ(choice.fits.front().model, "tracking_wall");
  EXPECT_EQ(choice.fits.size() + choice.refused.size(), fit_models().size());
  for (std::size_t i = 1; i < choice.fits.size(); ++i) EXPECT_GE(choice.fits[i].aic, choice.fits[i - 1].aic);
}

TEST(SeveralCurves, share_one_set_of_values) {
  // The first curve never rests and so gives no information on the catch-up time; the second is short.
  const std::vector<double> values = {0.8, 1.2, 0.4, 0.0};
  const std::vector<MeasuredCurve> curves = {
      with_noise(generated_curve("tracking_wall", values, {{10.0, 1.0}}), 0.02, 1),
      with_noise(generated_curve("tracking_wall", values, {{20.0, 0.4}, {0.0, 0.6}}), 0.02, 2)};
  EXPECT_EQ(fit_curve(curves[0], {.model = "tracking_wall"}).find("catch_up")->status,
            ParameterStatus::not_identified);
  const CurveFit both = fit_curves(curves, {.model = "tracking_wall"});
  EXPECT_EQ(both.samples, curves[0].size() + curves[1].size());
  EXPECT_EQ(both.force.size(), both.samples);
  EXPECT_TRUE(within(both, "stiffness", 0.8) && within(both, "force", 1.2) && within(both, "catch_up", 0.4));
  EXPECT_NEAR(both.rmse, 0.02, 0.004);
  // The same curve twice has the same best values and smaller errors.
  const std::vector<MeasuredCurve> twice = {curves[1], curves[1]};
  const CurveFit one = fit_curve(curves[1], {.model = "tracking_wall"}),
                 two = fit_curves(twice, {.model = "tracking_wall"});
  EXPECT_NEAR(two.find("force")->value, one.find("force")->value, 1e-4);
  EXPECT_NEAR(two.find("force")->standard_error, one.find("force")->standard_error / std::sqrt(2.0),
              0.05 * one.find("force")->standard_error);
}

TEST(SeveralCurves, punctures_at_two_speeds_share_one_break_force) {
  const std::vector<double> values = {0.05, 1.1, 0.02, 0.03, 0.002, 1.0, 0.5, 1.2, 0.0};
  const std::vector<MeasuredCurve> curves = {with_noise(generated_curve("layered", values, {{10.0, 1.2}}), 0.01, 3),
                                             with_noise(generated_curve("layered", values, {{25.0, 0.5}}), 0.01, 4)};
  const CurveFit fit = fit_curves(curves, {.model = "layered"});
  EXPECT_TRUE(within(fit, "break_force", 1.1))
      << fit.find("break_force")->low << " " << fit.find("break_force")->high;
  EXPECT_NEAR(fit.find("stiffness")->value, 0.05, 0.005);
  EXPECT_NEAR(fit.rmse, 0.01, 0.005);
}

TEST(SeveralCurves, r_squared_of_a_constant_force_is_undefined) {
  MeasuredCurve curve = generated_curve("tracking_wall", {0.8, 1.2, 0.4, 0.0}, {{10.0, 1.0}});
  for (double& force : curve.force) force = 0.7;
  const CurveFit fit = fit_curve(curve, {.model = "spring_damper_wall"});
  EXPECT_TRUE(std::isnan(fit.r_squared));
  EXPECT_TRUE(std::isfinite(fit.aic) && std::isfinite(fit.rmse));
}

std::string refused(const std::function<void()>& what) {
  try {
    what();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SeveralCurves, times_without_depths_need_a_speed_which_is_then_said) {
  std::string table = "time_s,force_N\n";
  for (int i = 0; i <= 20; ++i) table += fmt::format("{},{}\n", 0.1 * i, 0.05 * i);
  EXPECT_THAT(refused([&] { parse_measured_curve(table, "t.csv"); }),
              HasSubstr("there is no column depth_mm, so that the forces belong to no place; give the depth"));
  const MeasuredCurve curve = parse_measured_curve(table, "t.csv", 5.0);
  EXPECT_NEAR(curve.depth.back(), 10.0, 1e-9);
  const CurveFit fit = fit_curve(curve, {.model = "spring_damper_wall", .speed = 5.0});
  ASSERT_FALSE(fit.notes.empty());
  EXPECT_THAT(fit.notes.front(), HasSubstr("taken as 5 mm/s times time_s"));
}

TEST(SeveralCurves, stacks_and_needles_that_make_no_sense_are_refused) {
  const MeasuredCurve curve = generated_curve("tracking_wall", {0.8, 1.2, 0.4, 0.0}, {{10.0, 1.0}});
  const auto stack = [&](const std::string& model, const std::vector<double>& layers) {
    return refused([&] {
      FitRequest request{.model = model};
      request.layers = layers;
      fit_curve(curve, request);
    });
  };
  EXPECT_THAT(stack("fracture", {0.0, 3.0}), HasSubstr("has one tissue and no layers"));
  EXPECT_THAT(stack("tracking_wall", {1.0, 3.0}), HasSubstr("expected 0, the skin, first"));
  EXPECT_THAT(stack("tracking_wall", {0.0, 3.0, 3.0}), HasSubstr("expected depths that rise"));
  const auto law = [](const std::vector<PunctureOfNeedle>& points) {
    return refused([&] { fit_gauge_law(points); });
  };
  EXPECT_THAT(law({{"a", 0.7, 1.0}, {"b", 0.7, 1.1}}), HasSubstr("all curves are of one diameter"));
  EXPECT_THAT(law({{"a", 0.7, 0.0}, {"b", 0.9, 1.1}}), HasSubstr("expected both above 0"));
  EXPECT_FALSE(fit_gauge_law(std::vector<PunctureOfNeedle>{{"a", 0.5, 1.0}, {"b", 1.0, 4.0}}).has_intervals);
  EXPECT_NEAR(fit_gauge_law(std::vector<PunctureOfNeedle>{{"a", 0.5, 1.0}, {"b", 1.0, 4.0}}).exponent, 2.0, 1e-9);
}

}  // namespace
}  // namespace bodkin
