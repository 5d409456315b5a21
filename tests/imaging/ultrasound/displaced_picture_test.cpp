// Displaced tissue: the image moves with it.
#include "tests/imaging/ultrasound/hand_made_patient.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

std::shared_ptr<AcousticVolume> patient_of_balls() {
  AcousticTissue soft = checks::clear_medium(1.63, 0.5), dark = checks::clear_medium(1.6, 0.4);
  soft.echo = -25.0;
  dark.echo = -45.0;
  return checks::hand_made({.half_width = 32.0, .depth = 60.0, .half_thickness = 12.0}, {soft, dark},
                           [](const Vec3& p) {
                             const Vec3 cell(std::remainder(p.x(), 13.0), std::remainder(p.y(), 13.0), p.z());
                             return p.y() > 4.0 && cell.head<2>().norm() < 4.0 ? 2 : 1;
                           });
}

UltrasoundDetail displaced_detail() {
  UltrasoundDetail detail = checks::plain_detail(50.0);
  detail.speckle = true;
  detail.slices = 3;
  return detail;
}

// Mean difference in grey levels, of pixels that are `columns` apart.
double difference(const UltrasoundFrame& a, const UltrasoundFrame& b, int columns = 0) {
  double sum = 0.0;
  int count = 0;
  for (int row = 0; row < a.height; ++row) {
    for (int column = 16; column + columns + 16 < a.width; ++column, ++count) {
      const auto at = static_cast<std::size_t>(row * a.width + column);
      sum += std::abs(a.pixels[at] - b.pixels[at + static_cast<std::size_t>(columns)]);
    }
  }
  return sum / count;
}

// The same for all points.
ScanDisplacement uniform(const Vec3& u, std::vector<float>& moved) {
  moved.clear();
  for (int point = 0; point < 6; ++point)
    for (int axis = 0; axis < 3; ++axis) moved.push_back(static_cast<float>(u[axis]));
  return {Vec3(-15.0, 5.0, 0.0), 20.0, 3, 2, moved};
}

TEST(DisplacedPicture, patient_and_probe_moved_alike_show_the_same) {
  Ultrasound machine(patient_of_balls(), checks::flat_probe(), {.depth = 50.0}, displaced_detail());
  const Vec3 u(3.0, 5.0, -2.0);
  std::vector<float> moved;
  const Pose place = checks::moved_to(Vec3(1.0, 0.0, 0.5));
  const UltrasoundFrame rest = machine.image(place);
  const UltrasoundFrame with = machine.image(checks::moved_to(Vec3(1.0, 0.0, 0.5) + u), {}, uniform(u, moved));
  ASSERT_EQ(with.why, NoImage::none);
  EXPECT_LT(difference(rest, with), 0.5);
  EXPECT_GT(difference(rest, machine.image(checks::moved_to(Vec3(1.0, 0.0, 0.5) + u))), 5.0);
}

TEST(DisplacedPicture, five_millimetres_are_five_millimetres) {
  Ultrasound machine(patient_of_balls(), checks::flat_probe(), {.depth = 50.0}, displaced_detail());
  const UltrasoundFrame rest = machine.image(Pose::Identity());
  std::vector<float> moved;
  const UltrasoundFrame aside = machine.image(Pose::Identity(), {}, uniform(Vec3(5.0, 0.0, 0.0), moved));
  EXPECT_LT(difference(rest, aside, 20), 0.5);
  EXPECT_GT(difference(rest, aside), 5.0);
}

