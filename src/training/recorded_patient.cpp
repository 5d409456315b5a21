#include "training/recorded_patient.h"

#include <algorithm>
#include <utility>

#include "session/session_run.h"
#include <fmt/format.h>

#include "io/case_folder.h"
#include "io/resources.h"

namespace bodkin::training {

std::optional<RecordedPatient> kept_patient(const session::Session& session) {
  const session::RecordedVolumes& volumes = session.header.volumes;
  if (volumes.structures.empty() && volumes.tissues.empty()) return std::nullopt;
  RecordedPatient patient;
  if (!volumes.structures.empty()) patient.structures = session::structures_of(volumes, "the session");
  if (!volumes.tissues.empty()) patient.tissues = session::tissues_of(volumes, "the session");
  return patient;
}

RecordedPatient read_recorded_patient(const session::Session& session, const anatomy::CaseDescription& description,
                                      const std::filesystem::path& named, const Procedure& procedure,
                                      const Progress& progress) {
  if (named.empty()) {
    if (std::optional<RecordedPatient> kept = kept_patient(session)) return std::move(*kept);
  }
  const std::filesystem::path folder = named.empty() ? std::filesystem::path(session.header.case_folder) : named;
  RecordedPatient patient;
  const std::filesystem::path document = folder / "case.xml";
  std::error_code error;
  if (!std::filesystem::is_regular_file(document, error)) {
    patient.missing =
        fmt::format("the session was recorded on the case {}, which holds no case.xml now", folder.string());
    return patient;
  }
  if (io::read_text_file(document, session::largest_case_xml) != session.header.case_xml) {
    patient.missing = fmt::format("{} is not the case.xml that the session was recorded on", document.string());
    return patient;
  }
  if (!description.structures_file.empty())
    patient.structures = io::load_case_structures(folder, description, progress);
  const bool forbids_tissues = std::any_of(procedure.forbidden.begin(), procedure.forbidden.end(),
                                           [](const Forbidden& each) { return !each.tissue.empty(); });
  if (forbids_tissues) patient.tissues = io::load_case_tissues(folder, description, progress);
  return patient;
}

}  // namespace bodkin::training
