#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "scene/camera.h"

#include "imaging/volume_rendering/ray_caster.h"

namespace bodkin::scene {

// The renderer of a volume.
enum class VolumeDrawer : std::uint8_t {
  automatic,  // a graphics card if there is one, else the processor
  card,       // OpenGL, even if emulated by the processor
  processor   // imaging::RayCaster
};
inline constexpr std::array<VolumeDrawer, 3> volume_drawers = {VolumeDrawer::automatic, VolumeDrawer::card,
                                                               VolumeDrawer::processor};
// "automatic", "card", "processor"
std::string_view name_of(VolumeDrawer drawer);

// The rays of a camera's image.
imaging::VolumeCamera volume_camera(const Projection& projection);

// A requested image of the inside of a patient.
struct VolumeRequest {
  Camera camera;
  imaging::VolumeLook look;
  int width = 0, height = 0;      // pixels
  double voxels = 1.0;            // length of a step
  bool may_be_cut_short = false;  // by another request; not while following a moving camera, or none would finish
  VolumeDrawer drawer = VolumeDrawer::processor;

  bool operator==(const VolumeRequest&) const = default;
};

struct VolumeResult {
  VolumeRequest request;
  std::vector<std::uint32_t> pixels;  // 0xffRRGGBB, row by row
  std::shared_ptr<const imaging::RayCaster> caster;
  double seconds = 0.0;  // to draw it
  bool by_card = false;
};

}  // namespace bodkin::scene
