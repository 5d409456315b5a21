#include "study/fitting/fit.h"

#include <cmath>
#include <string>

#include "tests/study/fitting/generated_curve.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "forces/voigt_law.h"
#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::io;
using namespace bodkin::study;
namespace {

using ::testing::HasSubstr;

const std::vector<Stretch> one_way = {{10.0, 1.2}};
const std::vector<double> tracking = {0.8, 1.2, 0.4, 0.0};
const std::vector<double> layered = {0.05, 1.1, 0.02, 0.03, 0.002, 1.0, 0.5, 1.2, 0.0};

std::string refusal(const MeasuredCurve& curve, const FitRequest& request) {
  try {
    fit_curve(curve, request);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

// By hand: a wall of 0.5 N/mm that begins to follow at 1 N is a ramp of 2 mm and a plateau.
TEST(Fit, finds_a_ramp_and_its_plateau_drawn_by_hand) {
  MeasuredCurve curve;
  for (int i = 0; i <= 100; ++i) {
    const double depth = 0.1 * i;
    curve.time.push_back(0.01 * i);
    curve.depth.push_back(depth);
    curve.force.push_back(std::min(0.5 * depth, 1.0));
  }
  const CurveFit fit = fit_curve(curve, {.model = "tracking_wall"});
  EXPECT_NEAR(fit.find("stiffness")->value, 0.5, 1e-4);
  EXPECT_NEAR(fit.find("force")->value, 1.0, 1e-4);
  EXPECT_GT(fit.r_squared, 0.99999);
}

// k dx a (a+1)(a+2)/6 with k = 0.1, dx = 1 is 2 N at 3.49... mm; after the puncture there is no shaft friction.
TEST(Fit, finds_where_a_cubic_gives_way) {
  const VoigtLaw law(VoigtSum::cubic, 0.1, 0.0, 1.0);
  const double depth_at_yield = law.inverse(2.0);
  MeasuredCurve curve;
  for (int i = 0; i <= 200; ++i) {
    const double depth = 0.05 * i;
    curve.time.push_back(0.005 * i);
    curve.depth.push_back(depth);
    curve.force.push_back(depth < depth_at_yield ? law.elastic(depth) : 0.4);
  }
  const CurveFit fit = fit_curve(curve, {.model = "fracture"});
  ASSERT_EQ(fit.yields_at.size(), 1U);
  EXPECT_NEAR(fit.yields_at.front(), depth_at_yield, 0.05);
  EXPECT_NEAR(fit.find("stiffness")->value, 0.1, 1e-4);
  EXPECT_NEAR(fit.find("cutting_toughness")->value * 0.8, 0.4, 1e-3);
  const FittedParameter& toughness = *fit.find("toughness");
  EXPECT_LE(toughness.low, 0.1 * 1.0 * 0.0 + toughness.value);
  EXPECT_LE(toughness.value, toughness.high);
}

TEST(Fit, the_answer_does_not_hang_on_where_it_begins) {
  const MeasuredCurve curve = with_noise(generated_curve("layered", layered, one_way), 0.005, 7);
  const CurveFit plain = fit_curve(curve, {.model = "layered"});
  const CurveFit far = fit_curve(curve, {.model = "layered",
                                         .start = {{"stiffness", 0.5}, {"dynamic_friction", 0.2}},
                                         .bounds = {{"stiffness", 0.001, 5.0}}});
  for (const char* name : {"stiffness", "break_force", "dynamic_friction"}) {
    const FittedParameter &a = *plain.find(name), &b = *far.find(name);
    EXPECT_NEAR(a.value, b.value, 0.2 * (a.high - a.low)) << name;
  }
}

TEST(Fit, says_which_parameters_the_data_do_not_tell) {
  // Without a rest, nothing depends on the catch-up time.
  const CurveFit wall =
      fit_curve(with_noise(generated_curve("tracking_wall", tracking, one_way), 0.01, 3), {.model = "tracking_wall"});
  EXPECT_EQ(wall.find("catch_up")->status, ParameterStatus::not_identified);
  EXPECT_THAT(wall.find("catch_up")->remark, HasSubstr("do not depend"));
  EXPECT_EQ(wall.find("catch_up")->value, 0.5);
  EXPECT_EQ(wall.find("force")->status, ParameterStatus::estimated);

  // At a single speed, friction proportional to it cannot be told from other friction.
  const CurveFit friction = fit_curve(
      with_noise(generated_curve("shaft_friction", {0.015, 0.06, 0.0003, 0.015, 5.0, 0.0}, one_way), 0.002, 4),
      {.model = "shaft_friction", .fix = {{"static", 0.0}}});
  EXPECT_EQ(friction.find("viscous")->status, ParameterStatus::not_identified);
  EXPECT_THAT(friction.find("viscous")->remark, HasSubstr("coulomb"));
}

TEST(Fit, a_curve_in_which_nothing_gives_way_bounds_the_break_force_only) {
  const MeasuredCurve curve = with_noise(
      generated_curve("layered", {0.05, 50.0, 0.02, 0.03, 0.002, 1.0, 0.5, 1.2, 0.0}, {{10.0, 0.5}}), 0.01, 5);
  const CurveFit fit = fit_curve(curve, {.model = "layered"});
  EXPECT_EQ(fit.find("break_force")->status, ParameterStatus::not_identified);
  EXPECT_THAT(fit.find("break_force")->remark, HasSubstr("nothing gives way"));
  EXPECT_GT(fit.find("break_force")->value, curve.force.back() - 0.05);
  EXPECT_EQ(fit.find("stiffness")->status, ParameterStatus::estimated);
  EXPECT_EQ(fit.find("shaft_stiffness")->status, ParameterStatus::not_identified);
}

TEST(Fit, keeps_what_it_is_told_to_keep_and_counts_what_it_is_told_to_count) {
  const MeasuredCurve curve = generated_curve("tracking_wall", tracking, one_way);
  const CurveFit fixed = fit_curve(curve, {.model = "tracking_wall", .fix = {{"stiffness", 0.5}}});
  EXPECT_EQ(fixed.find("stiffness")->value, 0.5);
  EXPECT_EQ(fixed.find("stiffness")->status, ParameterStatus::kept);
  const CurveFit bound = fit_curve(curve, {.model = "tracking_wall", .bounds = {{"force", 0.1, 1.0}}});
  EXPECT_EQ(bound.find("force")->status, ParameterStatus::at_bound);
  EXPECT_NEAR(bound.find("force")->value, 1.0, 1e-6);
  const CurveFit part = fit_curve(curve, {.model = "tracking_wall", .from = 2.0, .to = 6.0});
  EXPECT_EQ(part.samples, 40U);
}

TEST(Fit, finds_a_contact_that_is_not_at_zero_when_it_may) {
  const MeasuredCurve curve =
      with_noise(generated_curve("tracking_wall", {0.8, 1.2, 0.4, 3.3}, {{10.0, 1.2}, {0.0, 0.3}}), 0.01, 6);
  const CurveFit fit = fit_curve(curve, {.model = "tracking_wall", .free = {"contact"}});
  EXPECT_NEAR(fit.find("contact")->value, 3.3, 0.05);
  const CurveFit unaware = fit_curve(curve, {.model = "tracking_wall"});
  ASSERT_FALSE(unaware.notes.empty());
  EXPECT_THAT(testing::PrintToString(unaware.notes), HasSubstr("--free contact"));
}

TEST(Fit, a_model_that_misses_something_is_told_by_its_residuals) {
  const MeasuredCurve curve = with_noise(generated_curve("layered", layered, one_way), 0.005, 8);
  const CurveFit fit = fit_curve(curve, {.model = "spring_damper_wall"});
  EXPECT_THAT(testing::PrintToString(fit.notes), HasSubstr("neighbouring residuals are alike"));
}

TEST(Fit, a_curve_without_times_needs_a_speed_where_the_model_asks_for_it) {
  MeasuredCurve curve = generated_curve("layered", layered, one_way);
  const CurveFit timed = fit_curve(curve, {.model = "layered"});
  curve.time.clear();
  EXPECT_THAT(refusal(curve, {.model = "layered"}), HasSubstr("--speed"));
  const CurveFit spaced = fit_curve(curve, {.model = "layered", .speed = 10.0});
  EXPECT_NEAR(spaced.find("stiffness")->value, timed.find("stiffness")->value, 1e-4);
  EXPECT_NO_THROW(fit_curve(curve, {.model = "fracture"}));
}

TEST(Fit, refuses_requests_that_do_not_fit_the_model) {
  const MeasuredCurve curve = generated_curve("tracking_wall", tracking, one_way);
  const FitRequest ask = {.model = "tracking_wall"};
  const auto with = [&](auto change) {
    FitRequest request = ask;
    change(request);
    return refusal(curve, request);
  };
  EXPECT_THAT(refusal(curve, {.model = "beam"}), HasSubstr("expected one of spring_damper_wall, tracking_wall"));
  EXPECT_THAT(with([](auto& r) { r.fix = {{"stifness", 1.0}}; }), HasSubstr("expected one of stiffness, force"));
  EXPECT_THAT(with([](auto& r) { r.fix = {{"force", -1.0}}; }), HasSubstr("expected 0 to 50"));
  EXPECT_THAT(with([](auto& r) { r.start = {{"force", std::nan("")}}; }), HasSubstr("expected 0 to 50"));
  EXPECT_THAT(with([](auto& r) { r.bounds = {{"force", 2.0, 1.0}}; }), HasSubstr("lower value first"));
  EXPECT_THAT(with([](auto& r) { r.from = 3.0, r.to = 2.0; }), HasSubstr("holds no depth"));
  EXPECT_THAT(with([](auto& r) { r.from = 3.0, r.to = 3.5; }), HasSubstr("too few for 3 parameters"));
  EXPECT_THAT(with([](auto& r) { r.speed = 0.0; }), HasSubstr("--speed"));
  EXPECT_THAT(with([](auto& r) { r.resolution = -1.0; }), HasSubstr("--resolution"));
}

// The element <NAME ...> with its end tag.
std::string element_of(const std::string& document, const std::string& name) {
  const std::size_t begin = document.find("<" + name);
  if (begin == std::string::npos) return "";
  const std::string end = "</" + name + ">";
  const std::size_t close = document.find(end, begin);
  return close == std::string::npos ? document.substr(begin, document.find("/>", begin) + 2 - begin)
                                    : document.substr(begin, close + end.size() - begin);
}

TEST(FittedXml, is_what_tissue_library_and_case_read) {
  const XmlSchema tissues("tissues.xsd"), cases("case.xsd");
  for (const FitModel& model : fit_models()) {
    CurveFit fit;
    fit.model = model.name;
    std::vector<double> values;
    for (const FitParameter& one : model.parameters) values.push_back(one.usual + 0.1 / 3.0);
    fit.elements = model.elements(values);
    MeasuredCurve curve;
    curve.name = "a<b>&\"c\".csv";
    const std::string document = fitted_xml(fit, curve);
    if (!fit.elements.tissues.empty()) {
      std::string inside = element_of(document, "tissue");
      inside = inside.substr(inside.find('>') + 1);
      inside = inside.substr(0, inside.rfind("</tissue>"));
      if (inside.find("<layered") == std::string::npos) inside += "<layered><none/></layered>";
      const std::string library =
          "<tissue_library version=\"1\"><tissue id=\"0\" name=\"air\" title=\"air\" colour=\"#000000\" "
          "hounsfield_HU=\"-1000\" hounsfield_noise_HU=\"0\">" +
          inside + "</tissue></tissue_library>";
      const TissueLibrary read = parse_tissue_library(library, "library.xml", tissues);
      EXPECT_THAT(read.tissues().front().source, HasSubstr("a<b>&\"c\".csv"));
      if (model.name == "tracking_wall") {
        EXPECT_EQ(read.tissues().front().tracking_wall.force, values[1]);
      }
      if (model.name == "layered") {
        EXPECT_EQ(read.tissues().front().layered.break_force, values[1]);
      }
      if (model.name == "shaft_friction") {
        EXPECT_EQ(read.tissues().front().shaft_friction.viscous, values[2]);
      }
    }
    if (fit.elements.resistance) {
      const std::string haptics = element_of(document, "haptics");
      EXPECT_NO_THROW(cases.read(haptics, "case.xml")) << haptics;
      EXPECT_THAT(haptics, HasSubstr("<" + std::string(model.name)));
    }
    EXPECT_TRUE(!fit.elements.tissues.empty() || fit.elements.resistance) << model.name;
  }
}

}  // namespace
}  // namespace bodkin
