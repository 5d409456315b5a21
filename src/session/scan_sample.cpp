#include "session/scan_sample.h"

namespace bodkin::session {

std::vector<ScannedPart> newly_scanned(const imaging::ScannedParts& found, imaging::ScannedParts& seen,
                                       const anatomy::Case& patient, double time) {
  std::vector<ScannedPart> fresh;
  for (const anatomy::TissueProperties& tissue : patient.library.tissues())
    if (found.tissues[tissue.id] && !seen.tissues[tissue.id]) fresh.push_back({false, tissue.name, time});
  for (const anatomy::Structure& structure : patient.description.structures)
    if (found.structures.contains(structure.label) && !seen.structures.contains(structure.label))
      fresh.push_back({true, structure.name, time});
  seen.tissues |= found.tissues;
  seen.structures.insert(found.structures.begin(), found.structures.end());
  return fresh;
}

}  // namespace bodkin::session
