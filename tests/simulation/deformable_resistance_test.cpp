// The deformable body as the resistance of a case, through the whole tick.
#include "simulation/deformable_resistance.h"

#include <cmath>
#include <string>
#include <vector>

#include "tests/fem/dense_body.h"
#include "tests/one_tick.h"
#include "tests/simulation/real_time_guard.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/tissue_library_file.h"
#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using namespace bodkin::forces;
using namespace bodkin::io;
using namespace bodkin::simulation;
namespace {

using ::testing::HasSubstr;

constexpr double lattice_step = 2.0;                                                 // mm between nodes
constexpr double flavum_from = 20.0, flavum_to = 24.0, deformable_bone_from = 50.0;  // mm below the skin

TissueId deformable_tissue_at(double depth) {
  return depth < 0.0                    ? tissue::air
         : depth < 2.0                  ? tissue::skin
         : depth < flavum_from          ? tissue::muscle
         : depth < flavum_to            ? tissue::ligamentum_flavum
         : depth < 28.0                 ? tissue::epidural_fat
         : depth < deformable_bone_from ? tissue::muscle
                                        : tissue::cortical_bone;
}

// Layers along z with points of the planned path, which is the z axis, or a lattice of nodes about it. `modulus`:
// MPa.
Case deformable_patient(const ResistanceSettings& resistance, double device = 10.0, double modulus = 0.02,
                        double apart = lattice_step) {
  Case patient;
  patient.library = default_tissue_library();
  Grid grid;
  grid.size = {20, 20, 80};
  grid.origin = Vec3(-9.5, -9.5, -19.5);
  patient.tissues = TissueVolume(grid);
  for (int k = 0; k < 80; ++k) {
    for (int j = 0; j < 20; ++j) {
      for (int i = 0; i < 20; ++i) patient.tissues.at(i, j, k) = deformable_tissue_at(k - 19.5);
    }
  }
  patient.ct = CtVolume(grid, 40);
  const bool points = std::holds_alternative<EmbeddedNeedleSettings>(resistance);
  const int along = 1 + static_cast<int>(deformable_bone_from / apart);
  auto body =
      std::make_shared<CondensedBody>(points ? checks::as_points(checks::kelvin_body(1, along, apart, modulus))
                                             : checks::kelvin_body(3, along, apart, modulus));
  for (std::size_t node = 0; node < body->nodes.size(); ++node)
    body->tissues[node] = deformable_tissue_at(body->nodes[node].z() + 0.01);
  patient.prepared = {std::move(body), NeedlePath{Vec3(0.0, 0.0, 0.0), Vec3(0.0, 0.0, 30.0)}};
  patient.description.device = {"strong", 100.0, 50.0, 1e6, device, 0.0};
  patient.description.haptics.resistance = resistance;
  patient.description.haptics.constraint = NoConstraint{};
  return patient;
}

Pose along_z(double depth) {
  return needle_pose(Vec3(0.0, 0.0, depth), Vec3::UnitZ());
}

struct Felt {
  double peak = 0.0, end = 0.0, torque = 0.0, across = 0.0, stiffest = 0.0;
  std::vector<Event> events;
  bool has(EventKind kind, TissueId of) const {
    return std::any_of(events.begin(), events.end(),
                       [&](const Event& event) { return event.kind == kind && event.tissue == of; });
  }
};

// From 2 mm before the skin to `depth` at 20 mm/s.
Felt push_in(HapticTick& tick, double depth, double sideways = 0.0) {
  Felt felt;
  double before = 0.0;
  for (double place = -2.0; place < depth; place += 0.02) {
    Pose pose = along_z(place);
    if (place > depth - 2.0) pose.translation().x() = sideways * (place - depth + 2.0) / 2.0;
    const TickOutput output = tick.step({pose});
    felt.peak = std::max(felt.peak, output.resistance);
    felt.stiffest = std::max(felt.stiffest, std::abs(output.resistance - before) / 0.02);
    before = felt.end = output.resistance;
    felt.torque = output.requested.torque.norm();
    felt.across = output.requested.force.x();
    felt.events.insert(felt.events.end(), output.events.begin(), output.events.end());
  }
  return felt;
}

TEST(DeformableResistance, skin_and_ligament_give_way_in_their_order_and_resistance_is_lost) {
  ClosestNodeSettings closest;  // nodes 11 mm apart, as of the paper's 2000
  closest.capture_radius = 5.5;
  for (const Case& patient :
       {deformable_patient(EmbeddedNeedleSettings{}, 100.0, 0.4), deformable_patient(closest, 10.0, 0.02, 11.0)}) {
    const std::string_view name = name_of(patient.description.haptics.resistance);
    HapticTick tick(patient);
    const Felt felt = push_in(tick, 40.0);
    EXPECT_TRUE(felt.has(EventKind::puncture, tissue::skin)) << name;
    EXPECT_TRUE(felt.has(EventKind::puncture, tissue::ligamentum_flavum)) << name;
    EXPECT_TRUE(felt.has(EventKind::loss_of_resistance, tissue::epidural_fat)) << name;
    EXPECT_GT(felt.peak, 4.65) << name;
    EXPECT_LT(felt.end, 3.5) << name;
  }
}

TEST(DeformableResistance, is_what_the_embedded_needle_says) {
  EmbeddedNeedleSettings settings;
  const Case patient = deformable_patient(settings, 1e6);
  HapticTick tick(patient);
  ContactTissues tissues;
  for (const TissueProperties& tissue : patient.library.tissues()) {
    const DeformableTissue& here = tissue.deformable;
    tissues[tissue.id] = {.friction = here.friction, .puncture_force = here.puncture_force};
  }
  EmbeddedNeedle needle(*patient.prepared.body, tissues, settings, one_tick);
  bool begun = false;
  for (double place = -1.0; place < 30.0; place += 0.05) {
    const Pose pose = needle_pose(Vec3(0.0005 * place, 0.0, place), Vec3::UnitZ());
    const TickOutput output = tick.step({pose});
    if (!output.in_contact) continue;
    if (!begun) needle.begin(pose.translation() - (output.depth) * Vec3::UnitZ(), Vec3::UnitZ());
    begun = true;
    const EmbeddedNeedleForce& found = needle.step(pose);
    // The tick finds the entry by bisection, so that the lines differ by a trace.
    ASSERT_NEAR(output.resistance, found.resistance, 1e-6 + 1e-5 * std::abs(found.resistance)) << place;
    ASSERT_LT((output.requested.torque - found.on_hand.torque).norm(), 1e-4 + 1e-4 * found.on_hand.torque.norm());
  }
  EXPECT_TRUE(begun);
}

// The hand holds still; the tissue relaxes, but the spring that represents a weak device does not.
TEST(DeformableResistance, tissue_relaxes_where_the_case_says_so) {
  for (const double device : {1e6, 0.5}) {
    Case patient = deformable_patient(EmbeddedNeedleSettings{}, device, 0.4);
    HapticTick elastic(patient);
    patient.description.haptics.parts.relaxation = {{.share = 0.4, .time = 0.1}};
    HapticTick relaxing(patient);
    const double depth = device > 1.0 ? 0.5 : 1.5;
    push_in(elastic, depth);
    push_in(relaxing, depth);
    double was = 0.0, is = 0.0;
    for (int tick = 0; tick < 3000; ++tick) {
      was = elastic.step({along_z(depth)}).resistance;
      is = relaxing.step({along_z(depth)}).resistance;
    }
    ASSERT_GT(was, 0.1);
    if (device > 1.0) {
      EXPECT_NEAR(is, 0.6 * was, 0.01 * was);
    } else {
      EXPECT_GT(is, 0.75 * was) << "most of the way is the spring's";
    }
    EXPECT_LT(is, 0.98 * was);
  }
  Case closest = deformable_patient(ClosestNodeSettings{});
  closest.description.haptics.parts.relaxation = {{}};
  EXPECT_THROW(HapticTick{closest}, InputError);
}

TEST(DeformableResistance, holds_the_needle_sideways_with_force_and_torque) {
  const Case patient = deformable_patient(EmbeddedNeedleSettings{});
  HapticTick tick(patient);
  const Felt felt = push_in(tick, 18.0, 1.0);
  EXPECT_LT(felt.across, -0.01);
  EXPECT_GT(felt.torque, 0.01);
}

// A 27G needle that bends as much as steel does, its bevel towards -y.
Case patient_with_a_thin_needle(double cut_offset, NeedleHold hold = NeedleHold::clamped) {
  EmbeddedNeedleSettings settings;
  settings.bending = {.flexible = true, .hold = hold, .cut_offset = cut_offset};
  Case patient = deformable_patient(settings, 10.0, 0.2);
  const GaugeSize size = *gauge_size(27);
  patient.description.needle = {size.gauge, size.outer_diameter, size.inner_diameter, 90.0, NeedleTip::quincke};
  return patient;
}

// The force at every tick on the way to 40 mm at 20 mm/s, with the needle turned by `roll` from half-way on.
std::vector<Wrench> steered_in(const Case& patient, double roll_before, double roll_after) {
  HapticTick tick(patient);
  std::vector<Wrench> felt;
  for (double place = -2.0; place < 40.0; place += 0.02) {
    Pose pose = along_z(place);
    pose.linear() =
        pose.linear() * Eigen::AngleAxisd(place < 20.0 ? roll_before : roll_after, Vec3::UnitZ()).toRotationMatrix();
    felt.push_back(tick.step({pose}).requested);
  }
  return felt;
}

TEST(DeformableResistance, a_bevelled_needle_that_bends_leans_on_the_hand_and_a_rigid_one_does_not) {
  Case rigid = patient_with_a_thin_needle(0.0);
  std::get<EmbeddedNeedleSettings>(rigid.description.haptics.resistance).bending = {};
  const Wrench straight = steered_in(rigid, 0.0, 0.0).back();
  EXPECT_LT(straight.force.head<2>().norm(), 1e-6);
  EXPECT_LT(straight.torque.norm(), 1e-4);
  const Wrench symmetric = steered_in(patient_with_a_thin_needle(0.0), 0.0, 0.0).back();
  EXPECT_LT(symmetric.force.head<2>().norm(), 1e-6);

  for (const NeedleHold hold : {NeedleHold::clamped, NeedleHold::pinned}) {
    const Case patient = patient_with_a_thin_needle(0.2, hold);
    const Vec3 away = along_z(0.0).linear().col(1);  // from the bevel
    const std::vector<Wrench> steered = steered_in(patient, 0.0, 0.0);
    // First the tip draws the hand after it. Deeper, the curve that it has cut bows the shaft towards the bevel, the
    // skin keeps it from doing so, and that is felt the other way.
    EXPECT_LT(steered[300].force.dot(away), -0.001);  // 4 mm deep
    EXPECT_GT(steered.back().force.dot(away), 0.005);
    EXPECT_GT(steered.back().torque.norm(), 0.5);
    const double at_hub = (steered.back().torque + (90.0 * Vec3::UnitZ()).cross(steered.back().force)).norm();
    if (hold == NeedleHold::clamped) {
      EXPECT_GT(at_hub, 0.1);
    } else {
      EXPECT_LT(at_hub, 1e-6);
    }
    // Turned by 180 degrees it is the mirror image; 10 mm after it was turned it leans less.
    const Wrench mirrored = steered_in(patient, 180.0 * degree, 180.0 * degree).back();
    EXPECT_LT((mirrored.force + steered.back().force).head<2>().norm(), 1e-6);
    const Wrench turned = steered_in(patient, 0.0, 180.0 * degree)[1600];
    EXPECT_LT(turned.force.dot(away), 0.96 * steered[1600].force.dot(away));
  }
}

TEST(DeformableResistance, a_steered_needle_is_replayed_to_the_bit) {
  const Case patient = patient_with_a_thin_needle(0.2);
  const std::vector<Wrench> first = steered_in(patient, 0.0, 100.0 * degree);
  const std::vector<Wrench> again = steered_in(patient, 0.0, 100.0 * degree);
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(first[i].force, again[i].force) << i;
    ASSERT_EQ(first[i].torque, again[i].torque) << i;
  }
}

