#pragma once

#include <string>
#include <vector>

#include "anatomy/case.h"
#include "core/progress.h"
#include "fem/node_forces.h"
#include "fem/solid/elastic_body.h"
#include "imaging/canvas.h"

namespace bodkin::study {

// The state of a needle in a deformable body at one time.
struct DeformedState {
  fem::NodeForces forces;          // by node of the mesh
  Pose needle = Pose::Identity();  // in the body
  double ahead = 0.0;              // mm from it to the hand's needle
  double depth = 0.0;              // mm
  double resistance = 0.0;         // N
};

// The displacement of a body at rest under forces, mm, x y z at each point (LPS mm); zero outside its mesh. `body`:
// as prepared (prepare_body); it is factorised anew, for all of its displacements. Throws InputError when that does
// not fit into memory.
std::vector<float> displacements_at(const fem::BodyDescription& body, const fem::NodeForces& forces,
                                    const std::vector<Vec3>& points, const Progress& progress = {});

// The patient in the plane of the path, at rest and as deformed by the needle, side by side with the needle. `body`:
// as returned by prepare_body() for the patient; it is factorised anew, for all of its displacements. Throws
// InputError when that does not fit into memory.
imaging::Canvas deformation_picture(const anatomy::Case& patient, const fem::BodyDescription& body,
                                    const DeformedState& moment, const Progress& progress = {});

}  // namespace bodkin::study
