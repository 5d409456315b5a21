#include "anatomy/needle.h"

#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
namespace {

TEST(Needle, gauges_are_tubes_that_get_thinner) {
  double previous = 1e9;
  for (const GaugeSize& size : gauge_sizes()) {
    EXPECT_LT(size.outer_diameter, previous) << size.gauge;
    EXPECT_LT(size.inner_diameter, size.outer_diameter) << size.gauge;
    EXPECT_GT(size.inner_diameter, 0.0) << size.gauge;
    previous = size.outer_diameter;
  }
}

TEST(Needle, a_22_gauge_spinal_needle_is_0_7176_mm_thick) {
  ASSERT_TRUE(gauge_size(22));
  EXPECT_DOUBLE_EQ(gauge_size(22)->outer_diameter, 0.7176);
  EXPECT_DOUBLE_EQ(gauge_size(22)->inner_diameter, 0.413);
  EXPECT_FALSE(gauge_size(9));
  EXPECT_FALSE(gauge_size(35));
}

TEST(Needle, tips_keep_their_names) {
  for (const NeedleTip tip : {NeedleTip::quincke, NeedleTip::whitacre, NeedleTip::tuohy, NeedleTip::chiba,
                              NeedleTip::trephine, NeedleTip::filiform}) {
    EXPECT_EQ(needle_tip_from(to_string(tip)), tip);
  }
  EXPECT_FALSE(needle_tip_from("blunt"));
}

}  // namespace
}  // namespace bodkin
