// Stacks of `layered`: the force drops at each layer's own puncture. The curves come from a script in another
// language.
#include <cstdio>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "study/fitting/layer_falls.h"
#include "tests/study/fitting/curves_of_others.h"
#include "tests/study/fitting/generated_curve.h"
#include <gmock/gmock.h>

#include "core/error.h"
#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::io;
using namespace bodkin::study;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
namespace {

#if defined(BODKIN_ADDRESS_SANITIZER) || defined(BODKIN_THREAD_SANITIZER)
constexpr int pairs = 5;
#else
constexpr int pairs = 100;
#endif

using StackOfLayered = CurvesOfOthers;

// The values of `heng` in measured_by_others.py: skin, muscle, ligament.
const std::vector<std::pair<std::string, double>> truth = {
    {"stiffness_1", 0.05},        {"stiffness_2", 0.03},  {"stiffness_3", 0.12},        {"break_force_1", 1.1},
    {"break_force_2", 0.6},       {"break_force_3", 2.0}, {"dynamic_friction_1", 0.02}, {"dynamic_friction_2", 0.01},
    {"dynamic_friction_3", 0.05}, {"shaft_ratio", 1.5},   {"viscosity_ratio", 0.02}};

TEST_F(StackOfLayered, has_the_truth_in_its_intervals_in_95_of_100_pairs_of_curves) {
  const std::vector<MeasuredCurve> clean = {curve_of({"heng", "20", "clean"}), curve_of({"heng", "40", "clean"})};
  int held = 0;
  std::vector<int> alone(truth.size());
  std::vector<double> mean(truth.size());
  for (int trial = 0; trial < pairs; ++trial) {
    const auto seed = static_cast<std::uint64_t>(2 * trial);
    const std::vector<MeasuredCurve> curves = {with_noise(clean[0], 0.01, seed),
                                               with_noise(clean[1], 0.01, seed + 1)};
    const CurveFit fit = fit_curves(curves, {.model = "layered", .layers = {0.0, 7.0, 14.0}});
    bool all = true;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const auto& [name, value] = truth[i];
      EXPECT_EQ(fit.find(name)->status, ParameterStatus::estimated) << name << ", trial " << trial;
      mean[i] += fit.find(name)->value / pairs;
      alone[i] += within(fit, name, value) ? 1 : 0;
      all = all && within(fit, name, value);
    }
    held += all ? 1 : 0;
    EXPECT_NEAR(fit.rmse, 0.01, 0.002) << "trial " << trial;
    ASSERT_EQ(fit.yields_at.size(), 3U);
  }
  // 95 of 100; with fewer pairs, a correct interval gives fewer than the limit at most once in a thousand runs.
  EXPECT_GE(held, pairs == 100 ? 95 : pairs - 3);
  std::printf("all held in %d of %d; alone:", held, pairs);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    std::printf(" %s %d", truth[i].first.c_str(), alone[i]);
    EXPECT_NEAR(mean[i], truth[i].second, 0.03 * truth[i].second) << truth[i].first << " has no bias";
  }
  std::printf("\n");
}

TEST_F(StackOfLayered, a_layer_may_give_way_before_the_one_above_it) {
  const CurveFit fit = fit_curve(curve_of({"pressed", "1"}), {.model = "layered", .layers = {0.0, 3.0}});
  ASSERT_EQ(fit.yields_at.size(), 2U);
  EXPECT_GT(fit.yields_at[0], fit.yields_at[1]);
  EXPECT_TRUE(within(fit, "break_force_1", 0.9) && within(fit, "break_force_2", 0.7));
  EXPECT_TRUE(within(fit, "stiffness_1", 0.01) && within(fit, "stiffness_2", 0.06));
}

TEST_F(StackOfLayered, a_layer_that_resists_nothing_takes_nothing_from_the_others) {
  const CurveFit fit = fit_curve(curve_of({"fat", "1"}), {.model = "layered", .layers = {0.0, 5.0, 15.0}});
  EXPECT_EQ(fit.find("break_force_2")->status, ParameterStatus::not_identified);
  EXPECT_THAT(fit.find("break_force_2")->remark, HasSubstr("nothing gives way in the data"));
  EXPECT_LT(fit.find("stiffness_2")->value, 1e-4);
  EXPECT_TRUE(within(fit, "break_force_1", 1.1) && within(fit, "break_force_3", 2.0));
  EXPECT_TRUE(within(fit, "stiffness_1", 0.05) && within(fit, "stiffness_3", 0.12));
}

TEST_F(StackOfLayered, a_layer_that_no_needle_reached_is_kept) {
  const CurveFit fit =
      fit_curve(curve_of({"heng", "10", "3"}), {.model = "layered", .layers = {0.0, 7.0, 14.0, 60.0}});
  for (const char* name : {"stiffness_4", "break_force_4", "dynamic_friction_4"})
    EXPECT_EQ(fit.find(name)->status, ParameterStatus::not_identified) << name;
  EXPECT_NEAR(fit.find("break_force_3")->value, 2.0, 0.1);
}

