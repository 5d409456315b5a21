#include "scene/volume_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bodkin::scene {

namespace {

// Two colours in 256 parts, all channels at once.
std::uint32_t between(std::uint32_t a, std::uint32_t b, std::uint32_t share) {
  const std::uint32_t rest = 256U - share;
  const std::uint32_t red_blue = ((a & 0xFF00FFU) * rest + (b & 0xFF00FFU) * share) >> 8U & 0xFF00FFU;
  const std::uint32_t green = ((a & 0x00FF00U) * rest + (b & 0x00FF00U) * share) >> 8U & 0x00FF00U;
  return 0xFF000000U | red_blue | green;
}

// Position of the middle of each of `to` pixels among `from` pixels: the one before it, and 256ths beyond.
struct Tap {
  int before, after;
  std::uint32_t share;
};
std::vector<Tap> taps(int from, int to) {
  std::vector<Tap> made(static_cast<std::size_t>(to));
  for (int i = 0; i < to; ++i) {
    const double at = std::clamp((i + 0.5) * from / to - 0.5, 0.0, from - 1.0);
    const int before = static_cast<int>(at);
    made[static_cast<std::size_t>(i)] = {before, std::min(before + 1, from - 1),
                                         static_cast<std::uint32_t>(256.0 * (at - before))};
  }
  return made;
}

}  // namespace

void VolumePicture::set_size(int width, int height) {
  if (width == picture_.width && height == picture_.height) return;
  picture_ = Picture(width, height);
  moving_.emplace(width, height);
  scale_base();
}

void VolumePicture::set_base(std::shared_ptr<const VolumeResult> base) {
  base_ = std::move(base);
  scale_base();
}

void VolumePicture::scale_base() {
  still_ = Picture(picture_.width, picture_.height);
  if (!base_ || still_.pixels.empty()) return;
  const int width = base_->request.width;
  if (width == still_.width && base_->request.height == still_.height) {
    still_.pixels = base_->pixels;
    return;
  }
  const std::vector<Tap> columns = taps(width, still_.width), rows = taps(base_->request.height, still_.height);
  for (int y = 0; y < still_.height; ++y) {
    const Tap& row = rows[static_cast<std::size_t>(y)];
    const std::uint32_t* const above = base_->pixels.data() + static_cast<std::ptrdiff_t>(row.before) * width;
    const std::uint32_t* const below = base_->pixels.data() + static_cast<std::ptrdiff_t>(row.after) * width;
    std::uint32_t* const out = still_.row(y);
    for (int x = 0; x < still_.width; ++x) {
      const Tap& column = columns[static_cast<std::size_t>(x)];
      out[x] = between(between(above[column.before], above[column.after], column.share),
                       between(below[column.before], below[column.after], column.share), row.share);
    }
  }
}

void VolumePicture::draw(const std::vector<NeedleLook>& needles, const SceneMarks& marks) {
  if (!base_ || !moving_) return;
  picture_.pixels = still_.pixels;
  const Projection seen = projection();
  draw_marks(marks, seen, *moving_);
  for (const NeedleLook& needle : needles) draw_needle(needle, seen, *moving_);
  moving_->take_all([&](int x, int y, const MovingPixels::Fragment& fragment) {
    picture_.row(y)[x] = mixed(seen, x, y, fragment);
  });
}

std::uint32_t VolumePicture::mixed(const Projection& projection, int x, int y,
                                   const MovingPixels::Fragment& fragment) const {
  const std::uint32_t whole = still_.row(y)[x];
  const imaging::VolumeMode mode = base_->request.look.mode;
  imaging::CastRay front;  // what lies before the needle
  if ((mode == imaging::VolumeMode::colour || mode == imaging::VolumeMode::grey) && fragment.nearness > 0.0F) {
    const ViewRay ray = projection.ray(x + 0.5, y + 0.5);
    const double ahead = ray.direction.dot(projection.axes().col(2));
    front = base_->caster->cast(ray.origin, ray.direction, 1.0 / (static_cast<double>(fragment.nearness) * ahead));
  }  // in a sum and in the largest HU there is no before and behind, and metal is what is seen most
  const float left = 1.0F - front.opacity, opacity = fragment.opacity;
  const float faint = fragment.behind * opacity * front.opacity;
  std::uint32_t colour = 0xFF000000U;
  const std::pair<unsigned, float> channels[3] = {{16U, front.red}, {8U, front.green}, {0U, front.blue}};
  for (const auto& [shift, light] : channels) {
    const auto own = static_cast<float>(fragment.colour >> shift & 0xFFU);
    const auto all = static_cast<float>(whole >> shift & 0xFFU);
    const float before = 255.0F * light;
    const float exact = before + left * opacity * own + (1.0F - opacity) * (all - before);
    const float shown = exact + faint * (own - exact);
    colour |= static_cast<std::uint32_t>(std::clamp(shown, 0.0F, 255.0F) + 0.5F) << shift;
  }
  return colour;
}

}  // namespace bodkin::scene
