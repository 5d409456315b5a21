#include "scene/moving_pixels.h"

#include "scene/blend.h"

namespace bodkin::scene {

MovingPixels::MovingPixels(int width, int height) : width_(width), height_(height), fragments_(index(0, height)) {}

void MovingPixels::add(int x, int y, float nearness, std::uint32_t colour, float opacity, float behind) {
  if (opacity <= 0.0F) return;
  Fragment& fragment = fragments_[index(x, y)];
  if (fragment.opacity == 0.0F) {
    fragment = {nearness, opacity, behind, colour};
    covered_.push_back({x, y});
    return;
  }
  const float both = fragment.opacity + opacity - fragment.opacity * opacity;
  fragment.colour = blend(fragment.colour, colour, opacity / both);
  if (opacity >= fragment.opacity) {
    fragment.nearness = nearness;
    fragment.behind = behind;
  }
  fragment.opacity = both;
}

PixelBox MovingPixels::show(const StillLayers& layers, const Picture& still, Picture& picture) {
  PixelBox changed;
  for (const Pixel& pixel : shown_) {
    picture.pixels[index(pixel.x, pixel.y)] = still.pixels[index(pixel.x, pixel.y)];
    changed = changed.join({pixel.x, pixel.y, pixel.x + 1, pixel.y + 1});
  }
  for (const Pixel& pixel : covered_) {
    Fragment& fragment = fragments_[index(pixel.x, pixel.y)];
    picture.pixels[index(pixel.x, pixel.y)] =
        layers.mix(pixel.x, pixel.y, fragment.nearness, fragment.colour, fragment.opacity, fragment.behind);
    fragment.opacity = 0.0F;
    changed = changed.join({pixel.x, pixel.y, pixel.x + 1, pixel.y + 1});
  }
  shown_.swap(covered_);
  covered_.clear();
  return changed;
}

}  // namespace bodkin::scene
