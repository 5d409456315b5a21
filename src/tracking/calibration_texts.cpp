#include "tracking/calibration_texts.h"

#include <fmt/format.h>

namespace bodkin::tracking {

namespace {

constexpr double a_while = 0.5, again = 3.0;  // s

const char* what_to_do(PictureUse use) {
  switch (use) {
    case PictureUse::kept:
      break;
    case PictureUse::few_corners:
      return "bring more of the board into the picture, in even light";
    case PictureUse::moving:
      return "hold the board still";
    case PictureUse::seen_already:
      return "hold the board elsewhere, or tilt it";
  }
  return "";
}

}  // namespace

std::string CalibrationTexts::of(PictureUse use, double time) {
  if (use != use_) next_ = time + a_while;
  use_ = use;
  if (use == PictureUse::kept || time < next_) return {};
  next_ = time + again;
  return fmt::format("not kept: {}; {}", name_of(use), what_to_do(use));
}

}  // namespace bodkin::tracking
