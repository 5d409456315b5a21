#include "training/case_score.h"

#include "training/expert_table.h"
#include "training/procedure_file.h"

namespace bodkin::training {

Score score_on_case(const session::Session& session, const anatomy::Case& patient, const std::string& name) {
  const Procedure procedure =
      name.empty() ? procedure_of_case(patient.description.procedure.name) : find_procedure(name);
  const auto experts = experts_of(procedure);
  return score(session, patient.description, procedure, {&patient.structures, &patient.tissues},
               experts ? &*experts : nullptr);
}

}  // namespace bodkin::training
