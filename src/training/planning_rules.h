#pragma once

#include <optional>
#include <string>

#include "patient/planning/obstacles.h"

#include "anatomy/tissue.h"
#include "training/procedure.h"

namespace bodkin::training {

// What a path of this procedure keeps away from, and at which interspaces it may be planned.
patient::PlanningRules planning_rules(const Procedure& procedure);

// The tissue whose touch completes an attempt, because touching it is a goal of the procedure ("mass" in a biopsy);
// empty: a person ends the attempt.
std::string completing_tissue(const Procedure& procedure);
// The same as the patient's library numbers it.
std::optional<anatomy::TissueId> completing_id(const Procedure& procedure, const anatomy::TissueLibrary& library);

}  // namespace bodkin::training
