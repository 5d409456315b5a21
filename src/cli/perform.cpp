#include <array>
#include <atomic>
#include <csignal>
#include <memory>

#include "desktop/keys.h"
#include "station/station.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/outcome.h"
#include "cli/perform_options.h"
#include "cli/perform_screen.h"

namespace bodkin::cli {

namespace {

std::atomic<station::Station*> running{nullptr};

// Ctrl-C ends the session as q does. The end of the terminal or of the machine ends it too: force to zero, devices
// stopped, the recording complete.
class EndOnSignal {
 public:
  explicit EndOnSignal(station::Station& station) {
    running.store(&station);
    for (std::size_t i = 0; i < signals.size(); ++i) before_[i] = std::signal(signals[i], &end);
  }
  ~EndOnSignal() {
    for (std::size_t i = 0; i < signals.size(); ++i) std::signal(signals[i], before_[i]);
    running.store(nullptr);
  }
  EndOnSignal(const EndOnSignal&) = delete;
  EndOnSignal& operator=(const EndOnSignal&) = delete;

  // 0, or the signal that a shell reports as the end of the command: all but Ctrl-C, with which a person ends a
  // session.
  static int reason() noexcept { return ended_by.load() == SIGINT ? 0 : ended_by.load(); }

 private:
  static constexpr std::array<int, 3> signals = {SIGINT, SIGTERM, SIGHUP};

  static void end(int signal) {
    ended_by.store(signal);
    if (station::Station* const station = running.load()) station->end();
  }

  static inline std::atomic<int> ended_by{0};
  std::array<void (*)(int), signals.size()> before_{};
};

station::StationResult run_with_keys(station::Station& station, PerformScreen& screen) {
  desktop::Keys keys;
  const EndOnSignal signals(station);
  screen.listen_to(&keys);
  station::StationResult result = station.run();
  screen.listen_to(nullptr);
  return result;
}

void run_perform(const PerformOptions& arguments, CommandContext& context) {
  Console console(context);
  station::StationOptions options = station_options(arguments, console);
  PerformScreen screen(console, options.ultrasound, is_mouse(options.device), options.longest);
  station::Station station(std::move(options), screen);
  station::StationResult result = run_with_keys(station, screen);
  console.clear_bar();
  if (const int signal = EndOnSignal::reason(); signal != 0) {
    context.exit_code = 128 + signal;
    console.note(signal == SIGHUP ? "the terminal was closed, which ended the session; it is complete"
                                  : "the session was ended from outside (SIGTERM); it is complete");
  }
  const Outcome outcome = read_outcome(arguments.output, station.patient(), std::move(result.run));
  for (const std::string& note : outcome.run.notes) console.note(note);
  console.note(fmt::format("{} of {} ticks were late (by {:.2f} ms at worst)", outcome.run.missed_deadlines,
                           outcome.run.ticks, 1e3 * outcome.run.worst_lateness));
  print(console, outcome, station.patient());
  nlohmann::ordered_json json = json_of(outcome, station.patient());
  if (!arguments.ultrasound.empty()) json["ultrasound_pictures"] = result.ultrasound_pictures;
  console.json(json.dump(2));
}

}  // namespace

void add_perform_command(CLI::App& app, CommandContext& context) {
  auto options = std::make_shared<PerformOptions>();
  CLI::App* command =
      add_command(app, "perform", "Your own hand performs the procedure on a haptic device", perform_footer);
  add_perform_options(*command, *options);
  on_run(*command, [options, &context] { run_perform(*options, context); });
}

}  // namespace bodkin::cli
