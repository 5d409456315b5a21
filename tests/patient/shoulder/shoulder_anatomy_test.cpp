#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "patient/shoulder/shoulder.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/tissue_library_file.h"

// The anatomy of synthetic shoulders, measured in their voxels.

namespace bodkin_test {
namespace {

using namespace bodkin;
using namespace bodkin::patient;
namespace tissue = anatomy::tissue;

const anatomy::TissueLibrary& joint_library() {
  static const anatomy::TissueLibrary library = with_joint_tissues(io::default_tissue_library());
  return library;
}

ShoulderParameters coarse(std::uint64_t seed = 1) {
  ShoulderParameters parameters;
  parameters.seed = seed;
  parameters.spacing = 1.25;
  return parameters;
}

const SyntheticShoulder& usual_shoulder() {
  static const SyntheticShoulder made = synthesize_shoulder(coarse(), joint_library());
  return made;
}

Vec3 landmark_of(const SyntheticShoulder& made, const std::string& name) {
  for (const anatomy::Landmark& each : made.landmarks)
    if (each.name == name) return each.position;
  ADD_FAILURE() << "no landmark " << name;
  return Vec3::Zero();
}

// The tissues on a line, each once, in order.
std::vector<anatomy::TissueId> met(const SyntheticShoulder& made, double beyond_target) {
  std::vector<anatomy::TissueId> found;
  const Vec3 direction = made.path.direction();
  for (double depth = 0.5; depth < made.path.length() + beyond_target; depth += 0.2) {
    const anatomy::TissueId id =
        anatomy::nearest(made.tissues, Vec3(made.path.entry + depth * direction), tissue::air);
    if (found.empty() && id == tissue::air) continue;  // the skin begins in the middle of a voxel
    if (std::find(found.begin(), found.end(), id) == found.end()) found.push_back(id);
  }
  return found;
}

double nearest_distance(const SyntheticShoulder& made, const std::set<anatomy::TissueId>& wanted) {
  const anatomy::Grid& grid = made.tissues.grid;
  const Vec3 entry = made.path.entry, direction = made.path.direction();
  double least = 1e6;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        if (!wanted.contains(made.tissues.at(i, j, k))) continue;
        const Vec3 off = grid.to_patient(Vec3(i, j, k)) - entry;
        const double along = std::clamp(off.dot(direction), 0.0, made.path.length());
        least = std::min(least, (off - along * direction).norm());
      }
    }
  }
  return least;
}

TEST(ShoulderAnatomy, posterior_approach_begins_below_and_medial_of_the_acromion_and_points_at_the_coracoid) {
  const SyntheticShoulder& made = usual_shoulder();
  const Vec3 corner = landmark_of(made, "acromion_corner");
  EXPECT_NEAR(corner.z() - made.path.entry.z(), 20.0, 0.1);
  EXPECT_NEAR(made.path.entry.x() - corner.x(), 10.0, 0.1);  // a right shoulder: medial is towards the left
  EXPECT_GT(made.path.entry.y(), corner.y());                // from behind
  const Vec3 to_coracoid = (landmark_of(made, "coracoid_tip") - made.path.entry).normalized();
  EXPECT_GT(to_coracoid.dot(made.path.direction()), 0.9999);
}

TEST(ShoulderAnatomy, acromion_and_coracoid_are_bone_where_their_landmarks_say) {
  const SyntheticShoulder& made = usual_shoulder();
  for (const char* name : {"acromion_corner", "coracoid_tip"}) {
    const Vec3 place = landmark_of(made, name);
    double least = 1e6;
    const anatomy::Grid& grid = made.structures.grid;
    for (int k = 0; k < grid.size[2]; ++k)
      for (int j = 0; j < grid.size[1]; ++j)
        for (int i = 0; i < grid.size[0]; ++i)
          if (made.structures.at(i, j, k) == 72)
            least = std::min(least, (grid.to_patient(Vec3(i, j, k)) - place).norm());
    EXPECT_LT(least, 4.0) << name;
  }
}

TEST(ShoulderAnatomy, needle_meets_skin_fat_deltoid_cuff_capsule_and_joint_in_this_order) {
  const std::vector<anatomy::TissueId> expected = {tissue::skin, tissue::fat, tissue::muscle, joint_capsule,
                                                   joint_space};
  EXPECT_EQ(met(usual_shoulder(), 0.0), expected);
}

