#include "patient/from_ct/dense_pieces.h"

#include <functional>

#include "patient/from_ct/patient_builder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Tissue as dense as bone but not bone, in a body with known contents.

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::patient;
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

// A block of muscle, 200 x 200 x 100 mm in air, with a column of bone along z behind its middle and what `content`
// adds: HU at a place, or nothing.
CtVolume body_with(const std::function<std::optional<int>(const Vec3&)>& content) {
  Grid grid;
  grid.size = {120, 120, 50};
  grid.spacing = Vec3(2, 2, 2);
  CtVolume ct(grid, -1000);
  for (int k = 0; k < 50; ++k) {
    for (int j = 0; j < 120; ++j) {
      for (int i = 0; i < 120; ++i) {
        const Vec3 p = grid.to_patient(Vec3(i, j, k));
        if (p.x() < 20 || p.x() > 220 || p.y() < 20 || p.y() > 220) continue;
        const double from_bone = std::hypot(p.x() - 120, p.y() - 150);
        int value = 40;
        if (from_bone < 20) value = from_bone < 16 ? 250 : 800;
        if (const auto added = content(p)) value = *added;
        ct.at(i, j, k) = static_cast<std::int16_t>(value);
      }
    }
  }
  return ct;
}

BuiltPatient built(const CtVolume& ct) {
  PatientOptions options;
  options.construct_lumbar = false;
  return build_patient(ct, {}, {}, options, {});
}

bool is_dense(TissueId id) {
  return id == tissue::cortical_bone || id == tissue::cancellous_bone;
}

TEST(DensePieces, an_enhanced_vessel_is_a_vessel_and_the_column_beside_it_bone) {
  const Vec3 vessel(120, 105, 50);  // its wall 10 mm in front of the bone
  const CtVolume ct = body_with([&](const Vec3& p) {
    return std::hypot(p.x() - vessel.x(), p.y() - vessel.y()) < 14 ? std::optional(320) : std::nullopt;
  });
  const BuiltPatient patient = built(ct);
  EXPECT_EQ(nearest(patient.tissues, vessel, tissue::air), tissue::vessel);
  EXPECT_TRUE(is_dense(nearest(patient.tissues, Vec3(120, 150, 50), tissue::air)));
  EXPECT_THAT(patient.notes, Contains(HasSubstr("Contrast deep in the body")));
}

TEST(DensePieces, a_stone_and_a_speck_are_soft_and_told) {
  const Vec3 stone(80, 100, 50), speck(150, 90, 50);
  const CtVolume ct = body_with([&](const Vec3& p) -> std::optional<int> {
    if ((p - stone).norm() < 5) return 900;
    if ((p - speck).norm() < 0.5) return 1500;
    return std::nullopt;
  });
  const BuiltPatient patient = built(ct);
  EXPECT_EQ(nearest(patient.tissues, stone, tissue::air), tissue::soft);
  EXPECT_EQ(nearest(patient.tissues, speck, tissue::air), tissue::soft);
  EXPECT_THAT(patient.notes, Contains(HasSubstr("Stones or calcifications")));
  EXPECT_THAT(patient.notes, Contains(HasSubstr("Specks as dense as bone (pieces: 1")));
}

TEST(DensePieces, bone_apart_from_the_skeleton_stays_bone) {
  const CtVolume ct = body_with([&](const Vec3& p) -> std::optional<int> {
    const double rib = std::hypot(p.x() - 40, p.y() - 120);  // near the skin
    if (rib < 6) return rib < 3 ? 200 : 600;
    const double hip = std::hypot(p.x() - 120, p.y() - 90);  // deep, but with a shell as bone has
    if (hip < 14) return hip < 10 ? 220 : 900;
    return std::nullopt;
  });
  const BuiltPatient patient = built(ct);
  EXPECT_TRUE(is_dense(nearest(patient.tissues, Vec3(44, 120, 50), tissue::air)));
  EXPECT_TRUE(is_dense(nearest(patient.tissues, Vec3(132, 90, 50), tissue::air)));
  EXPECT_THAT(patient.notes, Not(Contains(HasSubstr("taken for"))));
}

// An aorta of 28 mm that lies on the column, as on a spine, so that the two are one piece of dense voxels.
TEST(DensePieces, an_enhanced_vessel_that_touches_bone_is_a_vessel_and_the_bone_bone) {
  const Vec3 vessel(120, 117, 50);  // its wall 1 mm within the bone's
  const CtVolume ct = body_with([&](const Vec3& p) -> std::optional<int> {
    if (std::hypot(p.x() - 120, p.y() - 150) < 20) return std::nullopt;
    return std::hypot(p.x() - vessel.x(), p.y() - vessel.y()) < 14 ? std::optional(320) : std::nullopt;
  });
  const BuiltPatient patient = built(ct);
  for (const double z : {10.0, 50.0, 90.0}) {
    for (const double along : {-9.0, 0.0, 9.0}) {
      EXPECT_EQ(nearest(patient.tissues, Vec3(120 + along, vessel.y(), z), tissue::air), tissue::vessel);
      EXPECT_EQ(nearest(patient.tissues, Vec3(120, vessel.y() + along, z), tissue::air), tissue::vessel);
    }
    for (const double y : {133.0, 150.0, 167.0})
      EXPECT_TRUE(is_dense(nearest(patient.tissues, Vec3(120, y, z), tissue::air))) << y;
  }
  EXPECT_THAT(patient.notes, Contains(HasSubstr("Contrast that touches bone")));
}

// A vertebral body with dense marrow as bright as contrast, including its thin cortex, remains bone.
TEST(DensePieces, dense_marrow_in_a_shell_or_in_a_short_block_stays_bone) {
  const CtVolume ct = body_with([&](const Vec3& p) -> std::optional<int> {
    const double off = std::max(std::abs(p.x() - 80), std::abs(p.y() - 110));
    if (p.z() > 25 && p.z() < 55 && off < 17) return 300;       // a short block without any shell
    const double shaft = std::hypot(p.x() - 120, p.y() - 110);  // long, with a shell, on the column
    if (shaft < 14) return shaft < 11 ? 280 : 600;
    return std::nullopt;
  });
  const BuiltPatient patient = built(ct);
  EXPECT_TRUE(is_dense(nearest(patient.tissues, Vec3(120, 110, 50), tissue::air)));
  EXPECT_TRUE(is_dense(nearest(patient.tissues, Vec3(120, 100, 50), tissue::air)));
  EXPECT_THAT(patient.notes, Not(Contains(HasSubstr("Contrast that touches bone"))));
}

}  // namespace
}  // namespace bodkin
