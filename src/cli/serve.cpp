#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

#include "link/command.h"
#include "link/contents.h"
#include "link/fitting_json.h"
#include "link/session_feed.h"
#include "station/station.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/deliver.h"
#include "cli/end_on_signal.h"
#include "cli/interruptible_wait.h"
#include "cli/outcome.h"
#include "cli/pane_options.h"
#include "cli/perform_options.h"
#include "cli/perform_screen.h"
#include "cli/station_requests.h"
#include "cli/terminal_keys.h"
#include "core/error.h"
#include "io/case_folder.h"
#include "training/procedure_file.h"
#include "training/store/attempt_record.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

const char* const serve_footer = R"(Examples:
  bodkin serve patient simulated                             a simulated hand; programs on this machine can watch
  bodkin serve patient openhaptics --ultrasound C5-2         the first Touch, and what a probe sees
  bodkin serve patient force_dimension --listen 0.0.0.0      for other machines too
  bodkin serve patient recorded:mine.bodkin --port 18945     a recorded session, for a program that shows it
  bodkin serve patient openhaptics --trainee t-07            the result goes to the results store
  bodkin serve cases openhaptics --wait --listen 0.0.0.0     waits for a teacher: 'bodkin stations start'

In 3D Slicer: module OpenIGTLinkIF, a client for localhost and port 18944, Active. NeedleTipToReference appears as a
transform, Image_Reference as an image, PlannedPath as a model. 'docs/openigtlink.md' has every name, and the commands.
The keys are those of 'bodkin perform'.)";

struct ServeOptions {
  PerformOptions perform;
  std::string address = "127.0.0.1";
  std::int64_t port = 18944;
  double rate = 60.0;
  std::int64_t clients = 8;
  bool wait = false;
  std::string trainee, store;
};

