#pragma once

#include "anatomy/case.h"
#include "simulation/operator_script.h"

namespace bodkin::simulation {

// The script with newtons instead of shares: a share times the force at which `layered` punctures the tissue with the
// needle of this patient (forces::effective_tissues). A condition that also states a force in N gets the larger of
// the two. A share never exceeds the force that the patient's device renders. An operator knows these forces from
// experience with the needle, so the thresholds do not depend on the selected model. Throws InputError if the
// patient's library lacks the tissue or it cannot be punctured.
OperatorScript for_patient(const OperatorScript& script, const anatomy::Case& patient);

}  // namespace bodkin::simulation
