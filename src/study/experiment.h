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

// One tick of an experiment; Quantity explains the members.
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

// A published number and the computed one.
struct PublishedComparison {
  io::PublishedValue published;
  double found = 0.0;
  bool agrees = false;  // |found - published| <= tolerance
};

// A completed experiment.
struct ExperimentRun {
  double dt = 0.001;  // s
  std::vector<ExperimentTick> ticks;
  std::vector<PublishedComparison> comparisons;  // in the order of the file
};

// Reads an experiment with its patient, if that is its body: the case's volumes, and the motion placed along the path
// from the skin inwards, with the deformable body that the resistance needs. `note` receives the assumptions.
// `whole`, unless null, becomes the patient's factorised body; see patient::prepare_body(). Throws InputError
// whenever io::read_experiment does, for a case that cannot be loaded and for a missing path, one that misses the
// body or one on which the motion leaves the volume.
io::Experiment load_experiment(const std::filesystem::path& file, const Progress& progress = {},
                               const std::function<void(const std::string&)>& note = {},
                               std::shared_ptr<const fem::ContactBody>* whole = nullptr);

// The body, needle and settings of an experiment as a patient in memory: a tissue map, and a CT if the resistance
// reads one. Throws InputError for a body of more than 60 million voxels or one without tissue, and for a patient not
// loaded by load_experiment().
anatomy::Case experiment_case(const io::Experiment& experiment);

// A CT on the lattice of the tissue map, without noise: the HU of each voxel's tissue.
anatomy::CtVolume ct_of_tissues(const anatomy::Case& patient);

// Moves the needle of an experiment according to its motion through the same tick as for a hand. `whole`: for a
// patient, from load_experiment(); the needle meets it off the path too. Throws InputError when body, tissues and
// settings are incompatible or when a published value's window contains no tick.
ExperimentRun play(const io::Experiment& experiment, const Progress& progress = {},
                   std::shared_ptr<const fem::ContactBody> whole = {});

// Whether a tick lies in a window; one with a depth contains only ticks in contact.
bool is_inside(const io::ExperimentWindow& window, const ExperimentTick& tick);

// A quantity of one tick in its unit; NaN when undefined (a wall whose spring is slack).
double value_of(io::Quantity quantity, const ExperimentTick& tick, const io::Experiment& experiment);

// The table of a run, a row per tick.
std::string experiment_csv(const io::Experiment& experiment, const ExperimentRun& run);

}  // namespace bodkin::study
