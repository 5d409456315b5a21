#pragma once

#include "anatomy/case.h"
#include "simulation/operator_script.h"

namespace bodkin::simulation {

// The script with newtons in place of shares: a share times the force at which `layered` lets the tissue give way to
// the needle of this patient (forces::felt_tissues). A condition that states a force in N as well has the larger of
// the two. A share is never more than the device of the patient renders. An operator knows this from experience with
// the needle in hand, so the thresholds do not depend on the model that is felt. Throws InputError where the
// patient's library has no such tissue or it does not give way.
OperatorScript for_patient(const OperatorScript& script, const anatomy::Case& patient);

}  // namespace bodkin::simulation
