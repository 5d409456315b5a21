// Invalid requests: a black image with the reason, or one sentence, and never a crash.
#include <array>
#include <limits>

#include "tests/imaging/ultrasound/hand_made_patient.h"
#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

using ::testing::HasSubstr;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::shared_ptr<AcousticVolume> small_patient() {
  AcousticTissue soft = checks::clear_medium(1.63, 0.5);
  soft.echo = -20.0;
  return checks::hand_made({.half_width = 30.0, .above = 20.0, .depth = 60.0, .half_thickness = 10.0, .voxel = 1.0},
                           {soft, checks::clear_medium(7.0, 10.0)},
                           [](const Vec3& p) { return (p - Vec3(4.0, 25.0, 0.0)).norm() < 8.0 ? 2 : 1; });
}

UltrasoundDetail small_detail() {
  UltrasoundDetail detail;
  detail.lines = detail.width = 48;
  detail.samples = detail.height = 64;
  return detail;
}

bool black(const UltrasoundFrame& frame) {
  return std::all_of(frame.pixels.begin(), frame.pixels.end(), [](std::uint8_t p) { return p == 0; });
}

TEST(BadInput, places_without_an_image_are_black_with_their_reason) {
  Ultrasound machine(small_patient(), checks::flat_probe(), {}, small_detail());
  const auto why = [&machine](const Vec3& point) {
    const UltrasoundFrame& frame = machine.image(checks::moved_to(point));
    EXPECT_EQ(frame.pixels.size(), 48u * 64u);
    EXPECT_EQ(black(frame), frame.why != NoImage::none);
    return frame.why;
  };
  EXPECT_EQ(why(Vec3(0.0, 0.0, 0.0)), NoImage::none);
  EXPECT_EQ(why(Vec3(0.0, -10.0, 0.0)), NoImage::no_contact);
  EXPECT_EQ(why(Vec3(0.0, 55.0, 0.0)), NoImage::inside_body);
  EXPECT_EQ(why(Vec3(200.0, 0.0, 0.0)), NoImage::outside_volume);
  EXPECT_EQ(why(Vec3(0.0, -1000.0, 0.0)), NoImage::outside_volume);
  EXPECT_EQ(why(Vec3(0.0, 1e300, 0.0)), NoImage::outside_volume);
  EXPECT_EQ(why(Vec3(nothing, 0.0, 0.0)), NoImage::broken_pose);
  EXPECT_EQ(why(Vec3(0.0, 0.0, std::numeric_limits<double>::infinity())), NoImage::broken_pose);
  // A good place after bad ones.
  EXPECT_EQ(why(Vec3(1.0, 0.0, 2.0)), NoImage::none);
  // Turned away from the skin.
  const Pose away = probe_pose(Vec3(0.0, -3.0, 0.0), -Vec3::UnitY(), Vec3::UnitX());
  EXPECT_EQ(machine.image(away).why, NoImage::no_contact);
}

TEST(BadInput, poses_that_are_not_rigid_are_no_poses) {
  Ultrasound machine(small_patient(), checks::curved_probe(), {}, small_detail());
  const auto why = [&machine](const Mat3& linear) {
    Pose pose = Pose::Identity();
    pose.linear() = linear;
    return machine.image(pose).why;
  };
  EXPECT_EQ(why(Mat3::Identity()), NoImage::none);
  EXPECT_EQ(why(2.0 * Mat3::Identity()), NoImage::broken_pose);
  EXPECT_EQ(why(Mat3::Zero()), NoImage::broken_pose);
  EXPECT_EQ(why(1e300 * Mat3::Identity()), NoImage::broken_pose);
  EXPECT_EQ(why(Mat3::Constant(nothing)), NoImage::broken_pose);
  EXPECT_EQ(why(Vec3(1.0, 1.0, -1.0).asDiagonal()), NoImage::broken_pose) << "a mirror";
}

TEST(BadInput, garbage_poses_needles_and_displacements_crash_nothing) {
  Random random(0xBAD);
  std::vector<Ultrasound> machines;
  for (const UltrasoundProbe& probe : {checks::flat_probe(), checks::curved_probe(), checks::phased_probe()})
    machines.emplace_back(small_patient(), probe, UltrasoundSettings{}, small_detail());
  const std::array<double, 8> wild = {0.0,   -0.0,   nothing, std::numeric_limits<double>::infinity(),
                                      1e300, -1e300, 1e-300,  1e10};
  const auto number = [&](double usual) {
    const double any = random.uniform();
    return any < 0.1 ? wild[random.next() % wild.size()] : random.uniform(-usual, usual);
  };
  std::vector<float> moved(3 * 5 * 4);
  int images = 0;
  for (int round = 0; round < 400; ++round) {
    const Vec3 towards(number(1.0), random.uniform() < 0.7 ? 1.0 : number(1.0), number(1.0));
    Pose pose = Pose::Identity();
    try {
      pose = probe_pose(Vec3(number(20.0), random.uniform(-3.0, 6.0), number(8.0)), towards,
                        Vec3(number(1.0), number(0.2), number(1.0)));
    } catch (const InputError&) {
      pose.translation().x() = number(20.0);
    }
    if (random.uniform() < 0.1) pose.linear()(random.next() % 3, random.next() % 3) = number(2.0);
    std::optional<NeedleInUltrasound> needle;
    if (random.uniform() < 0.5) {
      needle.emplace();
      needle->pose = needle_pose(Vec3(number(20.0), number(40.0), number(3.0)),
                                 Vec3(random.normal(), random.normal(), random.normal()));
      if (random.uniform() < 0.3) needle->pose.linear()(random.next() % 3, 2) = number(1.0);
      if (random.uniform() < 0.3) needle->needle.outer_diameter = number(2.0);
      if (random.uniform() < 0.3) needle->needle.length = number(100.0);
    }
    std::optional<ScanDisplacement> displacement;
    if (random.uniform() < 0.5) {
      for (float& u : moved) u = static_cast<float>(random.uniform(-5.0, 5.0));
      if (random.uniform() < 0.3) moved[random.next() % moved.size()] = static_cast<float>(number(1e6));
      displacement = {Vec3(number(20.0), number(5.0), 0.0), number(10.0), 5, 4, moved};
      if (random.uniform() < 0.2) displacement->columns = static_cast<int>(random.next());
      if (random.uniform() < 0.2) displacement->rows = static_cast<int>(random.next());
    }
    const UltrasoundFrame& frame =
        machines[static_cast<std::size_t>(round) % machines.size()].image(pose, needle, displacement);
    images += frame.why == NoImage::none ? 1 : 0;
    ASSERT_EQ(frame.pixels.size(), 48u * 64u);
    ASSERT_GE(frame.contact, 0.0);
    ASSERT_LE(frame.contact, 1.0);
    ASSERT_GE(frame.press, 0.0);
    ASSERT_TRUE(frame.why == NoImage::none || black(frame)) << round;
  }
  EXPECT_GT(images, 100);
}