TEST(ShoulderAnatomy, beyond_the_joint_lies_cartilage_then_bone) {
  const std::vector<anatomy::TissueId> found = met(usual_shoulder(), 9.0);
  const auto cartilage = std::find(found.begin(), found.end(), tissue::cartilage);
  ASSERT_NE(cartilage, found.end());
  EXPECT_TRUE(std::any_of(cartilage, found.end(), [](anatomy::TissueId id) {
    return id == tissue::cortical_bone || id == tissue::cancellous_bone;
  }));
}

TEST(ShoulderAnatomy, joint_has_the_sizes_of_its_sources) {
  const SyntheticShoulder& made = usual_shoulder();
  const anatomy::Grid& grid = made.tissues.grid;
  // Glenoid: the extent of the cartilage of the scapula, upwards. Head: bone and cartilage about the origin,
  // downwards and backwards free of the shaft.
  double low = 1e6, high = -1e6;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        if (made.tissues.at(i, j, k) != tissue::cartilage || made.structures.at(i, j, k) != 72) continue;
        const double z = grid.to_patient(Vec3(i, j, k)).z();
        low = std::min(low, z);
        high = std::max(high, z);
      }
  EXPECT_NEAR(high - low, 39.0, 3.0);  // Iannotti et al. 1992: 39 mm, standard deviation 3.7
  double radius = 0.0;
  for (; radius < 40.0; radius += 0.1) {
    const Vec3 place = radius * Vec3(0.42, 0.9, 0.1).normalized();  // towards the capsule behind
    if (anatomy::nearest(made.tissues, place, tissue::air) == joint_space) break;
  }
  EXPECT_NEAR(radius, 24.0, 2.1);  // Iannotti et al. 1992: 24 mm, standard deviation 2.1
}

TEST(ShoulderAnatomy, vessels_and_nerves_are_there_and_the_approach_keeps_clear_of_them) {
  const SyntheticShoulder& made = usual_shoulder();
  std::set<std::string> names;
  for (const anatomy::Structure& each : made.structure_table) {
    names.insert(each.name);
    EXPECT_EQ(each.critical, each.tissue == "vessel" || each.tissue == "nerve" || each.tissue == "lung") << each.name;
  }
  for (const char* name : {"axillary_artery_right", "axillary_vein_right", "brachial_plexus_right",
                           "lung_upper_lobe_right", "axillary_nerve_right", "suprascapular_nerve_right",
                           "humerus_right", "scapula_right", "clavicula_right", "glenohumeral_joint_right"})
    EXPECT_TRUE(names.contains(name)) << name;
  EXPECT_GT(nearest_distance(made, {tissue::vessel, tissue::lung}), 20.0);
  EXPECT_GT(nearest_distance(made, {tissue::nerve}), 10.0);
}

TEST(ShoulderAnatomy, every_varied_shoulder_has_a_clear_way_into_its_joint) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    ShoulderParameters parameters = draw_shoulder(seed).parameters;
    parameters.spacing = 1.5;
    const SyntheticShoulder made = synthesize_shoulder(parameters, joint_library());
    const std::vector<anatomy::TissueId> found = met(made, 0.0);
    EXPECT_EQ(found.back(), joint_space) << seed;
    for (const anatomy::TissueId id : found) {
      EXPECT_TRUE(id == tissue::skin || id == tissue::fat || id == tissue::muscle || id == tendon ||
                  id == joint_capsule || id == joint_space)
          << "seed " << seed << ": " << joint_library().title(id);
    }
    EXPECT_GT(made.path.length(), 25.0) << seed;
    EXPECT_LT(made.path.length(), 85.0) << seed;  // what a needle of 90 mm reaches
  }
}

