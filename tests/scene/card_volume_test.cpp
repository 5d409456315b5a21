// The volume as VTK's mapper for graphics cards draws it, by an OpenGL that the processor computes, against our own
// ray caster.
#include "scene/graphics_card/card_volume.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "scene/graphics_card/opengl_context.h"
#include "tests/scene/software_display.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "core/thread_pool.h"

namespace bodkin::scene {
namespace {

using imaging::VolumeMode;

constexpr int picture_size = 160;

// Balls of many HU in air, with noise, on a lattice that is turned and has long voxels.
std::shared_ptr<const imaging::PreparedVolume> balls() {
  anatomy::Grid grid;
  grid.size = {61, 55, 40};
  grid.spacing = Vec3(1.5, 1.5, 2.4);
  grid.direction = (Eigen::AngleAxisd(0.4, Vec3::UnitZ()) * Eigen::AngleAxisd(0.2, Vec3::UnitX())).toRotationMatrix();
  grid.origin = Vec3(-30.0, 70.0, 15.0);
  anatomy::CtVolume ct(grid, -1000);
  const Vec3 middle = grid.to_patient(Vec3(30, 27, 19.5));
  Random random(7);
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 at = grid.to_patient(Vec3(i, j, k)) - middle;
        double value = -1000.0;
        if (at.norm() < 33.0) value = 40.0;
        if ((at - Vec3(9, -3, 0)).norm() < 12.0) value = 700.0;
        if ((at - Vec3(-18, 0, 9)).norm() < 8.0) value = -100.0;
        ct.at(i, j, k) = static_cast<std::int16_t>(value + 20.0 * (random.uniform() - 0.5));
      }
    }
  }
  return std::make_shared<const imaging::PreparedVolume>(imaging::prepare_volume(ct, {}, {}));
}

imaging::VolumeCamera camera_of(const imaging::PreparedVolume& volume, const Vec3& direction, double distance) {
  const Vec3 last(volume.grid.size[0] - 1, volume.grid.size[1] - 1, volume.grid.size[2] - 1);
  const Vec3 ahead = direction.normalized();
  imaging::VolumeCamera camera;
  camera.eye = volume.grid.to_patient(0.5 * last) - distance * ahead;
  camera.width = picture_size + 40;
  camera.height = picture_size;
  const double pixel = 0.5 / picture_size;
  camera.right = pixel * ahead.cross(Vec3::UnitZ()).normalized();
  camera.down = ahead.cross(camera.right);
  camera.first = ahead + (0.5 - 0.5 * camera.width) * camera.right + (0.5 - 0.5 * camera.height) * camera.down;
  return camera;
}

struct Comparison {
  double mean = 0.0;   // of the largest difference of a channel, of 255
  double share = 0.0;  // of the pixels that differ by more than 16
  double light = 0.0;  // the mean of the ray caster's own picture
};
Comparison compare(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  Comparison found;
  if (a.size() != b.size() || a.empty()) return {255.0, 1.0, 0.0};
  for (std::size_t i = 0; i < a.size(); ++i) {
    double most = 0.0;
    for (unsigned shift = 0; shift < 24U; shift += 8U) {
      const double one = a[i] >> shift & 0xFFU, other = b[i] >> shift & 0xFFU;
      most = std::max(most, std::abs(one - other));
      found.light += one / 3.0;
    }
    found.mean += most;
    found.share += most > 16.0 ? 1.0 : 0.0;
  }
  const auto count = static_cast<double>(a.size());
  found.mean /= count;
  found.share /= count;
  found.light /= count;
  return found;
}

class CardVolumeTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { display_.emplace(); }
  static void TearDownTestSuite() { display_.reset(); }
  void SetUp() override {
    if (!display_->is_there()) GTEST_SKIP() << "Xvfb is not installed";
  }

  static Comparison compare_with_caster(const std::shared_ptr<const imaging::PreparedVolume>& volume,
                                        CardVolume& card, const imaging::VolumeLook& look,
                                        const imaging::VolumeCamera& camera) {
    const double step = imaging::step_of(*volume, 0.5);
    std::vector<std::uint32_t> by_card, by_caster;
    card.draw(camera, look, step, by_card);
    ThreadPool pool(2);
    imaging::RayCaster(volume, look, step).draw(camera, pool, by_caster);
    return compare(by_caster, by_card);
  }

  static std::optional<SoftwareDisplay> display_;
};
std::optional<SoftwareDisplay> CardVolumeTest::display_;

// In the mean over the picture, of 255: what two ways of interpolating and of rounding make, which a shift by a voxel
// exceeds many times. Light uses gradients that are smoothed in two ways.
constexpr double most_unlit = 0.3, most_lit = 0.6;

TEST_F(CardVolumeTest, draws_what_the_ray_caster_draws_in_every_mode) {
  const auto volume = balls();
  CardVolume card(volume, true);
  EXPECT_FALSE(is_graphics_card(card.renderer())) << card.renderer();
  for (const VolumeMode mode : {VolumeMode::maximum, VolumeMode::sum, VolumeMode::grey, VolumeMode::colour}) {
    for (const Vec3& direction : {Vec3(0.1, -1.0, -0.3), Vec3(1.0, 0.4, 0.6)}) {
      for (const bool shaded : {false, true}) {
        imaging::VolumeLook look;
        look.mode = mode;
        look.shaded = shaded;
        const bool lit = shaded && (mode == VolumeMode::grey || mode == VolumeMode::colour);
        const Comparison found = compare_with_caster(volume, card, look, camera_of(*volume, direction, 300.0));
        EXPECT_GT(found.light, 8.0) << "something is seen";
        EXPECT_LT(found.mean, lit ? most_lit : most_unlit) << static_cast<int>(mode) << " " << shaded;
        EXPECT_LT(found.share, 0.01) << static_cast<int>(mode) << " " << shaded;
      }
    }
  }
}

