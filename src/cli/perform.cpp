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

// Ctrl-C ends the session as q does.
class EndOnSignal {
 public:
  explicit EndOnSignal(station::Station& station)
      : interrupt_(std::signal(SIGINT, &end)), terminate_(std::signal(SIGTERM, &end)) {
    running.store(&station);
  }
  ~EndOnSignal() {
    std::signal(SIGINT, interrupt_);
    std::signal(SIGTERM, terminate_);
    running.store(nullptr);
  }
  EndOnSignal(const EndOnSignal&) = delete;
  EndOnSignal& operator=(const EndOnSignal&) = delete;

 private:
  static void end(int) {
    if (station::Station* const station = running.load()) station->end();
  }
  void (*interrupt_)(int);
  void (*terminate_)(int);
};

station::StationResult run_with_keys(station::Station& station, PerformScreen& screen) {
  desktop::Keys keys;
  const EndOnSignal signals(station);
  screen.listen_to(&keys);
  station::StationResult result = station.run();
  screen.listen_to(nullptr);
  return result;
}

void run_perform(const PerformOptions& arguments, const CommandContext& context) {
  Console console(context);
  station::StationOptions options = station_options(arguments, console);
  PerformScreen screen(console, options.ultrasound, is_mouse(options.device), options.longest);
  station::Station station(std::move(options), screen);
  station::StationResult result = run_with_keys(station, screen);
  console.clear_bar();
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
