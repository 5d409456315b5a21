#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tracking/registration.h"
#include "tracking/tracker.h"

#include "anatomy/case.h"
#include "imaging/image_rgb.h"
#include "imaging/tissue_displacement.h"
#include "imaging/volume_rendering/cutaway.h"

namespace bodkin::tracking {

// The overlay of the camera's image.
struct AugmentedLook {
  Eigen::Vector2d radii{150.0, 185.0};  // of the oval, pixels
  double threshold = 0.7;               // see imaging::CutawayOval
  imaging::TransferPreset preset = imaging::TransferPreset::soft_tissue;
  double step = 1.0;           // of the rays, voxels
  std::optional<Vec3> region;  // centre of the oval, LPS mm; absent: target, or the needle's tip
  bool needle = true, plan = true, front_view = true, status = true;
  bool coarse_while_moving = true;  // half the resolution while the mannequin or the camera moves
};

// Where the needle's tip is in the patient.
struct NeedleInPatient {
  Vec3 tip = Vec3::Zero();  // LPS mm
  std::string tissue;       // at the tip, as people read it; empty outside the patient
  bool bone = false;
  double depth = 0.0;  // mm of the shaft within the patient
};

// A body as drawn in an image.
struct ShownBody {
  const MarkerBody* body = nullptr;
  const TrackedPose* pose = nullptr;
};

// The camera's image with a cutaway into the patient exactly where the mannequin is (Sutherland et al. 2013).
class AugmentedView {
 public:
  // `mannequin_from_patient`: placement of the patient in the frame of the body named "mannequin".
  AugmentedView(const anatomy::Case& patient, const CameraModel& camera, const Similarity& mannequin_from_patient,
                const AugmentedLook& look = {});

  // Draws on `picture`, which has the camera's size, according to the poses of the same image. `tools`: objects held
  // in front of the mannequin that hide the cutaway; the one named "needle" is drawn to its tip. A lost body is not
  // drawn; its status is written instead, and its earlier pose is never used. The rays are cast anew unless the
  // patient lies within a tenth of a pixel of his position at the last cast. `moved`: the displacement of his tissue
  // (null: none), which the cutaway, the planned path, the view from the front and the needle's tissues follow.
  void draw(imaging::ImageRgb& picture, const TrackedPose* mannequin, const std::vector<ShownBody>& tools,
            const imaging::TissueDisplacement* moved = nullptr);

  void set_look(const AugmentedLook& look);

  // Of the last image.
  const std::optional<NeedleInPatient>& needle() const { return needle_; }
  // Null: no cutaway in the image.
  const imaging::Cutaway* cutaway() const { return is_shown_ ? &cutaway_ : nullptr; }
  // Whether its oval is so large that it is always cast at half the resolution (imaging::cast_cutaway).
  bool is_large() const { return is_shown_ && cutaway_.large; }
  // s for casting the rays; 0: those of an earlier image were reused.
  double cast_seconds() const { return cast_seconds_; }

 private:
  void draw_tools(imaging::ImageRgb& picture, const Similarity& camera_from_patient, const TrackedPose* needle,
                  const MarkerBody* needle_body, const imaging::TissueDisplacement* moved);
  void draw_front_view(imaging::ImageRgb& picture, const imaging::TissueDisplacement* moved) const;
  std::optional<Eigen::Vector2d> pixel_of(const Vec3& in_camera) const;
  Vec3 region() const;
  double moved(const Similarity& from, const Similarity& to) const;
  bool press(const imaging::TissueDisplacement* tissue);
  void draw_patient(imaging::ImageRgb& picture, const Similarity& camera_from_patient,
                    const imaging::TissueDisplacement* tissue);

  const anatomy::Case& patient_;
  CameraModel camera_;
  Similarity mannequin_from_patient_;
  AugmentedLook look_;
  std::shared_ptr<const imaging::PreparedVolume> volume_;
  imaging::RayCaster caster_;
  ThreadPool pool_;
  std::vector<Eigen::Vector2f> rays_;  // of the lens, for every pixel
  std::optional<NeedleInPatient> needle_;
  imaging::ImageRgb before_;  // the camera's image without the overlay
  imaging::Cutaway cutaway_;
  bool is_shown_ = false, coarse_by_motion_ = false;
  double cast_seconds_ = 0.0;
  std::optional<Similarity> cast_at_, last_;  // camera from patient: of the cutaway, and of the previous image
  std::optional<imaging::TissueDisplacement> cast_tissue_;  // of the cutaway; empty: at rest
  int at_rest_ = 0;                                         // consecutive images
};

// placed_along() the patient's path; without a path, the middle of its CT is placed there.
Similarity placed_at(const anatomy::Case& patient, const Vec3& at);

}  // namespace bodkin::tracking