TEST_F(CardVolumeTest, draws_what_the_ray_caster_draws_with_every_preset_and_from_within) {
  const auto volume = balls();
  CardVolume card(volume, true);
  imaging::VolumeLook look;
  for (const imaging::TransferPreset preset : imaging::transfer_presets) {
    look.transfer = imaging::preset_function(preset);
    for (const double distance : {300.0, 20.0}) {
      const Comparison found =
          compare_with_caster(volume, card, look, camera_of(*volume, Vec3(0.2, 1, 0.1), distance));
      // A surface that fills the picture: its light is where the two differ most.
      const bool fills = distance < 100.0;
      EXPECT_LT(found.mean, fills ? 8.0 : 1.0) << imaging::name_of(preset) << " " << distance;
      EXPECT_LT(found.share, fills ? 0.06 : 0.01) << imaging::name_of(preset) << " " << distance;
    }
  }
}

TEST_F(CardVolumeTest, follows_the_opacity_curve_and_the_window) {
  const auto volume = balls();
  CardVolume card(volume, true);
  const imaging::VolumeCamera camera = camera_of(*volume, Vec3(0.0, -1.0, 0.0), 300.0);
  imaging::VolumeLook look;
  look.shaded = false;
  look.transfer.opacity = {{-1024.0, 0.0}, {-300.0, 0.0}, {0.0, 0.03}, {3071.0, 0.03}};
  look.transfer.colours = {{-1000.0, 0x3060FF}, {1000.0, 0xFF4020}};
  EXPECT_LT(compare_with_caster(volume, card, look, camera).mean, 0.5);
  look.transfer.opacity = {{-1024.0, 0.0}, {400.0, 0.0}, {500.0, 0.4}, {3071.0, 0.4}};
  EXPECT_LT(compare_with_caster(volume, card, look, camera).mean, 0.5);
  look.mode = VolumeMode::maximum;
  for (const double level : {-80.0, 300.0}) {
    look.window = 400.0;
    look.level = level;
    EXPECT_LT(compare_with_caster(volume, card, look, camera).mean, 0.6) << level;
  }
}

TEST_F(CardVolumeTest, is_refused_where_the_processor_computes_opengl) {
  try {
    const CardVolume card(balls(), false);
    FAIL() << "llvmpipe is no graphics card";
  } catch (const SystemError& error) {
    EXPECT_EQ(std::string(error.what()).find("OpenGL is computed by the processor here ("), 0U) << error.what();
  }
}

TEST_F(CardVolumeTest, is_refused_for_a_volume_that_is_too_long) {
  const int most = OpenGlContext().most_along_a_side();
  ASSERT_GE(most, 256);
  anatomy::Grid grid;
  grid.size = {most + 1, 3, 3};
  const auto volume =
      std::make_shared<const imaging::PreparedVolume>(imaging::prepare_volume(anatomy::CtVolume(grid, 100), {}, {}));
  try {
    const CardVolume card(volume, true);
    FAIL() << "the volume does not fit";
  } catch (const SystemError& error) {
    EXPECT_NE(std::string(error.what()).find("voxels long, and the graphics card takes " + std::to_string(most)),
              std::string::npos)
        << error.what();
  }
}

TEST(CardVolumeWithoutDisplay, goes_on_or_says_so_when_the_server_goes_away) {
  std::optional<SoftwareDisplay> display(std::in_place);
  if (!display->is_there()) GTEST_SKIP() << "Xvfb is not installed";
  const auto volume = balls();
  CardVolume card(volume, true);
  display.reset();
  std::vector<std::uint32_t> pixels;
  try {
    card.draw(camera_of(*volume, Vec3(0.0, -1.0, 0.0), 300.0), {}, 1.0, pixels);
  } catch (const SystemError&) {  // the program lives
  }
}

TEST(CardVolumeWithoutDisplay, is_refused) {
  const char* const before = std::getenv("DISPLAY");
  const std::string kept = before == nullptr ? "" : before;
  unsetenv("DISPLAY");
  EXPECT_THROW(CardVolume(balls(), true), SystemError);
  if (before != nullptr) setenv("DISPLAY", kept.c_str(), 1);
}

TEST(GraphicsCard, is_told_from_the_processor_by_the_name_of_the_renderer) {
  for (const char* const name :
       {"NVIDIA GeForce RTX 3060/PCIe/SSE2", "Mesa Intel(R) UHD Graphics 620 (KBL GT2)", "NVIDIA H100 80GB HBM3/PCIe",
        "AMD Radeon RX 6600 (navi23, LLVM 15.0.6, DRM 3.49, 6.1.0-13-amd64)", "SVGA3D; build: RELEASE;  LLVM;",
        "V3D 4.2", "Apple M1", "zink (Intel(R) HD Graphics 520 (SKL GT2))", "NV137"}) {
    EXPECT_TRUE(is_graphics_card(name)) << name;
  }
  for (const char* const name :
       {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Google SwiftShader", "Software Rasterizer", "Mesa X11",
        "Gallium 0.4 on llvmpipe (LLVM 3.3, 128 bits)", "virgl (LLVMPIPE (LLVM 15.0.7, 256 bits))",
        "zink (llvmpipe (LLVM 15.0.6, 256 bits))", "D3D12 (Microsoft Basic Render Driver)", "GDI Generic", ""}) {
    EXPECT_FALSE(is_graphics_card(name)) << name;
  }
}

}  // namespace
}  // namespace bodkin::scene
