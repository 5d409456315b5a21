#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "session/session_file.h"

#include "core/progress.h"
#include "training/harm.h"
#include "training/procedure.h"

namespace bodkin::training {

// The voxels of a session's patient, as far as a score can use them.
struct RecordedPatient {
  std::optional<anatomy::LabelVolume> structures;
  std::optional<anatomy::TissueVolume> tissues;
  std::string missing;  // why there are none: one sentence; empty if they were read

  PatientVolumes volumes() const { return {structures ? &*structures : nullptr, tissues ? &*tissues : nullptr}; }
};

// The voxels stored in the session; empty for sessions without them, before format version 5. Throws InputError for a
// damaged volume.
std::optional<RecordedPatient> kept_patient(const session::Session& session);

// The volumes stored in the session; if it has none or `folder` names a case, those that `procedure` needs of the
// case in that folder (empty: where it was recorded): the segmentation, and the tissues for near misses. The case
// must be the session's own, with an identical case.xml and the volumes of its digests; if it does not exist or
// differs, `missing` says so. The CT is not read. Throws InputError for a damaged volume.
RecordedPatient read_recorded_patient(const session::Session& session, const anatomy::CaseDescription& description,
                                      const std::filesystem::path& folder, const Procedure& procedure,
                                      const Progress& progress = {});

}  // namespace bodkin::training
