#pragma once

#include <map>
#include <string>
#include <vector>

#include "tracking/grey_picture.h"
#include "tracking/tracker.h"

namespace bodkin::tracking {

// Says why bodies are lost in picture after picture: no marker of the dictionary is seen at all, the pictures are
// mirrored, or the markers that are seen are on no body, as those of the camera's calibration board.
class MarkerWatch {
 public:
  // `source`: name of the pictures, for sentences.
  explicit MarkerWatch(std::string source) : source_(std::move(source)) {}

  // The next picture, which `tracker` has tracked.
  void add(const Tracker& tracker, const GreyPicture& picture);

  // One sentence while it has been so for 30 pictures; else empty.
  std::string warning() const;
  // The same of all pictures together, however few: why a body was in none of them. Empty: each was seen, or nothing
  // is known.
  std::string warning_of_all() const;
  // A marker of a body was seen in some picture.
  bool any_body() const { return any_body_; }

 private:
  using Counts = std::map<int, int>;  // pictures that showed a marker, by its id

  std::string sentence_about(const Counts& foreign, int pictures) const;

  std::string source_;
  int without_ = 0;                // pictures in a row without a marker
  int lost_ = 0;                   // pictures in a row in which a body was lost
  std::string nothing_, strange_;  // of the pictures in a row
  Counts foreign_, all_foreign_;   // of those in a row, and of all
  int pictures_ = 0;
  bool any_marker_ = false, any_body_ = false;
  std::vector<bool> seen_;  // the bodies that some picture showed
  GreyPicture last_;        // while none has shown a marker
};

}  // namespace bodkin::tracking
