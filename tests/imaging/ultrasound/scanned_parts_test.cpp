// Tissues and structures met by a probe's lines, in bodies of flat layers.
#include "imaging/ultrasound/scanned_parts.h"

#include <limits>

#include "tests/session/slab_case.h"
#include <gtest/gtest.h>

#include "imaging/ultrasound/probe.h"
#include "io/probe_library_file.h"

namespace bodkin {
namespace {

using imaging::ScannedParts;

// On the back of the body, `above` mm from the skin, looking straight in.
Pose on_the_back(double above) {
  return imaging::probe_pose(Vec3(0.0, above, 0.0), -Vec3::UnitY(), Vec3::UnitX());
}

ScannedParts found(const Case& patient, const Pose& pose, double depth, bool gel = true) {
  const anatomy::UltrasoundProbe probe = io::find_probe("L14-5");
  ScannedParts parts;
  imaging::ScannedSearch(patient, probe).add(pose, {.depth = depth, .gel = gel}, parts);
  return parts;
}

Case nerve_before_bone() {
  return slab_case({{tissue::skin, 2.0},
                    {tissue::muscle, 18.0},
                    {tissue::nerve, 2.0},
                    {tissue::cortical_bone, 1.0},
                    {tissue::vessel, 5.0}});
}

TEST(ScannedParts, a_line_meets_bone_and_nothing_behind_it) {
  const ScannedParts parts = found(nerve_before_bone(), on_the_back(0.0), 60.0);
  for (const TissueId seen : {tissue::skin, tissue::muscle, tissue::nerve, tissue::cortical_bone})
    EXPECT_TRUE(parts.tissues[seen]) << int{seen};
  EXPECT_FALSE(parts.tissues[tissue::vessel]) << "it lies in the bone's shadow";
  EXPECT_FALSE(parts.tissues[tissue::air]);
}

TEST(ScannedParts, what_lies_deeper_than_the_picture_is_not_in_it) {
  EXPECT_FALSE(found(nerve_before_bone(), on_the_back(0.0), 15.0).tissues[tissue::nerve]);
  EXPECT_TRUE(found(nerve_before_bone(), on_the_back(0.0), 25.0).tissues[tissue::nerve]);
}

TEST(ScannedParts, gel_bridges_five_millimetres_and_no_more) {
  EXPECT_TRUE(found(nerve_before_bone(), on_the_back(4.0), 60.0).tissues[tissue::nerve]);
  EXPECT_TRUE(found(nerve_before_bone(), on_the_back(4.0), 60.0, false).tissues.none());
  EXPECT_TRUE(found(nerve_before_bone(), on_the_back(6.0), 60.0).tissues.none());
}

TEST(ScannedParts, a_probe_that_looks_away_meets_nothing) {
  const Pose away = imaging::probe_pose(Vec3::Zero(), Vec3::UnitY(), Vec3::UnitX());
  EXPECT_TRUE(found(nerve_before_bone(), away, 60.0).tissues.none());
  Pose broken = on_the_back(0.0);
  broken.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(found(nerve_before_bone(), broken, 60.0).tissues.none());
}

TEST(ScannedParts, structures_are_found_by_their_labels_where_the_slice_cuts_them) {
  Case patient = slab_case({{tissue::skin, 2.0}, {tissue::muscle, 40.0}});
  patient.structures = LabelVolume(patient.tissues.grid, 0);
  const auto fill = [&](const Vec3& middle, std::uint16_t label) {
    const Vec3 index = patient.structures.grid.to_index(middle);
    patient.structures.at(static_cast<int>(index.x() + 0.5), static_cast<int>(index.y() + 0.5),
                          static_cast<int>(index.z() + 0.5)) = label;
  };
  fill(Vec3(0.0, -20.0, 0.0), 7);   // in the slice z = 0
  fill(Vec3(0.0, -20.0, 10.0), 8);  // 10 mm from that slice
  EXPECT_EQ(found(patient, on_the_back(0.0), 60.0).structures, (std::set<std::uint16_t>{7}));
}

}  // namespace
}  // namespace bodkin
