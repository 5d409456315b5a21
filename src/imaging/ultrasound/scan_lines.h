#pragma once

#include <cstdint>
#include <vector>

#include "imaging/ultrasound/frame.h"
#include "imaging/ultrasound/probe.h"
#include "imaging/ultrasound/settings.h"

namespace bodkin::imaging {

// The scan lines of a probe in its own frame (z = 0), and the positions of its image's pixels among them.
struct ScanLines {
  anatomy::ProbeKind kind = anatomy::ProbeKind::linear;
  double radius = 0.0;  // mm, of the face; 0: flat
  double first = 0.0;   // of the first line: mm along the face (linear) or radians from the middle
  double step = 0.0;    // from line to line, in the same unit
  int lines = 0;
  int samples = 0;
  double spacing = 0.0;  // mm between samples along a line

  // A line's start on the face, and its direction (unit). `line` may lie between two lines.
  Vec3 origin(double line) const;
  Vec3 direction(double line) const;
  // mm between neighbouring lines at a depth.
  double apart(double depth) const;
  // The line (x) and the sample (y), both continuous, of a point of the scan plane.
  Eigen::Vector2d place(const Vec3& point) const;
};

ScanLines scan_lines(const anatomy::UltrasoundProbe& probe, const UltrasoundSettings& settings,
                     const UltrasoundDetail& detail);

// The pixels of an image among rows of samples that are `stride` long: for each the position of the sample before it
// (that of row `lines.samples`, which is black, outside the field of view) and 256ths towards the next line and
// sample.
struct ScanConversion {
  int width = 0, height = 0;
  double pixel = 0.0;          // mm
  Vec3 corner = Vec3::Zero();  // mm, centre of the top left pixel, probe's frame
  struct Run {
    std::size_t first = 0, last = 0;  // pixels, `last` is the one after
  };
  std::vector<Run> runs;                 // of pixels in the field of view, each within a row, in order
  std::vector<std::size_t> row_of_runs;  // height + 1: the first run of each row
  std::vector<std::int32_t> place;
  std::vector<std::uint8_t> weights;
};

ScanConversion scan_conversion(const ScanLines& lines, int width, int height, int stride);

}  // namespace bodkin::imaging
