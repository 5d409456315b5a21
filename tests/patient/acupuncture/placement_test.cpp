#include "patient/acupuncture/placement.h"

#include <algorithm>

#include "patient/acupuncture/atlas.h"
#include "patient/whole_body/body_landmarks.h"
#include "tests/patient/acupuncture/second_placement.h"
#include <gtest/gtest.h>

#include "core/error.h"

// The 361 points on synthetic bodies, against a second implementation, and against anatomy.

namespace bodkin_test {
namespace {

using namespace bodkin::patient;

const Atlas& usual_body() {
  static const Atlas atlas{BodyParameters{}};
  return atlas;
}

void expect_same_as_second(const BodyParameters& parameters) {
  const BodyShape shape(parameters);
  const BodyLandmarks landmarks = body_landmarks(shape);
  const PointTable table = read_point_table();
  PointPlacer placer(table, shape, landmarks);
  SecondPlacement second(shape, landmarks);
  ASSERT_EQ(table.points.size(), 361u);
  for (const PointRow& row : table.points) {
    const double apart = (placer.place(row.code) - second.at(row.code)).norm();
    EXPECT_LE(apart, 3.0) << row.code << " " << placer.place(row.code).transpose() << " and "
                          << second.at(row.code).transpose();
  }
}

TEST(Placement, each_of_361_points_lies_within_3_mm_of_where_a_second_implementation_puts_it) {
  expect_same_as_second({});
}

TEST(Placement, the_two_implementations_agree_on_a_short_heavy_woman) {
  expect_same_as_second({1.55, 85.0, Sex::female});
}

TEST(Placement, every_point_lies_on_the_skin_and_no_two_at_one_place) {
  const Atlas& atlas = usual_body();
  ASSERT_EQ(atlas.points().size(), 361u);
  for (const AtlasPoint& point : atlas.points()) {
    const double off =
        atlas.shape().scale() * atlas.shape().drawn_distance(point.place / atlas.shape().scale(), false);
    EXPECT_NEAR(off, 0.0, 0.5) << point.code;
    for (const AtlasPoint& other : atlas.points()) {
      // GV28 is inside the lip, behind GV26; on a closed mouth they are one place.
      const bool is_lip =
          (point.code == "GV26" && other.code == "GV28") || (point.code == "GV28" && other.code == "GV26");
      if (&other != &point && !is_lip) {
        EXPECT_GT((other.place - point.place).norm(), 1.0) << point.code << " " << other.code;
      }
    }
  }
}

// Statements of the standard that are not in the table.
TEST(Placement, points_lie_where_the_standard_says_they_meet_others) {
  const Atlas& atlas = usual_body();
  const auto at = [&](const char* code) { return atlas.find(code)->place; };
  const double cun = atlas.shape().parameters().height * 1000.0 / 75.0;
  EXPECT_NEAR(at("GV20").y(), 20.0, 45.0);                        // between the tips of both ears
  EXPECT_NEAR(at("PC6").z(), at("TE5").z(), 12.0);                // opposite each other
  EXPECT_NEAR(at("BL23").z(), at("GV4").z(), 1.0);                // level
  EXPECT_NEAR((at("GV14") - at("GV13")).norm(), 25.0, 8.0);       // one vertebra
  EXPECT_NEAR((at("ST36") - at("ST37")).norm(), 3.0 * cun, 8.0);  // 3 cun
  EXPECT_NEAR((at("SP6") - at("SP7")).norm(), 3.0 * cun, 8.0);    // 3 cun
  EXPECT_NEAR((at("LU1") - at("LU2")).norm(), 1.0 * cun, 14.0);   // 1 cun
  EXPECT_NEAR((at("GV15") - at("GV16")).norm(), 0.5 * cun, 5.0);  // 0.5 cun
  EXPECT_NEAR(at("BL17").z(), at("GV9").z(), 1.0);                // under T7
  EXPECT_GT(at("LI11").x(), at("LU5").x());                       // outer end of the fold
  EXPECT_LT(at("HT3").x(), at("PC3").x());                        // inner end
  EXPECT_GT(at("ST40").x() - at("ST38").x(), 8.0);                // a finger's breadth outside
}

TEST(Placement, points_grow_with_the_body) {
  const Atlas& usual = usual_body();
  const Atlas tall(BodyParameters{1.90, 85.0, Sex::male});
  const double ratio = (tall.find("ST36")->place - tall.find("ST41")->place).norm() /
                       (usual.find("ST36")->place - usual.find("ST41")->place).norm();
  EXPECT_NEAR(ratio, 1.90 / 1.72, 0.01);
}

TEST(Landmarks, there_are_231_and_all_lie_on_the_skin_or_the_sole) {
  const BodyShape shape(BodyParameters{});
  const BodyLandmarks landmarks = body_landmarks(shape);
  EXPECT_EQ(landmarks.size(), 231u);
  for (const auto& [name, landmark] : landmarks) {
    EXPECT_EQ(landmark.kind == BodyLandmark::Kind::line, landmark.places.size() > 1) << name;
    if (name == "sole" || name == "heel_posterior_border") continue;
    for (const Vec3& place : landmark.places)
      EXPECT_NEAR(shape.drawn_distance(place / shape.scale(), false), 0.0, 0.6) << name;
  }
}

TEST(Body, is_as_tall_as_asked_stands_on_the_ground_and_weighs_about_its_weight) {
  for (const double weight : {55.0, 75.0, 100.0}) {
    const BodyShape shape({1.75, weight, Sex::male});
    EXPECT_NEAR(body_landmarks(shape).at("vertex_of_head").place().z(), 1750.0, 2.0);
    const auto volume = body_volume(shape, BodyTissues(shape), {.middle = {}, .width = 200.0, .spacing = 8.0});
    const auto inside = std::count_if(volume.voxels.begin(), volume.voxels.end(), [](auto id) { return id != 0; });
    const double litres = static_cast<double>(inside) * 8.0 * 8.0 * 8.0 * 1e-6;
    EXPECT_NEAR(litres, weight, 0.2 * weight);
  }
}

TEST(Body, has_lungs_under_the_chest_and_the_cord_under_the_spine) {
  const Atlas& atlas = usual_body();
  // Pleura: 20 to 35 mm under the inner line of the bladder meridian in adults of usual weight.
  for (const char* code : {"BL13", "BL15", "BL18", "BL43"}) {
    const AtlasPoint& point = *atlas.find(code);
    EXPECT_EQ(point.danger, "lung") << code;
    EXPECT_NEAR(point.danger_depth.value_or(0.0), 27.0, 8.0) << code;
  }
  EXPECT_EQ(atlas.find("GV14")->danger, "spinal canal");
  EXPECT_EQ(atlas.find("GV20")->danger, "brain");
  EXPECT_FALSE(atlas.find("ST36")->danger_depth && *atlas.find("ST36")->danger_depth < 30.0);
}

TEST(Body, parameters_out_of_range_are_refused_by_name) {
  EXPECT_THROW(check_body({2.4, 80.0, Sex::male}), bodkin::InputError);
  EXPECT_THROW(check_body({1.7, 500.0, Sex::male}), bodkin::InputError);
  EXPECT_THROW(check_body({1.9, 45.0, Sex::male}), bodkin::InputError);
}

TEST(Needling, published_depths_are_kept_and_others_stop_before_bone_and_danger) {
  const Atlas& atlas = usual_body();
  int published = 0;
  for (const AtlasPoint& point : atlas.points()) {
    const Needling how = atlas.needling(point);
    EXPECT_GT(how.deepest, 0.0) << point.code;
    EXPECT_LE(how.shallowest, how.deepest) << point.code;
    EXPECT_LT(how.axis.dot(point.normal), 0.0) << point.code;  // into the body
    if (!how.derived) {
      ++published;
    } else if (how.angle == 90.0) {
      EXPECT_LE(how.deepest, point.danger_depth.value_or(100.0) - 5.0) << point.code;
      EXPECT_LT(how.deepest, point.bone_depth.value_or(100.0)) << point.code;
    }
  }
  EXPECT_EQ(published, 53);  // of the 54 rows one is no standard point
  EXPECT_FALSE(atlas.needling(*atlas.find("GB30")).derived);
  EXPECT_EQ(atlas.needling(*atlas.find("GB30")).deepest, 56.0);
}

TEST(Needling, the_planned_path_ends_before_bone_and_danger_whatever_is_published) {
  const Atlas& atlas = usual_body();
  for (const char* code : {"ST36", "PC6", "BL13", "GB30", "LI4", "GV14"}) {
    const AtlasPoint& point = *atlas.find(code);
    const bodkin::anatomy::NeedlePath path = atlas.path(point);
    EXPECT_GE(path.length(), 3.0) << code;
    const double deep = (path.entry - path.target).dot(point.normal);
    EXPECT_LT(deep, point.bone_depth.value_or(100.0)) << code;
    EXPECT_LT(deep, point.danger_depth.value_or(100.0)) << code;
  }
}

TEST(Search, finds_by_code_name_and_meridian_however_written) {
  const Atlas& atlas = usual_body();
  EXPECT_EQ(atlas.find("st 36")->pinyin, "Zusanli");
  EXPECT_EQ(atlas.find("zusanli")->code, "ST36");
  EXPECT_EQ(atlas.find("ST99"), nullptr);
  EXPECT_EQ(atlas.search("").size(), 361u);
  EXPECT_EQ(atlas.search("bladder").size(), 67u + 44u);  // the gallbladder's too
  EXPECT_EQ(atlas.search("ST3").front()->code, "ST3");
}

TEST(Meridians, are_fourteen_and_run_on_the_skin_through_all_their_points) {
  const Atlas& atlas = usual_body();
  ASSERT_EQ(atlas.meridians().size(), 14u);
  std::size_t through = 0;
  for (const Meridian& meridian : atlas.meridians()) {
    for (const auto& line : meridian.lines) {
      for (std::size_t i = 0; i < line.size(); ++i) {
        const double off = atlas.shape().drawn_distance(line[i] / atlas.shape().scale(), false);
        EXPECT_NEAR(off, 0.0, 0.6) << meridian.code;
      }
    }
    for (const AtlasPoint& point : atlas.points()) {
      if (meridian_code(point.code) != meridian.code) continue;
      for (const auto& line : meridian.lines) {
        if (std::any_of(line.begin(), line.end(), [&](const Vec3& p) { return (p - point.place).norm() < 0.01; })) {
          ++through;
          break;
        }
      }
    }
  }
  EXPECT_EQ(through, 361u);
}

}  // namespace
}  // namespace bodkin_test