TEST_F(StackOfLayered, a_stack_of_one_layer_is_the_tissue_itself) {
  const MeasuredCurve curve = curve_of({"layered", "0.7", "3"});
  const CurveFit one = fit_curve(curve, {.model = "layered"}),
                 stack = fit_curve(curve, {.model = "layered", .layers = {0.0}});
  EXPECT_NEAR(stack.find("break_force_1")->value, one.find("break_force")->value, 1e-3);
  EXPECT_NEAR(stack.find("stiffness_1")->value, one.find("stiffness")->value, 1e-4);
  EXPECT_NEAR(stack.rmse, one.rmse, 1e-4);
}

TEST_F(StackOfLayered, the_criterion_prefers_it_where_it_drew_the_curve) {
  const MeasuredCurve curve = curve_of({"heng", "10", "3"});
  FitRequest request;
  request.layers = {0.0, 7.0, 14.0};
  const ModelChoice choice = choose_model({&curve, 1}, request);
  EXPECT_EQ(choice.fits.front().model, "layered");
  EXPECT_EQ(choice.fits.size() + choice.refused.size(), fit_models().size());
  for (const CurveFit& fit : choice.fits)
    EXPECT_EQ(fit.find("from_3") != nullptr, fit_model(fit.model).stack != nullptr)
        << fit.model << ": the others as one tissue";
}

TEST_F(StackOfLayered, its_elements_are_what_a_tissue_library_reads) {
  const CurveFit fit = fit_curve(curve_of({"heng", "10", "3"}), {.model = "layered", .layers = {0.0, 7.0, 14.0}});
  ASSERT_EQ(fit.elements.tissues.size(), 3U);
  std::string document = fitted_xml(fit, curve_of({"heng", "10", "3"}));
  std::string library = "<tissue_library version=\"1\">";
  for (int id = 0; id < 3; ++id) {
    const std::size_t begin = document.find("<tissue>") + 8, end = document.find("</tissue>");
    library += "<tissue id=\"" + std::to_string(id) + "\" name=\"layer_" + std::to_string(id) +
               "\" title=\"a layer\" colour=\"#000000\" hounsfield_HU=\"0\" hounsfield_noise_HU=\"0\">" +
               document.substr(begin, end - begin) + "</tissue>";
    document = document.substr(end + 9);
  }
  const anatomy::TissueLibrary read =
      parse_tissue_library(library + "</tissue_library>", "layers.xml", XmlSchema("tissues.xsd"));
  EXPECT_NEAR(read.tissues()[1].layered.break_force, fit.find("break_force_2")->value, 1e-9);
  EXPECT_NEAR(read.tissues()[2].layered.dynamic_friction, fit.find("dynamic_friction_3")->value, 1e-9);
  EXPECT_NEAR(read.tissues()[2].layered.viscosity,
              fit.find("viscosity_ratio")->value * fit.find("stiffness_3")->value, 1e-9);
}

TEST(StackOfLayeredErrors, depths_between_its_steps_and_wrong_names_are_refused) {
  const MeasuredCurve curve = generated_curve("tracking_wall", {0.8, 1.2, 0.4, 0.0}, {{10.0, 1.0}});
  const auto refused = [&](const FitRequest& request) -> std::string {
    try {
      fit_curve(curve, request);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(
      refused({.model = "layered", .layers = {0.0, 3.14}}),
      HasSubstr("--layers has 3.14 mm, expected multiples of 0.1 mm for layered, which knows tissues no finer; "
                "give 3.1"));
  EXPECT_THAT(refused({.model = "layered", .fix = {{"break_force", 1.0}}, .layers = {0.0, 3.0}}),
              HasSubstr("expected one of stiffness_1, stiffness_2, break_force_1"));
  MeasuredCurve untimed = curve;
  untimed.time.clear();
  EXPECT_THROW(fit_curve(untimed, {.model = "layered", .layers = {0.0, 3.0}}), InputError);
}

// By hand: drops at samples 50, 90 and 120, the first before the second layer is met.
TEST(LayerFalls, each_fall_belongs_to_a_layer_that_was_met) {
  EXPECT_THAT(shares_of_falls({{120, 3}, {90, 2}, {50, 1}}, 3, 9), ElementsAre(ElementsAre(50, 90, 120)));
  EXPECT_THAT(shares_of_falls({{120, 2}, {90, 2}}, 2, 9), ElementsAre(ElementsAre(90, 120), ElementsAre(120, 90)));
  // The third largest drop cannot be explained together with the two largest; the smallest can.
  EXPECT_THAT(shares_of_falls({{50, 1}, {90, 2}, {95, 2}, {120, 3}}, 3, 9), ElementsAre(ElementsAre(50, 90, 120)));
  EXPECT_THAT(shares_of_falls({{90, 2}}, 2, 9), ElementsAre(ElementsAre(90, 0), ElementsAre(0, 90)));
  EXPECT_THAT(shares_of_falls({}, 2, 9), ElementsAre(ElementsAre(0, 0)));
  EXPECT_THAT(shares_of_falls({{10, 0}}, 2, 9), ElementsAre(ElementsAre(0, 0))) << "before the skin";
  EXPECT_EQ(shares_of_falls({{90, 8}, {100, 8}}, 8, 12).size(), 12U);
}

}  // namespace
}  // namespace bodkin
