#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/camera.h"
#include "scene/mesh.h"

namespace bodkin::scene {

// Whole pixels [left, right) x [top, bottom).
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;

  bool empty() const { return right <= left || bottom <= top; }
  int width() const { return right - left; }
  int height() const { return bottom - top; }
  PixelBox meet(const PixelBox& other) const;
  // The smallest box around both; an empty one adds nothing.
  PixelBox join(const PixelBox& other) const;
  PixelBox grown(int margin) const { return {left - margin, top - margin, right + margin, bottom + margin}; }
  // The box in a picture with `factor` times as many pixels along each side.
  PixelBox times(int factor) const { return {left * factor, top * factor, right * factor, bottom * factor}; }
  // The box in a picture with 1 / `factor` times as many, rounded outwards.
  PixelBox over(int factor) const;
};

// Colours and depths of one object in a part of the image. Rows are padded, so that eight pixels from any one on may
// be read and written.
class Layer {
 public:
  Layer() = default;
  // Empty: no colour, nearness 0.
  explicit Layer(const PixelBox& box) { resize(box); }

  // Changes to another part of the image; the content is undefined afterwards.
  void resize(const PixelBox& box);
  // Sets all nearness to 0.
  void clear();
  const PixelBox& box() const { return box_; }
  bool empty() const { return colours_.empty(); }
  // 0xRRGGBB, meaningful where the nearness is above 0.
  std::uint32_t* colours(int y) { return colours_.data() + start(y); }
  const std::uint32_t* colours(int y) const { return colours_.data() + start(y); }
  // 1 / distance along the line of sight, 1/mm; 0: empty.
  float* nearness(int y) { return nearness_.data() + start(y); }
  const float* nearness(int y) const { return nearness_.data() + start(y); }
  // Of a pixel; 0 outside the box.
  float nearness_at(int x, int y) const;

 private:
  // Position of pixel x = 0 of row y: add x, box().left <= x < box().right + 8.
  std::ptrdiff_t start(int y) const { return static_cast<std::ptrdiff_t>(y - box_.top) * stride_ - box_.left; }

  PixelBox box_;
  std::ptrdiff_t stride_ = 0;
  std::vector<std::uint32_t> colours_;
  std::vector<float> nearness_;
};

// A point of a mesh in the image.
struct ScreenPoint {
  float x, y, nearness;    // as Place; nearness 0: too close to be drawn
  float red, green, blue;  // 0 to 255
};

// Draws triangles into the part of the image held by `layer`, where they are nearer than its content. Colours are
// interpolated between the corners. A pixel belongs to the triangle that contains its centre. Triangles facing away
// from the viewer are skipped if `front_only`.
void draw_triangles(std::span<const ScreenPoint> points, std::span<const std::array<std::int32_t, 3>> triangles,
                    bool front_only, Layer& layer);

}  // namespace bodkin::scene
