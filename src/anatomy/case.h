#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "anatomy/breathing.h"
#include "anatomy/condensed_body.h"
#include "anatomy/force_settings.h"
#include "anatomy/needle.h"
#include "anatomy/needle_path.h"
#include "anatomy/tissue.h"
#include "anatomy/volume.h"

namespace bodkin::anatomy {

// One label of a segmentation: its name and its tissue.
struct Structure {
  std::uint16_t label = 0;  // value in the structure volume; > 0
  std::string name;         // "vertebrae_L3"
  std::string tissue;       // name of a tissue of the library: "cortical_bone"; empty: decided by HU
  bool critical = false;    // an organ or vessel that the needle must not enter
};

// A named point, LPS mm.
struct Landmark {
  std::string name;
  Vec3 position = Vec3::Zero();
};

// The limits of the device; the governor and the stiffness limits are set from them.
struct DeviceLimits {
  std::string profile = "generic";
  double peak_force = 6.0;
  double continuous_force = 2.0;
  double peak_torque = 188.0;
  double stiffness = 1.0;
  double lateral_stiffness = 0.0;
  double position_resolution = 0.0;

  // N/mm of springs that act across the needle, or to every side.
  double across() const noexcept { return lateral_stiffness > 0.0 ? lateral_stiffness : stiffness; }

  template <typename S = DeviceLimits>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"profile", &S::profile, "what the device is called", Origin::choice},
        Parameter{"peak_force_N", &S::peak_force, above(0.0, 100.0), "N", "for moments", Origin::choice},
        Parameter{"continuous_force_N", &S::continuous_force, above(0.0, 100.0), "N",
                  "for as long as one likes; at most peak_force_N", Origin::choice},
        Parameter{"peak_torque_N_mm", &S::peak_torque, Range{0.0, 1e4}, "N mm", "0: the device renders no torques",
                  Origin::choice},
        Parameter{"stiffness_N_per_mm", &S::stiffness, above(0.0, 100.0), "N/mm",
                  "that it renders stably along the needle", Origin::choice},
        Parameter{"lateral_stiffness_N_per_mm", &S::lateral_stiffness, Range{0.0, 100.0}, "N/mm",
                  "that it renders stably across the needle; 0: as along it", Origin::choice},
        Parameter{"position_resolution_mm", &S::position_resolution, Range{0.0, 1.0}, "mm", "0: without noise",
                  Origin::choice}};
  }
  static constexpr auto relations() {
    return std::tuple{AtMost{&DeviceLimits::continuous_force, &DeviceLimits::peak_force}};
  }
};

// Which numbers the force models use for their tissues (docs/needle-forces.md).
enum class Mechanics : std::uint8_t {
  tables,   // each model its own numbers of the tissue library, whatever the needle, as in Bodkin 0.1
  physical  // all models the one physical description of the tissue, for the case's needle; the tip's tissue is that
            // of the deformed material, and a thin needle buckles
};
constexpr std::array<std::string_view, 2> enumeration_names(Mechanics) {
  return {"tables", "physical"};
}

// The force on the hand while the tip is in a forbidden organ.
enum class ForceInOrgans : std::uint8_t {
  felt,  // the force of the models
  none   // nothing, as in the simulator of Kwon et al. 2001: the force fades out, and returns behind the organ
};
constexpr std::array<std::string_view, 2> enumeration_names(ForceInOrgans) {
  return {"felt", "none"};
}

struct HapticSettings {
  double rate = 1000.0;
  Mechanics mechanics = Mechanics::tables;
  ForceInOrgans force_in_organs = ForceInOrgans::felt;
  ResistanceSettings resistance;
  ConstraintSettings constraint;
  ForceParts parts;
  GravitySettings compensation;

  // Without the members that files write as elements of their own.
  static constexpr auto parameters() {
    using S = HapticSettings;
    return std::tuple{
        Parameter{"rate_Hz", &S::rate, Range{200.0, 4000.0}, "Hz", "of the haptic tick", Origin::choice},
        Parameter{"mechanics", &S::mechanics,
                  "numbers of each model's own, or one description of each tissue for every model", Origin::choice},
        Parameter{"force_in_organs", &S::force_in_organs,
                  "none: the force of every model fades to zero while the tip is in a critical structure, an organ "
                  "or a lung",
                  Origin::paper}};
  }
};

struct Procedure {
  std::string name = "lumbar_puncture";
  std::optional<NeedlePath> path;  // the planned path
  std::string target_tissue;       // tissue whose entry is the aim; empty = only the target point counts
  double target_tolerance = 3.0;   // mm; > 0
};

// The content of case.xml: everything but the voxels.
struct CaseDescription {
  std::string name;
  std::string description;
  std::string created_by;
  std::string ct_file, ct_digest;                  // relative to the case folder
  std::string structures_file, structures_digest;  // empty = no segmentation
  std::string tissues_file, tissues_digest;
  std::string tissue_library_file;  // empty = the library that comes with Bodkin
  std::vector<Structure> structures;
  Needle needle;
  DeviceLimits device;
  HapticSettings haptics;
  std::vector<Landmark> landmarks;
  Procedure procedure;
  std::optional<Breathing> breathing;  // empty: the patient does not breathe
  std::vector<std::string> notes;      // repairs and assumptions made when the case was created
};

// A patient in memory, ready for the needle.
struct Case {
  CaseDescription description;
  TissueLibrary library;
  CtVolume ct;
  LabelVolume structures;  // empty when there is no segmentation
  TissueVolume tissues;    // its lattice may be finer than the CT's
  // The deformable body, prepared by prepare_body(); empty for resistances that need none.
  PreparedBody prepared;
  // Needles left in the body earlier, from their entry to their tip at rest: prepare_body() couples them with the
  // needle in the hand, for the resistance with contact points.
  std::vector<NeedlePath> left_needles;
};

}  // namespace bodkin::anatomy
