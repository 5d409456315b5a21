// Whether a needle pushed, withdrawn and tilted in the mesh of the default patient, fast and slowly, ever returns
// more work to the hand than was put in.
#include <algorithm>
#include <cmath>
#include <vector>

#include "patient/prepared_body.h"
#include "tests/cli/meshed_patient.h"
#include "tests/fem/working_hand.h"

#include "core/random.h"
#include "io/case_folder.h"
#include "simulation/contact_settings.h"

namespace bodkin_test {
namespace {

using namespace ::bodkin;
using checks::HandWork;
using checks::WorkingHand;

constexpr double fastest_hand = 500.0;  // mm/s, of tip and hub
constexpr double deepest_push = 50.0;   // mm, through ligamentum flavum and dura
constexpr double bound_of_fall = 1e-3;  // N mm
constexpr double widest_tilt = 0.05;    // tangent, 3 degrees

class NeedleWork : public MeshedPatient {
 protected:
  // The points of the planned line, with these needles left in the body.
  static anatomy::Case patient_with(anatomy::Mechanics mechanics, const std::vector<anatomy::NeedlePath>& left) {
    anatomy::Case patient = io::load_case(folder_ / "patient");
    patient.description.haptics.mechanics = mechanics;
    patient.description.haptics.resistance = anatomy::EmbeddedNeedleSettings{};
    patient.left_needles = left;
    patient::prepare_body(patient, folder_ / "patient", {}, {}, {});
    return patient;
  }
};

struct Found {
  HandWork fall;                         // N mm, the greatest
  double least_lost = 1e9, force = 0.0;  // N mm; N
  double of_other_forces = 0.0;          // N
};

// `friction`: share of the patient's; without it only the equations of a tick dissipate energy.
Found push_about(const anatomy::Case& patient, double friction, std::uint64_t seed) {
  fem::ContactTissues tissues = simulation::contact_tissues(patient);
  for (fem::ContactTissue& tissue : tissues) tissue.friction *= friction;
  Random random(seed);
  WorkingHand hand(*patient.prepared.body, tissues, *patient.description.procedure.path);
  for (int way = 0; way < 12; ++way) {
    const Vec3 goal(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), random.uniform(-1.0, deepest_push));
    const bool tilts = way % 3 != 0;
    const Eigen::Vector2d lean =
        tilts ? Eigen::Vector2d(random.uniform(-widest_tilt, widest_tilt), random.uniform(-widest_tilt, widest_tilt))
              : hand.lean();
    const double speed = fastest_hand * std::pow(10.0, random.uniform(-1.5, 0.0));
    hand.move(goal, lean, speed, tilts ? random.uniform(-0.05, 0.05) : 0.0);
  }
  hand.move(Vec3(0.0, 0.0, -1.0), Eigen::Vector2d::Zero(), fastest_hand);
  return {hand.greatest_fall(), hand.lost().turning, hand.greatest_force(), hand.greatest_difference()};
}

TEST_F(NeedleWork, work_less_stored_energy_never_falls_in_the_default_patient) {
  for (const anatomy::Mechanics mechanics : {anatomy::Mechanics::tables, anatomy::Mechanics::physical}) {
    const bool physical = mechanics == anatomy::Mechanics::physical;
    anatomy::Case patient = patient_with(mechanics, {});
    const anatomy::NeedlePath path = *patient.description.procedure.path;
    const Vec3 beside = 3.0 * path.direction().unitOrthogonal();
    for (const bool left : {false, true}) {
      if (left) patient = patient_with(mechanics, {{path.entry + beside, path.target + 0.4 * beside}});
      for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const Found found = push_about(patient, seed % 2 == 0 ? 0.0 : 1.0, seed);
        EXPECT_LT(found.fall.turning, bound_of_fall) << seed << (physical ? ", physical" : ", tables");
        EXPECT_LT(found.of_other_forces, 1e-6 * found.force) << "it is the hand's work";
        EXPECT_GT(found.least_lost, 0.0);
        EXPECT_GT(found.force, physical ? 1.0 : 2.0) << "it has gone through the ligamentum flavum";
      }
    }
  }
}

}  // namespace
}  // namespace bodkin_test