// Displacements are along the patient's axes, for any orientation of the probe.
TEST(DisplacedPicture, displacements_are_the_patients) {
  const auto volume = checks::hand_made({.half_width = 26.0, .half_thickness = 26.0, .voxel = 0.5},
                                        {checks::clear_medium(), checks::clear_medium(1.9)},
                                        [](const Vec3& p) { return p.y() > 25.0 && std::abs(p.z()) < 2.2 ? 2 : 1; });
  Ultrasound machine(volume, checks::flat_probe(), {.depth = 50.0}, checks::plain_detail(50.0));
  const Pose turned = probe_pose(Vec3::Zero(), Vec3::UnitY(), Vec3::UnitZ());
  const auto middle_of_bar = [](const UltrasoundFrame& frame) {
    double sum = 0.0, weighted = 0.0;
    for (int row = 95; row < 110; ++row) {
      for (int column = 0; column < frame.width; ++column) {
        const double grey = frame.pixels[static_cast<std::size_t>(row * frame.width + column)];
        sum += grey;
        weighted += grey * column;
      }
    }
    return frame.corner.x() + frame.pixel * weighted / sum;
  };
  EXPECT_NEAR(middle_of_bar(machine.image(turned)), 0.0, 0.1);
  std::vector<float> moved;
  EXPECT_NEAR(middle_of_bar(machine.image(turned, {}, uniform(Vec3(0.0, 0.0, 5.0), moved))), 5.0, 0.1);
  EXPECT_NEAR(middle_of_bar(machine.image(turned, {}, uniform(Vec3(5.0, 0.0, 0.0), moved))), 0.0, 0.1);
}

// A growing field: half way between two of its points the displacement is the mean.
TEST(DisplacedPicture, between_its_points_a_field_is_linear) {
  const auto volume = checks::hand_made({.half_width = 22.0, .half_thickness = 1.0, .voxel = 0.25},
                                        {checks::clear_medium(), checks::clear_medium(1.8)},
                                        [](const Vec3& p) { return p.y() < 20.0 ? 1 : 2; });
  Ultrasound machine(volume, checks::flat_probe(), {.depth = 50.0}, checks::plain_detail(50.0));
  // u_y = 0 at the face and 10 mm at 50 mm: tissue from 20 mm is at x with x - x / 5 = 20.
  std::vector<float> moved(3 * 2, 0.0F);
  moved[4] = 10.0F;
  const ScanDisplacement stretched{Vec3::Zero(), 50.0, 1, 2, moved};
  const UltrasoundFrame& frame = machine.image(Pose::Identity(), {}, stretched);
  int brightest = 0;
  for (int row = 0; row < frame.height; ++row) {
    const auto at = static_cast<std::size_t>(row * frame.width + 80);
    if (frame.pixels[at] > frame.pixels[static_cast<std::size_t>(brightest * frame.width + 80)]) brightest = row;
  }
  EXPECT_NEAR(brightest * frame.pixel, 25.0, 0.26);
}

// A face 6 mm below the skin: yielding tissue stays before it, rigid tissue is passed.
TEST(DisplacedPicture, tissue_under_a_pressed_face_yields_if_asked_to) {
  const auto volume = checks::hand_made({.half_width = 22.0, .half_thickness = 1.0, .voxel = 0.25},
                                        {checks::clear_medium(), checks::clear_medium(1.8)},
                                        [](const Vec3& p) { return p.y() < 20.0 ? 1 : 2; });
  const auto surface_at = [&](bool yielding) {
    UltrasoundDetail detail = checks::plain_detail(40.0);
    detail.yielding = yielding;
    Ultrasound machine(volume, checks::flat_probe(), {.depth = 40.0}, detail);
    const UltrasoundFrame& frame = machine.image(checks::moved_to(Vec3(0.0, 6.0, 0.0)));
    EXPECT_NEAR(frame.press, 6.0, 0.3);
    int brightest = 0;
    const auto grey = [&](int row) { return frame.pixels[static_cast<std::size_t>(row * frame.width + 80)]; };
    for (int row = 0; row < frame.height; ++row) brightest = grey(row) > grey(brightest) ? row : brightest;
    return brightest * frame.pixel;
  };
  EXPECT_NEAR(surface_at(false), 14.0, 0.5);
  EXPECT_GT(surface_at(true), 14.5);
  EXPECT_LT(surface_at(true), 20.0);
}

}  // namespace
}  // namespace bodkin
