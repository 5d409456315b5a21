#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/hand/needle_control.h"
#include "app/models/station_link.h"
#include "station/puncture_watch.h"
#include "views/changes.h"
#include "views/frame.h"
#include "views/open_case.h"

namespace bodkin::app {

using namespace views;

// Builds the frame of one time from the data of the station, the hand and the patient, and finds the changes. It
// remembers state that a single frame does not show: whether the skin is punctured, whether the tip is on bone, how
// long the needle has been in the body.
class FrameMaker {
 public:
  // A new attempt on this patient (null: none).
  void begin(std::shared_ptr<const OpenCase> patient, const std::optional<anatomy::NeedlePath>& plan);

  // Everything in the frame except its state, warning, hint and clock. `control`: null if another device holds the
  // needle. `hand`: of the mouse.
  void update(Frame& frame, const StationUpdate& news, const NeedleControl* control, const HandReport& hand);
  // The differences from the last drawn frame, after the calls so far; to be called once the frame is complete.
  Changes changes(const Frame& frame);

  bool is_touching() const noexcept { return contact_.is_touching(); }
  bool has_punctured() const noexcept { return contact_.has_punctured(); }
  bool is_on_bone() const noexcept { return contact_.is_on_bone(); }
  // LPS mm, position in the frame of the tissue that is at `material` after expiration.
  Vec3 seen(const Vec3& material) const;
  // Empty: the patient does not breathe.
  const std::optional<anatomy::BreathField>& breath() const noexcept { return breath_; }
  // The inverse of seen().
  Vec3 in_material(const Vec3& place) const;

 private:
  void place_needle(Frame& frame, const StationUpdate& news, const NeedleControl* control,
                    const HandReport& hand) const;
  void breathe(Frame& frame, double drawn_in);
  void measure_plan(Frame& frame) const;
  double pushed_of(const Frame& frame) const;
  bool have_moved(std::span<const LeftNeedle> left);
  SkinDimple dimple_of(const Frame& frame, const StationUpdate& news) const;

  std::shared_ptr<const OpenCase> patient_;
  std::optional<anatomy::NeedlePath> plan_;
  station::PunctureWatch contact_;
  bool new_attempt_ = true;
  double time_in_body_ = 0.0, last_time_ = 0.0;
  std::optional<anatomy::BreathField> breath_;
  double drawn_in_ = 0.0;   // displayed value
  Frame last_;              // as last drawn
  std::vector<Pose> left_;  // left needles, as last drawn
};

}  // namespace bodkin::app
