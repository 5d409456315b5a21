// Bodies of experiments as cases for any device.
#include "study/phantom.h"

#include <cmath>

#include "study/profile.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/case_folder.h"

namespace bodkin::study {
namespace {

namespace fs = std::filesystem;

class Phantom : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / fmt_name();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  static std::string fmt_name() {
    return std::string("phantom_") + testing::UnitTest::GetInstance()->current_test_info()->name();
  }
  fs::path folder_;
};

// A hemisphere of 30 mm whose three shells of 10 mm resist with 1, 3 and 2 N once their springs of 1 N/mm are taut.
io::Experiment half_ball(const std::string& motion) {
  return io::parse_experiment(R"(<?xml version="1.0" encoding="UTF-8"?>
<experiment version="1" name="half_ball" title="Half ball">
  <caption><reproduces>-</reproduces><parameters>-</parameters><agrees>-</agrees><differs>-</differs></caption>
  <changed_tissues>
    <changed name="outer" like="muscle" title="outer" colour="#F4B6C2"><tracking_wall stiffness_N_per_mm="1" force_N="1"/></changed>
    <changed name="middle" like="muscle" title="middle" colour="#F2D65C"><tracking_wall stiffness_N_per_mm="1" force_N="3"/></changed>
    <changed name="inner" like="muscle" title="inner" colour="#E6B08F"><tracking_wall stiffness_N_per_mm="1" force_N="2"/></changed>
  </changed_tissues>
  <body>
    <hemisphere radius_mm="30" voxel_mm="0.5">
      <tissue_layer tissue="outer" thickness_mm="10"/>
      <tissue_layer tissue="middle" thickness_mm="10"/>
      <tissue_layer tissue="inner" thickness_mm="10"/>
    </hemisphere>
  </body>
  <device profile="strong" peak_force_N="10" continuous_force_N="5"/>
  <haptics><resistance><tracking_wall/></resistance><constraint><line_spring/></constraint></haptics>
  )" + motion + R"(
  <plot><panel><curve quantity="resistance_N"/></panel></plot>
</experiment>)",
                              "half_ball.xml");
}

constexpr const char* straight_in = R"(<motion from_mm="-10"><move depth_mm="28" speed_mm_per_s="10"/></motion>)";

TEST_F(Phantom, a_half_ball_becomes_a_sound_case_with_the_force_of_each_layer) {
  const fs::path made = folder_ / "case";
  const anatomy::CaseDescription said = write_phantom(half_ball(straight_in), {made, false, "mine"});
  EXPECT_EQ(said.name, "mine");
  EXPECT_THAT(io::check_case(made), testing::IsEmpty());
  const anatomy::Case patient = io::load_case(made);
  const anatomy::NeedlePath& path = *patient.description.procedure.path;
  // In a prone patient, depth increases towards the front.
  EXPECT_LT((path.direction() + Vec3::UnitY()).norm(), 1e-12);
  EXPECT_NEAR(path.length(), 28.0, 0.5);
  EXPECT_GT(patient.description.needle.length, 28.0);
  const Profile profile = insert_at_constant_speed(patient, {});
  // Behind each wall's ramp and up to half a voxel before the next border the force is that of the layer.
  for (const simulation::TickRecord& tick : profile.ticks) {
    const double depth = tick.output.depth;
    if (depth > 2.0 && depth < 9.0) {
      EXPECT_NEAR(tick.output.resistance, 1.0, 0.01) << depth;
    }
    if (depth > 14.0 && depth < 19.0) {
      EXPECT_NEAR(tick.output.resistance, 3.0, 0.01) << depth;
    }
    if (depth > 22.0 && depth < 28.0) {
      EXPECT_NEAR(tick.output.resistance, 2.0, 0.01) << depth;
    }
  }
  EXPECT_GT(profile.ticks.back().output.depth, 26.0);
}

TEST_F(Phantom, every_voxel_is_where_the_experiment_has_it) {
  write_phantom(half_ball(straight_in), {folder_ / "case"});
  const anatomy::Case patient = io::load_case(folder_ / "case");
  for (const double x : {-11.0, 0.0, 7.0}) {
    for (const double z : {-20.0, 3.0}) {
      for (double depth = 0.3; depth < 29.5; depth += 1.0) {
        const double inside = 30.0 - Vec3(x, depth - 30.0, z).norm();  // depth in the shells, from outside
        if (std::abs(inside) < 0.6 || std::abs(inside - 10.0) < 0.6 || std::abs(inside - 20.0) < 0.6) continue;
        const anatomy::TissueId id =
            anatomy::nearest<anatomy::TissueId>(patient.tissues, Vec3(x, -depth, z), anatomy::tissue::air);
        const std::string_view expected = inside < 0.0    ? ""
                                          : inside < 10.0 ? "outer"
                                          : inside < 20.0 ? "middle"
                                                          : "inner";
        const anatomy::TissueProperties* const found = patient.library.find(id);
        EXPECT_EQ(id == anatomy::tissue::air ? "" : found->name, expected) << x << " " << depth << " " << z;
      }
    }
  }
}

TEST_F(Phantom, a_motion_that_stays_outside_is_refused_and_leaves_nothing) {
  const io::Experiment outside =
      half_ball(R"(<motion from_mm="-20"><move depth_mm="-5" speed_mm_per_s="10"/></motion>)");
  try {
    write_phantom(outside, {folder_ / "case"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("never enters the body"));
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(Phantom, every_published_experiment_can_be_felt) {
  for (const fs::path& file : io::shipped_experiments()) {
    const fs::path made = folder_ / file.stem();
    write_phantom(io::read_experiment(file), {made});
    EXPECT_THAT(io::check_case(made), testing::IsEmpty()) << file;
    fs::remove_all(made);
  }
}

}  // namespace
}  // namespace bodkin::study
