#pragma once

#include <vector>

#include "session/session_file.h"

#include "core/parameter.h"

namespace bodkin::training {

// Where an ultrasound probe was, and how far its picture reached.
struct ProbeMoment {
  double time = 0.0;           // s of the session
  Vec3 face = Vec3::Zero();    // the middle of its face, LPS mm
  Vec3 into = Vec3::Zero();    // unit, out of the face into the patient, within the slice
  Vec3 normal = Vec3::Zero();  // unit, of the slice
  double reach = unbounded;    // mm from the face that the picture shows
};

// Whether a point (LPS mm) lies within `thickness` mm of the slice and inside the picture. A probe in a second hand
// without a machine has a picture without edges: all that is in front of its face. `machine`: of the session, or
// null.
bool is_in_picture(const ProbeMoment& probe, const anatomy::UltrasoundProbe* machine, const Vec3& point,
                   double thickness);

// A sample of an ultrasound machine, at a `time` (s of the session) at which it holds.
ProbeMoment probe_moment(const session::ScanSample& sample, double time);

// The way of the probe, a hundred times a second: that of a second hand which held it, or else as the machine's own
// samples have it, each of which holds until the next one. Empty without a probe.
std::vector<ProbeMoment> probe_track(const session::Session& session);

}  // namespace bodkin::training
