#include "training/recorded_patient.h"

#include <algorithm>

#include "session/session_run.h"
#include <fmt/format.h>

#include "io/case_folder.h"
#include "io/resources.h"

namespace bodkin::training {

RecordedPatient read_recorded_patient(const session::Session& session, const anatomy::CaseDescription& description,
                                      const std::filesystem::path& folder, const Procedure& procedure,
                                      const Progress& progress) {
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
