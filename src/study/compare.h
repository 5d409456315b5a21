#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "study/needle_motion.h"

#include "anatomy/case.h"
#include "core/progress.h"
#include "forces/diagnostics.h"
#include "forces/events.h"

namespace bodkin::study {

// A resistance as one curve.
struct ComparedModel {
  std::string name;
  anatomy::ResistanceSettings settings;
};

// The names compared by default: those of `resistance_names` in their order, each followed by its variants, except
// `surface_proxy`, which does not admit the needle, and `registered`, which needs the name of a model.
//
//   layered, layered_sum                     Heng's eq. 2 as printed; the sum of elements of the text before it
//   tracking_wall, tracking_wall_leash       the wall as a number on the line; as a point that may leave it
//   volume_proxy, volume_proxy_viscous       the drag variant; the viscous one
std::span<const std::string_view> compared_names();

// The models given as texts, each once; all of compared_names() for none. A text is such a name, which keeps the
// settings of the case's own model, `own`, unless they define the variant, or a name with settings as in
// io/force_choice.h ("tracking_wall catch_up_s=0.3"), in which missing settings have their defaults. Throws
// InputError for an unknown name, listing the known ones, and for unknown settings.
std::vector<ComparedModel> models_of(const std::vector<std::string>& texts, const anatomy::ResistanceSettings& own);

// One scripted motion through a patient, the same for every model.
struct CompareOptions {
  std::optional<Vec3> entry, target;     // LPS mm; the case's planned path if absent
  double speed = 10.0;                   // mm/s, 0.5 to 500
  std::optional<double> withdraw_speed;  // mm/s, 0.5 to 500; `speed` if absent
  double pause = 2.0;                    // s at the deepest point, 0 to 60
  bool reinsert = true;                  // after the withdrawal, at `speed` to the same depth
  NeedleMotion motion;  // instead of the last three, at most 600 s; steps without a speed use `speed`; may be empty
  std::vector<ComparedModel> models;                      // at least one; names differ
  std::optional<anatomy::ConstraintSettings> constraint;  // the case's if absent
  std::optional<anatomy::ForceParts> parts;               // added to every resistance; the case's if absent
};

struct ReportedEvent {
  std::size_t tick = 0;
  forces::Event event;
};

// Result of one model on the motion. Forces are the model's resistance along the needle before the governor, positive
// pushes the hand out.
struct ModelRun {
  std::string name;
  std::vector<double> force;                        // N; motion's ticks
  std::vector<forces::DiagnosticName> diagnostics;  // that the model publishes
  std::vector<double> published;                    // their values, tick by tick

  double peak = 0.0;                                     // N, the largest on the insertion; 0 if nothing pushed
  std::size_t peak_tick = 0;                             // its first tick
  anatomy::TissueId peak_tissue = anatomy::tissue::air;  // punctured then, or else at the tip
  double peak_again = 0.0;                               // N, the largest where the tip has been before
  double lowest = 0.0;       // N, the most negative (the tissue holds the needle back on withdrawal); 0 or less
  double end_of_stop = 0.0;  // N, at the last tick before the first withdrawal, or of all without one
  std::array<double, motion_phases> work{};  // N mm taken from the hand
  // Up to `Comparison::closed`, where the motion ends as it began: at least 0 for a passive model.
  double closed_work = 0.0;  // N mm
  std::array<int, motion_phases> punctures{};
  std::vector<ReportedEvent> events;  // punctures on the insertion, in order, including the loss of resistance
  double largest_difference = 0.0;    // N, from the reference while the tip is in the body
  double rms_difference = 0.0;        // N, root mean square difference of the resistance
  double nanoseconds = 0.0;  // mean processor time of a whole tick with this model, on this machine; not reproducible
};

// A model that cannot run on the case, and the reason.
struct ModelRefused {
  std::string name;
  std::string reason;
};

struct Comparison {
  anatomy::NeedlePath path;
  CompareOptions options;
  std::string constraint;                 // its name
  double dt = 0.001;                      // s
  std::vector<double> depth;              // ticks; mm below the skin, negative before it
  std::vector<anatomy::TissueId> tissue;  // ticks; at the tip
  std::vector<MotionPhase> parts;         // kinds of the parts of the motion
  std::vector<std::size_t> first;         // tick of each part, then the number of ticks
  std::size_t closed = 0;                 // ticks until the needle is outside for the last time; 0: never
  std::vector<ModelRun> models;           // at least one, in the requested order
  std::vector<ModelRefused> refused;
  std::size_t reference = 0;           // the model with which the others are compared: `layered`, or else the first
  std::optional<double> ends_in_bone;  // mm; the depth at which the motion stops short of the target
  std::vector<std::string> notes;      // assumptions, one sentence each

  MotionPhase phase_of(std::size_t tick) const;
};

// Plays one motion - in at constant speed from 10 mm before the skin, a stop, out, in again through the same channel,
// or the one of the options - through the tick of `patient` with one model after another. Settings of the case's own
// model are kept, others have their defaults. The motion ends at the target or in bone, where a spring of that bone's
// stiffness (at most the device's) would require the device's peak force. Forces have the same bits each time.
//
// Work taken from the hand is the integral of resistance over the insertion, by the trapezoidal rule. Models that
// throw InputError are in `refused`; throws InputError itself when all do, for an option out of its range, a motion
// of more than 3 million ticks, and when the path is invalid or misses the body (saying by how much). `prepare` adds
// to the case what the model in its description needs (its deformable body); it may be empty.
Comparison compare_models(anatomy::Case patient, const CompareOptions& options, const Progress& progress = {},
                          const std::function<void(anatomy::Case&)>& prepare = {});

// A row per tick: time_s, depth_mm, and per model a column NAME_N and one NAME_DIAGNOSTIC for each of its
// diagnostics, with each run of characters in a name other than letters, digits and points replaced by one
// underscore.
std::string comparison_csv(const Comparison& comparison);

}  // namespace bodkin::study
