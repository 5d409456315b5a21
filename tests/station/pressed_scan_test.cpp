// A hand-held probe presses a patient, image after image: compared with the body's own solver, and what the images
// show of it.
#include "station/pressed_scan.h"

#include <algorithm>
#include <cmath>

#include "patient/meshing/mesh_record.h"
#include "station/probe_contact.h"
#include "tests/fem/lattice_body.h"
#include "tests/io/scratch_folder.h"
#include <gtest/gtest.h>

#include "fem/solid/patient_body.h"
#include "io/probe_library_file.h"
#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using namespace bodkin::io;
using namespace bodkin::station;
namespace {

constexpr double plate_depth = 20.0;  // mm, of a thin plate visible only in the CT

// A block of muscle, 120 x 50 x 80 mm below the plane y = 0, fixed where it ends, with its mesh in a folder.
class PressedScanTest : public testing::Test {
 protected:
  PressedScanTest() {
    patient_.library = default_tissue_library();
    Grid grid;
    grid.size = {60, 70, 40};
    grid.spacing = Vec3(2.0, 1.0, 2.0);
    grid.origin = Vec3(-59.0, -49.5, -39.0);
    patient_.tissues = TissueVolume(grid, tissue::air);
    patient_.ct = CtVolume(grid, -1000);
    for (int k = 0; k < grid.size[2]; ++k) {
      for (int j = 0; j < 50; ++j) {
        for (int i = 0; i < grid.size[0]; ++i) {
          patient_.tissues.at(i, j, k) = tissue::muscle;
          patient_.ct.at(i, j, k) = std::abs(grid.origin.y() + j + plate_depth) < 1.0 ? 1000 : 0;
        }
      }
    }
    patient_.description.procedure.path = NeedlePath{Vec3(-30.0, 0.0, 0.0), Vec3(-30.0, -30.0, 0.0)};
    mesh_ = kuhn_box({13, 6, 9}, Vec3(120.0, 50.0, 80.0));
    for (Vec3& node : mesh_.nodes) node -= Vec3(60.0, 50.0, 40.0);
    std::fill(mesh_.tissues.begin(), mesh_.tissues.end(), tissue::muscle);
    patient::write_case_mesh(mesh_, {}, folder_.path());
    choice_.probe = find_probe("L12-3");
    choice_.settings.depth = 40.0;
  }

  // The face looks down and is pressed in by `depth` mm.
  static Pose probe_at(double depth) {
    Pose tool = Pose::Identity();
    tool.linear().col(0) = Vec3::UnitX();
    tool.linear().col(1) = Vec3::UnitZ();
    tool.linear().col(2) = -Vec3::UnitY();
    tool.translation() = Vec3(0.0, -depth, 0.0);
    return probe_in_hand(tool);
  }
  // mm from the probe's face to the brightest part of the plate.
  static double plate_in(const imaging::ImageRgb& ct, double pixel) {
    double sum = 0.0, weight = 0.0;
    for (int y = 0; y < ct.height; ++y) {
      const double level = ct.at(ct.width / 2, y).green;
      if (level < 200.0) continue;
      sum += y * level;
      weight += level;
    }
    EXPECT_GT(weight, 0.0) << "the plate is not in the picture";
    return pixel * sum / weight;
  }

