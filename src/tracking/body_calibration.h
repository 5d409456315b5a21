#pragma once

#include <vector>

#include "tracking/camera_model.h"
#include "tracking/grey_picture.h"
#include "tracking/marker_body.h"
#include "tracking/photometric_refinement.h"

namespace bodkin::tracking {

// What was found out about one face of a folded body.
struct CalibratedFace {
  int id = -1;
  int pictures = 0;              // in which it was seen together with another face
  double deviation = 0.0;        // mm, standard deviation of its place
  double angle_deviation = 0.0;  // degrees
  double moved = 0.0;            // mm, from where it should be
  double turned = 0.0;           // degrees
};

struct CalibratedBody {
  MarkerBody body;
  std::vector<CalibratedFace> faces;  // the marked ones
  int pictures = 0;                   // that showed two faces or more
};

// Finds where the faces of a folded body really are, from pictures of it. In every picture each visible face gets a
// pose of its own by photometric refinement; all of them together, with their covariances, give the places of the
// faces and of the body in every picture (least squares). The first marked face stays where it is, and so does the
// size of the markers: that comes from a ruler on the print.
class BodyCalibration {
 public:
  BodyCalibration(const CameraModel& camera, MarkerBody body);

  // A picture of the camera's size. Returns how many faces it gave.
  int add(const GreyPicture& picture);
  // Throws InputError when a face was seen beside another one in fewer than `least` pictures.
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
