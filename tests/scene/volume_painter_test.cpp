#include "scene/volume_painter.h"

#include "tests/scene/software_display.h"
#include <gtest/gtest.h>

namespace bodkin::scene {
namespace {

std::shared_ptr<const imaging::PreparedVolume> block_of_bone() {
  anatomy::Grid grid;
  grid.size = {30, 30, 30};
  anatomy::CtVolume ct(grid, -1000);
  for (int k = 8; k < 22; ++k) {
    for (int j = 8; j < 22; ++j) {
      for (int i = 8; i < 22; ++i) ct.at(i, j, k) = 900;
    }
  }
  return std::make_shared<const imaging::PreparedVolume>(imaging::prepare_volume(ct, {}, {}));
}

VolumeRequest request_by(VolumeDrawer drawer) {
  VolumeRequest request;
  request.camera.eye = Vec3(15.0, -100.0, 15.0);
  request.camera.focus = Vec3(15.0, 15.0, 15.0);
  request.width = 64;
  request.height = 48;
  request.drawer = drawer;
  return request;
}

VolumeResult drawn(VolumePainter& painter, const VolumeRequest& request) {
  VolumeResult result;
  EXPECT_TRUE(painter.draw(request, {}, result));
  EXPECT_EQ(result.pixels.size(), 64U * 48U);
  EXPECT_NE(result.caster, nullptr) << "needles need it in any case";
  return result;
}

TEST(VolumePainter, draws_by_opengl_that_the_processor_computes_only_if_told_to) {
  const SoftwareDisplay display;
  if (!display.is_there()) GTEST_SKIP() << "Xvfb is not installed";
  VolumePainter painter(block_of_bone(), 1);
  const VolumeResult automatic = drawn(painter, request_by(VolumeDrawer::automatic));
  EXPECT_FALSE(automatic.by_card);
  EXPECT_TRUE(painter.card().empty());
  EXPECT_NE(painter.refusal().find("computed by the processor"), std::string::npos) << painter.refusal();

  const VolumeResult forced = drawn(painter, request_by(VolumeDrawer::card));
  EXPECT_TRUE(forced.by_card);
  EXPECT_NE(painter.card().find("llvmpipe"), std::string::npos) << painter.card();
  EXPECT_TRUE(painter.refusal().empty());
  const std::uint32_t middle = forced.pixels[64U * 24U + 32U];
  EXPECT_EQ(middle >> 24U, 0xFFU);
  EXPECT_GT(middle & 0xFFU, 100U) << "bone is bright";

  EXPECT_FALSE(drawn(painter, request_by(VolumeDrawer::automatic)).by_card);
  EXPECT_FALSE(drawn(painter, request_by(VolumeDrawer::processor)).by_card);
  EXPECT_TRUE(painter.refusal().empty()) << "nobody wished for a card";
}

TEST(VolumePainter, draws_colours_of_the_tissues_by_the_processor) {
  const SoftwareDisplay display;
  if (!display.is_there()) GTEST_SKIP() << "Xvfb is not installed";
  VolumePainter painter(block_of_bone(), 1);
  VolumeRequest request = request_by(VolumeDrawer::card);
  request.look.tissue_colours = true;
  EXPECT_FALSE(drawn(painter, request).by_card);
  request.look.mode = imaging::VolumeMode::grey;
  EXPECT_TRUE(drawn(painter, request).by_card) << "grey has no colours of tissues";
}

TEST(VolumePainter, draws_by_the_processor_where_there_is_no_display) {
  unsetenv("DISPLAY");
  VolumePainter painter(block_of_bone(), 1);
  EXPECT_FALSE(drawn(painter, request_by(VolumeDrawer::card)).by_card);
  EXPECT_EQ(painter.refusal(), "no graphics card can be reached, because there is no X11 display");
}

TEST(VolumePainter, keeps_its_tables_while_only_the_camera_moves) {
  VolumePainter painter(block_of_bone(), 1);
  VolumeRequest request = request_by(VolumeDrawer::processor);
  const VolumeResult before = drawn(painter, request);
  request.camera.eye.x() += 10.0;
  EXPECT_EQ(drawn(painter, request).caster, before.caster);
  request.look.window += 10.0;
  EXPECT_NE(drawn(painter, request).caster, before.caster);
}

}  // namespace
}  // namespace bodkin::scene
