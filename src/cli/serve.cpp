#include <memory>

#include "link/session_feed.h"
#include "station/station.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/end_on_signal.h"
#include "cli/outcome.h"
#include "cli/pane_options.h"
#include "cli/perform_options.h"
#include "cli/perform_screen.h"
#include "cli/terminal_keys.h"

namespace bodkin::cli {

namespace {

const char* const serve_footer = R"(Examples:
  bodkin serve patient simulated                             a simulated hand; any program on this machine may look
  bodkin serve patient openhaptics --ultrasound C5-2         the first Touch, and what a probe sees
  bodkin serve patient force_dimension --listen 0.0.0.0      for other machines too
  bodkin serve patient recorded:mine.bodkin --port 18945     a session again, for a program that shows it

In 3D Slicer: module OpenIGTLinkIF, a client for localhost and port 18944, Active. NeedleTipToReference appears as a
transform, Image_Reference as a picture, PlannedPath as a model. 'docs/openigtlink.md' has every name, and the commands.
The keys are those of 'bodkin perform'.)";

struct ServeOptions {
  PerformOptions perform;
  std::string address = "127.0.0.1";
  std::int64_t port = 18944;
  double rate = 60.0;
  std::int64_t clients = 8;
};

void run_serve(const ServeOptions& arguments, CommandContext& context) {
  Console console(context);
  link::ServerSettings settings;
  settings.address = arguments.address;
  settings.port = static_cast<std::uint16_t>(arguments.port);
  settings.most_clients = static_cast<std::size_t>(arguments.clients);
  link::Server server(settings);
  station::StationOptions options = station_options(arguments.perform, console);
  if (!arguments.perform.ultrasound.empty())
    options.ultrasound = station::choose_ultrasound(pane_request(arguments.perform.ultrasound));
  PerformScreen screen(console, options.longest);
  link::SessionFeed feed(server, screen, options.ultrasound, arguments.rate);
  station::Station station(std::move(options), feed);
  console.note(fmt::format("OpenIGTLink at {}, port {}", settings.address, server.port()));
  if (server.is_exposed())
    console.note(
        "every machine that reaches this one can look and give commands; without --listen only this one can");
  station::StationResult result;
  {
    TerminalKeys keys;
    const EndOnSignal signals(station);
    screen.listen_to(&keys);
    result = station.run();
    screen.listen_to(nullptr);
  }
  console.clear_bar();
  if (const int signal = EndOnSignal::reason(); signal != 0) context.exit_code = 128 + signal;
  const Outcome outcome = read_outcome(arguments.perform.output, station.patient(), std::move(result.run));
  for (const std::string& note : outcome.run.notes) console.note(note);
  const link::ServerCounts counts = server.counts();
  console.note(fmt::format("{} clients, {} messages sent, {} received, {} clients dropped", counts.accepted,
                           counts.sent, counts.received, counts.dropped));
  print(console, outcome, station.patient());
  nlohmann::ordered_json json = json_of(outcome, station.patient());
  json["clients"] = counts.accepted;
  json["clients_dropped"] = counts.dropped;
  json["messages_sent"] = counts.sent;
  json["messages_received"] = counts.received;
  console.json(json.dump(2));
}

}  // namespace

void add_serve_command(CLI::App& app, CommandContext& context) {
  auto options = std::make_shared<ServeOptions>();
  CLI::App* command = add_command(
      app, "serve", "The same without a window, shown to 3D Slicer, PLUS and others over OpenIGTLink", serve_footer);
  add_perform_options(*command, options->perform);
  add_text(*command, "--listen", options->address, "Address of this machine at which clients are let in");
  add_whole_number(*command, "--port", options->port, 0, 65535, "Port, 0 to 65535; 0 is any free one");
  add_number(*command, "--rate", options->rate, 1.0, 240.0, "Poses per second, 1 to 240");
  add_whole_number(*command, "--clients", options->clients, 1, 64, "Clients at once, 1 to 64");
  on_run(*command, [options, &context] { run_serve(*options, context); });
}

}  // namespace bodkin::cli
