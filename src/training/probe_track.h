#pragma once

#include <vector>

#include "session/session_file.h"

#include "core/parameter.h"

namespace bodkin::training {

// The pose of an ultrasound probe, and the depth of its image.
struct ProbeState {
  double time = 0.0;           // s of the session
  Vec3 face = Vec3::Zero();    // the middle of its face, LPS mm
  Vec3 into = Vec3::Zero();    // unit, out of the face into the patient, within the slice
  Vec3 normal = Vec3::Zero();  // unit, of the slice
  double reach = unbounded;    // mm from the face, depth of the image
};

// Whether a point (LPS mm) lies within `thickness` mm of the slice and inside the image. For a probe in a second hand
// without a machine the image is unlimited: everything in front of its face. `machine`: of the session, or null.
bool is_in_picture(const ProbeState& probe, const anatomy::UltrasoundProbe* machine, const Vec3& point,
                   double thickness);

// A sample of an ultrasound machine, at a `time` (s of the session) for which it is valid.
ProbeState probe_moment(const session::ScanSample& sample, double time);

// The poses of the probe, a hundred times a second: of a second hand that held it, or else from the machine's own
// samples, each valid until the next one. Empty without a probe.
std::vector<ProbeState> probe_track(const session::Session& session);

}  // namespace bodkin::training
