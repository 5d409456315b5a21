#include "simulation/operator_thresholds.h"

#include <algorithm>

#include "core/error.h"
#include "forces/needle_law.h"

namespace bodkin::simulation {

namespace {

constexpr double most_felt = 0.95;  // of the device's peak force: no hand can wait for more

// N; 0 if nothing gives way.
double break_force_of(const anatomy::TissueLibrary& tissues, const std::string& name) {
  const anatomy::TissueProperties* tissue = tissues.find(name);
  const bool gives_way = tissue != nullptr && tissue->layered.kind == anatomy::LayeredKind::viscoelastic;
  return gives_way ? tissue->layered.break_force : 0.0;
}

void resolve(std::optional<double>& share, double force, double most, std::optional<double>& threshold) {
  if (share) threshold = std::max(std::min(*share * force, most), threshold.value_or(0.0));
  share.reset();
}

}  // namespace

OperatorScript for_patient(const OperatorScript& script, const anatomy::Case& patient) {
  const anatomy::TissueLibrary felt = forces::effective_tissues(patient);
  const double most = most_felt * patient.description.device.peak_force;
  OperatorScript known = script;
  for (OperatorPhase& phase : known.phases) {
    for (OperatorCondition& condition : phase.until) {
      if (!condition.has_share()) continue;
      const double force = break_force_of(felt, condition.share_of);
      if (!(force > 0.0))
        throw InputError("operator '" + script.name + "': phase '" + phase.name +
                         "' waits for a share of the force at which '" + condition.share_of +
                         "' gives way, but the patient's tissue library has no such tissue that gives way; expected "
                         "the name of a tissue with a break_force_N");
      resolve(condition.drop_share, force, most, condition.force_drop);
      resolve(condition.force_above_share, force, most, condition.force_above);
      condition.share_of.clear();
    }
  }
  return known;
}

}  // namespace bodkin::simulation
