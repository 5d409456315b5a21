#include <csignal>
#include <memory>

#include "station/station.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/app_window.h"
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/end_on_signal.h"
#include "cli/outcome.h"
#include "cli/perform_options.h"
#include "cli/perform_screen.h"
#include "cli/terminal_keys.h"

namespace bodkin::cli {

namespace {

station::StationResult run_with_keys(station::Station& station, PerformScreen& screen) {
  TerminalKeys keys;
  const EndOnSignal signals(station);
  screen.listen_to(&keys);
  station::StationResult result = station.run();
  screen.listen_to(nullptr);
  return result;
}

void run_perform(const PerformOptions& arguments, CommandContext& context) {
  if (needs_window(arguments)) {
    const std::string attempt = attempt_json(arguments);
    require_window();
    exec_app({"--attempt", attempt, "--", arguments.folder});
  }
  Console console(context);
  station::StationOptions options = station_options(arguments, console);
  PerformScreen screen(console, options.longest);
  screen.end_as_practised(options.patient);
  station::Station station(std::move(options), screen);
  station::StationResult result = run_with_keys(station, screen);
  console.clear_bar();
  if (const int signal = EndOnSignal::reason(); signal != 0) {
    context.exit_code = 128 + signal;
    console.note(signal == SIGHUP ? "the session ended because the terminal was closed; it is complete"
                                  : "the session was ended by SIGTERM; it is complete");
  }
  const Outcome outcome = read_outcome(arguments.output, station.patient(), std::move(result.run));
  for (const std::string& note : outcome.run.notes) console.note(note);
  console.note(fmt::format("{} of {} ticks were late (by {:.2f} ms at worst)", outcome.run.missed_deadlines,
                           outcome.run.ticks, 1e3 * outcome.run.worst_lateness));
  print(console, outcome, station.patient());
  nlohmann::ordered_json json = json_of(outcome, station.patient());
  console.json(json.dump(2));
}

}  // namespace

void add_perform_command(CLI::App& app, CommandContext& context) {
  add_command(app, "perform", "Perform the procedure yourself on a haptic device", perform_footer,
              [&context](CLI::App& command) {
                auto options = std::make_shared<PerformOptions>();
                add_perform_options(command, *options);
                on_run(command, [options, &context] { run_perform(*options, context); });
              });
}

}  // namespace bodkin::cli