  ScratchFolder folder_;
  Case patient_;
  TetrahedralMesh mesh_;
  UltrasoundChoice choice_;
};

TEST_F(PressedScanTest, the_body_moves_as_its_own_solver_has_it) {
  PressedScan scan(patient_, folder_.path(), choice_, {});
  ASSERT_TRUE(scan.deforms());
  DeformableBodySettings settings;
  settings.stiffness_scale = 1.0;
  const BodyDescription body = describe_body(mesh_, patient_, settings, *patient_.description.procedure.path);
  BodySolverSettings motion;
  motion.probe = face_of(choice_.probe, mesh_);
  DeformableBodySolver solver(body, motion);
  const Pose goal = probe_at(6.0);
  Pose tool = tool_of_probe(goal);
  tool.translation().y() += 40.0;  // it starts there, at 300 mm/s
  for (int step = 0; step < 120; ++step) {
    scan.advance(goal, 1.0 / 60.0 + 1e-12);
    tool.translation().y() = std::max(-6.0, tool.translation().y() - 5.0);
    solver.step(tool);
  }
  const double force = -solver.press().on_probe(solver.body()).force.dot(tool.linear().col(2));
  EXPECT_GT(force, 0.5);
  EXPECT_NEAR(scan.force(), force, 1e-6 * force);
  // The skin moves as far as the face; the image begins up to 2 mm below it, in elements of 10 mm.
  scan.image(goal, {});
  EXPECT_GT(scan.most_moved(), 6.0 * 0.8);
  EXPECT_LE(scan.most_moved(), 6.0 + 1e-3);
}

TEST_F(PressedScanTest, the_ct_in_its_plane_moves_with_the_tissue_and_comes_back) {
  PressedScan pressed(patient_, folder_.path(), choice_, {}), rigid(patient_, {}, choice_, {});
  EXPECT_FALSE(rigid.deforms());
  constexpr double pixel = 0.5;
  const Pose probe = probe_at(8.0);
  for (int step = 0; step < 90; ++step) pressed.advance(probe, 1.0 / 60.0);
  pressed.image(probe, {});
  rigid.image(probe, {});
  const double deformed = plate_in(pressed.slice(probe, pixel), pixel),
               at_rest = plate_in(rigid.slice(probe, pixel), pixel);
  EXPECT_NEAR(at_rest, plate_depth - 8.0, 1.0) << "the face has come nearer to what stays where it is";
  // Because the block is fixed at 50 mm depth, the plate yields by a part of the 8 mm.
  EXPECT_GT(deformed, at_rest + 1.5);
  EXPECT_LT(deformed, plate_depth + 0.5);
  for (int step = 0; step < 180; ++step) pressed.advance(std::nullopt, 1.0 / 60.0);
  EXPECT_EQ(pressed.force(), 0.0);
  pressed.image(probe, {});
  EXPECT_LT(pressed.most_moved(), 0.2);
}

// Slices in other planes show the same body: across the probe's plane the plate is as deep as in it.
TEST_F(PressedScanTest, the_tissue_has_moved_alike_in_every_plane_and_comes_back) {
  PressedScan scan(patient_, folder_.path(), choice_, {});
  EXPECT_EQ(scan.moved_tissue(), nullptr);
  const Pose probe = probe_at(8.0);
  for (int step = 0; step < 90; ++step) scan.advance(probe, 1.0 / 60.0);
  scan.image(probe, {});
  constexpr double pixel = 0.5;
  const double in_plane = plate_in(scan.slice(probe, pixel), pixel);
  const auto moved = scan.moved_tissue();
  ASSERT_NE(moved, nullptr);
  const imaging::SlicePlane across = {Vec3(0.0, -8.0, -5.0), Vec3::UnitZ(), -Vec3::UnitY(), pixel, 21, 80};
  const double in_other = plate_in(
      imaging::paint(imaging::cut_moved(across, patient_.ct, patient_.tissues, *moved), patient_.library), pixel);
  EXPECT_NEAR(in_other, in_plane, 0.3);
  // At the skin the tissue has moved as far as the face, far away not at all.
  EXPECT_NEAR(moved->of(Vec3(0.0, -0.5, 0.0)).y(), -8.0, 1.0);
  EXPECT_LT(moved->of(Vec3(-58.0, -48.0, 0.0)).norm(), 0.3);
  for (int step = 0; step < 180; ++step) scan.advance(std::nullopt, 1.0 / 60.0);
  const auto after = scan.moved_tissue();
  EXPECT_TRUE(after == nullptr || after->of(Vec3(0.0, -0.5, 0.0)).norm() < 0.2);
}

TEST_F(PressedScanTest, a_long_pause_is_not_made_up_for_and_no_probe_is_no_fault) {
  PressedScan scan(patient_, folder_.path(), choice_, {});
  scan.advance(probe_at(15.0), 1000.0);
  EXPECT_TRUE(scan.deforms());
  scan.advance(std::nullopt, -3.0);
  EXPECT_TRUE(scan.deforms());
}

// The moving body has no fibres: the image is computed without it, and the reason is given.
TEST_F(PressedScanTest, a_tissue_with_fibres_is_pressed_layer_by_layer) {
  std::vector<TissueProperties> tissues = patient_.library.tissues();
  for (TissueProperties& one : tissues)
    if (one.id == tissue::muscle) one.deformable.fibres = FibreAxis::superior;
  patient_.library = TissueLibrary(tissues);
  std::vector<std::string> notes;
  PressedScan scan(patient_, folder_.path(), choice_, [&](const std::string& note) { notes.push_back(note); });
  EXPECT_FALSE(scan.deforms());
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("layer by layer"), std::string::npos) << notes[0];
  scan.advance(probe_at(6.0), 0.5);
  EXPECT_GT(scan.image(probe_at(6.0), {}).press, 4.0);
}

TEST_F(PressedScanTest, a_tool_and_its_probe_are_each_others_inverse) {
  const Pose probe = probe_at(3.0);
  EXPECT_LT((probe_in_hand(tool_of_probe(probe)).matrix() - probe.matrix()).norm(), 1e-12);
}

}  // namespace
}  // namespace bodkin
