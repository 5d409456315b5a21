// Left needles in an ultrasound image: they move with their tissue.
#include <cmath>

#include "study/deformation_picture.h"
#include "tests/station/seen_block.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using namespace bodkin::imaging;
using namespace bodkin::station;
using namespace bodkin::study;
namespace {

// Next to the path, in the slice of a probe on the skin at z = 5.
const NeedlePath left_beside{Vec3(0.0, 0.0, 12.0), Vec3(0.0, -24.0, 6.0)};

// The pose, by definition, of a needle whose tissue moves like this.
Pose with_tissue(const std::vector<Vec3>& points, const std::vector<float>& moved, double length) {
  std::vector<Vec3> places = points;
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] += Eigen::Map<const Eigen::Vector3f>(moved.data() + 3 * i).cast<double>();
  return rigid_needle(places, length);
}

TEST(LeftNeedlesInSound, one_is_dragged_by_the_one_in_the_hand) {
  SeenThread seen;
  ScanBody body{seen.block.body, std::make_unique<NodeField>(seen.elastic, *seen.block.body,
                                                             *seen.block.patient.description.procedure.path)};
  body.left = LeftNeedleMotion({left_beside});
  const std::vector<Vec3> points = body.left.points();
  ScanThread thread(seen.block.sounding, seen.machine(), Needle(), std::move(body), {on_skin(0.0, 5.0), shallow()},
                    200.0);
  const LiveImage* picture = picture_where(thread, [](const LiveImage& now) { return !now.left.empty(); });
  ASSERT_NE(picture, nullptr);
  EXPECT_LT((picture->left[0].translation() - left_beside.target).norm(), 1e-5) << "nothing moves yet";
  Ultrasound machine = seen.machine();
  const NeedleInUltrasound at_rest{needle_pose(left_beside.target, left_beside.direction()), Needle()};
  EXPECT_GT(mean_difference(picture->frame, machine.image(picture->setup.probe)), 0.5) << "it is in the picture";

  const NodeForces forces = forces_on(seen.elastic, seen.block);
  thread.set_needle(forces, straight_in);
  picture = picture_where(thread, [](const LiveImage& now) { return now.most > 0.0; });
  ASSERT_NE(picture, nullptr);
  const Pose expected = with_tissue(points, displacements_at(*seen.block.body, forces, points), left_beside.length());
  EXPECT_LT((picture->left[0].translation() - expected.translation()).norm(), 1e-3);
  EXPECT_LT((needle_axis(picture->left[0]) - needle_axis(expected)).norm(), 1e-4);
  EXPECT_GT((expected.translation() - left_beside.target).norm(), 0.3) << "it is dragged";
  ScanDisplacement displacement = picture->grid;
  displacement.moved = picture->moved;
  const NeedleInUltrasound hand{straight_in, Needle()}, dragged{picture->left[0], Needle()};
  EXPECT_EQ(machine.image(picture->setup.probe, hand, displacement, {&dragged, 1}).pixels, picture->frame.pixels);
  EXPECT_NE(machine.image(picture->setup.probe, hand, displacement, {&at_rest, 1}).pixels, picture->frame.pixels);
}

TEST(LeftNeedlesInSound, one_goes_with_a_moving_body_and_with_breath) {
  SeenThread seen;
  Breathing breathing;
  breathing.motion = Vec3(0.0, 0.0, -6.0);
  breathing.radius = 1e5;  // the whole body
  ScanBody body{seen.block.body, nullptr, true, BreathField(breathing)};
  body.left = LeftNeedleMotion({left_beside}, body.breath);
  ScanThread thread(seen.block.sounding, seen.machine(), Needle(), std::move(body), {on_skin(0.0, 0.0), shallow()},
                    200.0);
  std::vector<float> nodes;
  for (std::size_t node = 0; node < seen.block.body->mesh.nodes.size(); ++node)
    nodes.insert(nodes.end(), {0.5F, -2.0F, 1.0F});
  thread.set_displacements(nodes);
  thread.set_needle({}, straight_in, 0.5);
  const Vec3 expected = left_beside.target + Vec3(0.5, -2.0, 1.0) + Vec3(0.0, 0.0, -3.0);
  const LiveImage* const picture = picture_where(thread, [&](const LiveImage& now) {
    return !now.left.empty() && (now.left[0].translation() - expected).norm() < 1e-3;
  });
  ASSERT_NE(picture, nullptr);
  EXPECT_LT((needle_axis(picture->left[0]) - left_beside.direction()).norm(), 1e-5);
}

// Also for a patient without a mesh, where only the simulated ultrasound machine knows what the probe presses.
TEST(LeftNeedlesInSound, one_goes_down_under_a_pressed_probe) {
  SeenThread seen;
  const NeedlePath shallow_one{Vec3(0.0, -4.0, 10.0), Vec3(0.0, -8.0, -10.0)};
  for (const double press : {0.0, 4.0}) {
    ScanBody body;
    body.left = LeftNeedleMotion({shallow_one});
    ScanThread thread(seen.block.sounding, seen.machine(), Needle(), std::move(body),
                      {on_skin(0.0, 0.0, press), shallow()}, 200.0);
    const LiveImage* const picture = picture_where(thread, [](const LiveImage& now) { return !now.left.empty(); });
    ASSERT_NE(picture, nullptr);
    EXPECT_EQ(picture->grid.columns, 0) << "the machine moves the tissue by itself";
    const double down = shallow_one.target.y() - picture->left[0].translation().y();
    EXPECT_GE(down, 0.4 * press - 0.3);
    EXPECT_LE(down, press + 0.3);
  }
}

}  // namespace
}  // namespace bodkin
