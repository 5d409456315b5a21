#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "session/session_file.h"

#include "core/progress.h"
#include "training/harm.h"
#include "training/procedure.h"

namespace bodkin::training {

// The voxels of the patient that a session was recorded on, as far as a score can use them.
struct RecordedPatient {
  std::optional<anatomy::LabelVolume> structures;
  std::optional<anatomy::TissueVolume> tissues;
  std::string missing;  // why there are none: one sentence; empty where they were read

  PatientVolumes volumes() const { return {structures ? &*structures : nullptr, tissues ? &*tissues : nullptr}; }
};

// The voxels that the session keeps itself; nothing where it keeps none, which sessions of before format version 5
// do. Throws InputError for a damaged volume.
std::optional<RecordedPatient> kept_patient(const session::Session& session);

// What the session keeps, and where it keeps nothing or `folder` names a case, what `procedure` needs of the case in
// that folder (empty: where it was recorded): the segmentation, and the tissues for near misses. The case must be the
// session's own, its case.xml the same to the letter and its volumes those of the digests in it; if it is gone or
// another one, `missing` says so. The CT is not read. Throws InputError for a damaged volume.
RecordedPatient read_recorded_patient(const session::Session& session, const anatomy::CaseDescription& description,
                                      const std::filesystem::path& folder, const Procedure& procedure,
                                      const Progress& progress = {});

}  // namespace bodkin::training
