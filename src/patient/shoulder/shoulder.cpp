#include "patient/shoulder/shoulder.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "patient/shoulder/shoulder_model.h"
#include "patient/synthetic/bounded_normal.h"
#include "patient/synthetic/painter.h"
#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel_for.h"
#include "core/random.h"
#include "core/settings_check.h"

namespace bodkin::patient {
namespace {

// From the model's left shoulder to the patient's.
Vec3 placed(Vec3 point, BodySide side) {
  if (side == BodySide::right) point.x() = -point.x();
  return point;
}

std::vector<anatomy::Structure> shoulder_structures(const anatomy::LabelVolume& labels, BodySide side) {
  using namespace shoulder_label;
  const std::string end = side == BodySide::left ? "_left" : "_right";
  const std::uint16_t other = side == BodySide::left ? 0 : 1;
  const auto of_bone = [other](std::uint16_t label) { return static_cast<std::uint16_t>(label + other); };
  const std::vector<anatomy::Structure> all = {
      {of_bone(humerus), "humerus" + end, "bone", false},
      {of_bone(scapula), "scapula" + end, "bone", false},
      {of_bone(clavicle), "clavicula" + end, "bone", false},
      {joint, "glenohumeral_joint" + end, joint_space_name, false},
      {artery, "axillary_artery" + end, "vessel", true},
      {vein, "axillary_vein" + end, "vessel", true},
      {plexus, "brachial_plexus" + end, "nerve", true},
      {axillary_nerve, "axillary_nerve" + end, "nerve", true},
      {suprascapular_nerve, "suprascapular_nerve" + end, "nerve", true},
      {side == BodySide::left ? lung_left : lung_right, "lung_upper_lobe" + end, "lung", true},
  };
  const std::set<std::uint16_t> present(labels.voxels.begin(), labels.voxels.end());
  std::vector<anatomy::Structure> table;
  for (const anatomy::Structure& each : all)
    if (present.contains(each.label)) table.push_back(each);
  return table;
}

std::uint16_t label_on(std::uint16_t label, BodySide side) {
  using namespace shoulder_label;
  if (side == BodySide::left) return label;
  if (label == lung_left) return lung_right;
  return label == humerus || label == scapula || label == clavicle ? static_cast<std::uint16_t>(label + 1) : label;
}

// The path with its target in the middle of the first fluid on its line, by the voxels.
anatomy::NeedlePath aimed_at_fluid(const Vec3& entry, const Vec3& direction, const anatomy::TissueVolume& tissues) {
  double begin = -1.0, end = -1.0;
  for (double depth = 0.0; depth < 160.0; depth += 0.2) {
    const anatomy::TissueId id = anatomy::nearest(tissues, Vec3(entry + depth * direction), anatomy::tissue::air);
    if (id == joint_space) {
      if (begin < 0.0) begin = depth;
      end = depth;
    } else if (begin >= 0.0) {
      break;
    }
  }
  if (begin < 0.0) {
    throw InputError(
        "synthetic shoulder: the voxels are too coarse for the space of the joint, expected a smaller spacing or "
        "more "
        "fluid");
  }
  return {entry, entry + 0.5 * (begin + end) * direction};
}

}  // namespace

anatomy::TissueLibrary with_joint_tissues(const anatomy::TissueLibrary& library) {
  const auto derived = [&library](anatomy::TissueId from, anatomy::TissueId id, const char* name, const char* title) {
    const anatomy::TissueProperties* const found = library.find(from);
    if (found == nullptr) {
      throw InputError(fmt::format(
          "synthetic shoulder: the tissue library has no tissue with id {}, expected it for the {}", from, title));
    }
    anatomy::TissueProperties made = *found;
    made.id = id;
    made.name = name;
    made.title = title;
    return made;
  };
  anatomy::TissueProperties capsule =
      derived(anatomy::tissue::interspinous_ligament, joint_capsule, joint_capsule_name, "joint capsule");
  constexpr double force = 2.0;  // N
  capsule.colour = 0x5FA8D3;
  capsule.hounsfield = 70.0;
  capsule.layered.stiffness = 0.8;
  capsule.layered.element_spacing = 20.0;
  capsule.layered.break_force = force;
  capsule.tracking_wall = {.stiffness = 0.8, .force = force};
  capsule.volume_proxy.properties.penetrability = force;
  capsule.deformable.puncture_force = force;
  capsule.physical.puncture_force = force;
  capsule.source =
      "Bodkin default, no published value: gives way at 2 N, less than half of the ligamentum flavum. All else as "
      "the "
      "interspinous ligament.";
  anatomy::TissueProperties sinew =
      derived(anatomy::tissue::supraspinous_ligament, tendon, tendon_name, "tendon of the rotator cuff");
  sinew.colour = 0xD8E2DC;
  sinew.source = "Bodkin default, no published value: as the supraspinous ligament.";
  anatomy::TissueProperties space =
      derived(anatomy::tissue::cerebrospinal_fluid, joint_space, joint_space_name, "joint space");
  space.colour = 0x2EC4B6;
  space.hounsfield = 15.0;
  space.syringe.pressure = 0.0;
  space.source = "Bodkin default, no published value: fluid that a needle does not feel, as cerebrospinal fluid.";
  std::vector<anatomy::TissueProperties> tissues = library.tissues();
  tissues.push_back(std::move(capsule));
  tissues.push_back(std::move(sinew));
  tissues.push_back(std::move(space));
  return anatomy::TissueLibrary(std::move(tissues));
}

void check_shoulder(const ShoulderParameters& parameters) {
  constexpr auto origin = "synthetic shoulder";
  check_range(origin, "age", parameters.age, {18.0, 95.0}, "years");
  check_range(origin, "height", parameters.height, {1.40, 2.05}, "m");
  check_range(origin, "weight", parameters.weight, {40.0, 160.0}, "kg");
  check_range(origin, "fluid", parameters.fluid, {2.5, 8.0}, "mm");
  check_range(origin, "spacing", parameters.spacing, {0.6, 2.0}, "mm");
}

ShoulderSizes shoulder_sizes(const ShoulderParameters& parameters) {
  Random random(mix64(parameters.seed ^ 0x53484F554CULL));
  const auto vary = [&random](double percent) { return 1.0 + 0.01 * percent * bounded_normal(random, 2.5); };
  const double bmi = std::clamp(parameters.weight / (parameters.height * parameters.height), 15.0, 60.0);
  const double excess = bmi - 25.0;
  ShoulderSizes sizes{};
  sizes.scale = parameters.height / 1.72 * vary(1.5);
  sizes.head = 24.0 * sizes.scale * vary(2.0);  // mean 24, standard deviation 2.1 mm (Iannotti et al. 1992)
  sizes.fluid = parameters.fluid;
  sizes.glenoid_gap = std::min(0.5 * parameters.fluid, 3.0);
  sizes.cuff = 8.0 * sizes.scale * vary(4.0);
  // Fat and deltoid behind: our choice.
  sizes.deltoid = (14.0 + std::clamp(0.35 * excess, -4.0, 5.0)) * sizes.scale * vary(3.0);
  sizes.fat = std::max(6.0 + (excess > 0.0 ? 0.9 : 0.5) * excess, 1.5) * vary(5.0);
  sizes.skin = 1.8 * vary(4.0);
  return sizes;
}

SyntheticShoulder synthesize_shoulder(const ShoulderParameters& parameters, const anatomy::TissueLibrary& library,
                                      const Progress& progress, ShoulderTarget target) {
  check_shoulder(parameters);
  const BodySide side = parameters.side;
  const ShoulderModel model(shoulder_sizes(parameters), parameters.spacing);
  const Vec3 low = model.lowest(), high = model.highest();
  anatomy::Grid grid;
  grid.spacing = Vec3::Constant(parameters.spacing);
  for (int axis = 0; axis < 3; ++axis) {
    const double length = high[axis] - low[axis];
    grid.size[static_cast<std::size_t>(axis)] = static_cast<int>(std::ceil(length / parameters.spacing)) + 1;
  }
  grid.origin = low;
  if (side == BodySide::right) grid.origin.x() = -(low.x() + parameters.spacing * (grid.size[0] - 1));

  SyntheticShoulder made;
  made.tissues = anatomy::TissueVolume(grid);
  made.structures = anatomy::LabelVolume(grid);
  parallel_for(grid.size[2], "anatomy", progress, [&](int k) {
    std::size_t at = grid.offset(0, 0, k);
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i, ++at) {
        const Material material = model.at(placed(grid.to_patient(Vec3(i, j, k)), side));
        made.tissues.voxels[at] = material.tissue;
        made.structures.voxels[at] = label_on(material.label, side);
      }
    }
  });
  if (target == ShoulderTarget::suprascapular_nerve) {
    made.path = {placed(model.block_entry(), side), placed(model.block(), side)};
  } else {
    made.path = aimed_at_fluid(placed(model.entry(), side), placed(model.direction(), side), made.tissues);
  }
  made.landmarks = {{"acromion_corner", placed(model.acromion_corner(), side)},
                    {"coracoid_tip", placed(model.coracoid_tip(), side)},
                    {"humeral_head", Vec3::Zero()},
                    {"glenoid", placed(model.glenoid(), side)},
                    {"suprascapular_nerve", placed(model.blocked_nerve(), side)}};
  made.structure_table = shoulder_structures(made.structures, side);
  LumbarSizes adult{};  // for the effect of age on bone and muscle, as in the lumbar torso
  adult.cancellous_factor = std::clamp(1.0 - 0.0125 * (parameters.age - 45.0), 0.4, 1.3);
  adult.cortical_factor = std::clamp(1.0 - 0.003 * (parameters.age - 45.0), 0.8, 1.05);
  adult.torso.muscle_fat = std::clamp((parameters.age - 35.0) / 60.0, 0.0, 1.0);
  made.ct = paint_ct(made.tissues, library, adult, parameters.seed, progress);
  return made;
}

ShoulderVariant draw_shoulder(std::uint64_t seed) {
  const auto in_steps = [](double value, double per_unit) { return std::floor(value * per_unit + 0.5) / per_unit; };
  ShoulderVariant drawn;
  ShoulderParameters& patient = drawn.parameters;
  patient.seed = seed;
  Random random(mix64(seed ^ 0x5348564152ULL));
  patient.age = in_steps(random.uniform(30.0, 85.0), 1.0);
  patient.height = in_steps(std::clamp(1.70 + 0.09 * bounded_normal(random, 2.5), 1.45, 2.0), 100.0);
  const double share = random.uniform();
  const double body_mass_index = 19.0 + 14.0 * share + 12.0 * share * share * share;
  patient.weight = in_steps(std::clamp(body_mass_index * patient.height * patient.height, 40.0, 160.0), 1.0);
  patient.fluid = in_steps(random.uniform(3.0, 6.0), 2.0);
  patient.side = random.uniform() < 0.5 ? BodySide::left : BodySide::right;
  drawn.gauge = 21 + static_cast<int>(random.uniform() * 3.0);
  return drawn;
}

}  // namespace bodkin::patient
