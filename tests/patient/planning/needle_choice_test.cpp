#include "patient/planning/needle_choice.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin::patient {
namespace {

TEST(NeedleChoice, says_gauge_length_and_tip) {
  const anatomy::Needle tuohy = parse_needle("18,80,tuohy");
  EXPECT_EQ(tuohy.gauge, 18);
  EXPECT_EQ(tuohy.length, 80.0);
  EXPECT_EQ(tuohy.tip, anatomy::NeedleTip::tuohy);
  EXPECT_EQ(tuohy.outer_diameter, anatomy::gauge_size(18)->outer_diameter);
  EXPECT_EQ(parse_needle("25").length, 90.0);
  EXPECT_EQ(parse_needle("31,40,filiform").inner_diameter, 0.0) << "solid";
  for (const char* wrong : {"", "9", "18,", "18,0", "18,90,blunt", "18,90,tuohy,1", "18;90"})
    EXPECT_THROW(parse_needle(wrong), InputError) << wrong;
}

TEST(NeedleChoice, an_epidural_ends_in_the_middle_of_the_epidural_space) {
  anatomy::Grid grid;
  grid.size = {9, 60, 9};
  grid.spacing = Vec3::Ones();
  anatomy::TissueVolume tissues(grid, anatomy::tissue::muscle);
  for (int k = 0; k < 9; ++k) {
    for (int j = 0; j < 20; ++j) {
      for (int i = 0; i < 9; ++i)
        tissues.at(i, j, k) = j >= 14 ? anatomy::tissue::epidural_fat : anatomy::tissue::cerebrospinal_fluid;
    }
  }
  const anatomy::NeedlePath path{Vec3(4.0, 50.0, 4.0), Vec3(4.0, 8.0, 4.0)};
  EXPECT_NEAR(ended_in_epidural_space(path, tissues).target.y(), 16.5, 0.3);
  const anatomy::NeedlePath short_path{Vec3(4.0, 50.0, 4.0), Vec3(4.0, 30.0, 4.0)};
  EXPECT_EQ(ended_in_epidural_space(short_path, tissues).target.y(), 30.0) << "it crosses none";
}

}  // namespace
}  // namespace bodkin::patient
