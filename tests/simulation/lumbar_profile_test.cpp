#include <algorithm>
#include <vector>

#include "patient/synthetic/calcification.h"
#include "patient/synthetic/lumbar.h"
#include <gtest/gtest.h>

#include "io/tissue_library_file.h"
#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::io;
using namespace bodkin::patient;
using namespace bodkin::simulation;
namespace {

using namespace tissue;

struct Profile {
  std::vector<double> depth, force;
  std::vector<TissueId> tip;
  std::vector<Event> events;
  double device_stiffness_scale = 1.0;

  std::vector<Event> seen(EventKind kind) const {
    std::vector<Event> found;
    std::copy_if(events.begin(), events.end(), std::back_inserter(found),
                 [kind](const Event& event) { return event.kind == kind; });
    return found;
  }
};

// The planned puncture of the synthetic torso at 10 mm/s, from 5 mm before the skin to 6 mm beyond the target.
Profile lumbar_puncture(const LumbarParameters& parameters) {
  Case patient;
  patient.library = default_tissue_library();
  if (parameters.calcification > 0.0) patient.library = with_calcified_ligament(patient.library);
  SyntheticPatient torso = synthesize_lumbar(parameters, patient.library);
  patient.tissues = std::move(torso.tissues);
  HapticTick tick(patient);
  Profile profile;
  profile.device_stiffness_scale = tick.stiffness_scale();
  const Vec3 along = torso.path.direction();
  for (double way = -5.0; way < torso.path.length() + 6.0; way += 0.01) {
    const TickOutput output = tick.step({needle_pose(torso.path.entry + way * along, along)});
    profile.depth.push_back(output.depth);
    profile.force.push_back(output.resistance);
    profile.tip.push_back(output.tissue);
    profile.events.insert(profile.events.end(), output.events.begin(), output.events.end());
  }
  return profile;
}

const Profile& usual_puncture() {
  static const Profile profile = lumbar_puncture({});
  return profile;
}

std::size_t first_puncture(const Profile& profile, TissueId tissue) {
  for (std::size_t i = 0; i < profile.events.size(); ++i) {
    if (profile.events[i].kind == EventKind::puncture && profile.events[i].tissue == tissue) return i;
  }
  return profile.events.size();
}

TEST(LumbarProfile, skin_ligaments_flavum_and_loss_of_resistance_come_in_this_order) {
  const Profile& profile = usual_puncture();
  const std::size_t skin_pop = first_puncture(profile, skin), flavum_pop = first_puncture(profile, ligamentum_flavum);
  const std::size_t ligament_pop = first_puncture(profile, interspinous_ligament);
  ASSERT_LT(flavum_pop, profile.events.size());
  EXPECT_LT(skin_pop, ligament_pop);
  EXPECT_LT(ligament_pop, flavum_pop);
  const auto losses = profile.seen(EventKind::loss_of_resistance);
  ASSERT_EQ(losses.size(), 1u);
  EXPECT_GE(losses[0].depth, profile.events[flavum_pop].depth);
  EXPECT_GT(losses[0].value, 1.5);
  // The ligament gives way while the tip is at its far side: the dura is not reached by tenting alone.
  EXPECT_LT(profile.events[flavum_pop].depth, losses[0].depth + 2.0);
  EXPECT_TRUE(profile.seen(EventKind::bone_contact).empty());
  EXPECT_EQ(profile.device_stiffness_scale, 1.0);  // the default tissues suit the default device
}

// 4.7 N: mean puncture force of the ligamentum flavum, Sutherland et al. 2013; 1.5 N at the skin.
TEST(LumbarProfile, the_force_peaks_near_the_published_one_at_the_flavum) {
  const Profile& profile = usual_puncture();
  const auto peak = std::max_element(profile.force.begin(), profile.force.end());
  const double at = profile.depth[static_cast<std::size_t>(peak - profile.force.begin())];
  EXPECT_NEAR(*peak, 4.7, 0.5);
  const std::size_t flavum_pop = first_puncture(profile, ligamentum_flavum);
  ASSERT_LT(flavum_pop, profile.events.size());
  EXPECT_NEAR(at, profile.events[flavum_pop].depth, 0.1);
  EXPECT_NEAR(profile.events[first_puncture(profile, skin)].value, 1.4, 0.3);
}

// Twice the force of the ligamentum flavum, and more by the grip of what lies behind it; the flavum comes afterwards.
TEST(LumbarProfile, calcified_ligaments_are_felt_as_nearly_bone) {
  const Profile profile = lumbar_puncture({.calcification = 0.5, .spacing = 1.5});
  const std::size_t hard_pop = first_puncture(profile, calcified_ligament);
  ASSERT_LT(hard_pop, profile.events.size());
  EXPECT_LT(hard_pop, first_puncture(profile, ligamentum_flavum));
  EXPECT_GT(profile.events[hard_pop].value, 9.0);
  EXPECT_LT(profile.events[hard_pop].value, 13.0);
  EXPECT_LT(profile.events[hard_pop].depth, 35.0);
  EXPECT_TRUE(profile.seen(EventKind::bone_contact).empty());
}

}  // namespace
}  // namespace bodkin
