#pragma once

#include <string>
#include <vector>

#include "anatomy/case.h"
#include "imaging/image_rgb.h"

namespace bodkin::imaging {

// The three views of radiology: axial as seen from the feet (patient's left on the right, back below), coronal as
// seen from the front (patient's left on the right, head above), sagittal as seen from the patient's left (front on
// the left, head above).
enum class View { axial, coronal, sagittal };

// A rectangle of square pixels anywhere in the patient, in any orientation of the stored volumes.
struct SlicePlane {
  Vec3 corner = Vec3::Zero();  // LPS mm, centre of the top left pixel
  Vec3 right = Vec3::UnitX();  // unit, along the rows
  Vec3 down = Vec3::UnitY();   // unit, along the columns, perpendicular to `right`
  double pixel = 0.5;          // mm
  int width = 0;               // pixels
  int height = 0;              // pixels

  // LPS mm of a position in the image; the centre of the top left pixel is (0, 0).
  Vec3 point(double column, double row) const { return corner + pixel * (column * right + row * down); }
  // The position in the image of a point projected onto the plane.
  Eigen::Vector2d place(const Vec3& point) const {
    return Eigen::Vector2d(right.dot(point - corner), down.dot(point - corner)) / pixel;
  }
  // Unit, away from the eye.
  Vec3 normal() const { return right.cross(down); }
  // mm from the plane, positive away from the eye.
  double distance(const Vec3& point) const { return normal().dot(point - corner); }
};

// A box along the patient's axes, LPS mm.
struct PatientBox {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();
};

// The box around everything except air (around the whole volume if there is nothing else).
PatientBox body_box(const anatomy::TissueVolume& tissues);

// The plane of a view through `middle` that covers `width` x `height` mm around it.
SlicePlane view_plane(View view, const Vec3& middle, double width, double height, double pixel);

// The plane nearest to sagittal that contains a path. A path that runs more than 45 degrees out of the sagittal plane
// gets the true sagittal plane through its target.
SlicePlane sagittal_plane_along(const anatomy::NeedlePath& path, const Vec3& middle, double width, double height,
                                double pixel);

// The letters of a direction, "A", "P", "L", "R", "S", "I", two if it runs between two axes.
std::string direction_letters(const Vec3& direction);

// The content of a plane, pixel by pixel.
struct Slice {
  SlicePlane plane;
  std::vector<float> hounsfield;           // height x width, HU, trilinear; NaN outside the CT
  std::vector<anatomy::TissueId> tissues;  // height x width, nearest voxel; 255 outside

  static constexpr anatomy::TissueId outside = 255;
};

Slice cut(const SlicePlane& plane, const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues);

// Display settings of a slice.
struct SliceLook {
  double window = 600.0;  // HU from black to white: shows both soft tissue and bone
  double level = 50.0;    // HU in the middle
  double fill = 0.22;     // opacity of the tissue's colour inside it, 0 to 1
  double border = 0.85;   // opacity on its outline
};

// The slice as an image: HU as grey, tissues tinted with the colours of the library and outlined. Air stays black.
ImageRgb paint(const Slice& slice, const anatomy::TissueLibrary& library, const SliceLook& look = {});

// The tissues in a slice, without air, most pixels first.
std::vector<anatomy::TissueId> tissues_present(const Slice& slice);

}  // namespace bodkin::imaging
