#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "scene/camera.h"

#include "imaging/volume_rendering/ray_caster.h"

namespace bodkin::scene {

// What draws a volume.
enum class VolumeDrawer : std::uint8_t {
  automatic,  // a graphics card where there is one, else the processor
  card,       // OpenGL, also one that is computed by the processor
  processor   // imaging::RayCaster
};
inline constexpr std::array<VolumeDrawer, 3> volume_drawers = {VolumeDrawer::automatic, VolumeDrawer::card,
                                                               VolumeDrawer::processor};
// "automatic", "card", "processor"
std::string_view name_of(VolumeDrawer drawer);

// The rays of a camera's picture.
imaging::VolumeCamera volume_camera(const Projection& projection);

// A picture of the inside of a patient that is wanted.
struct VolumeOrder {
  Camera camera;
  imaging::VolumeLook look;
  int width = 0, height = 0;      // pixels
  double voxels = 1.0;            // that a step is long
  bool may_be_cut_short = false;  // by another order; one that follows a moving camera must not, or none is finished
  VolumeDrawer drawer = VolumeDrawer::processor;

  bool operator==(const VolumeOrder&) const = default;
};

struct VolumeResult {
  VolumeOrder order;
  std::vector<std::uint32_t> pixels;  // 0xffRRGGBB, row by row
  std::shared_ptr<const imaging::RayCaster> caster;
  double seconds = 0.0;  // that it took
  bool by_card = false;
};

}  // namespace bodkin::scene
