#include "training/planning_rules.h"

#include <algorithm>
#include <sstream>

namespace bodkin::training {

patient::PlanningRules planning_rules(const Procedure& procedure) {
  patient::PlanningRules rules;
  // A plan leaves more room than a hand must: a near miss of an attempt is too small a margin for a path.
  for (const Forbidden& each : procedure.forbidden)
    rules.avoid.push_back({each.tissue, each.structure, each.title, std::max(each.margin, rules.margin)});
  std::istringstream levels(procedure.levels);
  for (std::string level; levels >> level;) rules.levels.push_back(level);
  return rules;
}

std::string completing_tissue(const Procedure& procedure) {
  for (const Goal& goal : procedure.goals)
    if (goal.by == GoalKind::touch) return goal.tissue;
  return "";
}

std::optional<anatomy::TissueId> completing_id(const Procedure& procedure, const anatomy::TissueLibrary& library) {
  const anatomy::TissueProperties* const tissue = library.find(completing_tissue(procedure));
  return tissue == nullptr ? std::nullopt : std::optional(tissue->id);
}

}  // namespace bodkin::training
