#include "patient/segmentation/label_editor.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace bodkin::patient {
namespace {

// Voxels of 1 x 1 x 2 mm, turned by 90 degrees about z.
anatomy::LabelVolume blank() {
  anatomy::Grid grid;
  grid.size = {40, 40, 20};
  grid.spacing = {1.0, 1.0, 2.0};
  grid.direction << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  grid.origin = {5.0, -7.0, 11.0};
  return anatomy::LabelVolume(grid);
}

TEST(LabelEditor, a_ball_and_a_disc_have_their_volumes) {
  LabelEditor editor(blank());
  const anatomy::Grid& grid = editor.labels().grid;
  const Vec3 middle = grid.to_patient({20.0, 20.0, 10.0});
  editor.paint(middle, middle, {8.0, true, 2}, 3, Overwriting::all);
  const double ball = 4.0 / 3.0 * M_PI * 512.0 / 2.0;                    // in voxels of 2 mm^3
  EXPECT_NEAR(static_cast<double>(editor.count(3)), ball, 0.05 * ball);  // of its surface, which voxels cut
  editor.undo();
  EXPECT_EQ(editor.count(3), 0U);
  editor.paint(middle, middle, {8.0, false, 2}, 3, Overwriting::all);
  EXPECT_NEAR(static_cast<double>(editor.count(3)), M_PI * 64.0, 0.05 * M_PI * 64.0);
  for (std::size_t i = 0; i < editor.labels().voxels.size(); ++i) {
    if (editor.labels().voxels[i] != 0) {
      EXPECT_EQ(i / 1600, 10U) << "a disc stays in its slice";
    }
  }
}

TEST(LabelEditor, a_stroke_is_a_tube_without_gaps) {
  LabelEditor editor(blank());
  const anatomy::Grid& grid = editor.labels().grid;
  const Vec3 from = grid.to_patient({5.0, 10.0, 10.0}), to = grid.to_patient({35.0, 25.0, 10.0});
  editor.paint(from, to, {2.5, false, 2}, 1, Overwriting::all);
  for (int i = 0; i <= 100; ++i) {
    const Vec3 point = from + 0.01 * i * (to - from);
    EXPECT_EQ(anatomy::nearest(editor.labels(), point, std::uint16_t{0}), 1);
  }
  const double area = 5.0 * (to - from).norm() + M_PI * 6.25;
  EXPECT_NEAR(static_cast<double>(editor.count(1)), area, 0.05 * area);
}

TEST(LabelEditor, paint_keeps_other_structures_when_it_shall_and_erase_takes_its_own_alone) {
  LabelEditor editor(blank());
  const Vec3 left = editor.labels().grid.to_patient({15.0, 20.0, 10.0});
  const Vec3 right = editor.labels().grid.to_patient({20.0, 20.0, 10.0});
  const Brush brush{6.0, true, 2};
  editor.paint(left, left, brush, 1, Overwriting::all);
  const std::size_t first = editor.count(1);
  editor.paint(right, right, brush, 2, Overwriting::nothing);
  EXPECT_EQ(editor.count(1), first);
  const std::size_t second = editor.count(2);
  EXPECT_LT(second, first);
  editor.paint(right, right, brush, 2, Overwriting::all);
  EXPECT_EQ(editor.count(2), first);
  editor.erase(left, left, brush, 2);
  EXPECT_EQ(editor.count(2), second);
  EXPECT_LT(editor.count(1), first);
}

TEST(LabelEditor, every_step_is_undone_and_done_again_to_the_voxel) {
  LabelEditor editor(blank());
  std::vector<std::vector<std::uint16_t>> states = {editor.labels().voxels};
  for (int i = 0; i < 12; ++i) {
    const Vec3 at = editor.labels().grid.to_patient(Vec3(10.0 + 2.0 * i, 15.0 + i, 10.0));
    if (i % 3 == 2) {
      editor.erase(at, at, {4.0, true, 2}, 1);
    } else {
      editor.paint(at, at, {3.0, true, 2}, static_cast<std::uint16_t>(1 + i % 2), Overwriting::all);
    }
    editor.commit();
    if (editor.labels().voxels != states.back()) states.push_back(editor.labels().voxels);
  }
  for (std::size_t i = states.size() - 1; i-- > 0;) {
    ASSERT_TRUE(editor.can_undo());
    editor.undo();
    EXPECT_EQ(editor.labels().voxels, states[i]);
  }
  EXPECT_FALSE(editor.can_undo());
  for (std::size_t i = 1; i < states.size(); ++i) {
    ASSERT_TRUE(editor.can_redo());
    editor.redo();
    EXPECT_EQ(editor.labels().voxels, states[i]);
  }
  editor.undo();
  const Vec3 at = editor.labels().grid.to_patient({3.0, 3.0, 3.0});
  editor.paint(at, at, {2.0, true, 2}, 9, Overwriting::all);
  editor.commit();
  EXPECT_FALSE(editor.can_redo()) << "what came after is another story";
}

TEST(LabelEditor, forgets_the_oldest_steps_beyond_its_memory) {
  LabelEditor editor(blank(), 20000);
  int steps = 0;
  for (int i = 0; i < 20; ++i) {
    const Vec3 at = editor.labels().grid.to_patient(Vec3(5.0 + 1.5 * i, 20.0, 10.0));
    editor.paint(at, at, {5.0, true, 2}, static_cast<std::uint16_t>(i + 1), Overwriting::all);
    editor.commit();
  }
  while (editor.can_undo()) {
    editor.undo();
    ++steps;
  }
  EXPECT_GE(steps, 1);
  EXPECT_LT(steps, 20);
}

TEST(LabelEditor, a_mask_becomes_the_structure) {
  LabelEditor editor(blank());
  SegmentMask mask(editor.labels().grid);
  for (std::size_t i = 100; i < 200; ++i) mask.voxels[i] = 1;
  editor.replace(mask, 4, Overwriting::all, false);
  EXPECT_EQ(editor.mask_of(4).voxels, mask.voxels);
  SegmentMask other(editor.labels().grid);
  for (std::size_t i = 150; i < 300; ++i) other.voxels[i] = 1;
  editor.replace(other, 4, Overwriting::all, true);
  EXPECT_EQ(editor.count(4), 200U);
  editor.replace(other, 4, Overwriting::all, false);
  EXPECT_EQ(editor.count(4), 150U);
  editor.undo();
  editor.undo();
  EXPECT_EQ(editor.mask_of(4).voxels, mask.voxels);
  anatomy::Grid small = mask.grid;
  small.size = {1, 1, 1};
  EXPECT_THROW(editor.replace(SegmentMask(small), 4, Overwriting::all, false), std::invalid_argument);
}

TEST(LabelEditor, takes_all_labels_of_another_volume_as_one_step) {
  anatomy::Grid grid;
  grid.size = {4, 3, 2};
  anatomy::LabelVolume before(grid), after(grid);
  before.at(1, 1, 0) = 5;
  after.at(2, 1, 1) = 7;
  LabelEditor editor(before);
  editor.take(after);
  EXPECT_EQ(editor.labels().voxels, after.voxels);
  editor.undo();
  EXPECT_EQ(editor.labels().voxels, before.voxels);
  EXPECT_FALSE(editor.can_undo());
  grid.size = {4, 3, 1};
  EXPECT_THROW(editor.take(anatomy::LabelVolume(grid)), std::invalid_argument);
}

}  // namespace
}  // namespace bodkin::patient
