#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "link/station_watch.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "training/store/attempt_record.h"

namespace bodkin::cli {

namespace {

constexpr int exit_not_all = 3;

struct StationsArguments {
  std::vector<std::string> stations;
  std::string wanted_case;
  std::string trainee;
  double patience = 5.0;  // s
};
using Watches = std::vector<std::unique_ptr<link::StationWatch>>;

constexpr const char* stations_footer = R"(Examples:
  bodkin stations list room1 room2 room3:18945             what each station does
  bodkin stations start room1 room2 --case lumbar          the same procedure on all, at once
  bodkin stations stop room1 room2                         the sessions end and are saved

A station is 'bodkin serve CASE DEVICE --wait --listen 0.0.0.0' on its computer. Exit code 3: some stations did not
carry it out. 'bodkin teacher --station room1' shows them live in the browser.)";

Watches watch_all(const std::vector<std::string>& stations) {
  Watches watches;
  for (const std::string& station : stations)
    watches.push_back(std::make_unique<link::StationWatch>(link::parse_server(station, "STATION")));
  return watches;
}

// Waits at most so many seconds until the condition holds for each.
void wait_for_all(const Watches& watches, double seconds,
                  const std::function<bool(const link::StationView&)>& is_so) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < end) {
    if (std::all_of(watches.begin(), watches.end(), [&](const auto& each) { return is_so(each->view()); })) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

// One line for people.
std::string state_of(const link::StationView& view) {
  if (view.status.state != link::ClientState::connected)
    return view.status.sentence.empty() ? "does not answer" : view.status.sentence;
  if (view.guard.empty()) return "connected, but reports no session";
  if (!view.runs) return "waits for a procedure";
  const double depth = view.moments.empty() ? 0.0 : view.moments.back().depth;
  const double force = view.moments.empty() ? 0.0 : view.moments.back().force;
  return fmt::format("{}, {}: {}, {:.1f} mm, {:.2f} N, {}", view.patient, view.procedure,
                     view.step.empty() ? "no step yet" : view.step, depth, force, view.tissue);
}

void run_stations_list(const StationsArguments& arguments, CommandContext& context) {
  Console console(context);
  const Watches watches = watch_all(arguments.stations);
  wait_for_all(watches, arguments.patience, [](const link::StationView& view) { return !view.guard.empty(); });
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const auto& each : watches) {
    const link::StationView view = each->view();
    const bool is_connected = view.status.state == link::ClientState::connected;
    if (!is_connected) context.exit_code = exit_not_all;
    console.line(fmt::format("{:<24} {}", view.place, state_of(view)));
    all.push_back({{"station", view.place},
                   {"connected", is_connected},
                   {"runs", view.runs},
                   {"case", view.patient},
                   {"procedure", view.procedure},
                   {"step", view.step},
                   {"tissue", view.tissue},
                   {"state", state_of(view)}});
  }
  console.json(all.dump(2));
}

void order_all(const StationsArguments& arguments, const std::string& name,
               const std::vector<std::pair<std::string, std::string>>& values, CommandContext& context) {
  Console console(context);
  const Watches watches = watch_all(arguments.stations);
  wait_for_all(watches, arguments.patience,
               [](const link::StationView& view) { return view.status.state == link::ClientState::connected; });
  for (const auto& each : watches) each->command(name, values);
  wait_for_all(watches, arguments.patience, [](const link::StationView& view) { return !view.reply.empty(); });
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const auto& each : watches) {
    const link::StationView view = each->view();
    const bool is_done = view.reply == "SUCCESS";
    if (!is_done) context.exit_code = exit_not_all;
    const std::string words = is_done                        ? "does it"
                              : !view.reply.empty()          ? view.reply
                              : view.status.sentence.empty() ? "has not answered"
                                                             : view.status.sentence;
    console.line(fmt::format("{:<24} {}", view.place, words));
    all.push_back({{"station", view.place}, {"done", is_done}, {"sentence", words}});
  }
  console.json(all.dump(2));
}

void run_stations_start(const StationsArguments& arguments, CommandContext& context) {
  std::vector<std::pair<std::string, std::string>> values;
  if (!arguments.wanted_case.empty()) values.emplace_back("Case", arguments.wanted_case);
  if (!arguments.trainee.empty()) {
    training::check_label(arguments.trainee, "--trainee");
    values.emplace_back("Trainee", arguments.trainee);
  }
  order_all(arguments, "StartProcedure", values, context);
}

void run_stations_stop(const StationsArguments& arguments, CommandContext& context) {
  order_all(arguments, "StopRecording", {}, context);
}

CLI::App* add_stations_one(CLI::App& group, CommandContext& context,
                           const std::shared_ptr<StationsArguments>& arguments, const std::string& name,
                           const std::string& help, void (*work)(const StationsArguments&, CommandContext&)) {
  CLI::App* command = add_command(group, name, help, stations_footer);
  add_texts(*command, "STATION", arguments->stations, "HOST or HOST:PORT of a 'bodkin serve'").required();
  add_number(*command, "--patience", arguments->patience, 0.1, 60.0, "s to wait for each answer, 0.1 to 60");
  on_run(*command, [arguments, &context, work] { work(*arguments, context); });
  return command;
}

}  // namespace

void add_stations_command(CLI::App& app, CommandContext& context) {
  CLI::App* group = add_command(app, "stations", "Stations in other rooms: list, start, stop", stations_footer);
  need_command(*group);
  const auto fresh = [] { return std::make_shared<StationsArguments>(); };
  add_stations_one(*group, context, fresh(), "list", "List what each station does", run_stations_list);
  const auto start = fresh();
  CLI::App* command =
      add_stations_one(*group, context, start, "start", "Starts a procedure on all", run_stations_start);
  add_text(*command, "--case", start->wanted_case, "Name of the case in the stations' folders (default: theirs)");
  add_text(*command, "--trainee", start->trainee, "Label under which the results are kept");
  add_stations_one(*group, context, fresh(), "stop", "Ends the sessions, which are saved", run_stations_stop);
}

}  // namespace bodkin::cli
