// Whether the epidural space can be found by feel in the deformable body of the default patient.
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "patient/prepared_body.h"
#include "session/operator_file.h"
#include "tests/cli/meshed_patient.h"
#include <nlohmann/json.hpp>

#include "core/thread_pool.h"
#include "io/case_folder.h"
#include "simulation/closed_loop.h"

namespace bodkin_test {
namespace {

using namespace ::bodkin;
using nlohmann::json;

constexpr int seeds = 40, nearly_all = 38;
constexpr double at_rest = 0.4;          // mm, within which the tip stays
constexpr double long_enough = 0.7;      // s
constexpr double longest_search = 60.0;  // s

class EpiduralSpace : public MeshedPatient {
 protected:
  // Along the planned path, without feeling, past the dura.
  static json profile(const std::string& mechanics) {
    const Outcome found = bodkin(
        "-q --json profile patient --beyond 6 --constraint none --resistance "
        "embedded_needle -o " +
        mechanics + " --mechanics " + mechanics);
    EXPECT_EQ(found.exit_code, 0) << found.errors;
    return json::parse(found.output);
  }
};

// mm, depth of the hand's tip at the first event with this prefix; negative: none.
double depth_of(const json& profile, const std::string& text) {
  for (const json& event : profile.at("events"))
    if (event.at("text").get<std::string>().rfind(text, 0) == 0) return event.at("depth_mm").get<double>();
  return -1.0;
}

double force_of(const json& profile, const std::string& text) {
  for (const json& event : profile.at("events"))
    if (event.at("text").get<std::string>().rfind(text, 0) == 0) return event.at("value_N").get<double>();
  return -1.0;
}

constexpr double least_space = 2.5;  // mm of the hand between the loss of resistance and the dura

using Whole = std::shared_ptr<const fem::ContactBody>;

struct Attempt {
  bool found = false;      // it rests in the epidural space: after the loss of resistance, the dura intact
  bool left_line = false;  // it was past the points of its line
};

// The needle follows the hand, as in `bodkin run`.
Attempt attempt_of(const anatomy::Case& patient, Whole whole, const simulation::OperatorScript& script,
                   std::uint64_t seed) {
  const anatomy::NeedlePath& planned = *patient.description.procedure.path;
  simulation::ClosedLoop loop(patient, script, planned, seed);
  std::shared_ptr<fem::ContactLine> line = loop.body()->stream_points(simulation::BodyPort::PointTiming::in_time);
  const auto stream = patient::contact_stream(
      whole->description(), std::shared_ptr<const anatomy::Case>(std::shared_ptr<const anatomy::Case>(), &patient),
      planned.length(), whole, std::move(line));
  simulation::TickRecord record;
  Attempt attempt;
  bool lost = false;
  double rest = 0.0, least = 0.0, most = 0.0;  // s; mm
  for (double time = 0.0; time < longest_search && !loop.finished(); time += loop.dt()) {
    loop.step(record);
    for (const forces::Event& event : record.output.events) {
      if (event.kind == forces::EventKind::points_passed) attempt.left_line = true;
      if (event.kind == forces::EventKind::loss_of_resistance) lost = true;
      if (event.kind == forces::EventKind::puncture && event.tissue == anatomy::tissue::dura) return attempt;
    }
    const double depth = record.output.depth;
    least = std::min(least, depth);
    most = std::max(most, depth);
    rest += loop.dt();
    if (!lost || record.output.tissue != anatomy::tissue::epidural_fat || most - least > at_rest) {
      least = most = depth;
      rest = 0.0;
    }
    attempt.found = rest >= long_enough;
    if (attempt.found) return attempt;
  }
  return attempt;
}

// Beside bone a needle may pass the last point of its line for a moment; a needle that was led aside does not.
constexpr int most_past_line = 2;

int found_by(const anatomy::Case& patient, const Whole& whole, const std::string& name) {
  const simulation::OperatorScript script = session::load_operator(name);
  std::vector<Attempt> attempts(seeds);
  ThreadPool(2).run(seeds, [&](std::size_t seed) { attempts[seed] = attempt_of(patient, whole, script, seed + 1); });
  EXPECT_LE(std::ranges::count_if(attempts, &Attempt::left_line), most_past_line) << name;
  return static_cast<int>(std::ranges::count_if(attempts, &Attempt::found));
}

anatomy::Case deformable(const std::filesystem::path& folder, anatomy::Mechanics mechanics, Whole& whole) {
  anatomy::Case patient = io::load_case(folder);
  patient.description.haptics.mechanics = mechanics;
  patient.description.haptics.resistance = anatomy::EmbeddedNeedleSettings{};
  patient::prepare_body(patient, folder, {}, {}, {}, &whole);
  return patient;
}

TEST_F(EpiduralSpace, each_layer_gives_way_by_itself_at_its_force) {
  // The forces of the tables; the physical description's for a 22G quincke needle (docs/needle-forces.md).
  const std::vector<std::pair<std::string, std::vector<double>>> expected = {{"tables", {1.5, 4.7, 0.9}},
                                                                             {"physical", {1.22, 1.41, 0.9}}};
  for (const auto& [mechanics, force] : expected) {
    const json found = profile(mechanics);
    EXPECT_NEAR(force_of(found, "skin gives way"), force[0], 0.02) << mechanics;
    EXPECT_NEAR(force_of(found, "ligamentum flavum gives way"), force[1], 0.02) << mechanics;
    EXPECT_NEAR(force_of(found, "dura gives way"), force[2], 0.02) << mechanics;
    const double skin = depth_of(found, "skin gives way"), flavum = depth_of(found, "ligamentum flavum gives way");
    const double loss = depth_of(found, "loss of resistance"), dura = depth_of(found, "dura gives way");
    // In the patient at rest the ligamentum flavum begins at 41.3 mm, the dura at 49.4 mm.
    EXPECT_GT(skin, 2.5) << mechanics;
    EXPECT_LT(skin, 5.5) << mechanics;
    EXPECT_GT(flavum, 43.0) << mechanics;
    EXPECT_LT(flavum, 48.5) << mechanics;
    EXPECT_GE(loss, flavum) << mechanics;
    EXPECT_GT(dura - loss, least_space) << mechanics;
    EXPECT_GT(dura, 49.4 + 2.0) << mechanics << ": Zarzur and Goncalves 1992, 2 to 6 mm";
    EXPECT_LT(dura, 49.4 + 6.0) << mechanics;
    EXPECT_GT(depth_of(found, "the tip enters cerebrospinal fluid"), dura - 1e-3) << mechanics;
    EXPECT_GT(depth_of(found, "the tip enters epidural space"), flavum - 1e-3) << mechanics;
  }
}

TEST_F(EpiduralSpace, experts_find_it_in_the_deformable_body_and_novices_mostly_do_not) {
  for (const anatomy::Mechanics mechanics : {anatomy::Mechanics::tables, anatomy::Mechanics::physical}) {
    SCOPED_TRACE(mechanics == anatomy::Mechanics::tables ? "tables" : "physical");
    Whole whole;
    const anatomy::Case patient = deformable(folder_ / "patient", mechanics, whole);
    EXPECT_GE(found_by(patient, whole, "expert"), nearly_all);
    EXPECT_GE(found_by(patient, whole, "expert_epidural"), nearly_all);
    EXPECT_LT(found_by(patient, whole, "novice"), seeds / 2);
  }
}

// With the procedure's own needle.
TEST_F(EpiduralSpace, experts_find_it_in_the_deformable_body_with_the_needle_of_an_epidural) {
  for (const char* command : {"-q case synthesize lumbar epidural --procedure epidural", "-q case mesh epidural"}) {
    const Outcome made = bodkin(command);
    ASSERT_EQ(made.exit_code, 0) << made.errors;
  }
  Whole whole;
  const anatomy::Case patient = deformable(folder_ / "epidural", anatomy::Mechanics::physical, whole);
  EXPECT_EQ(patient.description.needle.gauge, 18);
  EXPECT_GE(found_by(patient, whole, "expert_epidural"), nearly_all);
}

}  // namespace
}  // namespace bodkin_test
