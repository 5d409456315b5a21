#include "patient/shoulder/shoulder_case.h"

#include <fmt/format.h>

#include "anatomy/generic_device.h"
#include "core/error.h"
#include "io/case_folder.h"
#include "io/deferred_termination.h"
#include "io/partial_folder.h"
#include "io/tissue_library_file.h"

namespace bodkin::patient {
namespace {

constexpr double tolerance = 3.0;                          // mm about the target: at a nerve, less than lies between
constexpr double short_needle = 50.0, long_needle = 90.0;  // mm
constexpr double stays_outside = 5.0;                      // mm of the needle

}  // namespace

anatomy::CaseDescription write_shoulder_case(const ShoulderCase& wanted, const Progress& teller) {
  const io::DeferredTermination deferred;  // ends this process, if a signal asked for it, once the folder is removed
  const Progress progress = io::until_interrupted(teller);
  check_shoulder(wanted.shoulder);
  const anatomy::TissueLibrary library = with_joint_tissues(io::default_tissue_library());
  io::PartialFolder folder(wanted.folder, wanted.overwrite);
  const SyntheticShoulder made = synthesize_shoulder(wanted.shoulder, library, progress, wanted.target);
  const bool at_nerve = wanted.target == ShoulderTarget::suprascapular_nerve;
  const char* const usual = at_nerve ? "ultrasound_guided_nerve_block" : "joint_injection";

  anatomy::CaseDescription description;
  description.name = wanted.name.empty() ? wanted.folder.filename().string() : wanted.name;
  const ShoulderParameters& shoulder = wanted.shoulder;
  description.description =
      fmt::format("Synthetic {} shoulder: {:g} years, {:g} m, {:g} kg, {:g} mm of fluid in the joint, seed {}",
                  shoulder.side == BodySide::left ? "left" : "right", shoulder.age, shoulder.height, shoulder.weight,
                  shoulder.fluid, shoulder.seed);
  description.created_by = "bodkin";
  description.structures = made.structure_table;
  description.landmarks = made.landmarks;
  description.haptics.mechanics = wanted.mechanics;
  description.procedure.name = wanted.procedure.empty() ? usual : wanted.procedure;
  description.procedure.path = made.path;
  description.procedure.target_tolerance = tolerance;
  if (wanted.needle) {
    description.needle = *wanted.needle;
  } else {
    const std::optional<anatomy::GaugeSize> size = anatomy::gauge_size(wanted.gauge);
    if (!size) throw InputError(fmt::format("synthetic shoulder: there is no needle of {}G", wanted.gauge));
    description.needle.gauge = wanted.gauge;
    description.needle.outer_diameter = size->outer_diameter;
    description.needle.inner_diameter = size->inner_diameter;
    description.needle.length = made.path.length() + stays_outside > short_needle ? long_needle : short_needle;
  }
  description.device = anatomy::generic_device(description.needle, wanted.mechanics);
  progress("writing the case", 0.0);
  io::write_case(description, made.ct, made.tissues, made.structures, &library, folder.path());
  progress("writing the case", 0.99);
  folder.finish();
  if (teller) teller("writing the case", 1.0);
  return description;
}

}  // namespace bodkin::patient
