#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/arguments.h"
#include "cli/ultrasound_options.h"
#include "imaging/ultrasound_screen/machine_picture.h"

namespace bodkin::cli {

// A real picture to be shown beside the simulated one, as the command line gives it.
struct BesideOptions {
  std::string file;                 // with ":FRAME" behind it; empty: none
  std::string crop;                 // "left,top,width,height", pixels as stored; empty: all of it
  double pixel = 0.0;               // mm between its pixels
  std::string window, real_window;  // "across,depth,width,height", mm; empty: found
  Argument pixel_given;

  bool any() const { return !file.empty(); }
  // An option is given that means nothing without a file.
  bool more() const { return !crop.empty() || pixel_given.given() || !window.empty() || !real_window.empty(); }
};

void add_beside_options(CLI::App& command, BesideOptions& options);

// The picture with the probe's marked side where `mark` says, as far as the file tells which that is; its first row
// is where the field of view of `probe` begins. Throws InputError naming the file or the option.
imaging::RealPicture read_real_picture(const BesideOptions& options, const anatomy::UltrasoundProbe& probe,
                                       imaging::MarkSide mark);

// The simulated picture gets the depth and the size of pixels of the real one, as far as the command line does not
// say otherwise. Throws InputError when there is no such depth.
void match_real_picture(const UltrasoundOptions& options, const imaging::RealPicture& real,
                        station::UltrasoundChoice& choice);

// The windows of the two pictures and their greys.
struct BesideCompared {
  imaging::GreyWindow simulated_window, real_window;
  imaging::GreyStatistics simulated, real;
};

// The windows that the options say, otherwise in both pictures one in the middle: a third of the narrower picture's
// width, a tenth of the shallower's depth. Throws InputError when a window is not inside its picture.
BesideCompared compare_greys(const BesideOptions& options, const imaging::GreyPicture& simulated,
                             const imaging::GreyPicture& real);

// "grey 5, 25, 50, 75, 95 %: ..." and "half-width ...", for below a picture.
std::vector<std::string> statistics_words(const imaging::GreyStatistics& statistics);

}  // namespace bodkin::cli
