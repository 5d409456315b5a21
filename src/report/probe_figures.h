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

// What a report shows of an ultrasound probe: where it went, and its slice when the needle came in and when it
// rested.
class ProbeFigures {
 public:
  // `session` must outlive the object.
  explicit ProbeFigures(const session::Session& session);

  bool empty() const { return track_.empty(); }  // there was no probe

  // "The probe moved by 23 mm and turned by up to 8 deg. ..."
  std::string sentence(const training::Score& score) const;
  // The CT in the slice of the probe, with the edges of its picture, the planned path and the way of the tip: at
  // `times` (s since the first tick), each with its words.
  struct Moment {
    double time = 0.0;
    std::string words;  // "when the tip came to rest"
  };
  std::vector<imaging::SlicePanel> panels(const anatomy::Case& patient, const std::vector<Moment>& moments,
                                          const std::vector<Vec3>& travelled) const;
  // For the picture in 3-D, the slice as it was at a time.
  ProbeWay way(double time) const;

 private:
  // The edges of what the probe showed, LPS mm, a closed line. A probe in a second hand without a machine has none:
  // instead a piece of its slice, 40 mm wide, as deep as the target.
  std::vector<Vec3> outline(const training::ProbeMoment& probe) const;
  const training::ProbeMoment& at(double time) const;
  // The way of the middle of the face, LPS mm, without its trembling.
  std::vector<Vec3> way_of_face() const;

  const session::Session& session_;
  std::vector<training::ProbeMoment> track_;
  double start_ = 0.0;  // s of the session at its first tick
};

}  // namespace bodkin::report
