#include "session/session_run.h"

#include <atomic>
#include <chrono>
#include <memory>
#include <utility>

#include "patient/prepared_body.h"
#include "session/case_digest.h"
#include "session/operator_file.h"
#include "session/recorder.h"
#include "session/session_schema.h"

#include "core/random_id.h"
#include "core/settings_check.h"
#include "core/utc_time.h"
#include "haptics/deadline_clock.h"
#include "haptics/tick_clock.h"
#include "io/resources.h"
#include "simulation/closed_loop.h"
#include "simulation/resistance_models.h"

namespace bodkin::session {

namespace {

constexpr std::uint64_t show_interval = 512;  // ticks

// The points of the needle's own lines; nothing without a body or points. Only on the clock may they be late.
std::unique_ptr<fem::ContactStream> points_of(const anatomy::Case& patient, const RunSettings& settings,
                                              simulation::BodyPort* port) {
  if (settings.whole_body == nullptr || port == nullptr) return {};
  using Timing = simulation::BodyPort::PointTiming;
  return patient::contact_stream(patient, settings.path.length(), settings.whole_body,
                                 port->stream_points(settings.realtime ? Timing::as_known : Timing::in_time));
}

// One run of the loop, driven by the processor's speed or by the clock.
class Run {
 public:
  Run(const anatomy::Case& patient, const SessionHeader& header, const RunSettings& settings,
      const Progress& progress)
      : settings_(settings),
        progress_(progress),
        loop_(patient, settings.script, settings.path, settings.seed),
        writer_(settings.output, header, settings.overwrite),
        stream_(points_of(patient, settings, loop_.body())),
        most_ticks_(static_cast<std::uint64_t>(settings.longest / header.dt)) {}

  // The present phase, or the last one afterwards.
  int last_phase() const { return last_phase_; }

  RunResult perform() {
    const auto begin = std::chrono::steady_clock::now();
    if (settings_.realtime) {
      on_the_clock();
    } else {
      at_full_speed();
    }
    if (stream_ != nullptr) {
      for (std::string& failure : stream_->take_failures()) result_.notes.push_back(std::move(failure));
    }
    result_.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    result_.operator_finished = loop_.finished();
    return std::move(result_);
  }

 private:
  bool is_cancelled() {
    result_.cancelled = settings_.cancelled && settings_.cancelled();
    return result_.cancelled;
  }
  bool is_over() { return result_.completed || loop_.finished() || is_cancelled(); }
  void note_completion(const simulation::TickRecord& record) noexcept {
    if (is_touched(record.output, settings_.ending)) result_.completed = record.output.depth;
  }

  void at_full_speed() {
    simulation::TickRecord record;
    for (std::uint64_t tick = 0; tick < most_ticks_ && !is_over(); ++tick) {
      note_phase(loop_.phase());
      loop_.step(record);
      writer_.append(record);
      note_completion(record);
      ++result_.ticks;
      if (tick % show_interval == 0) show(loop_.phase());
    }
    writer_.finish();
  }

  void on_the_clock() {
    std::atomic<int> phase{loop_.phase()};
    Recorder recorder(std::move(writer_), [&](const simulation::TickRecord& record) {
      if (record.tick % show_interval == 0) show(phase.load(std::memory_order_relaxed));
    });
    haptics::ServoTimings timings;
    {
      const haptics::RealTimePriority priority;
      result_.notes = priority.refused();
      haptics::DeadlineClock clock(loop_.dt());
      const haptics::TickClock now = haptics::monotonic_clock();
      simulation::TickRecord record;
      clock.start();
      for (std::uint64_t tick = 0; tick < most_ticks_ && !recorder.failed() && !is_over(); ++tick) {
        note_phase(loop_.phase());
        phase.store(loop_.phase(), std::memory_order_relaxed);
        clock.wait();
        const std::int64_t began = now();
        loop_.step(record);
        recorder.push(record);
        note_completion(record);
        const double compute = static_cast<double>(now() - began) * 1e-9;
        timings.lateness.record(clock.lateness());
        timings.compute.record(compute);
        timings.overruns += clock.lateness() > loop_.dt() || compute > loop_.dt() ? 1 : 0;
        ++result_.ticks;
      }
      result_.missed_deadlines = timings.overruns;
      result_.worst_lateness = clock.worst_lateness();
    }
    recorder.finish(timings_of(timings));
    result_.records_lost = recorder.lost();
  }

  void note_phase(int phase) noexcept {
    if (phase != simulation::OperatorCondition::end) last_phase_ = phase;
  }

  // On the clock a person can watch each phase; at full speed they pass too fast.
  void show(int phase) const {
    if (!progress_ || phase == simulation::OperatorCondition::end) return;
    const auto& phases = settings_.script.phases;
    const std::string stage =
        settings_.realtime ? "performing: " + phases[static_cast<std::size_t>(phase)].name : "performing";
    progress_(stage, static_cast<double>(phase) / static_cast<double>(phases.size()));
  }

  const RunSettings& settings_;
  const Progress& progress_;
  simulation::ClosedLoop loop_;
  SessionWriter writer_;
  std::unique_ptr<fem::ContactStream> stream_;
  RunResult result_;
  std::uint64_t most_ticks_;
  int last_phase_ = 0;
};

}  // namespace

bool is_touched(const simulation::TickOutput& output, const std::optional<anatomy::TissueId>& tissue) noexcept {
  return tissue && output.in_contact && output.tissue == *tissue;
}

SessionHeader session_header(const anatomy::Case& patient, const std::filesystem::path& case_folder,
                             const anatomy::NeedlePath& path) {
  SessionHeader header;
  header.bodkin_version = BODKIN_VERSION;
  header.case_folder = std::filesystem::absolute(case_folder).lexically_normal().string();
  header.case_xml = io::read_text_file(case_folder / "case.xml", largest_case_xml);
  const std::string mesh = mesh_digest(case_folder, patient.description.haptics.resistance);
  header.case_digest = case_digest(patient, header.case_xml, mesh);
  header.case_parts = case_parts(patient, mesh);
  header.dt = 1.0 / patient.description.haptics.rate;
  header.started_at = utc_now();
  header.recording_id = random_id();
  header.path = path;
  header.haptics = patient.description.haptics;
  header.left_needles = patient.left_needles;
  header.body_digest = digest_of_body(patient);
  header.body_points = digest_of_points(patient);
  header.volumes = recorded_volumes(patient);
  for (const forces::DiagnosticName& one : simulation::diagnostic_names(header.haptics))
    header.diagnostics.push_back({std::string(one.name), std::string(one.title)});
  for (int id = 0; id < 255; ++id) {
    const anatomy::TissueProperties* tissue = patient.library.find(static_cast<anatomy::TissueId>(id));
    if (tissue != nullptr) header.tissues.push_back({tissue->id, tissue->name, tissue->title});
  }
  return header;
}

SessionHeader session_header(const anatomy::Case& patient, const std::filesystem::path& case_folder,
                             const RunSettings& settings) {
  SessionHeader header = session_header(patient, case_folder, settings.path);
  header.operator_name = settings.script.name;
  header.operator_settings = operator_json(settings.script);
  header.seed = settings.seed;
  return header;
}

RunResult run_session(const anatomy::Case& patient, const SessionHeader& header, const RunSettings& settings,
                      const Progress& progress) {
  check_range("", "longest time", settings.longest, {1.0, 3600.0}, "s");
  Run run(patient, header, settings, progress);
  RunResult result = run.perform();
  result.last_phase = settings.script.phases[static_cast<std::size_t>(run.last_phase())].name;
  return result;
}

}  // namespace bodkin::session
