#pragma once

#include <vector>

#include "session/session_file.h"

namespace bodkin::training {

// Where an ultrasound probe was.
struct ProbeMoment {
  double time = 0.0;           // s of the session
  Vec3 face = Vec3::Zero();    // the middle of its face, LPS mm
  Vec3 into = Vec3::Zero();    // unit, out of the face into the patient, within the slice
  Vec3 normal = Vec3::Zero();  // unit, of the slice
};

// The way of the probe, a hundred times a second: that of a second hand which held it, or else as the machine's own
// samples have it, each of which holds until the next one. Empty without a probe.
std::vector<ProbeMoment> probe_track(const session::Session& session);

}  // namespace bodkin::training
