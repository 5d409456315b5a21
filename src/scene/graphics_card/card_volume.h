#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "imaging/volume_rendering/ray_caster.h"

namespace bodkin::scene {

// Draws the images of imaging::RayCaster by VTK's volume mapper for graphics cards, with the same tables of opacity
// and colour, lengths of steps and light. Created, used and destroyed by one thread, in which its OpenGL is current.
class CardVolume {
 public:
  // Uploads the volume to the card and compares a small image with the ray caster's. Throws SystemError, one
  // sentence, if there is no OpenGL, if the processor computes it (unless `software_too`), if the volume is too large
  // for the card, or if the card's image differs from the ray caster's.
  CardVolume(std::shared_ptr<const imaging::PreparedVolume> volume, bool software_too);
  ~CardVolume();
  CardVolume(const CardVolume&) = delete;
  CardVolume& operator=(const CardVolume&) = delete;

  const std::string& renderer() const;  // the card's name
  // `step`: mm between samples, above 0. Pixels 0xffRRGGBB, row by row, as RayCaster::draw() writes them. Throws
  // SystemError if the card fails.
  void draw(const imaging::VolumeCamera& camera, const imaging::VolumeLook& look, double step,
            std::vector<std::uint32_t>& pixels);

 private:
  struct Scene;

  void check_picture();

  std::unique_ptr<Scene> scene_;
};

}  // namespace bodkin::scene
