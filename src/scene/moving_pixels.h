#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "scene/picture.h"
#include "scene/raster.h"
#include "scene/still_layers.h"

namespace bodkin::scene {

// The few pixels of a frame that needles and marks cover. They are collected first, so that strokes which meet in a
// pixel are mixed with each other and only then, once, with the patient.
class MovingPixels {
 public:
  MovingPixels(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  // Over what was added before at pixel (x, y), which must be inside. `opacity`: 0 to 1, with the share of the pixel
  // that is covered; `behind`: factor on it where the patient is in front.
  void add(int x, int y, float nearness, std::uint32_t colour, float opacity, float behind);
  // Mixes all into `picture`, whose pixels are otherwise those of `still`, after it has taken back those of the last
  // call. Returns the box of all pixels that were written.
  PixelBox show(const StillLayers& layers, const Picture& still, Picture& picture);

  // See add(); of several things at one pixel, mixed.
  struct Fragment {
    float nearness = 0.0F, opacity = 0.0F, behind = 0.0F;
    std::uint32_t colour = 0;
  };
  // For a picture without layers: calls take(x, y, fragment) for every pixel since the last call, and forgets them.
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
