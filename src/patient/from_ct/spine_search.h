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
  std::string source;  // how it was found, for people
};

// What is looked at to find a spine, and the user's words about it.
struct SpineSearch {
  const anatomy::CtVolume& ct;
  const anatomy::LabelVolume& structures;  // may be empty
  const std::vector<std::uint8_t>& roles;  // of its labels
  anatomy::TissueVolume& tissues;          // marrow is filled in where only bone shows the spine
  const BodySurface& body;
  const PatientOptions& options;
};

// The spine by the labels of its canal, else by those of its vertebrae, else by bone alone. `why_not` becomes what
// speaks against a spine that bone shows, when it was not taken; the user's word on levels overrules it.
std::optional<FoundSpine> find_spine(const SpineSearch& search, std::string& why_not);

}  // namespace bodkin::patient
