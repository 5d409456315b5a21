#include "imaging/ultrasound/probe.h"

#include <limits>

#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

UltrasoundProbe curved() {
  return {.name = "C", .kind = ProbeKind::curvilinear, .pitch = 0.45, .radius = 60.0};
}

UltrasoundProbe sectored() {
  return {.name = "P", .kind = ProbeKind::phased, .elements = 64, .sector = 90.0};
}

// check() for a linear probe with one field changed.
template <typename Value>
std::string refused_probe(Value UltrasoundProbe::*field, Value value, UltrasoundProbe probe = {.name = "L"}) {
  probe.*field = value;
  return refusal([&probe] { check(probe, "here"); });
}

TEST(Probe, one_of_each_kind_exists) {
  for (const UltrasoundProbe& probe : {UltrasoundProbe{.name = "L"}, curved(), sectored()})
    EXPECT_NO_THROW(check(probe, "here"));
  EXPECT_NEAR(UltrasoundProbe{.elements = 128}.aperture(), 38.4, 1e-12);
}

TEST(Probe, what_could_not_exist_is_refused_with_field_found_and_expected) {
  using P = UltrasoundProbe;
  EXPECT_EQ(refused_probe(&P::frequency, 31.0), "here: probe 'L': frequency_MHz is 31 MHz, expected 1 to 30 MHz");
  EXPECT_EQ(refused_probe(&P::frequency, no_number),
            "here: probe 'L': frequency_MHz is nan MHz, expected 1 to 30 MHz");
  EXPECT_EQ(refused_probe(&P::lowest, 5.5),
            "here: probe 'L': lowest_MHz is 5.5 MHz, expected at most the frequency_MHz of 5 MHz");
  EXPECT_EQ(refused_probe(&P::highest, 4.5),
            "here: probe 'L': frequency_MHz is 5 MHz, expected at most the highest_MHz of 4.5 MHz");
  EXPECT_EQ(refused_probe(&P::elements, 15), "here: probe 'L': elements is 15, expected 16 to 1024");
  EXPECT_EQ(refused_probe(&P::pitch, 0.01), "here: probe 'L': pitch_mm is 0.01 mm, expected 0.02 to 2 mm");
  EXPECT_EQ(refused_probe(&P::height, 31.0), "here: probe 'L': height_mm is 31 mm, expected 0.5 to 30 mm");
  EXPECT_EQ(refused_probe(&P::lens, no_number), "here: probe 'L': lens_mm is nan mm, expected 5 to 300 mm");
  EXPECT_EQ(refused_probe(&P::cycles, 0.0), "here: probe 'L': cycles is 0 periods, expected 0.5 to 10 periods");
  EXPECT_EQ(refused_probe(&P::depth, 401.0), "here: probe 'L': depth_mm is 401 mm, expected 10 to 400 mm");
  EXPECT_EQ(refused_probe(&P::name, std::string()),
            "here: probe '': name is empty, expected what people call it, such as C5-2");
}

TEST(Probe, radius_and_sector_belong_to_kinds) {
  using P = UltrasoundProbe;
  EXPECT_EQ(
      refused_probe(&P::radius, 60.0),
      "here: probe 'L': radius_mm is 60 mm, expected 0 of a linear probe; leave it out, it belongs to curvilinear "
      "probes");
  EXPECT_EQ(refused_probe(&P::sector, 90.0, curved()),
            "here: probe 'C': sector_deg is 90 deg, expected 0 of a curvilinear probe; leave it out, it belongs to "
            "phased probes");
  EXPECT_EQ(refused_probe(&P::radius, no_number, sectored()),
            "here: probe 'P': radius_mm is nan mm, expected 0 to 200 mm");
  EXPECT_EQ(refused_probe(&P::radius, 0.0, curved()), "here: probe 'C': radius_mm is 0 mm, expected 5 to 200 mm");
  EXPECT_EQ(refused_probe(&P::sector, 0.0, sectored()),
            "here: probe 'P': sector_deg is 0 deg, expected 10 to 120 deg");
  EXPECT_THAT(refused_probe(&P::radius, 15.0, curved()), ::testing::HasSubstr("expected at most 180"));
}

TEST(ProbePose, axes_are_the_marked_side_the_depth_and_the_slice) {
  const Vec3 face(1.0, 2.0, 3.0), depth(0.0, -2.0, 0.0), marked(5.0, 4.0, 0.0);
  const Pose pose = probe_pose(face, depth, marked);
  EXPECT_TRUE(pose.translation().isApprox(face));
  EXPECT_TRUE(pose.linear().col(0).isApprox(Vec3::UnitX()));
  EXPECT_TRUE(pose.linear().col(1).isApprox(-Vec3::UnitY()));
  EXPECT_TRUE(pose.linear().col(2).isApprox(-Vec3::UnitZ()));
  EXPECT_NEAR(pose.linear().determinant(), 1.0, 1e-12);
}

TEST(ProbePose, directions_that_give_no_pose_are_refused) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), zero = Vec3::Zero();
  EXPECT_EQ(
      refusal([&] { probe_pose(zero, zero, x); }),
      "the probe's direction of view is (0, 0, 0), expected a direction of finite length that is not zero; give "
      "three numbers such as 0 1 0");
  EXPECT_EQ(refusal([&] { probe_pose(zero, y, Vec3(no_number, 0.0, 1.0)); }),
            "the probe's marked side is (nan, 0, 1), expected a direction of finite length that is not zero; give "
            "three numbers such as 0 1 0");
  EXPECT_EQ(refusal([&] { probe_pose(zero, y, -3.0 * y); }),
            "the probe's marked side (0, -3, 0) is parallel to its direction of view (0, 1, 0), expected one across "
            "the other; turn either of them");
  EXPECT_EQ(refusal([&] { probe_pose(Vec3(0.0, no_number, 0.0), y, x); }),
            "the middle of the probe's face is (0, nan, 0), expected three finite numbers; give its place in the "
            "patient in mm");
}

}  // namespace
}  // namespace bodkin
