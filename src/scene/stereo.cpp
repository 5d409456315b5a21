#include "scene/stereo.h"

namespace bodkin::scene {

std::array<Camera, 2> eyes(const Camera& camera) {
  const Vec3 half = camera.axes().col(0) * (camera.distance() / 60.0);
  std::array<Camera, 2> both = {camera, camera};
  both[0].eye -= half;
  both[1].eye += half;
  return both;
}

void mix_anaglyph(const Picture& left, const Picture& right, Picture& mixed) {
  mixed.width = left.width;
  mixed.height = left.height;
  mixed.pixels.resize(left.pixels.size());
  for (std::size_t i = 0; i < mixed.pixels.size(); ++i) {
    const std::uint32_t colour = left.pixels[i];
    const std::uint32_t red = (colour >> 16U) & 0xFFU, green = (colour >> 8U) & 0xFFU, blue = colour & 0xFFU;
    const std::uint32_t grey = (77U * red + 150U * green + 29U * blue) >> 8U;  // brightness, ITU-R BT.601
    mixed.pixels[i] = 0xFF000000U | (grey << 16U) | (right.pixels[i] & 0x00FFFFU);
  }
}

}  // namespace bodkin::scene
