#include "study/phantom.h"

#include <algorithm>
#include <cmath>

#include "study/experiment.h"
#include <fmt/format.h>

#include "core/error.h"
#include "io/case_folder.h"
#include "io/deferred_termination.h"
#include "io/partial_folder.h"
#include "io/tissue_library_file.h"

namespace bodkin::study {

namespace {

constexpr double air_above = 15.0;       // mm of the image over the skin
constexpr double outside_needle = 15.0;  // mm of the needle that stay outside at the end of the path

// From the experiment's coordinates to the patient's: its depth z towards -y, its y to z.
Vec3 laid_down(const Vec3& place) {
  return {place.x(), -place.z(), place.y()};
}

anatomy::TissueVolume laid_down(const anatomy::TissueVolume& from) {
  const double spacing = from.grid.spacing.x();
  const auto above = static_cast<int>(std::ceil(air_above / spacing));
  const auto& size = from.grid.size;
  anatomy::Grid grid;
  grid.spacing = from.grid.spacing;
  grid.size = {size[0], size[2] + above, size[1]};
  grid.origin = {from.grid.origin.x(), -(from.grid.origin.z() + (size[2] - 1) * spacing), from.grid.origin.y()};
  anatomy::TissueVolume to(grid, anatomy::tissue::air);
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) to.at(i, size[2] - 1 - k, j) = from.at(i, j, k);
    }
  }
  return to;
}

// The motion's line from the skin to its deepest place, in the experiment's coordinates.
anatomy::NeedlePath deepest_line(const io::Experiment& experiment, const anatomy::TissueVolume& tissues) {
  const io::ExperimentMotion& motion = experiment.motion;
  double deepest = 0.0;
  for (const io::ExperimentPlace& place : motion.places) deepest = std::max(deepest, place.depth);
  constexpr double step = 0.05;  // mm
  for (double depth = -experiment.body.voxel; depth < deepest; depth += step) {
    const Vec3 place = motion.entry + depth * motion.direction;
    if (anatomy::nearest<anatomy::TissueId>(tissues, place, anatomy::tissue::air) != anatomy::tissue::air)
      return {place, motion.entry + deepest * motion.direction};
  }
  throw InputError(
      fmt::format("{}: the needle never enters the body, so there is no path to practise; expected a "
                  "motion that goes deeper than its skin",
                  experiment.name));
}

}  // namespace

anatomy::CaseDescription write_phantom(const io::Experiment& experiment, const PhantomRequest& wanted,
                                       const Progress& progress) {
  if (!experiment.body.patient.empty()) {
    throw InputError(fmt::format("{}: its body is the patient {}, which can be felt as it is; expected layers",
                                 experiment.name, experiment.body.patient.string()));
  }
  const io::DeferredTermination deferred;  // ends this process, if a signal asked for it, once the folder is removed
  const Progress report = io::until_interrupted(progress);
  io::PartialFolder folder(wanted.folder, wanted.overwrite);
  report("building the layers", 0.0);
  anatomy::Case made = experiment_case(experiment);
  const anatomy::NeedlePath line = deepest_line(experiment, made.tissues);
  made.tissues = laid_down(made.tissues);
  made.ct = ct_of_tissues(made);

  anatomy::CaseDescription& description = made.description;
  if (!wanted.name.empty()) description.name = wanted.name;
  description.description = fmt::format("The body of the experiment '{}'", experiment.title);
  description.created_by = "bodkin";
  description.procedure.name = "needle_insertion";
  description.procedure.path = anatomy::NeedlePath{laid_down(line.entry), laid_down(line.target)};
  description.needle.length = std::max(description.needle.length, std::ceil(line.length() + outside_needle));
  report("writing the case", 0.5);
  io::write_case(description, made.ct, made.tissues, {}, &made.library, folder.path());
  report("writing the case", 0.99);
  folder.finish();
  if (progress) progress("writing the case", 1.0);
  return description;
}

}  // namespace bodkin::study
