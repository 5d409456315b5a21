#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "scene/breath_motion.h"
#include "scene/camera.h"
#include "scene/inner_patch.h"
#include "scene/look.h"
#include "scene/marks.h"
#include "scene/moving_pixels.h"
#include "scene/needle_actor.h"
#include "scene/picking.h"
#include "scene/picture.h"
#include "scene/skin_patch.h"
#include "scene/still_layers.h"
#include "scene/surfaces.h"

namespace bodkin::scene {

// The image of patient, needles and marks, drawn only by the processor. Setters only store requests; draw() does the
// work required: with camera and body at rest, the pixels of needles and marks; with a dent, also the skin about it;
// with a new camera or preset, everything. One thread.
class SoftwareView {
 public:
  explicit SoftwareView(std::shared_ptr<const PatientSurfaces> surfaces);

  // Pixels. At most 1920 x 1080 are recommended: draw larger images at lower resolution and scale them up.
  void set_size(int width, int height);
  void set_camera(const Camera& camera);
  void set_preset(Preset preset) { set_look({preset, {}}); }
  void set_look(Look look);
  void set_opening(const Opening& opening);
  // Samples along each side of a pixel, 1 to 4: 2 smooths edges, 1 is for large pictures while the camera turns.
  void set_detail(int detail);
  void set_needles(std::vector<NeedleLook> needles);
  void set_marks(SceneMarks marks);
  // Cuts out the skin about the entry of a needle as a patch, which can dent from then on.
  void set_entry(const Vec3& entry, const Vec3& direction);
  // LPS mm at rest: the points whose displacements are required, of the skin about the entry and then of the surfaces
  // inside near the needle's line.
  std::vector<Vec3> deformable_points() const;
  // See SkinPatch::deform; empty: the skin at rest. `displacements`: of deformable_points(). After set_entry().
  void set_dent(const std::optional<SkinDent>& dent, std::span<const float> displacements = {});

  // Breathing of the patient. The body at rest (set_entry, deformable_points, set_dent) is that after expiration.
  void set_breath(const BreathMotion& breath);

  // Colours blended over the skin, 0xAARRGGBB for each of its points (surfaces().skin()); empty: none. Tinted skin
  // does not dent. Throws std::invalid_argument for another number of colours.
  void set_skin_tint(std::vector<std::uint32_t> tint);

  // Updates the image. Returns the box of the pixels written, empty if none.
  PixelBox draw();

  const Picture& picture() const { return picture_; }
  const Camera& camera() const { return camera_; }
  const Look& look() const { return look_; }
  int width() const { return picture_.width; }
  int height() const { return picture_.height; }
  Projection projection() const { return {camera_, picture_.width, picture_.height}; }
  const SkinPatch& patch() const { return patch_; }
  const InnerPatch& inner_patch() const { return inner_; }
  // After expiration.
  const PatientSurfaces& surfaces() const { return *surfaces_; }
  const std::shared_ptr<const PatientSurfaces>& shared_surfaces() const { return surfaces_; }
  const StillLayers& layers() const { return *layers_; }
  // The skin under a pixel, undented.
  std::optional<SurfacePoint> skin_at(double x, double y) const;

 private:
  // At present.
  const PatientSurfaces& seen() const { return moved_ ? *moved_ : *surfaces_; }

  std::shared_ptr<const PatientSurfaces> surfaces_;
  std::optional<PatientSurfaces> moved_;  // by breathing; empty: after expiration
  BreathMotion breath_;
  bool breath_stale_ = false;  // the patches have not yet been moved with it
  Camera camera_;
  Look look_;
  Opening opening_;
  int detail_ = 2;
  std::vector<NeedleLook> needles_;
  SceneMarks marks_;
  SkinPatch patch_;
  InnerPatch inner_;
  std::vector<std::uint32_t> skin_tint_;
  SkinDent dent_;
  bool dented_ = false;
  bool inside_moved_ = false;

  bool stale_ = true;        // layers
  bool look_stale_ = true;   // what covers what
  bool patch_stale_ = true;  // the skin about the needle
  bool inner_stale_ = true;  // what moves inside
  bool moving_stale_ = true;
  std::optional<StillLayers> layers_;
  std::optional<MovingPixels> moving_;
  Picture still_, picture_;
  std::vector<ScreenPoint> points_;
};

}  // namespace bodkin::scene
