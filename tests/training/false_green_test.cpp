// A thousand attempts that harm the synthetic patient: the needle passes through a nerve, the cord, a vessel, an
// organ or bowel, and then comes to rest in the fluid as if nothing had happened. None may pass.
#include <cmath>
#include <map>
#include <string>
#include <string_view>

#include "tests/training/lumbar_patient.h"
#include "tests/training/page_table.h"
#include <gtest/gtest.h>

#include "core/geometry.h"
#include "core/random.h"
#include "simulation/haptic_tick.h"
#include "training/procedure_file.h"
#include "training/score.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::training;
namespace {

constexpr double way_step = 0.4;     // mm per tick during the motion: 400 mm/s
constexpr double start_way = 160.0;  // mm before the harmed voxel, where the needle begins

// A voxel that may be harmed, and what the segmentation and the tissues name it.
struct Victim {
  Vec3 point;
  const char* what;
};

std::vector<Victim> victims_of(const Case& patient) {
  std::vector<Victim> found;
  const Grid& grid = patient.tissues.grid;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 point = grid.to_patient(Vec3(i, j, k));
        const TissueId id = patient.tissues.at(i, j, k);
        const char* what = id == tissue::nerve || id == tissue::spinal_cord ? "nerve"
                           : id == tissue::vessel                           ? "vessel"
                           : id == tissue::organ                            ? "organ"
                                                                            : nullptr;
        const auto label = anatomy::nearest<std::uint16_t>(patient.structures, point, 0);
        for (const Structure& each : patient.description.structures) {
          if (each.label == label && (each.name == "colon" || each.name == "small_bowel")) what = "bowel";
        }
        if (what != nullptr) found.push_back({point, what});
      }
    }
  }
  return found;
}

// One attempt: along a straight line through the victim, out again, then along the planned path to a rest in the
// fluid.
class HarmfulAttempt {
 public:
  explicit HarmfulAttempt(const Case& patient) : patient_(patient), tick_(patient) {
    session_.header.dt = tick_.dt();
    session_.header.path = *patient.description.procedure.path;
    session_.finished = true;
    for (const TissueProperties& each : patient.library.tissues())
      session_.header.tissues.push_back({each.id, each.name, each.title});
  }

  const session::Session& perform(const Vec3& victim, const Vec3& direction) {
    move(victim - start_way * direction, victim + direction, direction);
    move(victim + direction, victim - start_way * direction, direction);
    const NeedlePath& path = session_.header.path;
    move(path.entry - 15.0 * path.direction(), path.target, path.direction());
    for (int i = 0; i < 700; ++i) step(path.target, path.direction());
    return session_;
  }

 private:
  void move(const Vec3& from, const Vec3& to, const Vec3& axis) {
    const int steps = static_cast<int>(std::ceil((to - from).norm() / way_step));
    for (int i = 0; i <= steps; ++i) step(from + (to - from) * i / steps, axis);
  }
  void step(const Vec3& tip, const Vec3& axis) {
    simulation::TickRecord& record = session_.ticks.emplace_back();
    record.tick = session_.ticks.size() - 1;
    record.input.needle = needle_pose(tip, axis);
    record.output = tick_.step(record.input);
    for (const forces::Event& event : record.output.events) session_.events.push_back({record.tick, event});
  }

  const Case& patient_;
  simulation::HapticTick tick_;
  session::Session session_;
};

TEST(FalseGreen, of_a_thousand_harmful_attempts_none_passes) {
  const Case& patient = lumbar_patient();
  const std::vector<Victim> victims = victims_of(patient);
  ASSERT_GT(victims.size(), 10000U);
  const training::Procedure procedure = find_procedure("lumbar_puncture");
  Random random(2026);
  std::map<std::string, int> count;
  int reached = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    // Every fourth victim is a nerve, because nerves have few voxels.
    const Victim* victim = nullptr;
    do {
      victim = &victims[static_cast<std::size_t>(random.uniform() * static_cast<double>(victims.size()))];
    } while (trial % 4 == 0 && std::string_view(victim->what) != "nerve");
    Vec3 direction(random.normal(), random.normal(), 0.4 * random.normal());
    direction.normalize();
    HarmfulAttempt attempt(patient);
    const Score result = score(attempt.perform(victim->point, direction), patient.description, procedure,
                               {&patient.structures, &patient.tissues});
    ASSERT_EQ(result.verdict, Grade::dangerous)
        << trial << ": through " << victim->what << " at " << victim->point.transpose() << ", " << result.headline;
    ++count[victim->what];
    reached += result.reached ? 1 : 0;
  }
  EXPECT_GT(reached, 900) << "they reached the aim all the same";
  EXPECT_GE(count["nerve"], 250);
  std::string table = "| through | attempts | called dangerous | reached the aim |\n|---|---|---|---|\n";
  for (const auto& [what, attempts] : count)
    table += "| " + what + " | " + std::to_string(attempts) + " | " + std::to_string(attempts) + " | |\n";
  table += "| together | 1000 | 1000 | " + std::to_string(reached) + " |\n";
  expect_table_on_page("cohorts.md", "| through |", table);
  for (const char* what : {"vessel", "organ", "bowel"}) EXPECT_GT(count[what], 20) << what;
}

}  // namespace
}  // namespace bodkin
