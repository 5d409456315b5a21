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

// An image with all its inputs.
struct ScanState {
  UltrasoundFrame frame;
  Pose pose = Pose::Identity();
  anatomy::UltrasoundProbe probe;
  UltrasoundSettings settings;
  std::string needle;  // description of the needle in it; empty if there is none
};

// A measured distance. Positions are mm in the probe's frame (x, y).
struct Caliper {
  Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();

  double length() const { return (to - from).norm(); }  // mm
};

// A named position, mm in the probe's frame (x, y).
struct ImageMarker {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  std::string name;
};

// The screen of an ultrasound machine: the newest image or a frozen one and the measurements in it.
class UltrasoundScreen {
 public:
  // `width` x `height` pixels, at least 200 x 150; `mark`: side of the probe's orientation marker.
  UltrasoundScreen(int width, int height, OrientationMarkerSide mark);
  // Changes the size; same minimum.
  void resize(int width, int height);
  // Translates the screen's own words and lines; empty: no translation.
  using Translator = std::function<std::string(const std::string& words)>;
  void translate_by(Translator translator) { translator_ = std::move(translator); }

  // Shows a new image; ignored while frozen.
  void take(const ScanState& moment);
  // Whether there is no image yet, or the frame has no pixels.
  bool empty() const { return moment_.frame.pixels.empty(); }
  // The content of the screen.
  const ScanState& moment() const { return moment_; }

  bool frozen() const { return frozen_; }
  // Unfreezing discards the measurements, which belonged to the frozen image.
  void freeze(bool frozen);

  // Positions in mm in the probe's frame. Every second one ends a caliper. Throws InputError without an image or if
  // the position is not finite.
  void measure(const Eigen::Vector2d& place);
  void mark(const Eigen::Vector2d& place, const std::string& name);
  // Whether a caliper's first end is set, without its second.
  bool measuring() const { return measuring_; }
  void clear_measurements();
  const std::vector<Caliper>& calipers() const { return calipers_; }
  const std::vector<ImageMarker>& markers() const { return markers_; }

  // From the probe's frame, mm, to pixels of the screen, and back; both need an image.
  Eigen::Vector2d to_screen(const Eigen::Vector2d& place) const;
  Eigen::Vector2d to_probe(const Eigen::Vector2d& pixel) const;
  // Whether the pixel lies in the image.
  bool holds(const Eigen::Vector2d& pixel) const;

  // The overlay of the image: scales, measurements and words.
  Canvas overlay() const;
  // Image and overlay as pixels.
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
  OrientationMarkerSide mark_;
  ScanState moment_;
  bool frozen_ = false;
  std::vector<Caliper> calipers_;
  bool measuring_ = false;
  Eigen::Vector2d first_ = Eigen::Vector2d::Zero();
  std::vector<ImageMarker> markers_;
  Translator translator_;
};

// "D 12.0 cm", "G -3 dB" and so on: a machine's captions next to its image, line by line. `touch`: also the contact
// of the probe with the patient, which changes from frame to frame.
std::vector<std::string> machine_lines(const ScanState& moment, bool touch = true);
// cm between the labels of the depth scale, to limit their number.
int centimetres_between_numbers(double depth);

}  // namespace bodkin::imaging
