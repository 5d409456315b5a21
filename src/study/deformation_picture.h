#pragma once

#include <string>
#include <vector>

#include "anatomy/case.h"
#include "core/progress.h"
#include "fem/node_forces.h"
#include "fem/solid/elastic_body.h"
#include "imaging/canvas.h"

namespace bodkin::study {

// What a needle did to a deformable body at one moment.
struct DeformedMoment {
  fem::NodeForces forces;          // by node of the mesh
  Pose needle = Pose::Identity();  // in the body
  double ahead = 0.0;              // mm by which the hand is ahead of it
  double depth = 0.0;              // mm
  double resistance = 0.0;         // N
};

// How a body at rest moves under forces, mm, x y z at each point (LPS mm) in turn; nothing outside its mesh. `body`:
// what was prepared (prepare_body); it is factorised anew, for the displacement of all of it. Throws
// InputError when that does not fit into memory.
std::vector<float> displacements_at(const fem::BodyDescription& body, const fem::NodeForces& forces,
                                    const std::vector<Vec3>& points, const Progress& progress = {});

// The patient in the plane of the path, at rest and as the needle deforms it, side by side with the needle.
// `body`: what prepare_body() has returned for the patient; it is factorised anew, for the
// displacement of all of it. Throws InputError when that does not fit into memory.
imaging::Canvas deformation_picture(const anatomy::Case& patient, const fem::BodyDescription& body,
                                    const DeformedMoment& moment, const Progress& progress = {});

}  // namespace bodkin::study
