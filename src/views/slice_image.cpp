#include "views/slice_image.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <utility>

#include "views/theme.h"

namespace bodkin::views {

const std::array<WindowPreset, 6> window_presets = {
    {{QT_TRANSLATE_NOOP("bodkin::views::SliceView", "Spine"), 620.0, 130.0},
     {QT_TRANSLATE_NOOP("bodkin::views::SliceView", "Soft tissue"), 400.0, 40.0},
     {QT_TRANSLATE_NOOP("bodkin::views::SliceView", "Bone"), 1800.0, 400.0},
     {QT_TRANSLATE_NOOP("bodkin::views::SliceView", "Lung"), 1500.0, -600.0},
     {QT_TRANSLATE_NOOP("bodkin::views::SliceView", "Liver"), 150.0, 60.0},
     {QT_TRANSLATE_NOOP("bodkin::views::SliceView", "Brain"), 80.0, 40.0}}};

namespace {

bool same_plane(const imaging::SlicePlane& a, const imaging::SlicePlane& b) {
  return a.corner == b.corner && a.right == b.right && a.down == b.down && a.pixel == b.pixel && a.width == b.width &&
         a.height == b.height;
}

}  // namespace

void SliceImage::set_case(std::shared_ptr<const OpenCase> patient) {
  patient_ = std::move(patient);
  look_.reset();
  places_.reset();
  if (patient_ == nullptr) return;
  places_.emplace(patient_->patient);
  breath_ = {};
  if (const auto& breathing = patient_->description().breathing) breath_.field.emplace(*breathing);
  constexpr double opacity = 0.38;
  std::array<std::uint32_t, 256> colours{};
  for (std::size_t id = 0; id < colours.size(); ++id) {
    colours[id] = tissue_colour(static_cast<anatomy::TissueId>(id), patient_->patient.library).rgb();
  }
  tints_ = tissue_tints(colours, opacity);
}

const QImage& SliceImage::picture(const imaging::SlicePlane& plane, const SliceLook& look, double drawn_in,
                                  std::shared_ptr<const imaging::TissueDisplacement> moved) {
  if (patient_ == nullptr || plane.width < 1 || plane.height < 1) {
    picture_ = QImage();
    return picture_;
  }
  const bool sampled = look_ && same_plane(plane, plane_) && look.slab == look_->slab &&
                       drawn_in == breath_.drawn_in && moved == moved_;
  if (sampled && look == *look_) return picture_;
  breath_.drawn_in = drawn_in;
  moved_ = std::move(moved);
  if (!sampled) {
    ++sampled_;
    breath_.moves() || moved_ != nullptr ? sample_moved(plane, look) : sample(plane, look);
  }
  paint(look);
  look_ = look;
  return picture_;
}

void SliceImage::sample(const imaging::SlicePlane& plane, const SliceLook& look) {
  plane_ = plane;
  const anatomy::Case& patient = patient_->patient;
  if (!patient.ct.empty()) {
    sample_hounsfield(plane, patient.ct, look.slab, hounsfield_);
  } else {
    sample_typical_hounsfield(plane, patient.tissues, patient.library, hounsfield_);
  }
  sample_tints(plane, patient.tissues, tints_, tint_);
  sample_forbidden(plane, *places_, forbidden_);
}

// The same in tiles, in each of which the map back to the patient at rest, who has breathed out, is taken as affine:
// over 8 pixels of a slice this is accurate to a hundredth of a millimetre for breath, and nearly so for a body.
void SliceImage::sample_moved(const imaging::SlicePlane& plane, const SliceLook& look) {
  constexpr int side = 8;  // pixels
  const std::size_t pixels = static_cast<std::size_t>(plane.width) * static_cast<std::size_t>(plane.height);
  std::vector<float> hounsfield(pixels);
  std::vector<Tint> tint(pixels);
  std::vector<std::uint8_t> forbidden(pixels);
  const auto material = [&](int column, int row) { return at_rest(plane.point(column, row)); };
  for (int top = 0; top < plane.height; top += side) {
    for (int left = 0; left < plane.width; left += side) {
      imaging::SlicePlane tile = plane;
      tile.width = std::min(side, plane.width - left);
      tile.height = std::min(side, plane.height - top);
      tile.corner = material(left, top);
      tile.right = (material(left + side, top) - tile.corner) / (side * plane.pixel);
      tile.down = (material(left, top + side) - tile.corner) / (side * plane.pixel);
      sample(tile, look);
      for (int row = 0; row < tile.height; ++row) {
        const auto from = static_cast<std::ptrdiff_t>(row) * tile.width;
        const auto to = static_cast<std::ptrdiff_t>(top + row) * plane.width + left;
        std::copy_n(hounsfield_.begin() + from, tile.width, hounsfield.begin() + to);
        std::copy_n(tint_.begin() + from, tile.width, tint.begin() + to);
        std::copy_n(forbidden_.begin() + from, tile.width, forbidden.begin() + to);
      }
    }
  }
  hounsfield_ = std::move(hounsfield);
  tint_ = std::move(tint);
  forbidden_ = std::move(forbidden);
  plane_ = plane;
}

void SliceImage::paint(const SliceLook& look) {
  ++painted_;
  constexpr int hatch_period = 9, hatch_width = 2;  // pixels along a row
  constexpr unsigned hatch_share = 150;             // of 255
  const QRgb danger = Theme::dark().danger.rgb();
  if (picture_.width() != plane_.width || picture_.height() != plane_.height) {
    picture_ = QImage(plane_.width, plane_.height, QImage::Format_RGB32);
  }
  const double scale = 255.0 / look.window, black = look.level - 0.5 * look.window;
  std::size_t at = 0;
  for (int row = 0; row < plane_.height; ++row) {
    auto* const line = reinterpret_cast<QRgb*>(picture_.scanLine(row));
    for (int column = 0; column < plane_.width; ++column, ++at) {
      const float value = hounsfield_[at];
      const double share = (value - black) * scale + 0.5;
      const unsigned grey = share >= 255.0 ? 255U : share > 0.0 ? static_cast<unsigned>(share) : 0U;  // NaN: 0
      unsigned red = grey, green = grey, blue = grey;
      const Tint tint = look.tints ? tint_[at] : 0U;
      if (tint != 0U) {
        const unsigned left = 255U - (tint >> 24);
        red = (red * left + 127U) / 255U + (tint >> 16 & 0xFFU);
        green = (green * left + 127U) / 255U + (tint >> 8 & 0xFFU);
        blue = (blue * left + 127U) / 255U + (tint & 0xFFU);
      }
      if (look.hatched && forbidden_[at] != 0 && (row + column) % hatch_period < hatch_width) {
        const auto mix = [&](unsigned below, int above) {
          return (below * (255U - hatch_share) + static_cast<unsigned>(above) * hatch_share) / 255U;
        };
        red = mix(red, qRed(danger));
        green = mix(green, qGreen(danger));
        blue = mix(blue, qBlue(danger));
      }
      line[column] = qRgb(static_cast<int>(std::min(red, 255U)), static_cast<int>(std::min(green, 255U)),
                          static_cast<int>(std::min(blue, 255U)));
    }
  }
}

}  // namespace bodkin::views