// In varied shoulders the needle meets only skin, fat and muscle, ends beside the nerve, and stays at least a
// millimetre from it.
TEST(ShoulderAnatomy, a_block_ends_beside_the_suprascapular_nerve_and_its_way_is_free) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    ShoulderParameters parameters = draw_shoulder(seed).parameters;
    parameters.spacing = 1.25;
    const SyntheticShoulder made =
        synthesize_shoulder(parameters, joint_library(), {}, ShoulderTarget::suprascapular_nerve);
    for (const anatomy::TissueId id : met(made, 1.0))
      EXPECT_TRUE(id == tissue::skin || id == tissue::fat || id == tissue::muscle || id == tendon)
          << joint_library().title(id);
    const Vec3 nerve = landmark_of(made, "suprascapular_nerve");
    EXPECT_EQ(anatomy::nearest(made.tissues, nerve, tissue::air), tissue::nerve);
    EXPECT_NEAR((made.path.target - nerve).norm(), 5.0, 0.01);
    EXPECT_GT(nearest_distance(made, {tissue::nerve}), 1.0);
    EXPECT_GT(nearest_distance(made, {tissue::vessel, tissue::lung}), 10.0);
    EXPECT_GT(nearest_distance(made, {tissue::cortical_bone, tissue::cancellous_bone}), 2.0);
    EXPECT_GT(made.path.entry.y(), made.path.target.y());  // from behind
    EXPECT_GT(made.path.entry.z(), made.path.target.z());  // and above
    EXPECT_LT(made.path.length(), 85.0);                   // what a needle of 90 mm reaches
  }
}

// The mean distance of the skin from the nerve in the supraspinous fossa, of 51 patients: 38 mm (synapse.koreamed.org
// 1013561, the classic approach).
TEST(ShoulderAnatomy, the_suprascapular_nerve_lies_as_deep_as_it_was_measured) {
  const SyntheticShoulder made =
      synthesize_shoulder(coarse(), joint_library(), {}, ShoulderTarget::suprascapular_nerve);
  EXPECT_NEAR(made.path.length(), 38.0, 10.0);
}

TEST(ShoulderAnatomy, left_shoulder_is_the_mirror_image_of_the_right_one) {
  ShoulderParameters parameters = coarse();
  parameters.spacing = 2.0;
  const SyntheticShoulder right = synthesize_shoulder(parameters, joint_library());
  parameters.side = BodySide::left;
  const SyntheticShoulder left = synthesize_shoulder(parameters, joint_library());
  ASSERT_EQ(left.tissues.grid.size, right.tissues.grid.size);
  const int last = left.tissues.grid.size[0] - 1;
  std::size_t different = 0;
  for (int k = 0; k < left.tissues.grid.size[2]; ++k)
    for (int j = 0; j < left.tissues.grid.size[1]; ++j)
      for (int i = 0; i <= last; ++i)
        different += left.tissues.at(i, j, k) != right.tissues.at(last - i, j, k) ? 1U : 0U;
  EXPECT_EQ(different, 0U);
  EXPECT_NEAR(left.path.target.x(), -right.path.target.x(), 1e-9);
}

TEST(ShoulderAnatomy, weight_makes_the_way_longer_and_fluid_the_joint_wider) {
  ShoulderParameters parameters = coarse();
  parameters.weight = 115.0;
  EXPECT_GT(synthesize_shoulder(parameters, joint_library()).path.length(), usual_shoulder().path.length() + 8.0);
  const auto volume = [](const SyntheticShoulder& made) {
    return std::count(made.tissues.voxels.begin(), made.tissues.voxels.end(), joint_space);
  };
  parameters = coarse();
  parameters.fluid = 7.0;
  EXPECT_GT(volume(synthesize_shoulder(parameters, joint_library())), volume(usual_shoulder()));
}

TEST(ShoulderAnatomy, same_parameters_give_the_same_voxels) {
  const SyntheticShoulder again = synthesize_shoulder(coarse(), joint_library());
  EXPECT_EQ(again.tissues.voxels, usual_shoulder().tissues.voxels);
  EXPECT_EQ(again.ct.voxels, usual_shoulder().ct.voxels);
  EXPECT_NE(synthesize_shoulder(coarse(2), joint_library()).tissues.voxels.size(), 0U);
}

TEST(ShoulderAnatomy, sizes_out_of_range_are_refused_by_name) {
  ShoulderParameters parameters;
  parameters.fluid = 1.0;
  try {
    check_shoulder(parameters);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("fluid is 1 mm, expected 2.5 to 8 mm"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace bodkin_test
