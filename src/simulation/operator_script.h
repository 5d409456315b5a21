#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "haptics/simulated_hand.h"

namespace bodkin::simulation {

// When a phase of an operator ends. Everything that is given must hold together. What is felt (the forces and the
// hardness) is answered after the operator's reaction time, what is planned (time and the needle's marks) at once.
struct OperatorCondition {
  static constexpr int end = -1;

  std::optional<double> time;             // s since the phase began, at least
  std::optional<double> travel;           // mm that the tip has moved since the phase began, at least
  std::optional<double> depth_above;      // mm of needle beyond the planned entry, read off its marks, at least
  std::optional<double> depth_below;      // mm, at most; negative = outside
  std::optional<double> remaining_below;  // mm still to go to the planned target, at most
  std::optional<double> force_above;      // N pushing the hand out, at least
  std::optional<double> force_below;      // N, at most
  std::optional<double> force_drop;       // N by which the force fell from its peak of the last 0.3 s, at least
  std::optional<double> hardness_above;   // N/mm by which the force rose over the last 0.15 s, at least
  // The same of force_drop and force_above, as shares of the force at which a tissue gives way to the needle. They
  // say nothing until the patient is known, see for_patient().
  std::string share_of;  // name of the tissue
  std::optional<double> drop_share;
  std::optional<double> force_above_share;
  int next = end;  // position of the phase that follows, or `end`

  bool has_share() const { return drop_share || force_above_share; }
  bool is_felt() const { return force_above || force_below || force_drop || hardness_above || has_share(); }
};

// One thing that an operator does: moves along the line of aim, or holds still, until a condition holds.
struct OperatorPhase {
  std::string name;
  double speed = 0.0;           // mm/s along the line of aim, positive inwards; 0 = holds still; -200 to 200
  double acceleration = 200.0;  // mm/s^2 by which the speed changes; > 0
  double step = 0.0;            // mm advanced between pauses; 0 = no pauses
  double pause = 0.0;           // s of each pause
  double tilt = 0.0;            // rad by which the needle is turned towards the head (about the entry) at the start
  double shift = 0.0;           // mm towards the head along the skin, beside the line of aim, while the phase lasts
  double twirl = 0.0;           // rad from one turning point about the needle's axis to the other, while it lasts
  double twirl_rate = 1.0;      // Hz of it
  bool finger = false;          // feels with a finger in place of the needle, while the phase lasts
  bool move_stylet = false;     // takes the stylet out, or puts it back, at the start
  bool move_manometer = false;  // connects the manometer, or takes it off, at the start
  bool aim_again = false;       // looks for the entry anew: a new error of aim is drawn
  int at_most = 0;              // how often the phase may be entered; 0 = as often as it comes
  int otherwise = OperatorCondition::end;  // the phase instead, when it has been entered that often
  std::vector<OperatorCondition> until;    // the first that holds decides
};

// A virtual trainee: a hand, its accuracy and its habits. Standard deviations are of a normal distribution.
struct OperatorScript {
  std::string name;
  std::string description;
  haptics::HandParameters hand;
  double aim_position = 0.5;          // mm, standard deviation of the entry point along each of two axes
  double aim_angle = 0.0087;          // rad, standard deviation of the direction about each of two axes
  double reaction = 0.18;             // s, mean from feeling to acting
  double reaction_spread = 0.03;      // s, standard deviation
  double unsteadiness = 0.0;          // standard deviation of the speed as a share of the wanted speed
  double wander = 0.0;                // mm, standard deviation of a slow drift of the tip across the line of aim
  double wander_angle = 0.0;          // rad, the same of the direction
  double start_distance = 30.0;       // mm before the skin; > 0
  std::vector<OperatorPhase> phases;  // begins with the first
};

// Throws InputError for a script that cannot be performed: no phases, a phase without an end, a value out of range, a
// phase that follows but does not exist. `origin` names the script in the sentence.
void check(const OperatorScript& script, const std::string& origin);

}  // namespace bodkin::simulation
