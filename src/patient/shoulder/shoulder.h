#pragma once

#include <cstdint>
#include <vector>

#include "anatomy/case.h"
#include "core/progress.h"

namespace bodkin::patient {

enum class BodySide : std::uint8_t { left, right };

// The target of the planned needle.
enum class ShoulderTarget : std::uint8_t { joint, suprascapular_nerve };

// Parameters of a synthetic shoulder.
struct ShoulderParameters {
  std::uint64_t seed = 1;  // small variations of sizes, and the noise of the HU
  double age = 55.0;       // years, 18 to 95: bone density, fat in the muscles
  double height = 1.72;    // m, 1.40 to 2.05: scales bones and muscles
  double weight = 76.0;    // kg, 40 to 160: with height, the fat under the skin and the deltoid
  double fluid = 4.0;      // mm of fluid between the head of the humerus and the capsule, 2.5 to 8
  BodySide side = BodySide::right;
  double spacing = 1.0;  // mm, isotropic voxels, 0.6 to 2
};

// Tissues that a shoulder has in addition to Bodkin's own, by id and name; its case contains a library with them.
inline constexpr anatomy::TissueId joint_capsule = 33, tendon = 34, joint_space = 35;
inline constexpr const char *joint_capsule_name = "joint_capsule", *tendon_name = "tendon",
                            *joint_space_name = "joint_space";

// `library` with the three. Their numbers are our choice: needle forces in them have never been measured. Throws
// InputError if the library uses an id or a name for something else, or lacks the tissues from which they are
// derived.
anatomy::TissueLibrary with_joint_tissues(const anatomy::TissueLibrary& library);

struct SyntheticShoulder {
  anatomy::CtVolume ct;
  anatomy::LabelVolume structures;  // TotalSegmentator ids if it has one
  std::vector<anatomy::Structure> structure_table;
  anatomy::TissueVolume tissues;
  std::vector<anatomy::Landmark> landmarks;  // acromion_corner, coracoid_tip, humeral_head, glenoid
  // Joint: from behind, 20 mm below and 10 mm medial of the posterolateral corner of the acromion, towards the
  // coracoid, to the middle of the fluid. Suprascapular nerve: from behind and above, above the spine of the scapula,
  // to a point in the supraspinous fossa next to the nerve, 5 mm from its axis.
  anatomy::NeedlePath path;
};

// Throws InputError naming the parameter, its value and its range.
void check_shoulder(const ShoulderParameters& parameters);

// The same parameters give the same voxels on every machine. HU and their noise come from `library`, which must have
// the tissues of with_joint_tissues. LPS, mm; the origin is the centre of the head of the humerus. Throws InputError.
SyntheticShoulder synthesize_shoulder(const ShoulderParameters& parameters, const anatomy::TissueLibrary& library,
                                      const Progress& progress = {}, ShoulderTarget target = ShoulderTarget::joint);

struct ShoulderVariant {
  ShoulderParameters parameters;  // with the seed; the spacing is the default
  int gauge = 22;                 // of the needle: 21, 22 or 23
};

// A shoulder whose parameters are drawn from the seed: age 30 to 85 years, height about 1.70 m (standard deviation
// 0.09), body mass index 19 to 45 and mostly below 33, fluid of 3 to 6 mm, either side. The distributions are our
// choice.
ShoulderVariant draw_shoulder(std::uint64_t seed);

}  // namespace bodkin::patient
