// A needle enters a meshed patient anywhere: the contact points of unplanned lines, computed on one thread and timed
// by the core's own clock, as in fem_contact_stream_bench. BODKIN_MESHED_PATIENTS names the case folders, with colons
// between; scripts/numbers.sh makes them with 20,000 nodes, and with 100,000 when BODKIN_LARGE_BODIES is set.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "patient/prepared_body.h"
#include <benchmark/benchmark.h>

#include "anatomy/volume.h"
#include "core/random.h"
#include "fem/solid/contact_sites.h"
#include "fem/solid/line_points.h"
#include "io/case_folder.h"

namespace {

using namespace bodkin;
using namespace bodkin::anatomy;
using namespace bodkin::fem;

constexpr double speed = 50.0;     // mm/s
constexpr double approach = 50.0;  // mm before the skin, where a needle requests its line
constexpr int ways = 40;

double thread_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Through the skin within 25 mm of the planned entry, up to 40 degrees from the planned direction.
NeedlePath any_way(const Case& patient, Random& random) {
  const NeedlePath& planned = *patient.description.procedure.path;
  const Vec3 along = planned.direction(), side = along.unitOrthogonal(), other = along.cross(side);
  const double right = random.uniform(-25.0, 25.0), up = random.uniform(-25.0, 25.0);
  const double angle = random.uniform(0.0, 0.7), turn = random.uniform(0.0, 6.28);
  const Vec3 from = planned.entry - 30.0 * along + right * side + up * other;
  const Vec3 direction = std::cos(angle) * along + std::sin(angle) * (std::cos(turn) * side + std::sin(turn) * other);
  for (double way = 0.0; way < 80.0; way += 0.01) {
    const Vec3 place = from + way * along;
    if (nearest<TissueId>(patient.tissues, place, tissue::air) != tissue::air)
      return {place, place + planned.length() * direction};
  }
  return planned;
}

void enter_patient(benchmark::State& state, const std::filesystem::path& folder) {
  Case patient = io::load_case(folder);
  const EmbeddedNeedleSettings settings;
  patient.description.haptics.resistance = settings;
  std::shared_ptr<const ContactBody> body;
  patient::prepare_body(patient, folder, std::nullopt, {}, {}, &body);
  const double length = patient.description.procedure.path->length() + settings.points_beyond;
  const BoundPoints unbound;
  Random random(1);
  std::vector<double> firsts, lines;
  double ahead = 0.0, points = 0.0, late = 0.0;
  for (auto _ : state) {
    const NeedlePath path = any_way(patient, random);
    const double asked = thread_time();
    double came = asked, first = 0.0;
    LinePoints line(*body, settings.tip_radius, unbound);
    line.add(contact_sites_along(path, length, settings.point_spacing, patient), path.direction());
    line.stream(0, [&](const ContactPoint& point) {
      came = thread_time();
      if (first == 0.0) first = came - asked;
      const double before = came - asked - (point.place - path.entry).dot(path.direction()) / speed;
      ahead = std::max(ahead, before);
      late += before > approach / speed ? 1.0 : 0.0;
      points += 1.0;
      return true;
    });
    firsts.push_back(first);
    lines.push_back(came - asked);
  }
  std::sort(firsts.begin(), firsts.end());
  std::sort(lines.begin(), lines.end());
  state.counters["nodes"] = static_cast<double>(body->description().mesh.nodes.size());
  state.counters["points"] = points / static_cast<double>(firsts.size());
  state.counters["median_ms"] = 1e3 * lines[lines.size() / 2];
  state.counters["slowest_line_ms"] = 1e3 * lines.back();
  state.counters["first_point_ms"] = 1e3 * firsts[firsts.size() / 2];
  state.counters["slowest_first_point_ms"] = 1e3 * firsts.back();
  // The time before skin contact at which a needle at 50 mm/s must request so that no point of any line is late, and
  // the number of late points for requests 50 mm before.
  state.counters["to_ask_before_contact_ms"] = 1e3 * ahead;
  state.counters["late_points"] = late;
}

const bool registered = [] {
  const char* folders = std::getenv("BODKIN_MESHED_PATIENTS");
  std::istringstream list(folders != nullptr ? folders : "");
  for (std::string folder; std::getline(list, folder, ':');) {
    benchmark::RegisterBenchmark(("enter_patient/" + std::filesystem::path(folder).filename().string()).c_str(),
                                 [folder](benchmark::State& state) { enter_patient(state, folder); })
        ->Iterations(ways)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