// An invalid displacement is ignored, and the image is that at rest.
TEST(BadInput, broken_displacements_are_left_out) {
  Ultrasound machine(small_patient(), checks::flat_probe(), {}, small_detail());
  const std::vector<std::uint8_t> still = machine.image(Pose::Identity()).pixels;
  std::vector<float> moved(3 * 4, 1.0F);
  ScanDisplacement field{Vec3(-20.0, 0.0, 0.0), 40.0, 2, 2, moved};
  EXPECT_NE(machine.image(Pose::Identity(), {}, field).pixels, still);
  const auto unchanged = [&](const ScanDisplacement& broken) {
    return machine.image(Pose::Identity(), {}, broken).pixels == still;
  };
  moved[7] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(unchanged(field));
  moved[7] = 1e9F;
  EXPECT_TRUE(unchanged(field));
  moved[7] = 1.0F;
  field.columns = 3;
  EXPECT_TRUE(unchanged(field));
  field.columns = 0;
  EXPECT_TRUE(unchanged(field));
  field.columns = 2;
  field.spacing = nothing;
  EXPECT_TRUE(unchanged(field));
}

TEST(BadInput, impossible_probes_settings_and_details_are_refused_and_change_nothing) {
  const auto patient = small_patient();
  const auto made = [&](const auto& change) {
    UltrasoundProbe probe = checks::flat_probe();
    UltrasoundSettings settings;
    UltrasoundDetail detail = small_detail();
    change(probe, settings, detail);
    return refusal([&] { Ultrasound(patient, probe, settings, detail); });
  };
  using P = UltrasoundProbe;
  for (double P::*field : {&P::frequency, &P::lowest, &P::highest, &P::pitch, &P::radius, &P::sector, &P::height,
                           &P::lens, &P::cycles, &P::depth}) {
    for (const double value : {nothing, -1.0, 1e9})
      EXPECT_THAT(made([&](P& probe, auto&, auto&) { probe.*field = value; }), HasSubstr("the probe: probe 'L': "));
  }
  EXPECT_THAT(made([](P& probe, auto&, auto&) { probe.elements = 0; }), HasSubstr("elements is 0"));
  EXPECT_THAT(made([](auto&, auto& settings, auto&) { settings.depth = nothing; }), HasSubstr("depth_mm is nan"));
  EXPECT_THAT(made([](auto&, auto&, auto& detail) { detail.slices = 4; }), HasSubstr("slices is an even number"));

  Ultrasound machine(patient, checks::flat_probe(), {}, small_detail());
  const std::vector<std::uint8_t> before = machine.image(Pose::Identity()).pixels;
  using S = UltrasoundSettings;
  for (double S::*field : {&S::depth, &S::gain, &S::dynamic_range, &S::focus, &S::frequency}) {
    UltrasoundSettings settings;
    settings.*field = nothing;
    EXPECT_THROW(machine.set(settings), InputError);
  }
  EXPECT_EQ(machine.settings().depth, UltrasoundSettings{}.depth);
  EXPECT_EQ(machine.image(Pose::Identity()).pixels, before);
}

TEST(BadInput, patients_that_cannot_be_walked_through_are_refused) {
  const auto made = [](std::shared_ptr<AcousticVolume> patient) {
    return refusal([&] { Ultrasound(std::move(patient), checks::flat_probe(), {}, small_detail()); });
  };
  EXPECT_THAT(made(nullptr), HasSubstr("ultrasound has no patient"));
  EXPECT_THAT(made(std::make_shared<AcousticVolume>()), HasSubstr("0 x 0 x 0 voxels"));
  auto thin = small_patient();
  thin->grid.size = {thin->grid.size[0] * thin->grid.size[1], 1, thin->grid.size[2]};
  EXPECT_THAT(made(thin), HasSubstr("expected at least two along each axis"));
  auto bare = small_patient();
  bare->voxels.clear();
  EXPECT_THAT(made(bare), HasSubstr("the acoustic volume has 0 voxels, expected "));
}

}  // namespace
}  // namespace bodkin
