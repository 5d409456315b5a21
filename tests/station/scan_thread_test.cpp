// The image of a probe next to a held needle, with the displaced tissue: compared with displacements solved for the
// whole body at once, and with images computed one by one.
#include "station/scan_thread.h"

#include <chrono>
#include <cmath>
#include <thread>

#include "study/deformation_picture.h"
#include "tests/sanitized.h"
#include "tests/station/seen_block.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "imaging/warped_slice.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using namespace bodkin::imaging;
using namespace bodkin::io;
using namespace bodkin::station;
using namespace bodkin::study;
namespace {

SlicePlane grid_of(const LiveImage& picture) {
  SlicePlane grid;
  grid.corner = picture.setup.probe * picture.grid.corner;
  grid.right = picture.setup.probe.linear().col(0);
  grid.down = picture.setup.probe.linear().col(1);
  grid.pixel = picture.grid.spacing;
  grid.width = picture.grid.columns;
  grid.height = picture.grid.rows;
  return grid;
}

void expect_field_of(const SeenThread& seen, const LiveImage& picture, const NodeForces& forces) {
  const SlicePlane grid = grid_of(picture);
  const std::vector<float> expected =
      displacements_of_places(grid, displacements_at(*seen.block.body, forces, points_of(grid)));
  ASSERT_EQ(picture.moved.size(), expected.size());
  double most = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_NEAR(static_cast<double>(picture.moved[i]), static_cast<double>(expected[i]), 1e-4) << i;
    most = std::max(most, std::abs(static_cast<double>(expected[i])));
  }
  EXPECT_GT(most, 0.5);
  EXPECT_GE(picture.most, most);
  EXPECT_LT(picture.most, 2.0 * most);
}

TEST(ScanThread, what_moves_the_picture_is_the_field_of_the_forces) {
  SeenThread seen;
  const auto thread = seen.start(on_skin(0.0, 5.0));
  const NodeForces forces = forces_on(seen.elastic, seen.block);
  ASSERT_EQ(forces.count, 3U);
  thread->set_needle(forces, straight_in);
  const LiveImage* const picture = picture_where(*thread, [](const LiveImage& now) { return now.most > 0.0; });
  ASSERT_NE(picture, nullptr);
  expect_field_of(seen, *picture, forces);
  EXPECT_EQ(picture->left_out, 0.0);
  // The simulated ultrasound machine gives the same image for this displacement.
  Ultrasound machine = seen.machine();
  ScanDisplacement displacement = picture->grid;
  displacement.moved = picture->moved;
  const NeedleInUltrasound needle{straight_in, Needle()};
  EXPECT_EQ(machine.image(picture->setup.probe, needle, displacement).pixels, picture->frame.pixels);
  EXPECT_NE(machine.image(picture->setup.probe, needle).pixels, picture->frame.pixels);
}

TEST(ScanThread, a_probe_that_moves_sees_the_body_where_it_is) {
  SeenThread seen;
  const auto thread = seen.start(on_skin(0.0, 5.0));
  const NodeForces forces = forces_on(seen.elastic, seen.block);
  thread->set_needle(forces, straight_in);
  UltrasoundSettings deeper = shallow();
  deeper.depth = 30.0;
  Pose tilted = on_skin(4.0, -3.0);
  tilted.rotate(Eigen::AngleAxisd(0.3, Vec3::UnitX()) * Eigen::AngleAxisd(0.5, Vec3::UnitY()));
  thread->set_setup({tilted, deeper});
  const LiveImage* const picture = picture_where(*thread, [&](const LiveImage& now) {
    return now.most > 0.0 && now.setup.settings.depth == 30.0 && now.setup.probe.matrix() == tilted.matrix();
  });
  ASSERT_NE(picture, nullptr);
  expect_field_of(seen, *picture, forces);
  // 45 mm before; at least the length of the array, because the image is square.
  EXPECT_LT(picture->grid.spacing * (picture->grid.rows - 1), 42.0);
}

TEST(ScanThread, settings_that_cannot_be_leave_the_last_ones) {
  SeenThread seen;
  const auto thread = seen.start(on_skin(0.0, 5.0));
  UltrasoundSettings wrong = shallow();
  wrong.gain = 1000.0;
  thread->set_setup({on_skin(0.0, 5.0), wrong});
  const LiveImage* const picture = picture_where(*thread, [](const LiveImage& now) { return now.refused; });
  ASSERT_NE(picture, nullptr);
  EXPECT_EQ(picture->setup.settings, shallow());
  EXPECT_EQ(picture->frame.why, NoImage::none);
}

