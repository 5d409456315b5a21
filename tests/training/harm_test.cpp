#include "training/harm.h"

#include "tests/training/written_session.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "training/procedure_file.h"
#include "training/score.h"
#include "training/surface_voxels.h"

namespace bodkin {

using namespace bodkin::training;
namespace {

constexpr std::uint16_t colon = 7;

// A slab of the colon from 30 to 34 mm, in a body of 60 mm.
struct Body {
  Body() {
    const Case patient = slab_case({{tissue::fat, 60.0}});
    structures = LabelVolume(patient.tissues.grid, 0);
    tissues = patient.tissues;
    const Grid& grid = structures.grid;
    for (int j = 0; j < grid.size[1]; ++j) {
      const double y = grid.to_patient(Vec3(0, j, 0)).y();
      if (y > -30.0 || y < -34.0) continue;
      for (int k = 0; k < grid.size[2]; ++k)
        for (int i = 0; i < grid.size[0]; ++i) structures.at(i, j, k) = colon;
    }
    description = written_description();
    description.structures = {{colon, "colon", "", true}, {8, "kidney_left", "organ", true}};
  }
  HarmReport harm(WrittenSession& written, const training::Procedure& procedure, bool volumes = true) const {
    const Attempt attempt(written.session(), description);
    return find_harm(attempt, procedure, volumes ? PatientVolumes{&structures, &tissues} : PatientVolumes{});
  }

