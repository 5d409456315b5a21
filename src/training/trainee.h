#pragma once

#include <cstdint>

#include "simulation/operator_script.h"

namespace bodkin::training {

// A simulated trainee: how good at the beginning, and how fast better.
struct Trainee {
  double skill = 0.0;     // at the first attempt: 0 the novice who comes with Bodkin, 1 the expert
  double learning = 0.1;  // share of what is still missing that an attempt teaches

  // After so many attempts: 1 - (1 - skill)(1 - learning)^attempts.
  double skill_after(int attempts) const;
};

// The trainee of that number in a cohort: skill evenly from 0 to 0.5, learning evenly from 0.02 to 0.25. Depends on
// nothing but the two arguments.
Trainee draw_trainee(std::uint64_t seed, std::uint64_t number);

// An operator of this skill, 0 to 1 (clamped). What both are made of lies between theirs: hand, accuracy, reaction
// and the phases' speeds, steps and pauses; the expert's way to go about it, with its conditions, is kept. At 1 it is
// the expert to the bit.
simulation::OperatorScript operator_of_skill(const simulation::OperatorScript& novice,
                                             const simulation::OperatorScript& expert, double skill);

}  // namespace bodkin::training
