#include <cstdint>
#include <memory>
#include <string>

#include "report/teacher/teacher_site.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "training/store/result_store.h"
#include "training/store/store_place.h"

namespace bodkin::cli {

namespace {

struct TeacherArguments {
  std::string store;
  std::string address = "127.0.0.1";
  std::int64_t port = 8737;
};

constexpr const char* teacher_footer = R"(Examples:
  bodkin teacher                                       open the address that it prints in a browser
  bodkin teacher --store postgresql://teacher@server/bodkin
  bodkin teacher --address 0.0.0.0                     for other computers too; the address then has a token

The page shows trainees, learning curves and attempts, and changes nothing. Ctrl+C ends it. docs/results.md explains it.)";

void run_teacher(const TeacherArguments& arguments, const CommandContext& context) {
  Console console(context);
  const std::string place = training::store_place(arguments.store);
  training::ResultStore store(place);  // a store that cannot be shown is said at once
  const std::string token = report::is_loopback(arguments.address) ? std::string() : report::new_token();
  const report::TeacherSite site(place, token);
  report::HttpServer server(arguments.address, static_cast<std::uint16_t>(arguments.port),
                            [&](const report::HttpRequest& request) { return site.answer(request); });
  const bool is_v6 = arguments.address.find(':') != std::string::npos;
  const std::string url =
      fmt::format("http://{}:{}/{}", is_v6 ? fmt::format("[{}]", arguments.address) : arguments.address,
                  server.port(), token.empty() ? "" : fmt::format("?token={}", token));
  console.line(fmt::format("{} shows {}; Ctrl+C ends it", url, store.place()));
  console.json(nlohmann::ordered_json{{"url", url}, {"store", store.place()}}.dump(2));
  if (!token.empty())
    console.note("nothing on the way to other computers is encrypted; use it in a network that you trust");
  server.run(true);
}

}  // namespace

void add_teacher_command(CLI::App& app, CommandContext& context) {
  auto arguments = std::make_shared<TeacherArguments>();
  CLI::App* command =
      add_command(app, "teacher", "A page in the browser: trainees, curves, attempts", teacher_footer);
  add_text(*command, "--store", arguments->store, "File or postgresql:// address of the store");
  add_text(*command, "--address", arguments->address,
           "IP address to answer at (default: 127.0.0.1, this computer alone)");
  add_whole_number(*command, "--port", arguments->port, 0, 65535, "Port (default: 8737); 0: any that is free");
  on_run(*command, [arguments, &context] { run_teacher(*arguments, context); });
}

}  // namespace bodkin::cli
