#pragma once

#include <map>
#include <string>
#include <vector>

#include "tracking/grey_image.h"
#include "tracking/tracker.h"

namespace bodkin::tracking {

// Explains why bodies are lost in image after image: no marker of the dictionary is seen at all, the images are
// mirrored, or the markers belong to no body, for example to the camera's calibration board.
class MarkerWatch {
 public:
  // `source`: name of the images, for sentences.
  explicit MarkerWatch(std::string source) : source_(std::move(source)) {}

  // The next image, already processed by `tracker`.
  void add(const Tracker& tracker, const GreyImage& picture);

  // One sentence after 30 such images in a row; else empty.
  std::string warning() const;
  // As warning(), for all images together, however few: why a body was in none of them. Empty: each was seen, or the
  // reason is unknown.
  std::string warning_of_all() const;
  // Whether a marker of a body was seen in some image.
  bool any_body() const { return any_body_; }

 private:
  using Counts = std::map<int, int>;  // images that showed a marker, by its id

  std::string sentence_about(const Counts& foreign, int pictures) const;

  std::string source_;
  int without_ = 0;                // consecutive images without a marker
  int lost_ = 0;                   // consecutive images in which a body was lost
  std::string nothing_, strange_;  // of the consecutive images
  Counts foreign_, all_foreign_;   // of the consecutive ones, and of all
  int pictures_ = 0;
  bool any_marker_ = false, any_body_ = false;
  std::vector<bool> seen_;  // the bodies seen in some image
  GreyImage last_;          // until one has shown a marker
};

}  // namespace bodkin::tracking
