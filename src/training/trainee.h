#pragma once

#include <cstdint>

#include "simulation/operator_script.h"

namespace bodkin::training {

// A simulated trainee: initial skill, and rate of learning.
struct Trainee {
  double skill = 0.0;     // at the first attempt: 0 the novice that comes with Bodkin, 1 the expert
  double learning = 0.1;  // fraction of the missing skill that an attempt teaches

  // After that many attempts: 1 - (1 - skill)(1 - learning)^attempts.
  double skill_after(int attempts) const;
};

// The trainee of that number in a cohort: skill uniform from 0 to 0.5, learning uniform from 0.02 to 0.25. Depends
// only on the two arguments.
Trainee draw_trainee(std::uint64_t seed, std::uint64_t number);

// An operator of this skill, 0 to 1 (clamped). Its parameters lie between those of novice and expert: hand, accuracy,
// reaction and the phases' speeds, steps and pauses; the expert's procedure, with its conditions, is kept. At 1 it is
// the expert to the bit.
simulation::OperatorScript operator_of_skill(const simulation::OperatorScript& novice,
                                             const simulation::OperatorScript& expert, double skill);

}  // namespace bodkin::training
