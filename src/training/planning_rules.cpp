#include "training/planning_rules.h"

#include <sstream>

namespace bodkin::training {

patient::PlanningRules planning_rules(const Procedure& procedure) {
  patient::PlanningRules rules;
  for (const Forbidden& each : procedure.forbidden)
    rules.avoid.push_back({each.tissue, each.structure, each.title, each.margin});
  std::istringstream levels(procedure.levels);
  for (std::string level; levels >> level;) rules.levels.push_back(level);
  return rules;
}

std::string completing_tissue(const Procedure& procedure) {
  for (const Goal& goal : procedure.goals)
    if (goal.by == GoalKind::touch) return goal.tissue;
  return "";
}

}  // namespace bodkin::training
