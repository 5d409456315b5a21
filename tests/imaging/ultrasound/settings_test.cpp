#include "imaging/ultrasound/settings.h"

#include <limits>
#include <set>
#include <string>

#include "tests/io/scratch_folder.h"
#include <gtest/gtest.h>

#include "anatomy/ultrasound_probe.h"
#include "imaging/ultrasound/frame.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

const UltrasoundProbe probe_of_settings = {.name = "C5-2", .frequency = 3.5, .lowest = 2.0, .highest = 5.0};

std::string refused_setting(double UltrasoundSettings::*field, double value) {
  UltrasoundSettings settings;
  settings.*field = value;
  return refusal([&] { check(settings, probe_of_settings); });
}

std::string refused_detail(int UltrasoundDetail::*field, int value) {
  UltrasoundDetail detail;
  detail.*field = value;
  return refusal([&] { check(detail); });
}

TEST(UltrasoundSettings, the_defaults_and_the_limits_are_accepted) {
  EXPECT_NO_THROW(check(UltrasoundSettings{}, probe_of_settings));
  UltrasoundSettings low{.depth = 10, .gain = -40, .dynamic_range = 20, .focus = 5, .frequency = 2, .sliders = {}};
  low.sliders.fill(-20.0);
  EXPECT_NO_THROW(check(low, probe_of_settings));
  UltrasoundSettings high{
      .depth = 400, .gain = 40, .dynamic_range = 120, .focus = 400, .frequency = 5, .sliders = {}};
  high.sliders.fill(20.0);
  EXPECT_NO_THROW(check(high, probe_of_settings));
}

TEST(UltrasoundSettings, what_is_out_of_range_is_refused_with_field_found_and_expected) {
  using S = UltrasoundSettings;
  EXPECT_EQ(refused_setting(&S::depth, 5.0), "ultrasound: depth_mm is 5 mm, expected 10 to 400 mm");
  EXPECT_EQ(refused_setting(&S::gain, 41.0), "ultrasound: gain_dB is 41 dB, expected -40 to 40 dB");
  EXPECT_EQ(refused_setting(&S::dynamic_range, 0.0), "ultrasound: dynamic_range_dB is 0 dB, expected 20 to 120 dB");
  EXPECT_EQ(refused_setting(&S::focus, 500.0), "ultrasound: focus_mm is 500 mm, expected 5 to 400 mm");
  EXPECT_EQ(refused_setting(&S::frequency, 7.0),
            "ultrasound frequency is 7 MHz, expected 2 to 5 MHz, the band of the probe C5-2; choose one in between, "
            "or 0 for its centre");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double S::*field : {&S::depth, &S::gain, &S::dynamic_range, &S::focus, &S::frequency})
    EXPECT_NE(refused_setting(field, nan).find("is nan"), std::string::npos);
  UltrasoundSettings slid;
  slid.sliders[7] = nan;
  EXPECT_EQ(refusal([&] { check(slid, probe_of_settings); }),
            "ultrasound: slider 8 is nan dB, expected -20 to 20 dB");
}

TEST(UltrasoundDetail, what_is_out_of_range_is_refused_with_field_found_and_expected) {
  using D = UltrasoundDetail;
  EXPECT_NO_THROW(check(D{}));
  EXPECT_NO_THROW(check(paper_detail()));
  EXPECT_EQ(refused_detail(&D::lines, 15), "ultrasound: lines is 15, expected 16 to 2048");
  EXPECT_EQ(refused_detail(&D::samples, 5000), "ultrasound: samples is 5000, expected 32 to 4096");
  EXPECT_EQ(refused_detail(&D::width, 0), "ultrasound: width is 0, expected 16 to 4096");
  EXPECT_EQ(refused_detail(&D::height, -1), "ultrasound: height is -1, expected 16 to 4096");
  EXPECT_EQ(refused_detail(&D::slices, 2), "ultrasound: slices is an even number, expected 1, 3, 5 or 7");
  EXPECT_EQ(refused_detail(&D::threads, 65), "ultrasound: threads is 65, expected 1 to 64");
}

TEST(UltrasoundDetail, the_papers_picture_has_what_the_paper_had) {
  const UltrasoundDetail paper = paper_detail();
  EXPECT_EQ(paper.slices, 1);
  EXPECT_FALSE(paper.speckle || paper.reverberation || paper.clutter);
  EXPECT_EQ(paper.lines * paper.samples, 300 * 300);
}

TEST(UltrasoundFrame, every_black_picture_has_a_reason_of_its_own) {
  EXPECT_TRUE(reason(NoImage::none).empty());
  std::set<std::string_view> reasons;
  for (const NoImage why :
       {NoImage::outside_volume, NoImage::no_contact, NoImage::inside_body, NoImage::broken_pose}) {
    EXPECT_TRUE(reason(why).ends_with('.'));
    reasons.insert(reason(why));
  }
  EXPECT_EQ(reasons.size(), 4U);
}

}  // namespace
}  // namespace bodkin
