#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "scene/picture.h"
#include "scene/raster.h"
#include "scene/still_layers.h"

namespace bodkin::scene {

// The few pixels of a frame covered by needles and marks. They are collected first, so that overlapping strokes are
// blended with each other and only then, once, with the patient.
class MovingPixels {
 public:
  MovingPixels(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  // Blends over earlier additions at pixel (x, y), which must be inside. `opacity`: 0 to 1, including the covered
  // fraction of the pixel; `behind`: factor on it where the patient is in front.
  void add(int x, int y, float nearness, std::uint32_t colour, float opacity, float behind);
  // Blends everything into `picture`, whose other pixels are those of `still`, after undoing the last call. Returns
  // the box of all pixels written.
  PixelBox show(const StillLayers& layers, const Picture& still, Picture& picture);

  // See add(); the blend of several at one pixel.
  struct Fragment {
    float nearness = 0.0F, opacity = 0.0F, behind = 0.0F;
    std::uint32_t colour = 0;
  };
  // For an image without layers: calls take(x, y, fragment) for every pixel since the last call, and forgets them.
  template <typename Take>
  void take_all(const Take& take) {
    for (const Pixel& pixel : covered_) {
      Fragment& fragment = fragments_[index(pixel.x, pixel.y)];
      take(pixel.x, pixel.y, std::as_const(fragment));
      fragment.opacity = 0.0F;
    }
    covered_.clear();
  }

 private:
  struct Pixel {
    int x, y;
  };
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_, height_;
  std::vector<Fragment> fragments_;  // of every pixel
  std::vector<Pixel> covered_;       // since the last show()
  std::vector<Pixel> shown_;         // by the last show()
};

}  // namespace bodkin::scene
