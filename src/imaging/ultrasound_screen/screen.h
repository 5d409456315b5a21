#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "imaging/canvas.h"
#include "imaging/image_rgb.h"
#include "imaging/ultrasound/frame.h"
#include "imaging/ultrasound/probe.h"
#include "imaging/ultrasound/settings.h"
#include "imaging/ultrasound_screen/scan_field.h"

namespace bodkin::imaging {

// A picture with all that made it.
struct ScanMoment {
  UltrasoundFrame frame;
  Pose pose = Pose::Identity();
  anatomy::UltrasoundProbe probe;
  UltrasoundSettings settings;
  std::string needle;  // what is said of the needle in it; empty where there is none
};

// A distance that somebody measures. Places are mm in the probe's frame (x, y).
struct Caliper {
  Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();

  double length() const { return (to - from).norm(); }  // mm
};

// A place with a name, mm in the probe's frame (x, y).
struct ImageMarker {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  std::string name;
};

// The screen of an ultrasound machine: the newest picture or a frozen one and what was measured in it.
class UltrasoundScreen {
 public:
  // `width` x `height` pixels, at least 200 x 150; `mark`: where the probe's marked side stands.
  UltrasoundScreen(int width, int height, MarkSide mark);
  // Of another size from now on, at least as large as that.
  void resize(int width, int height);
  // What is drawn for the screen's own words and lines, such as another language's; empty: they themselves.
  using Translator = std::function<std::string(const std::string& words)>;
  void translate_by(Translator translator) { translator_ = std::move(translator); }

  // The newest picture; a frozen screen does not take it.
  void take(const ScanMoment& moment);
  // Nothing was taken yet, or the frame has no pixels.
  bool empty() const { return moment_.frame.pixels.empty(); }
  // What is on the screen.
  const ScanMoment& moment() const { return moment_; }

  bool frozen() const { return frozen_; }
  // Let go, the screen forgets what was measured: it belonged to the picture that stood still.
  void freeze(bool frozen);

  // Places mm in the probe's frame. Every second one ends a caliper. Throws InputError where there is no picture or
  // the place is not finite.
  void measure(const Eigen::Vector2d& place);
  void mark(const Eigen::Vector2d& place, const std::string& name);
  // The caliper's first end, without its second.
  bool measuring() const { return measuring_; }
  void clear_measurements();
  const std::vector<Caliper>& calipers() const { return calipers_; }
  const std::vector<ImageMarker>& markers() const { return markers_; }

  // From the probe's frame, mm, to pixels of the screen, and back; both need a picture.
  Eigen::Vector2d to_screen(const Eigen::Vector2d& place) const;
  Eigen::Vector2d to_probe(const Eigen::Vector2d& pixel) const;
  // The pixel lies in the picture.
  bool holds(const Eigen::Vector2d& pixel) const;

  // What is drawn over the picture: scales, measurements and words.
  Canvas overlay() const;
  // All of it as pixels.
  ImageRgb compose() const;

 private:
  struct Box {
    double x = 0.0, y = 0.0, scale = 1.0;  // pixels; pixels of the screen per pixel of the frame
  };
  Box box() const;
  void draw_scale(Canvas& canvas) const;
  void draw_measurements(Canvas& canvas) const;
  void draw_words(Canvas& canvas) const;
  std::string translated(const std::string& words) const { return translator_ ? translator_(words) : words; }

  int width_, height_;
  MarkSide mark_;
  ScanMoment moment_;
  bool frozen_ = false;
  std::vector<Caliper> calipers_;
  bool measuring_ = false;
  Eigen::Vector2d first_ = Eigen::Vector2d::Zero();
  std::vector<ImageMarker> markers_;
  Translator translator_;
};

// "D 12.0 cm", "G -3 dB" and so on: what a machine says of a moment beside its picture, line by line. `touch`: also
// how the probe touches the patient, which changes from frame to frame.
std::vector<std::string> machine_lines(const ScanMoment& moment, bool touch = true);
// cm between the numbers of the depth's scale, so that there are not too many.
int centimetres_between_numbers(double depth);

}  // namespace bodkin::imaging
