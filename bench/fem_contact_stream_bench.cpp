// Rows of docs/contact-points.md: a body that a needle enters anywhere, from its mesh to the points of a line. Boxes
// of 100 mm in voxels of 1 mm: 2 mm of skin, muscle, and a ligament 20 to 24 mm deep; a line of 80 mm at 17 degrees,
// its points computed on one thread, timed by the core's own clock. The box of 97,336 nodes requires
// BODKIN_LARGE_BODIES.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/fem/lattice_body.h"
#include <benchmark/benchmark.h>

#include "fem/solid/contact_body.h"
#include "fem/solid/line_points.h"

namespace {

using namespace bodkin;
using namespace bodkin::anatomy;
using namespace bodkin::fem;

constexpr double side = 100.0;   // mm
constexpr double length = 80.0;  // mm
constexpr double speed = 50.0;   // mm/s

double wall_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// s of one core, so other work on the machine does not count.
double processor_time(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double thread_time() {
  return processor_time(CLOCK_THREAD_CPUTIME_ID);
}

// MB of this program: present or peak memory.
double memory(const char* what) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(what)) return std::stod(line.substr(line.find(':') + 1)) / 1000.0;
  return 0.0;
}

Case patient_in_voxels() {
  Case patient;
  std::vector<TissueProperties> tissues(4);
  tissues[0].name = "air";
  const std::vector<std::pair<TissueId, double>> forces = {
      {tissue::skin, 1.5}, {tissue::muscle, 0.9}, {tissue::ligamentum_flavum, 4.7}};
  for (std::size_t i = 0; i < forces.size(); ++i) {
    tissues[i + 1].id = forces[i].first;
    tissues[i + 1].name = tissues[i + 1].title = "tissue " + std::to_string(i);
    tissues[i + 1].deformable.puncture_force = forces[i].second;
  }
  patient.library = TissueLibrary(tissues);
  Grid grid;
  grid.size = {100, 100, 110};
  grid.origin = Vec3(0.5, 0.5, 0.5);
  patient.tissues = TissueVolume(grid, tissue::air);
  for (int k = 0; k < 100; ++k) {
    const double depth = side - (k + 0.5);
    const TissueId here = depth < 2.0                    ? tissue::skin
                          : depth < 20.0 || depth > 24.0 ? tissue::muscle
                                                         : tissue::ligamentum_flavum;
    for (int j = 0; j < 100; ++j)
      for (int i = 0; i < 100; ++i) patient.tissues.at(i, j, k) = here;
  }
  return patient;
}

void enter_anywhere(benchmark::State& state) {
  auto body =
      std::make_shared<BodyDescription>(lattice_body(static_cast<std::uint32_t>(state.range(0)), side, 0.1, 1000));
  const Case patient = patient_in_voxels();
  std::ofstream("/proc/self/clear_refs") << "5";
  const double before = memory("VmRSS"), start = wall_time(), used = processor_time(CLOCK_PROCESS_CPUTIME_ID),
               began = thread_time();
  check_body(*body);
  const ContactBody whole(body);
  state.counters["prepare_s"] = wall_time() - start;
  state.counters["prepare_core_s"] = processor_time(CLOCK_PROCESS_CPUTIME_ID) - used;
  // CPU time of this thread, which does the serial work: an upper bound of the duration with idle other cores.
  state.counters["prepare_thread_s"] = thread_time() - began;
  state.counters["peak_MB"] = memory("VmHWM") - before;
  state.counters["kept_MB"] = memory("VmRSS") - before;
  state.counters["factor_MB"] = 1e-6 * static_cast<double>(whole.factor().bytes());
  state.counters["nodes"] = static_cast<double>(body->mesh.nodes.size());
  const Vec3 along = Vec3(0.3, 0.0, -1.0).normalized();
  const BoundPoints unbound;
  double first = 0.0, all = 0.0, ahead = 0.0, points = 0.0;
  int lines = 0;
  for (auto _ : state) {
    const Vec3 entry(30.0 + 2.3 * (lines % 11), 40.0 + 1.7 * (lines % 7), side);
    ++lines;
    const NeedlePath path{entry, entry + length * along};
    const double asked = thread_time();
    double came = asked;
    bool is_first = true;
    LinePoints line(whole, 1.0, unbound);
    line.add(contact_sites_along(path, length, 1.0, patient), along);
    line.stream(0, [&](const ContactPoint& point) {
      came = thread_time();
      if (std::exchange(is_first, false)) first = std::max(first, came - asked);
      ahead = std::max(ahead, came - asked - (point.place - entry).norm() / speed);
      points += 1.0;
      return true;
    });
    all = std::max(all, came - asked);
  }
  // For the slowest line: its first point, all of them, and the time before skin contact at which a needle at 50 mm/s
  // must request them so that none is late.
  state.counters["first_ms"] = 1e3 * first;
  state.counters["line_ms"] = 1e3 * all;
  state.counters["ahead_ms"] = 1e3 * ahead;
  state.counters["points"] = points / lines;
}

const bool registered = [] {
  std::vector<std::int64_t> along = {13, 27};
  if (std::getenv("BODKIN_LARGE_BODIES") != nullptr) along.push_back(46);
  for (const std::int64_t nodes : along) {
    benchmark::RegisterBenchmark("enter_anywhere", enter_anywhere)
        ->Arg(nodes)
        ->Iterations(20)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
