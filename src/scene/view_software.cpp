#include "scene/view_software.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace bodkin::scene {

SoftwareView::SoftwareView(std::shared_ptr<const PatientSurfaces> surfaces) : surfaces_(std::move(surfaces)) {
  set_size(16, 16);
}

void SoftwareView::set_size(int width, int height) {
  width = std::max(width, 1);
  height = std::max(height, 1);
  if (width == picture_.width && height == picture_.height) return;
  still_ = picture_ = Picture(width, height);
  moving_.emplace(width, height);
  layers_.emplace(width, height, detail_);
  stale_ = true;
}

void SoftwareView::set_camera(const Camera& camera) {
  if (camera == camera_) return;
  camera_ = camera;
  stale_ = true;
}

void SoftwareView::set_look(Look look) {
  if (look == look_) return;
  look_ = std::move(look);
  stale_ = true;
}

void SoftwareView::set_opening(const Opening& opening) {
  opening_ = opening;
  look_stale_ = true;
}

void SoftwareView::set_detail(int detail) {
  detail = std::clamp(detail, 1, 4);
  if (detail == detail_) return;
  detail_ = detail;
  layers_.emplace(picture_.width, picture_.height, detail_);
  stale_ = true;
}

void SoftwareView::set_needles(std::vector<NeedleLook> needles) {
  if (std::equal(needles.begin(), needles.end(), needles_.begin(), needles_.end(), same_look)) return;
  needles_ = std::move(needles);
  moving_stale_ = true;
}

void SoftwareView::set_marks(SceneMarks marks) {
  if (same_marks(marks, marks_)) return;
  marks_ = std::move(marks);
  moving_stale_ = true;
}

void SoftwareView::set_entry(const Vec3& entry, const Vec3& direction) {
  patch_ = SkinPatch(surfaces_->skin(), entry, direction);
  inner_ = patch_.empty() ? InnerPatch() : InnerPatch(*surfaces_, entry, direction.normalized());
  dented_ = inside_moved_ = false;
  breath_stale_ = breath_.moves();
  stale_ = true;
}

void SoftwareView::set_breath(const BreathMotion& breath) {
  if (breath.drawn_in == breath_.drawn_in && breath.field.has_value() == breath_.field.has_value()) return;
  breath_ = breath;
  breath_stale_ = stale_ = true;
  if (!breath_.moves()) {
    moved_.reset();
    return;
  }
  if (!moved_) moved_ = *surfaces_;
  for (std::size_t part = 0; part < moved_->parts.size(); ++part) {
    const std::vector<Eigen::Vector3f>& rest = surfaces_->parts[part].mesh.points;
    std::vector<Eigen::Vector3f>& now = moved_->parts[part].mesh.points;
    for (std::size_t i = 0; i < rest.size(); ++i) now[i] = rest[i] + breath_.of(rest[i].cast<double>()).cast<float>();
  }
}

std::vector<Vec3> SoftwareView::deformable_points() const {
  std::vector<Vec3> points = patch_.rest();
  points.insert(points.end(), inner_.rest().begin(), inner_.rest().end());
  return points;
}

void SoftwareView::set_dent(const std::optional<SkinDent>& dent, std::span<const float> displacements) {
  if (patch_.empty()) return;
  const SkinDent now = dent.value_or(SkinDent{patch_.entry(), -Vec3::UnitY(), 0.0});
  const bool dented = now.depth != 0.0 || !displacements.empty();
  if (!dented && !dented_ && !breath_stale_) return;
  if (!breath_stale_ && dented == dented_ && displacements.empty() && now.depth == dent_.depth &&
      now.entry == dent_.entry && now.direction == dent_.direction) {
    return;
  }
  const std::size_t of_skin = 3 * patch_.rest().size();
  const bool known = displacements.size() == of_skin + 3 * inner_.rest().size();
  patch_.deform(now, known ? displacements.first(of_skin) : std::span<const float>(), breath_);
  dent_ = now;
  dented_ = dented;
  patch_stale_ = true;
  const bool was_stale = std::exchange(breath_stale_, false);
  if (!known && !inside_moved_ && !was_stale) return;
  inner_.deform(known ? displacements.subspan(of_skin) : std::span<const float>(), breath_);
  inside_moved_ = known;
  inner_stale_ = true;
}

void SoftwareView::set_skin_tint(std::vector<std::uint32_t> tint) {
  if (!tint.empty() && tint.size() != surfaces_->skin().points.size())
    throw std::invalid_argument("a tint needs one colour for each point of the skin");
  if (tint == skin_tint_) return;
  skin_tint_ = std::move(tint);
  if (!skin_tint_.empty()) {
    patch_ = SkinPatch();
    inner_ = InnerPatch();
    dented_ = inside_moved_ = false;
  }
  stale_ = true;
}

PixelBox SoftwareView::draw() {
  const PixelBox whole = layers_->box();
  const bool everything = stale_ || look_stale_;
  if (stale_) {
    layers_->draw(seen(), patch_.empty() ? surfaces_->skin().triangles : patch_.around(), inner_, camera_, look_,
                  skin_tint_);
    patch_stale_ = inner_stale_ = true;
  }
  const Appearance skin = appearance(look_, surfaces_->parts.front());
  if (everything) layers_->set_look(camera_, look_.preset, skin, opening_);
  PixelBox changed;
  if (inner_stale_ && !inner_.empty()) changed = layers_->draw_inner(*surfaces_, inner_, camera_, look_);
  if (patch_stale_ && !patch_.empty() && skin.drawn()) {
    shade(patch_.mesh(), material_of(surfaces_->parts.front(), skin.colour), layers_->samples(camera_), points_);
    changed = changed.join(layers_->draw_patch(points_, patch_.mesh().triangles));
  }
  if (everything) changed = whole;
  layers_->compose(changed, still_);
  for (int y = changed.top; y < changed.bottom; ++y) {
    std::copy(still_.row(y) + changed.left, still_.row(y) + changed.right, picture_.row(y) + changed.left);
  }
  if (everything || patch_stale_ || inner_stale_ || moving_stale_) {
    const Projection seen = projection();
    draw_marks(marks_, seen, *moving_);
    for (const NeedleLook& needle : needles_) draw_needle(needle, seen, *moving_);
    changed = changed.join(moving_->show(*layers_, still_, picture_));
  }
  stale_ = look_stale_ = patch_stale_ = inner_stale_ = moving_stale_ = false;
  return changed;
}

std::optional<SurfacePoint> SoftwareView::skin_at(double x, double y) const {
  return first_hit(seen().skin(), projection().ray(x, y));
}

}  // namespace bodkin::scene
