#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/arguments.h"
#include "cli/ultrasound_options.h"
#include "imaging/ultrasound_screen/scanner_image.h"

namespace bodkin::cli {

// A real image for display next to the simulated one, from the command line.
struct ReferenceOptions {
  std::string file;                 // followed by ":FRAME"; empty: none
  std::string crop;                 // "left,top,width,height", pixels as stored; empty: all of it
  double pixel = 0.0;               // mm between its pixels
  std::string window, real_window;  // "across,depth,width,height", mm; empty: automatic
  Argument pixel_given;

  bool any() const { return !file.empty(); }
  // An option is given that has no meaning without a file.
  bool more() const { return !crop.empty() || pixel_given.given() || !window.empty() || !real_window.empty(); }
};

void add_reference_options(CLI::App& command, ReferenceOptions& options);

// The image with the probe's marked side at `mark`, if the file states its orientation; its first row is at the
// beginning of `probe`'s field of view. Throws InputError naming the file or the option.
imaging::ReferenceImage read_reference_image(const ReferenceOptions& options, const anatomy::UltrasoundProbe& probe,
                                             imaging::OrientationMarkerSide mark);

// Gives the simulated image the depth and pixel size of the real one, unless the command line sets them. Throws
// InputError if that depth is not available.
void match_reference_image(const UltrasoundOptions& options, const imaging::ReferenceImage& real,
                           station::UltrasoundChoice& choice);

// The windows of the two images and their grey levels.
struct GreyComparison {
  imaging::GreyWindow simulated_window, real_window;
  imaging::GreyStatistics simulated, real;
};

// The windows of the options; by default one in the middle of each image: a third of the narrower image's width, a
// tenth of the shallower one's depth. Throws InputError if a window is not inside its image.
GreyComparison compare_greys(const ReferenceOptions& options, const imaging::GreyImage& simulated,
                             const imaging::GreyImage& real);

// "grey 5, 25, 50, 75, 95 %: ..." and "half-width ...", for the space below an image.
std::vector<std::string> statistics_words(const imaging::GreyStatistics& statistics);

}  // namespace bodkin::cli
