#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "haptics/simulated_hand.h"

namespace bodkin::simulation {

// When a phase of an operator ends. All stated conditions must hold together. Sensations (forces and hardness) take
// effect after the operator's reaction time, plans (time and the needle's marks) at once.
struct OperatorCondition {
  static constexpr int end = -1;

  std::optional<double> time;             // s since the phase began, at least
  std::optional<double> travel;           // mm that the tip has moved since the phase began, at least
  std::optional<double> depth_above;      // mm of needle beyond the planned entry, read off its marks, at least
  std::optional<double> depth_below;      // mm, at most; negative = outside
  std::optional<double> remaining_below;  // mm left to the planned target, at most
  std::optional<double> force_above;      // N pushing the hand out, at least
  std::optional<double> force_below;      // N, at most
  std::optional<double> force_drop;       // N by which the force fell from its peak of the last 0.3 s, at least
  std::optional<double> hardness_above;   // N/mm by which the force rose over the last 0.15 s, at least
  // As force_drop and force_above, as fractions of the force at which a tissue is punctured by the needle. They have
  // no effect until the patient is known, see for_patient().
  std::string share_of;  // name of the tissue
  std::optional<double> drop_share;
  std::optional<double> force_above_share;
  int next = end;  // the following phase, or `end`

  bool has_share() const { return drop_share || force_above_share; }
  bool has_force_condition() const {
    return force_above || force_below || force_drop || hardness_above || has_share();
  }
};

// One action of an operator: moves along the line of aim, or holds still, until a condition holds.
struct OperatorPhase {
  std::string name;
  double speed = 0.0;           // mm/s along the line of aim, positive inwards; 0 = holds still; -200 to 200
  double acceleration = 200.0;  // mm/s^2, change of the speed; > 0
  double step = 0.0;            // mm advanced between pauses; 0 = no pauses
  double pause = 0.0;           // s of each pause
  double tilt = 0.0;            // rad, rotation of the needle towards the head (about the entry) at the start
  double shift = 0.0;           // mm towards the head along the skin, off the line of aim, during the phase
  double twirl = 0.0;           // rad from one turning point about the needle's axis to the other, during the phase
  double twirl_rate = 1.0;      // Hz, of the twirling
  bool finger = false;          // palpates with a finger instead of the needle, during the phase
  bool move_stylet = false;     // removes or reinserts the stylet at the start
  bool move_manometer = false;  // connects or removes the manometer at the start
  bool aim_again = false;       // aims at the entry anew: with a new random error
  int at_most = 0;              // how often the phase may be entered; 0 = without limit
  int otherwise = OperatorCondition::end;  // the phase that replaces it when that number is reached
  std::vector<OperatorCondition> until;    // the first one that holds applies
};

// A virtual trainee: a hand, its accuracy and its habits. Standard deviations are of a normal distribution.
struct OperatorScript {
  std::string name;
  std::string description;
  haptics::HandParameters hand;
  double aim_position = 0.5;          // mm, standard deviation of the entry point along each of two axes
  double aim_angle = 0.0087;          // rad, standard deviation of the direction about each of two axes
  double reaction = 0.18;             // s, mean time from sensation to action
  double reaction_spread = 0.03;      // s, standard deviation
  double unsteadiness = 0.0;          // standard deviation of the speed as a fraction of the intended speed
  double wander = 0.0;                // mm, standard deviation of a slow drift of the tip across the line of aim
  double wander_angle = 0.0;          // rad, the same of the direction
  double start_distance = 30.0;       // mm before the skin; > 0
  std::vector<OperatorPhase> phases;  // the first one is the start
};

// Throws InputError for an invalid script: no phases, a phase without an end, a value out of range, a reference to a
// phase that does not exist. `origin` names the script in the message.
void check(const OperatorScript& script, const std::string& origin);

}  // namespace bodkin::simulation
