#include "report/recorded_report.h"

#include "report/report.h"
#include "session/case_digest.h"
#include "session/session_run.h"
#include <fmt/format.h>

#include "core/error.h"
#include "io/case_folder.h"
#include "io/resources.h"
#include "training/expert_table.h"
#include "training/procedure_file.h"
#include "training/recorded_patient.h"

namespace bodkin::report {

namespace fs = std::filesystem;

training::Score score_for_report(const session::Session& session, const anatomy::Case& patient, bool changed,
                                 const training::Procedure& procedure, const training::ExpertSet* experts) {
  const anatomy::CaseDescription description = training::description_of(session);
  const std::optional<training::RecordedPatient> kept = training::kept_patient(session);
  // Voxels of a patient other than the recorded one do not show the tissues met by the needle.
  const training::PatientVolumes of_case =
      changed ? training::PatientVolumes{} : training::PatientVolumes{&patient.structures, &patient.tissues};
  return training::score(session, description, procedure, kept ? kept->volumes() : of_case, experts);
}

std::string recorded_report_html(const fs::path& file) {
  const session::Session session = session::read_session(file);
  const fs::path folder = session.header.case_folder;
  std::error_code failure;
  if (!fs::is_regular_file(folder / "case.xml", failure)) {
    throw InputError(
        fmt::format("{} was recorded on the case {}, which holds no case.xml now; put the case back there",
                    file.string(), folder.string()));
  }
  const anatomy::Case patient = io::load_case(folder);
  const std::string description_text = io::read_text_file(folder / "case.xml", session::largest_case_xml);
  const bool changed = !session::is_digest_of_case(session.header.case_digest, patient, description_text,
                                                   session::mesh_digest(folder, session.header.haptics.resistance));
  const training::Procedure procedure = training::procedure_of_case(training::description_of(session).procedure.name);
  const auto experts = training::experts_of(procedure);
  return report_html(session, patient,
                     score_for_report(session, patient, changed, procedure, experts ? &*experts : nullptr), changed);
}

}  // namespace bodkin::report
