#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "imaging/volume_rendering/ray_caster.h"

namespace bodkin::scene {

// What imaging::RayCaster draws, drawn by VTK's volume mapper for graphics cards, with the same tables of opacity and
// colour, lengths of steps and light. Made, used and destroyed by one thread, in which its OpenGL is current.
class CardVolume {
 public:
  // Brings the volume to the card and compares a small picture with the ray caster's. Throws SystemError, one
  // sentence, where there is no OpenGL, where the processor computes it (unless `software_too`), where the volume is
  // too large for the card, or where the card draws something else than the ray caster.
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
