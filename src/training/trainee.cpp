#include "training/trainee.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/random.h"

namespace bodkin::training {

namespace {

constexpr double best_beginner = 0.5;
constexpr double slowest_learning = 0.02, fastest_learning = 0.25;

// From the novice's value towards the expert's; at 1 the expert's own bits.
double between(double novice, double expert, double skill) {
  return skill >= 1.0 ? expert : novice + skill * (expert - novice);
}

haptics::HandParameters hand_of_skill(const haptics::HandParameters& novice, const haptics::HandParameters& expert,
                                      double skill) {
  haptics::HandParameters hand = expert;
  for (double haptics::HandParameters::*member :
       {&haptics::HandParameters::mass, &haptics::HandParameters::stiffness, &haptics::HandParameters::damping,
        &haptics::HandParameters::inertia, &haptics::HandParameters::rotation_stiffness,
        &haptics::HandParameters::rotation_damping, &haptics::HandParameters::tremor,
        &haptics::HandParameters::tremor_angle})
    hand.*member = between(novice.*member, expert.*member, skill);
  return hand;
}

}  // namespace

double Trainee::skill_after(int attempts) const {
  return 1.0 - (1.0 - skill) * std::pow(1.0 - learning, attempts);
}

Trainee draw_trainee(std::uint64_t seed, std::uint64_t number) {
  Random random(mix64(seed) ^ mix64(number + 1));
  Trainee trainee;
  trainee.skill = random.uniform(0.0, best_beginner);
  trainee.learning = random.uniform(slowest_learning, fastest_learning);
  return trainee;
}

simulation::OperatorScript operator_of_skill(const simulation::OperatorScript& novice,
                                             const simulation::OperatorScript& expert, double skill) {
  using simulation::OperatorPhase;
  using simulation::OperatorScript;
  skill = std::clamp(skill, 0.0, 1.0);
  OperatorScript script = expert;
  script.name = fmt::format("skill {:.3f}", skill);
  script.hand = hand_of_skill(novice.hand, expert.hand, skill);
  for (double OperatorScript::*member :
       {&OperatorScript::aim_position, &OperatorScript::aim_angle, &OperatorScript::reaction,
        &OperatorScript::reaction_spread, &OperatorScript::unsteadiness, &OperatorScript::wander,
        &OperatorScript::wander_angle})
    script.*member = between(novice.*member, expert.*member, skill);
  for (OperatorPhase& phase : script.phases) {
    const auto same = std::find_if(novice.phases.begin(), novice.phases.end(),
                                   [&](const OperatorPhase& each) { return each.name == phase.name; });
    if (same == novice.phases.end()) continue;
    // A phase that moves for one and rests for the other reflects a different habit, not skill.
    if (same->speed * phase.speed > 0.0) phase.speed = between(same->speed, phase.speed, skill);
    if (same->step > 0.0 && phase.step > 0.0) {
      phase.step = between(same->step, phase.step, skill);
      phase.pause = between(same->pause, phase.pause, skill);
    }
  }
  return script;
}

}  // namespace bodkin::training
