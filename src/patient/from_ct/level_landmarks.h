#pragma once

#include <optional>

#include "patient/from_ct/spinal_canal.h"

namespace bodkin::patient {

// Heights (LPS z, mm) of bones near the spine that identify its levels, if visible in the image.
struct LevelLandmarks {
  std::optional<double> sacrum;       // top of its wings, slightly below the middle of L5/S1
  std::optional<double> lowest_rib;   // height at which the lowest ribs leave the spine; the mean of both sides
  std::optional<double> iliac_crest;  // highest point of the iliac crests, usually at L4/L5
};

// `wide` shows the image 100 mm to either side of the canal. The sacrum is where, between 28 and 40 mm from the
// midline, bone fills 1.5 cm^2 on average, nowhere less than 1.2, over 20 mm of height, with ilium next to it:
// transverse processes of lumbar vertebrae fill less. A rib is a piece of bone that reaches from 34 to 58 mm from the
// midline, begins next to the canal and descends; the lowest counts only if the image continues for 45 mm below it
// and both visible sides agree within 20 mm.
LevelLandmarks find_level_landmarks(const SpineView& wide, const SpinalCanal& canal);

// The box of such a view: the whole height of the image.
PatientBox wide_box(const SpinalCanal& canal, const PatientBox& image);

}  // namespace bodkin::patient
