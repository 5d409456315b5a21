#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "link/station_watch.h"
#include "report/teacher/teacher_site.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "core/random_id.h"
#include "training/store/result_store.h"
#include "training/store/store_place.h"

namespace bodkin::cli {

namespace {

struct TeacherArguments {
  std::string store;
  std::string address = "127.0.0.1";
  std::int64_t port = 8737;
  std::vector<std::string> stations;
};

constexpr const char* teacher_footer = R"(Examples:
  bodkin teacher                                       open the address that it prints in a browser
  bodkin teacher --store postgresql://teacher@server/bodkin
  bodkin teacher --address 0.0.0.0                     also for other computers; the address then has a token
  bodkin teacher --station room1 --station room2:18945 these stations live, at /stations

The page shows trainees, learning curves and attempts, and changes nothing; 'bodkin stations start' starts a procedure.
Ctrl+C ends the page. docs/results.md explains it.)";

report::StationCard card_of(const link::StationView& view) {
  report::StationCard card;
  card.place = view.place;
  if (view.status.state != link::ClientState::connected)
    card.trouble = view.status.sentence.empty() ? "it is being looked for" : view.status.sentence;
  card.runs = view.runs;
  card.patient = view.patient;
  card.procedure = view.procedure;
  if (!view.step.empty()) card.step = fmt::format("{} of {}, {}", view.step_number, view.steps, view.step);
  card.tissue = view.tissue;
  card.event = view.event;
  card.guard = view.guard;
  for (const link::StationState& moment : view.moments) card.forces.emplace_back(moment.time, moment.force);
  for (const link::StationLayer& layer : view.layers) card.layers.push_back({layer.tissue, layer.colour, layer.from});
  card.path = view.path;
  if (!view.moments.empty()) {
    card.depth = view.moments.back().depth;
    card.force = view.moments.back().force;
  }
  card.picture_width = view.picture_width;
  card.picture_height = view.picture_height;
  card.picture = view.picture;
  return card;
}

void run_teacher(const TeacherArguments& arguments, const CommandContext& context) {
  Console console(context);
  const std::string place = training::store_place(arguments.store);
  training::ResultStore store(place);  // a store that cannot be shown is said at once
  const std::string token = report::is_loopback(arguments.address) ? std::string() : random_id();
  std::vector<std::unique_ptr<link::StationWatch>> watches;
  for (const std::string& station : arguments.stations)
    watches.push_back(std::make_unique<link::StationWatch>(link::parse_server(station, "--station")));
  std::function<std::vector<report::StationCard>()> cards;
  if (!watches.empty()) {
    cards = [&watches] {
      std::vector<report::StationCard> all;
      for (const auto& watch : watches) all.push_back(card_of(watch->view()));
      return all;
    };
  }
  const report::TeacherSite site(place, token, cards);
  report::HttpServer server(arguments.address, static_cast<std::uint16_t>(arguments.port),
                            [&](const report::HttpRequest& request) { return site.answer(request); });
  const bool is_v6 = arguments.address.find(':') != std::string::npos;
  const std::string url =
      fmt::format("http://{}:{}/{}", is_v6 ? fmt::format("[{}]", arguments.address) : arguments.address,
                  server.port(), token.empty() ? "" : fmt::format("?token={}", token));
  console.line(fmt::format("{} shows {}; Ctrl+C ends it", url, store.place()));
  console.json(nlohmann::ordered_json{{"url", url}, {"store", store.place()}}.dump(2));
  if (!token.empty())
    console.note("connections from other computers are not encrypted; use it only in a network that you trust");
  server.run(true);
}

}  // namespace

void add_teacher_command(CLI::App& app, CommandContext& context) {
  add_command(
      app, "teacher", "A page in the browser: trainees, curves, attempts", teacher_footer,
      [&context](CLI::App& command) {
        auto arguments = std::make_shared<TeacherArguments>();
        add_text(command, "--store", arguments->store, "File or postgresql:// address of the store");
        add_text(command, "--address", arguments->address,
                 "IP address to listen at (default: 127.0.0.1, this computer alone)");
        add_texts(command, "--station", arguments->stations, "HOST or HOST:PORT of a 'bodkin serve' to show live");
        add_whole_number(command, "--port", arguments->port, 0, 65535, "Port (default: 8737); 0: any that is free");
        on_run(command, [arguments, &context] { run_teacher(*arguments, context); });
      });
}

}  // namespace bodkin::cli