// Forces and needle are published together: the field grows with the depth of the needle in the image.
TEST(ScanThread, every_picture_is_of_one_tick_and_the_tick_never_waits) {
  SeenThread seen;
  const auto thread = seen.start(on_skin(0.0, 5.0), 1000.0);
  const NodeForces unit = forces_on(seen.elastic, seen.block, 0.1F);
  thread->set_needle(unit, needle_pose(Vec3(0.0, -1.0, 0.0), -Vec3::UnitY()));
  const LiveImage* const first = picture_where(*thread, [](const LiveImage& now) { return now.most > 0.0; });
  ASSERT_NE(first, nullptr);
  const double most = first->most;
  std::jthread tick([&](const std::stop_token& stop) {
    for (int round = 0; !stop.stop_requested(); ++round) {
      const int depth = 1 + round % 4;
      thread->set_needle(forces_on(seen.elastic, seen.block, 0.1F * static_cast<float>(depth)),
                         needle_pose(Vec3(0.0, -depth, 0.0), -Vec3::UnitY()));
    }
  });
  std::uint64_t last = 0;
  for (int pictures = 0; pictures < (sanitized ? 5 : 60);) {
    const LiveImage& now = thread->picture();
    ASSERT_GE(now.number, last);
    if (now.number > last) {
      ++pictures;
      ASSERT_TRUE(now.needle);
      // In the plane of a small displacement the field is linear in the forces, except for where it is sampled.
      ASSERT_NEAR(now.most / most, -now.needle->translation().y(), 0.35);
    }
    last = now.number;
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
}

TEST(ScanThread, keeps_up) {
  SeenThread seen;
  const auto thread = seen.start(on_skin(0.0, 5.0), 60.0);
  ASSERT_NE(picture_where(*thread, [](const LiveImage&) { return true; }), nullptr);
  const std::uint64_t before = thread->picture().number;
  const auto begin = std::chrono::steady_clock::now();
  for (int tick = 0; tick < 1000; ++tick) {
    thread->set_needle(forces_on(seen.elastic, seen.block), straight_in);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const double gone = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const std::uint64_t made = thread->picture().number - before;
  EXPECT_GT(static_cast<double>(made) / gone, sanitized ? 0.5 : 15.0);
  EXPECT_LT(static_cast<double>(made) / gone, 75.0);
}

// Tissue that breath moves along the array looks as to a probe moved the opposite way. Away from the probe it moves
// less.
TEST(ScanThread, breath_moves_the_tissue_in_the_picture) {
  SeenThread seen;
  for (const bool deformable : {false, true}) {
    Breathing wide, narrow;
    wide.motion = narrow.motion = Vec3(0.0, 0.0, -6.0);
    wide.centre = narrow.centre = Vec3(0.0, 0.0, 0.0);
    wide.radius = 500.0;
    narrow.radius = 30.0;
    for (const Breathing& breathing : {wide, narrow}) {
      ScanBody body;
      if (deformable) {
        body.mesh = seen.block.body;
        body.by_forces = std::make_unique<NodeField>(seen.elastic, *seen.block.body,
                                                     *seen.block.patient.description.procedure.path);
      }
      const BreathField field(breathing);
      body.breath = field;
      const Pose probe = on_skin(0.0, 0.0);
      ScanThread thread(seen.block.sounding, seen.machine(), Needle(), std::move(body), {probe, shallow()}, 200.0);
      thread.set_needle({}, straight_in, 1.0);
      const LiveImage* const picture =
          picture_where(thread, [](const LiveImage& now) { return now.needle.has_value() && now.number > 2; });
      ASSERT_NE(picture, nullptr);
      EXPECT_EQ(picture->needle->translation(), straight_in.translation()) << "where the hand holds it";
      const Vec3 carried = probe.translation() - field.material(probe.translation(), 1.0);
      EXPECT_NEAR(carried.z(), -6.0, 0.6);
      Pose moved = probe, needle = straight_in;
      moved.translation() -= carried;
      needle.translation() -= carried;
      Ultrasound machine = seen.machine();
      const UltrasoundFrame expected = machine.image(moved, NeedleInUltrasound{needle, Needle()});
      const UltrasoundFrame still = machine.image(probe, NeedleInUltrasound{straight_in, Needle()});
      if (breathing.radius == wide.radius) {
        EXPECT_LT(mean_difference(picture->frame, expected), 0.6 * mean_difference(still, expected))
            << "but for speckle, which tells parts of a millimetre";
      }
      // Every point of the grid, compared with the formula solved by repeated substitution.
      const SlicePlane grid = grid_of(*picture);
      const std::vector<Vec3> points = points_of(grid);
      double apart = 0.0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        Vec3 material = points[i];
        for (int round = 0; round < 60; ++round) {
          const double inside = 1.0 - (material - breathing.centre).squaredNorm() / std::pow(breathing.radius, 2);
          material = points[i] - std::pow(std::max(0.0, inside), 2) * breathing.motion;
        }
        const Vec3 found = Eigen::Map<const Eigen::Vector3f>(picture->moved.data() + 3 * i).cast<double>();
        const Vec3 by_breath = points[i] - material - carried;
        // The displacement by the probe's pressure is added, across the array.
        apart = std::max(apart, std::abs(found.z() - by_breath.z()));
      }
      EXPECT_LT(apart, 0.2) << deformable;
    }
  }
}

TEST(ScanThread, without_a_body_the_picture_is_rigid) {
  SeenThread seen;
  ScanThread thread(seen.block.sounding, seen.machine(), Needle(), {}, {on_skin(0.0, 5.0, 2.0), shallow()}, 200.0);
  thread.set_needle({}, straight_in);
  const LiveImage* const picture = picture_where(thread, [](const LiveImage& now) { return now.needle.has_value(); });
  ASSERT_NE(picture, nullptr);
  EXPECT_EQ(picture->grid.columns, 0);
  Ultrasound machine = seen.machine();
  EXPECT_EQ(machine.image(on_skin(0.0, 5.0, 2.0), NeedleInUltrasound{straight_in, Needle()}).pixels,
            picture->frame.pixels);
}

TEST(ScanThread, what_is_told_of_the_nodes_of_a_moving_body_moves_the_picture) {
  SeenThread seen;
  ScanThread thread(seen.block.sounding, seen.machine(), Needle(), {seen.block.body, nullptr, true},
                    {on_skin(0.0, 0.0), shallow()}, 200.0);
  ASSERT_NE(picture_where(thread, [](const LiveImage&) { return true; }), nullptr);
  EXPECT_EQ(thread.picture().most, 0.0);
  thread.set_displacements(std::vector<float>(7, 1.0F));  // the size of another mesh
  std::vector<float> nodes;
  for (std::size_t node = 0; node < seen.block.body->mesh.nodes.size(); ++node)
    nodes.insert(nodes.end(), {0.5F, -2.0F, 1.0F});
  thread.set_displacements(nodes);
  const LiveImage* const picture = picture_where(thread, [](const LiveImage& now) { return now.most > 0.0; });
  ASSERT_NE(picture, nullptr);
  const SlicePlane grid = grid_of(*picture);
  const std::vector<Vec3> points = points_of(grid);
  int inside = 0;
  for (std::size_t point = 0; point < points.size(); ++point) {
    if (points[point].y() > -4.0 || points[point].y() < -44.0 || std::abs(points[point].z()) > 35.0) continue;
    ++inside;
    // The origin of tissue is found in eight halvings.
    const Eigen::Vector3f expected(0.5F, -2.0F, 1.0F);
    ASSERT_LT((Eigen::Map<const Eigen::Vector3f>(picture->moved.data() + 3 * point) - expected).norm(),
              1.1F / 256.0F * expected.norm());
  }
  EXPECT_GT(inside, 100);
}

// The displacement by the probe is added, as by the ultrasound machine when it gets no displacement.
TEST(ScanThread, a_pressed_probe_presses_beside_the_needle) {
  SeenThread seen;
  const Pose pressed = on_skin(0.0, 0.0, 4.0);
  const auto thread = seen.start(pressed);
  const LiveImage* const picture = picture_where(*thread, [](const LiveImage&) { return true; });
  ASSERT_NE(picture, nullptr);
  EXPECT_EQ(picture->most, 0.0);
  EXPECT_NEAR(picture->frame.press, 4.0, 0.6);
  const auto columns = static_cast<std::size_t>(picture->grid.columns),
             rows = static_cast<std::size_t>(picture->grid.rows);
  const std::size_t middle = columns / 2;
  EXPECT_NEAR(static_cast<double>(picture->moved[3 * middle + 1]), -picture->frame.press, 0.3);
  double last = picture->frame.press + 1.0;
  for (std::size_t row = 0; row < rows; ++row) {
    const double down = -static_cast<double>(picture->moved[3 * (row * columns + middle) + 1]);
    EXPECT_LE(down, last + 1e-3);
    last = down;
  }
  EXPECT_LT(last, 0.5 * picture->frame.press);
  Ultrasound machine = seen.machine();
  const std::vector<std::uint8_t> with_layers = machine.image(pressed).pixels;
  ScanDisplacement still = picture->grid;
  const std::vector<float> nothing(picture->moved.size(), 0.0F);
  still.moved = nothing;
  const std::vector<std::uint8_t> without = machine.image(pressed, std::nullopt, still).pixels;
  const auto apart = [&](const std::vector<std::uint8_t>& other) {
    double sum = 0.0;
    for (std::size_t i = 0; i < other.size(); ++i) sum += std::abs(int{other[i]} - int{picture->frame.pixels[i]});
    return sum / static_cast<double>(other.size());
  };
  EXPECT_LT(apart(with_layers), 0.4 * apart(without));
}

TEST(ScanThread, refuses_rates_that_are_none) {
  SeenThread seen;
  for (const double rate : {0.0, -1.0, 2000.0, std::nan("")})
    EXPECT_THROW(ScanThread(seen.block.sounding, seen.machine(), Needle(), {}, {}, rate), InputError);
}

}  // namespace
}  // namespace bodkin
