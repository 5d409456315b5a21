#pragma once

#include <optional>
#include <string>

#include "patient/planning/obstacles.h"

#include "anatomy/tissue.h"
#include "training/procedure.h"

namespace bodkin::training {

// The obstacles of a path in this procedure, and the interspaces at which it may be planned.
patient::PlanningRules planning_rules(const Procedure& procedure);

// The tissue whose touch completes an attempt, because touching it is a goal of the procedure ("mass" in a biopsy);
// empty: a person ends the attempt.
std::string completing_tissue(const Procedure& procedure);
// As above, as the id in the patient's library.
std::optional<anatomy::TissueId> completing_id(const Procedure& procedure, const anatomy::TissueLibrary& library);

}  // namespace bodkin::training
