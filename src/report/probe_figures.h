#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/cut_open_picture.h"
#include "session/session_file.h"

#include "anatomy/case.h"
#include "imaging/slice_picture.h"
#include "training/probe_track.h"
#include "training/score.h"

namespace bodkin::report {

// Figures of an ultrasound probe in a report: its path, and its slice when the needle was inserted and when it
// rested.
class ProbeFigures {
 public:
  // `session` must outlive the object.
  explicit ProbeFigures(const session::Session& session);

  bool empty() const { return track_.empty(); }  // no probe

  // "The probe moved by 23 mm and turned by up to 8 deg. ..."
  std::string sentence(const training::Score& score) const;
  // The CT in the slice of the probe, with the edges of its image, the planned path and the path of the tip: at
  // `times` (s since the first tick), each with its caption.
  struct Moment {
    double time = 0.0;
    std::string words;  // "when the tip came to rest"
  };
  std::vector<imaging::SlicePanel> panels(const anatomy::Case& patient, const std::vector<Moment>& moments,
                                          const std::vector<Vec3>& travelled) const;
  // For the 3-D image: the slice at a time.
  ProbePath path(double time) const;

 private:
  // The edges of the probe's image, LPS mm, a closed line. For a probe in a second hand without a machine, instead a
  // piece of its slice, 40 mm wide, as deep as the target.
  std::vector<Vec3> outline(const training::ProbeState& probe) const;
  const training::ProbeState& at(double time) const;
  // The path of the middle of the face, LPS mm, smoothed.
  std::vector<Vec3> face_path() const;

  const session::Session& session_;
  std::vector<training::ProbeState> track_;
  double start_ = 0.0;  // s of the session at its first tick
};

}  // namespace bodkin::report
