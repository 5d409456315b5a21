#include "training/simulated_attempt.h"

#include "patient/prepared_body.h"
#include "session/session_run.h"

#include "simulation/closed_loop.h"

namespace bodkin::training {

session::Session simulate_attempt(const anatomy::Case& patient, const simulation::OperatorScript& script,
                                  const anatomy::NeedlePath& path, std::uint64_t seed,
                                  const AttemptOptions& options) {
  simulation::ClosedLoop loop(patient, script, path, seed);
  std::unique_ptr<fem::ContactStream> points;  // of the needle's own lines
  if (options.whole_body != nullptr && loop.body() != nullptr) {
    points = patient::contact_stream(patient, path.length(), options.whole_body,
                                     loop.body()->stream_points(simulation::BodyPort::PointTiming::in_time));
  }
  session::Session session;
  session.header.dt = loop.dt();
  session.header.path = path;
  session.header.haptics = patient.description.haptics;
  session.header.operator_name = script.name;
  session.header.seed = seed;
  for (const anatomy::TissueProperties& each : patient.library.tissues())
    session.header.tissues.push_back({each.id, each.name, each.title});
  const auto most = static_cast<std::size_t>(options.longest / loop.dt());
  while (!loop.finished() && session.ticks.size() < most) {
    simulation::TickRecord& record = session.ticks.emplace_back();
    loop.step(record);
    for (const forces::Event& event : record.output.events) session.events.push_back({record.tick, event});
    if (session::is_touched(record.output, options.ending)) break;
  }
  if (points != nullptr) points->throw_failure();
  session.finished = true;
  return session;
}

}  // namespace bodkin::training
