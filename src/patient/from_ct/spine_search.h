#pragma once

#include <optional>
#include <string>
#include <vector>

#include "patient/from_ct/body_surface.h"
#include "patient/from_ct/lumbar_landmarks.h"
#include "patient/from_ct/patient_builder.h"
#include "patient/from_ct/spine_view.h"

namespace bodkin::patient {

struct FoundSpine {
  SpineView view;
  LumbarSpine spine;
  std::string source;  // method by which it was found, for people
};

// Input for finding a spine, including the user's statements about it.
struct SpineSearch {
  const anatomy::CtVolume& ct;
  const anatomy::LabelVolume& structures;  // may be empty
  const std::vector<std::uint8_t>& roles;  // of its labels
  anatomy::TissueVolume& tissues;          // marrow is filled in if only bone shows the spine
  const BodySurface& body;
  const PatientOptions& options;
};

// The spine from the labels of its canal, else from those of its vertebrae, else only from bone. `why_not` receives
// the reason why a spine shown by bone was rejected; the user's statement on levels overrules it.
std::optional<FoundSpine> find_spine(const SpineSearch& search, std::string& why_not);

}  // namespace bodkin::patient
