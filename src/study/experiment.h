#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "anatomy/case.h"
#include "core/progress.h"
#include "fem/solid/contact_body.h"
#include "forces/diagnostics.h"
#include "io/experiment_file.h"

namespace bodkin::study {

// One tick of an experiment; see Quantity for what is what.
struct ExperimentTick {
  double time = 0.0;        // s
  double depth = 0.0;       // mm along the line that was frozen at contact; 0 outside
  double velocity = 0.0;    // mm/s
  double resistance = 0.0;  // N
  double constraint = 0.0;  // N
  double aside = 0.0;       // mm
  double tilt = 0.0;        // rad
  Vec3 tip = Vec3::Zero();  // mm
  Wrench requested, applied;
  forces::Diagnostics diagnostics{};  // of the resistance, see its ResistanceTraits
  anatomy::TissueId tissue = anatomy::tissue::air;
  bool in_contact = false;
};

// A published number and what came out.
struct PublishedComparison {
  io::PublishedValue published;
  double found = 0.0;
  bool agrees = false;  // |found - published| <= tolerance
};

// An experiment that has been played.
struct ExperimentRun {
  double dt = 0.001;  // s
  std::vector<ExperimentTick> ticks;
  std::vector<PublishedComparison> comparisons;  // in the order of the file
};

// Reads an experiment with its patient, if that is its body: the case's volumes, and the motion laid along the path
// from the skin inwards, with the deformable body that the resistance needs. `note` hears what was assumed. `whole`,
// unless null, becomes the patient's factorised body; see patient::prepare_body(). Throws InputError for what
// io::read_experiment refuses, for a case that cannot be loaded and for no path, one that misses the body or one that
// the motion leaves at the end of the volume.
io::Experiment load_experiment(const std::filesystem::path& file, const Progress& progress = {},
                               const std::function<void(const std::string&)>& note = {},
                               std::shared_ptr<const fem::ContactBody>* whole = nullptr);

// The body, needle and settings of an experiment as a patient in memory: a tissue map, and a CT where the resistance
// reads one. Throws InputError for a body of more than 60 million voxels or one without tissue, and for a patient
// that was not loaded by load_experiment().
anatomy::Case experiment_case(const io::Experiment& experiment);

// A CT on the lattice of the tissue map, without noise: the HU of each voxel's tissue.
anatomy::CtVolume ct_of_tissues(const anatomy::Case& patient);

// Moves the needle of an experiment through the same tick that a hand would feel, as its motion says. `whole`: of a
// patient, what load_experiment() gave; the needle meets it beside the path too. Throws InputError when body, tissues
// and settings do not go together or when a published value's window holds no tick.
ExperimentRun play(const io::Experiment& experiment, const Progress& progress = {},
                   std::shared_ptr<const fem::ContactBody> whole = {});

// Whether a tick lies in a window; one that says a depth holds ticks in contact only.
bool is_inside(const io::ExperimentWindow& window, const ExperimentTick& tick);

// A quantity of one tick in its unit; NaN when undefined (a wall whose spring is slack).
double value_of(io::Quantity quantity, const ExperimentTick& tick, const io::Experiment& experiment);

// The table of a run, a row per tick.
std::string experiment_csv(const io::Experiment& experiment, const ExperimentRun& run);

}  // namespace bodkin::study
