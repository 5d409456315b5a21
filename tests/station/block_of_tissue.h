#pragma once

#include <algorithm>
#include <memory>

#include "patient/prepared_body.h"
#include "session/replay.h"
#include "tests/fem/lattice_body.h"
#include "tests/simulation/real_time_guard.h"
#include <gtest/gtest.h>

#include "anatomy/case.h"
#include "fem/solid/contact_body.h"
#include "fem/solid/patient_body.h"
#include "io/tissue_library_file.h"
#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using namespace bodkin::io;
using namespace bodkin::patient;

inline constexpr double block_side = 60.0;  // mm

struct BlockOfTissue {
  Case patient;
  std::shared_ptr<const BodyDescription> body;
  std::shared_ptr<const ContactBody> whole;
};

// A block of tissue, skin at z = 0, whose planned path runs at x = 15.
inline BlockOfTissue block_of_tissue() {
  BlockOfTissue made;
  Case& patient = made.patient;
  patient.library = default_tissue_library();
  Grid grid;
  grid.size = {60, 60, 80};
  grid.origin = Vec3(0.5, 0.5, -19.5);
  patient.tissues = TissueVolume(grid, tissue::air);
  for (int k = 20; k < 80; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 60; ++i) patient.tissues.at(i, j, k) = k < 22 ? tissue::skin : tissue::muscle;
  patient.ct = CtVolume(grid, 40);
  patient.description.device = {"strong", 100.0, 50.0, 1e6, 100.0, 0.0};
  patient.description.haptics.constraint = NoConstraint{};
  EmbeddedNeedleSettings settings;
  settings.body.fix_cut = false;
  settings.body.fix_beyond = 55.0;
  patient.description.haptics.resistance = settings;
  const NeedlePath path{Vec3(15.0, 30.0, 0.0), Vec3(15.0, 30.0, 30.0)};
  patient.description.procedure.path = path;
  TetrahedralMesh mesh = kuhn_lattice(13, block_side);
  std::fill(mesh.tissues.begin(), mesh.tissues.end(), tissue::muscle);
  made.body = std::make_shared<const BodyDescription>(describe_body(mesh, patient, settings.body, path));
  made.whole = std::make_shared<const ContactBody>(made.body);
  const auto sites =
      contact_sites_along(path, path.length() + settings.points_beyond, settings.point_spacing, patient);
  patient.prepared = {
      std::make_shared<const CondensedBody>(made.whole->contact_points(sites, path.direction(), settings.tip_radius)),
      path};
  return made;
}

// One tick with the needle there, recorded; how often it took memory or a lock.
inline std::size_t record_tick(simulation::HapticTick& tick, const Pose& needle, session::Session& session) {
  simulation::TickRecord record;
  record.tick = session.ticks.size();
  record.input.needle = needle;
  std::size_t real_time_calls = 0;
  {
    const RealTimeGuard guard;
    record.output = tick.step(record.input);
    real_time_calls = RealTimeGuard::heap_calls() + RealTimeGuard::lock_calls();
  }
  for (const forces::Event& event : record.output.events) session.events.push_back({record.tick, event});
  record.output.events.clear();
  session.ticks.push_back(record);
  return real_time_calls;
}

inline void expect_replay(const session::Session& session, const BlockOfTissue& block) {
  const session::ReplayResult same = session::replay_session(session, block.patient, {}, block.body.get());
  EXPECT_FALSE(same.difference) << same.difference->field << " at tick " << same.difference->tick;
  EXPECT_EQ(same.ticks, session.ticks.size());
}

}  // namespace bodkin
