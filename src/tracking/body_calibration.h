#pragma once

#include <vector>

#include "tracking/camera_model.h"
#include "tracking/grey_image.h"
#include "tracking/marker_body.h"
#include "tracking/photometric_refinement.h"

namespace bodkin::tracking {

// The calibration of one face of a folded body.
struct CalibratedFace {
  int id = -1;
  int pictures = 0;              // that showed it together with another face
  double deviation = 0.0;        // mm, standard deviation of its place
  double angle_deviation = 0.0;  // degrees
  double moved = 0.0;            // mm, from its nominal place
  double turned = 0.0;           // degrees
};

struct CalibratedBody {
  MarkerBody body;
  std::vector<CalibratedFace> faces;  // the marked ones
  int pictures = 0;                   // that showed at least two faces
};

// Finds the actual places of the faces of a folded body from images of it. In every image each visible face gets a
// pose of its own by photometric refinement; all of them together, with their covariances, determine the places of
// the faces and of the body in every image (least squares). The first marked face is kept in place, and the size of
// the markers is not changed: it comes from a ruler on the print.
class BodyCalibration {
 public:
  BodyCalibration(const CameraModel& camera, MarkerBody body);

  // An image of the camera's size. Returns the number of faces found in it.
  int add(const GreyImage& picture);
  // Throws InputError when a face was seen together with another one in fewer than `least` images.
  CalibratedBody solve(int least = 8) const;

 private:
  struct Seen {
    std::size_t face;  // of body_.faces
    Pose camera_from_face;
    Matrix6 information;
  };

  MarkerBody body_;
  PhotometricRefinement refinement_;
  std::vector<std::vector<Seen>> pictures_;
};

}  // namespace bodkin::tracking