// Waits until a client requests a session; nothing if a person ended the program first. `patient`: the name of the
// station's own case; empty: it has a folder of cases. `trouble`: why the last requested session did not run; empty:
// it did.
std::optional<StartRequest> wait_for_start_request(link::Server& server, StationRequests& requests,
                                                   const std::string& patient, const std::string& trouble,
                                                   Console& console) {
  std::uint64_t greeted = 0;
  const nlohmann::json state = {
      {"guard", "waiting"}, {"message", "waits for StartProcedure"}, {"case", patient}, {"trouble", trouble}};
  const std::string text = state.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  for (auto last_report = std::chrono::steady_clock::time_point{}; !InterruptibleWait::is_ended();) {
    const auto now = std::chrono::steady_clock::now();
    if (const link::ServerCounts counts = server.counts();
        counts.accepted != greeted || now - last_report > std::chrono::seconds(1)) {
      greeted = counts.accepted;
      last_report = now;
      server.publish({"STRING", "State", link::time_now(), link::string_content(text)}, true);
    }
    std::optional<StartRequest> request;
    for (const link::Received& received : server.take()) {
      bool success = false;
      std::string sentence = "the procedure begins";
      try {
        std::optional<StartRequest> wanted = requests.read_request(received.message);
        if (!wanted) continue;
        if (request) throw InputError("another client was first");
        if (wanted->begins)
          request = std::move(wanted);
        else
          sentence = "the case is chosen; StartProcedure or StartRecording begins";
        success = true;
      } catch (const InputError& error) {
        sentence = error.what();
      }
      server.send(received.client, link::reply_to(received.message, success, sentence, link::time_now()));
    }
    for (const std::string& note : server.take_notes()) console.note(note);
    if (request) return request;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return std::nullopt;
}

std::vector<link::WatchedStep> steps_of(const anatomy::Case& patient) {
  std::vector<link::WatchedStep> steps;
  for (const training::Step& step : training::procedure_of_case(patient.description.procedure.name).steps)
    steps.push_back({step.title, step.tissue, step.event});
  return steps;
}

struct Served {
  Outcome outcome;
  nlohmann::ordered_json json;
  bool again = false;                           // a client asked for Reset
  std::optional<forces::ModelSettings> models;  // of the next session, when clients have changed them
};

// `models`: replace the case's.
Served serve_session(const PerformOptions& perform, const std::optional<forces::ModelSettings>& models, double rate,
                     link::Server& server, Console& console, CommandContext& context) {
  station::StationOptions options = station_options(perform, console);
  if (models) {
    options.patient.description.haptics = models->haptics;
    // A deformable body is prepared with its tissues; other numbers change when the session runs, so that it can be
    // replayed on the unchanged case.
    if (anatomy::body_of(models->haptics.resistance) != nullptr)
      options.patient.library = anatomy::TissueLibrary(models->tissues);
  }
  if (!perform.ultrasound.empty()) options.ultrasound = station::choose_ultrasound(pane_request(perform.ultrasound));
  PerformScreen screen(console, options.longest);
  screen.end_as_practised(options.patient);
  link::SessionFeed feed(server, screen, options.ultrasound, rate, steps_of(options.patient), models);
  station::Station station(std::move(options), feed);
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
  Outcome outcome = read_outcome(perform.output, station.patient(), std::move(result.run));
  for (const std::string& note : outcome.run.notes) console.note(note);
  print(console, outcome, station.patient());
  nlohmann::ordered_json json = json_of(outcome, station.patient());
  constexpr std::chrono::milliseconds patience{1000};  // with clients that read slowly
  server.publish({"STRING", "Score", link::time_now(), link::string_content(link::fitting_json(json.dump()))}, false);
  server.flush(patience);
  return {std::move(outcome), std::move(json), feed.commands().wants_again(), feed.commands().models()};
}

// The first free name of "a.bodkin", "a-2.bodkin", ...
std::string free_session(const std::string& wanted) {
  const fs::path path = wanted;
  fs::path name = path;
  for (int number = 2; fs::exists(name); ++number)
    name = path.parent_path() / fmt::format("{}-{}{}", path.stem().string(), number, path.extension().string());
  return name.string();
}

// A session, and another of the same kind whenever clients request Reset. Calls saved(served) after each; returns the
// last one.
template <typename Saved>
Served serve_until_done(PerformOptions perform, double rate, link::Server& server, Console& console,
                        CommandContext& context, const Saved& saved) {
  const std::string wanted = perform.output;
  std::optional<forces::ModelSettings> models;
  while (true) {
    Served served = serve_session(perform, models, rate, server, console, context);
    saved(served, perform.output);
    if (!served.again || context.exit_code != 0) return served;
    if (served.models) models = served.models;
    perform.output = free_session(wanted);
  }
}

void serve_requests(const ServeOptions& arguments, link::Server& server, Console& console, CommandContext& context) {
  const InterruptibleWait interruptible;
  nlohmann::ordered_json sessions = nlohmann::ordered_json::array();
  StationRequests requests(arguments.perform.folder);
  const bool has_own_case = fs::exists(fs::path(arguments.perform.folder) / "case.xml");
  const std::string patient = has_own_case ? io::read_case_description(arguments.perform.folder).name : "";
  std::string trouble;
  while (context.exit_code == 0) {
    deliver_waiting(arguments.store, console);
    const std::optional<StartRequest> request = wait_for_start_request(server, requests, patient, trouble, console);
    if (!request) break;
    PerformOptions perform = arguments.perform;
    perform.folder = request->folder;
    const fs::path output = arguments.perform.output;
    perform.output = free_session(request->file.empty() ? output : output.parent_path() / request->file);
    trouble.clear();
    try {
      const std::string& trainee = request->trainee.empty() ? arguments.trainee : request->trainee;
      serve_until_done(
          perform, arguments.rate, server, console, context, [&](const Served& served, const std::string& file) {
            const training::Grade verdict = served.outcome.score.verdict;
            sessions.push_back({{"session", served.outcome.file.string()}, {"verdict", training::name_of(verdict)}});
            if (!trainee.empty()) deliver_result(file, trainee, arguments.store, console);
          });
    } catch (const std::runtime_error& error) {
      trouble = error.what();  // only of this request: the station waits for the next one
      console.note(trouble);
    }
  }
  console.json(nlohmann::ordered_json{{"sessions", sessions}}.dump(2));
}

void run_serve(const ServeOptions& arguments, CommandContext& context) {
  Console console(context);
  if (!arguments.trainee.empty()) training::check_label(arguments.trainee, "--trainee");
  link::ServerSettings settings;
  settings.address = arguments.address;
  settings.port = static_cast<std::uint16_t>(arguments.port);
  settings.most_clients = static_cast<std::size_t>(arguments.clients);
  link::Server server(settings);
  console.note(fmt::format("OpenIGTLink at {}, port {}", settings.address, server.port()));
  if (server.is_exposed())
    console.note(
        "every machine that can reach this one can watch and give commands; without --listen only this one can");
  if (arguments.wait) return serve_requests(arguments, server, console, context);
  if (!arguments.trainee.empty()) deliver_waiting(arguments.store, console);
  const auto deliver = [&](const Served&, const std::string& file) {
    if (!arguments.trainee.empty()) deliver_result(file, arguments.trainee, arguments.store, console);
  };
  nlohmann::ordered_json json =
      serve_until_done(arguments.perform, arguments.rate, server, console, context, deliver).json;
  const link::ServerCounts counts = server.counts();
  console.note(fmt::format("{} clients, {} messages sent, {} received, {} clients dropped", counts.accepted,
                           counts.sent, counts.received, counts.dropped));
  json["clients"] = counts.accepted;
  json["clients_dropped"] = counts.dropped;
  json["messages_sent"] = counts.sent;
  json["messages_received"] = counts.received;
  console.json(json.dump(2));
}

}  // namespace

void add_serve_command(CLI::App& app, CommandContext& context) {
  add_command(app, "serve", "Perform without a window; 3D Slicer, PLUS and others see it over OpenIGTLink",
              serve_footer, [&context](CLI::App& command) {
                auto options = std::make_shared<ServeOptions>();
                add_perform_options(command, options->perform);
                add_text(command, "--listen", options->address,
                         "Address of this machine at which it accepts clients");
                add_whole_number(command, "--port", options->port, 0, 65535, "Port, 0 to 65535; 0 is any free one");
                add_number(command, "--rate", options->rate, 1.0, 240.0, "Poses per second, 1 to 240");
                add_whole_number(command, "--clients", options->clients, 1, 64, "Clients at once, 1 to 64");
                add_switch(command, "--wait", options->wait,
                           "Wait for StartProcedure of a client, again and again; CASE may be a folder of cases");
                add_text(command, "--trainee", options->trainee, "Label of who performs: the result is kept");
                add_text(command, "--store", options->store, "File or postgresql:// address of the results store");
                on_run(command, [options, &context] { run_serve(*options, context); });
              });
}

}  // namespace bodkin::cli
