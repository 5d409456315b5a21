#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "anatomy/case.h"
#include "core/random.h"
#include "simulation/operator_script.h"
#include "simulation/tick_record.h"

namespace bodkin::simulation {

// The senses of an operator at one tick: the pose of the needle in the hand, and the force on the hand.
struct OperatorSense {
  Pose needle = Pose::Identity();  // LPS
  Vec3 force = Vec3::Zero();       // N, of the device on the hand
};

// Performs a script along a planned path: converts sensations into an intended motion. It never sees tissues, depths
// in the model or events. Equal seeds and equal sensations give equal intentions. step() allocates nothing.
class Operator {
 public:
  // Throws InputError for an invalid script or one with shares left (see for_patient()), or a path of zero length.
  // `dt`: s.
  Operator(const OperatorScript& script, const anatomy::NeedlePath& path, std::uint64_t seed, double dt);

  // The pose of the needle before the first tick.
  Pose start() const noexcept;
  // The intended pose of the needle at the end of this tick.
  Pose step(const OperatorSense& sense) noexcept;
  // Actions of the other hand in the tick of the last step().
  OtherHand other_hand() const noexcept { return other_; }
  // Whether the script has ended.
  bool finished() const noexcept { return phase_ == OperatorCondition::end; }
  // Position of the present phase in the script, or OperatorCondition::end.
  int phase() const noexcept { return phase_; }

 private:
  // Normal numbers at even intervals with a smooth interpolation, standard deviation near 1.
  class SlowNoise {
   public:
    SlowNoise(double interval, double dt, std::uint64_t seed);
    double next() noexcept;

   private:
    Random random_;
    double rate_;  // intervals per tick
    double position_ = 0.0;
    double from_;
    double to_;
  };

  // Recent sensations, one sample every few milliseconds.
  struct ForceSample {
    double force = 0.0;    // N, pushing out
    double advance = 0.0;  // mm
  };

  void add_sample(const OperatorSense& sense) noexcept;
  bool holds(const OperatorCondition& condition) const noexcept;
  double recent_drop() const noexcept;
  double recent_hardness() const noexcept;
  void decide() noexcept;
  void enter(int phase) noexcept;
  void draw_aim() noexcept;
  void move() noexcept;

  OperatorScript script_;
  anatomy::NeedlePath path_;
  double dt_;
  Random random_;
  SlowNoise speed_noise_;
  std::array<SlowNoise, 4> wander_;  // tip across the line (2), direction (2)
  Vec3 across_, along_;              // unit, perpendicular to the planned direction
  Vec3 cephalad_;                    // unit, the same, towards the head
  OtherHand other_;

  // the line of aim
  Vec3 aim_entry_, aim_direction_;  // the intended one
  Vec3 entry_, direction_;          // the present one, following at a human pace
  double intended_ = 0.0;           // mm along the line beyond the entry
  double speed_ = 0.0;              // mm/s
  double twirled_ = 0.0;            // rad about the needle's axis

  // the phase
  int phase_ = 0;
  std::vector<int> visits_;     // per phase
  double phase_time_ = 0.0;     // s
  double phase_advance_ = 0.0;  // mm, the tip's advance at the start of the phase
  double stepped_ = 0.0;        // mm since the last pause
  double pausing_ = 0.0;        // s left of a pause
  bool pending_ = false;        // a sensation awaits its response
  int pending_next_ = 0;        // the phase of the response
  double pending_time_ = 0.0;   // s left until the response

  // what is felt
  double force_ = 0.0;    // N, smoothed
  double advance_ = 0.0;  // mm along the planned line beyond the planned entry
  bool first_ = true;
  std::vector<ForceSample> samples_;  // ring over the longest memory
  std::size_t newest_ = 0;
  std::size_t sample_count_ = 0;  // samples since the phase began
  int until_sample_ = 0;          // ticks
  int sample_ticks_;
};

}  // namespace bodkin::simulation
