#include "training/recorded_score.h"

#include <fmt/format.h>

#include "core/error.h"
#include "training/expert_table.h"
#include "training/procedure_file.h"
#include "training/recorded_patient.h"

namespace bodkin::training {

session::Session read_attempt(const std::filesystem::path& file) {
  session::Session session = session::read_session(file);
  if (session.ticks.empty())
    throw InputError(fmt::format("{}: the session holds no tick, so that there is nothing to judge", file.string()));
  return session;
}

RecordedScore score_recording(const std::filesystem::path& file, const std::string& procedure,
                              const std::filesystem::path& folder, const Progress& progress) {
  RecordedScore result;
  result.session = read_attempt(file);
  result.description = description_of(result.session);
  const Procedure by =
      procedure.empty() ? procedure_of_case(result.description.procedure.name) : find_procedure(procedure);
  const RecordedPatient patient = read_recorded_patient(result.session, result.description, folder, by, progress);
  if (!patient.missing.empty() && !folder.empty()) throw InputError("--case: " + patient.missing);
  result.missing = patient.missing;
  const auto experts = experts_of(by);
  result.score = score(result.session, result.description, by, patient.volumes(), experts ? &*experts : nullptr);
  return result;
}

}  // namespace bodkin::training