  LabelVolume structures;
  TissueVolume tissues;
  CaseDescription description;
};

TEST(Harm, an_entry_counts_again_after_a_millimetre_of_travel_outside) {
  const Body body;
  WrittenSession written;
  written.to(0, 100, WrittenSession::air).to(32, 3200, {});
  written.to(29.7, 230, {}).to(32, 230, {});  // out by 0.3 mm and in again: the same entry
  written.to(25, 700, {}).to(32, 700, {});    // out by 5 mm and in again: another one
  const HarmReport report = body.harm(written, find_procedure("lumbar_puncture"));
  ASSERT_EQ(report.harms.size(), 1U);
  EXPECT_EQ(report.harms[0].title, "the colon");
  EXPECT_EQ(report.harms[0].grade, Grade::dangerous);
  EXPECT_EQ(report.harms[0].entries, 2);
  EXPECT_NEAR(report.harms[0].first_depth, 30.0, 0.02);
  EXPECT_NEAR(report.harms[0].deepest, 32.0, 0.02);
  EXPECT_NEAR(report.harms[0].time_inside, 1.0, 0.01);
}

TEST(Harm, a_bowel_of_soft_tissue_is_seen_in_the_segmentation_alone_so_without_it_nothing_passes) {
  const Body body;
  WrittenSession written = good_puncture();
  const HarmReport blind = body.harm(written, find_procedure("lumbar_puncture"), false);
  EXPECT_TRUE(blind.harms.empty());
  EXPECT_THAT(blind.unchecked, ::testing::ElementsAre("colon"));  // a kidney is found by its tissue
  const Score result = score(written.session(), body.description, find_procedure("lumbar_puncture"));
  EXPECT_EQ(result.verdict, Grade::borderline);
}

TEST(Harm, a_critical_structure_of_the_case_is_forbidden_in_every_procedure) {
  Body body;
  body.description.structures = {{colon, "left_ventricle", "", true}};
  WrittenSession written = good_puncture();
  for (const std::string& name : shipped_procedures()) {
    const training::Procedure procedure = find_procedure(name);
    const PatientVolumes volumes{&body.structures, &body.tissues};
    const Score result = score(written.session(), body.description, procedure, volumes);
    EXPECT_EQ(result.verdict, Grade::dangerous) << name;
    EXPECT_EQ(result.headline, "Dangerous: the tip entered the left ventricle") << name;
  }
}

TEST(Harm, the_organ_that_the_target_lies_in_may_be_entered) {
  Body body;
  WrittenSession written;
  written.session().header.path.target = Vec3(0, -33, 0);
  written.to(0, 100, WrittenSession::air).to(33, 3300, {}).rest(1000, {});
  EXPECT_TRUE(body.harm(written, find_procedure("ct_guided_biopsy")).harms.empty());
  written.session().header.path.target = Vec3(0, -50, 0);
  EXPECT_EQ(body.harm(written, find_procedure("ct_guided_biopsy")).harms.size(), 1U);
}

TEST(Harm, coming_closer_than_the_margin_is_a_near_miss) {
  const Body body;
  training::Procedure procedure = find_procedure("needle_insertion");
  procedure.forbidden.push_back({.structure = "colon", .title = "the colon", .margin = 2.0});
  WrittenSession close, far;
  close.to(0, 100, WrittenSession::air).to(29, 2900, {}).rest(1000, {});
  far.to(0, 100, WrittenSession::air).to(27.5, 2900, {}).rest(1000, {});
  const HarmReport near = body.harm(close, procedure);
  ASSERT_EQ(near.harms.size(), 1U);
  EXPECT_FALSE(near.harms[0].entered);
  EXPECT_EQ(near.harms[0].grade, Grade::borderline);
  EXPECT_NEAR(near.harms[0].closest, 1.0, 0.26);  // sampled every 0.25 mm; the slab begins at 30 mm
  EXPECT_TRUE(body.harm(far, procedure).harms.empty());
}

TEST(Harm, the_least_distance_to_everything_that_is_forbidden_is_told_beyond_any_margin) {
  const Body body;
  training::Procedure procedure = find_procedure("needle_insertion");
  procedure.forbidden = {{.structure = "colon", .title = "the colon", .margin = 2.0},
                         {.tissue = "cortical_bone", .title = "bone"}};
  WrittenSession written;
  written.to(0, 100, WrittenSession::air).to(12, 1200, {}).rest(300, {}).to(4, 800, {});
  const HarmReport report = body.harm(written, procedure);
  EXPECT_TRUE(report.harms.empty());
  ASSERT_EQ(report.distances.size(), 3U);  // includes a kidney, which the case marks as critical
  EXPECT_EQ(report.distances[0].title, "the colon");
  EXPECT_NEAR(report.distances[0].closest.value(), 18.0, 0.51);  // the slab begins at 30 mm; points every 0.5 mm
  EXPECT_NEAR(report.distances[0].depth, 12.0, 0.51);
  EXPECT_NEAR(report.distances[0].time, 1.3, 0.06);
  EXPECT_FALSE(report.distances[1].closest.has_value()) << "there is none of it";
  EXPECT_TRUE(body.harm(written, procedure, false).distances.empty()) << "the patient is not at hand";
  const Score result =
      score(written.session(), body.description, procedure, PatientVolumes{&body.structures, &body.tissues});
  EXPECT_NEAR(result.find("nearest_forbidden_mm")->value, 18.0, 0.51);
  written.to(31, 2700, {});
  EXPECT_EQ(body.harm(written, procedure).distances[0].closest.value(), 0.0);
}

// The search skips points that the path length between two points shows to be too far; the check skips none.
TEST(Harm, the_nearest_voxel_of_a_way_is_that_of_all_pairs) {
  Grid grid;
  grid.size = {40, 50, 30};
  grid.spacing = Vec3(1.0, 0.8, 1.5);
  grid.origin = Vec3(-20, -40, -20);
  LabelVolume volume(grid, 0);
  Random random(5);
  for (int n = 0; n < 25; ++n) {
    const auto at = [&](int size) { return std::min(size - 1, static_cast<int>(random.uniform() * size)); };
    volume.at(at(grid.size[0]), at(grid.size[1]), at(grid.size[2])) = static_cast<std::uint16_t>(1 + n % 5);
  }
  std::vector<WayPoint> way;
  Vec3 tip(0, 0, 0);
  for (std::size_t i = 0; i < 300; ++i) {
    tip += Vec3(random.normal(), random.normal() - 0.1, random.normal()) * 0.6;
    way.push_back({tip, i});
  }
  const SurfaceVoxels<std::uint16_t> surfaces(volume, {1, 2, 3, 4, 5});
  for (std::uint16_t label = 1; label <= 5; ++label) {
    double least = SurfaceVoxels<std::uint16_t>::farthest;
    for (const WayPoint& each : way) least = std::min(least, distance_to_value(volume, each.tip, label, least));
    const auto found = surfaces.nearest_to(label, way);
    ASSERT_TRUE(found.has_value()) << label;
    EXPECT_NEAR(found->distance, least, 1e-9) << label;
    EXPECT_NEAR(distance_to_value<std::uint16_t>(volume, way[found->point].tip, label, 60.0), least, 1e-9) << label;
  }
}

TEST(Harm, the_distance_to_a_voxel_is_measured_to_its_box) {
  Grid grid;
  grid.size = {9, 9, 9};
  grid.spacing = Vec3(1.0, 2.0, 0.5);
  LabelVolume volume(grid, 0);
  volume.at(4, 4, 4) = 3;
  const Vec3 centre = grid.to_patient(Vec3(4, 4, 4));
  EXPECT_NEAR(distance_to_value<std::uint16_t>(volume, centre, 3, 5.0), 0.0, 1e-12);
  EXPECT_NEAR(distance_to_value<std::uint16_t>(volume, centre + Vec3(2.0, 0, 0), 3, 5.0), 1.5, 1e-12);
  EXPECT_NEAR(distance_to_value<std::uint16_t>(volume, centre + Vec3(2.0, 3.0, 0), 3, 5.0), std::hypot(1.5, 2.0),
              1e-12);
  EXPECT_EQ(distance_to_value<std::uint16_t>(volume, centre + Vec3(90.0, 0, 0), 3, 5.0), 5.0);
}

}  // namespace
}  // namespace bodkin