TEST(DeformableResistance, a_needle_that_cannot_bend_or_steer_is_refused_with_a_way_out) {
  const auto refused = [](const Case& patient) {
    try {
      const HapticTick tick(patient);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  Case patient = patient_with_a_thin_needle(0.2);
  EXPECT_EQ(refused(patient), "");
  patient.description.needle.tip = NeedleTip::whitacre;
  EXPECT_THAT(refused(patient), HasSubstr("a whitacre needle has no bevel"));
  patient = patient_with_a_thin_needle(0.2);
  patient.description.needle.length = 900.0;
  EXPECT_THAT(refused(patient), HasSubstr("length"));
  std::get<EmbeddedNeedleSettings>(patient.description.haptics.resistance).bending.flexible = false;
  EXPECT_THAT(refused(patient), HasSubstr("flexible=true"));
}

TEST(DeformableResistance, a_body_too_stiff_for_the_device_is_softened_and_says_so) {
  const Case strong = deformable_patient(EmbeddedNeedleSettings{}, 1e6, 0.5);
  EXPECT_EQ(HapticTick(strong).stiffness_scale(), 1.0);
  const Case weak = deformable_patient(EmbeddedNeedleSettings{}, 0.6, 0.5);
  HapticTick tick(weak);
  EXPECT_LT(tick.stiffness_scale(), 0.2);
  EXPECT_LT(push_in(tick, 1.9).stiffest, 0.6);
  const Case tip = deformable_patient(ClosestNodeSettings{}, 0.6);
  HapticTick by_tip(tip);
  EXPECT_NEAR(by_tip.stiffness_scale(), 0.6, 1e-12);  // 1 N/mm of the ligament
}

TEST(DeformableResistance, the_needle_in_the_body_is_behind_the_hand_by_the_spring_between_them) {
  const Case strong = deformable_patient(EmbeddedNeedleSettings{}, 1e6, 0.5);
  HapticTick firm(strong);
  push_in(firm, 15.0);
  EXPECT_EQ(firm.body()->coupling_offset().norm(), 0.0);
  const Case weak = deformable_patient(EmbeddedNeedleSettings{}, 0.6, 0.5);
  HapticTick soft(weak);
  EXPECT_EQ(soft.body()->coupling_offset().norm(), 0.0);
  const Felt felt = push_in(soft, 15.0);
  const double spring = (1.0 - soft.stiffness_scale()) / 0.6;  // mm/N: 1/0.6 less the body's own compliance
  EXPECT_NEAR(soft.body()->coupling_offset().z(), spring * felt.end, 1e-9);
  EXPECT_GT(soft.body()->coupling_offset().z(), 0.2);
}

TEST(DeformableResistance, bone_stops_the_needle_and_lets_go_without_giving_energy) {
  const Case patient = deformable_patient(EmbeddedNeedleSettings{}, 2.0);
  HapticTick tick(patient);
  push_in(tick, deformable_bone_from - 0.5);
  double energy = 0.0, deepest = 0.0, last_place = deformable_bone_from - 0.5, before = 0.0;
  std::vector<Event> events;
  for (int i = 0; i <= 400; ++i) {
    const double place = deformable_bone_from - 0.5 + 2.0 * std::sin(EIGEN_PI * i / 400.0);
    const TickOutput output = tick.step({along_z(place)});
    energy += 0.5 * (before + output.resistance) * (place - last_place);
    last_place = place;
    before = output.resistance;
    deepest = std::max(deepest, output.resistance);
    events.insert(events.end(), output.events.begin(), output.events.end());
  }
  EXPECT_GT(deepest, 1.0);
  EXPECT_GT(energy, -1e-3);
  const auto count = [&](EventKind kind) {
    return std::count_if(events.begin(), events.end(), [kind](const Event& event) { return event.kind == kind; });
  };
  EXPECT_EQ(count(EventKind::bone_contact), 1);
  EXPECT_EQ(count(EventKind::bone_left), 1);
  EXPECT_EQ(count(EventKind::points_passed), 0);  // bone has no nodes and needs none
}

// Bent aside while leaning on bone, withdrawn, and straightened: the hand pays on the way in for the energy returned
// by the bent shaft.
TEST(DeformableResistance, a_needle_that_is_bent_on_bone_gives_no_work) {
  for (const double slope : {0.0, 0.05, -0.05}) {
    Case patient = patient_with_a_thin_needle(0.0);
    patient.description.device.stiffness = 1.0;
    patient.description.needle.length = 55.0;
    HapticTick tick(patient);
    push_in(tick, deformable_bone_from - 1.0);
    Vec3 place(0.0, 0.0, deformable_bone_from - 1.0);
    double lean = 0.0, work = 0.0;
    Wrench before = tick.step({along_z(place.z())}).requested;
    const auto go = [&](const Vec3& goal, double lean_there) {
      const Vec3 start = place;
      const double lean_before = lean;
      for (int i = 1; i <= 1000; ++i) {
        const Vec3 next = start + (goal - start) * (i / 1000.0);
        const double turned = (lean_before + (lean_there - lean_before) * (i / 1000.0)) - lean;
        lean += turned;
        Pose pose = along_z(0.0);
        pose.translation() = next;
        pose.linear() = Eigen::AngleAxisd(lean, Vec3::UnitY()).toRotationMatrix() * pose.linear();
        const Wrench now = tick.step({pose}).requested;
        work -= 0.5 * ((now.force + before.force).dot(next - place) + (now.torque + before.torque).y() * turned);
        before = now;
        place = next;
      }
    };
    const double above = deformable_bone_from - 1.0, on_bone = deformable_bone_from + 3.0;
    for (int round = 0; round < 2; ++round) {  // the first sets what slides
      work = 0.0;
      for (const double side : {3.0, -3.0}) {
        go(Vec3(0.0, 0.0, on_bone), 0.0);
        go(Vec3(side, 0.0, on_bone), slope);
        go(Vec3(side, 0.0, above), slope);
        go(Vec3(0.0, 0.0, above), 0.0);
      }
    }
    EXPECT_GT(work, -1e-3) << slope;
  }
}

TEST(DeformableResistance, a_needle_beside_its_line_of_points_is_told) {
  const Case patient = deformable_patient(EmbeddedNeedleSettings{});
  HapticTick tick(patient);
  std::vector<Event> events;
  for (double place = -1.0; place < 20.0; place += 0.05) {
    const TickOutput output = tick.step({needle_pose(Vec3(8.0, 0.0, place), Vec3::UnitZ())});
    events.insert(events.end(), output.events.begin(), output.events.end());
  }
  EXPECT_EQ(std::count_if(events.begin(), events.end(),
                          [](const Event& event) { return event.kind == EventKind::points_passed; }),
            1);
}

TEST(DeformableResistance, a_tick_allocates_and_locks_nothing) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer owns malloc and the locks in this build";
  const EmbeddedNeedleSettings bending{.bending = {.flexible = true, .cut_offset = 0.1}};
  for (const ResistanceSettings& settings :
       {ResistanceSettings(EmbeddedNeedleSettings{}), ResistanceSettings(bending),
        ResistanceSettings(ClosestNodeSettings{})}) {
    const Case patient = deformable_patient(settings);
    HapticTick tick(patient);
    std::size_t heap = 0, locks = 0;
    {
      const RealTimeGuard guard;
      for (int i = 0; i < 4000; ++i) {
        const double place = -2.0 + 50.0 * std::sin(EIGEN_PI * i / 4000.0);
        tick.step({along_z(place)});
      }
      heap = RealTimeGuard::heap_calls();
      locks = RealTimeGuard::lock_calls();
    }
    EXPECT_EQ(heap, 0U) << name_of(settings);
    EXPECT_EQ(locks, 0U) << name_of(settings);
  }
}

TEST(DeformableResistance, without_a_body_or_with_a_second_friction_it_is_refused) {
  Case patient = deformable_patient(EmbeddedNeedleSettings{});
  patient.description.haptics.parts.shaft_friction = ShaftFrictionSettings{};
  EXPECT_THROW(HapticTick{patient}, InputError);
  patient.description.haptics.parts.shaft_friction.reset();
  patient.prepared.body.reset();
  try {
    const HapticTick tick(patient);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("bodkin case mesh"));
  }
}

}  // namespace
}  // namespace bodkin
