#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <utility>

#include "session/session_export.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/force_options.h"
#include "core/error.h"

namespace bodkin::cli {

namespace {

struct ExportArguments {
  std::string session;
  std::string ticks;
  std::string events;
  std::string second;
};

constexpr const char* export_footer = R"(Examples:
  bodkin export session.bodkin --csv ticks.csv
  bodkin export session.bodkin --csv - | head
  bodkin export session.bodkin --csv ticks.csv --events events.csv
  bodkin export session.bodkin --second plunger.csv       the second hand of 'perform --second'

'-' is standard output. Every number can be read back to the same bits. docs/running.md lists the columns.)";

// A file that appears whole or not at all, or standard output.
class OutputFile {
 public:
  explicit OutputFile(const std::string& name) : name_(name), part_(name + ".part") {
    stream_ = name == "-" ? stdout : std::fopen(part_.c_str(), "wb");
    if (stream_ == nullptr) fail();
  }
  ~OutputFile() {
    if (stream_ == nullptr || stream_ == stdout) return;
    std::fclose(stream_);
    std::remove(part_.c_str());
  }
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size()) fail();
  }
  void close() {
    if (stream_ == stdout) {
      if (std::fflush(stdout) != 0) fail();
      return;
    }
    const bool closed = std::fclose(stream_) == 0;
    stream_ = nullptr;
    if (!closed || std::rename(part_.c_str(), name_.c_str()) != 0) {
      std::remove(part_.c_str());
      fail();
    }
  }

 private:
  [[noreturn]] void fail() const {
    throw SystemError(fmt::format("cannot write {}: {}", name_, std::strerror(errno)));
  }

  std::string name_;
  std::string part_;
  std::FILE* stream_ = nullptr;
};

void write(const std::string& name, void (*exporter)(const session::Session&, const session::TextSink&),
           const session::Session& session) {
  OutputFile file(name);
  exporter(session, [&](std::string_view text) { file.write(text); });
  file.close();
}

void run_export(const ExportArguments& arguments, const CommandContext& context) {
  Console console(context);
  const std::array<std::pair<const char*, const std::string*>, 3> places = {
      {{"--csv", &arguments.ticks}, {"--events", &arguments.events}, {"--second", &arguments.second}}};
  if (std::all_of(places.begin(), places.end(), [](const auto& place) { return place.second->empty(); })) {
    throw InputError("there is nothing to export, give --csv FILE, --events FILE or --second FILE");
  }
  bool to_terminal = false;
  for (auto place = places.begin(); place != places.end(); ++place) {
    const auto& [option, file] = *place;
    if (file->empty()) continue;
    to_terminal = to_terminal || *file == "-";
    for (auto other = place + 1; other != places.end(); ++other) {
      if (*file != *other->second) continue;
      throw InputError(
          fmt::format("{} and {} are both '{}'; expected two different places", option, other->first, *file));
    }
    if (*file != "-") require_writable(*file, option, arguments.session);
  }
  if (context.json && to_terminal)
    throw InputError("--json and a CSV file on standard output cannot go together, name a file");
  const session::Session session = session::read_session(arguments.session);
  if (!arguments.second.empty() && !session.header.second) {
    throw InputError(fmt::format("{} has no second hand; expected a session of 'bodkin perform --second DEVICE'",
                                 arguments.session));
  }
  if (!session.finished) console.note("the session was not finished; what was saved is exported");
  if (!arguments.ticks.empty()) write(arguments.ticks, session::export_ticks, session);
  if (!arguments.events.empty()) write(arguments.events, session::export_events, session);
  if (!arguments.second.empty()) write(arguments.second, session::export_second, session);
  if (!to_terminal) {
    console.line(fmt::format("{} ticks and {} events of {}", session.ticks.size(), session.events.size(),
                             force_names(session.header.haptics)));
  }
  console.json(nlohmann::ordered_json({{"ticks", session.ticks.size()},
                                       {"events", session.events.size()},
                                       {"resistance", anatomy::name_of(session.header.haptics.resistance)},
                                       {"constraint", anatomy::name_of(session.header.haptics.constraint)},
                                       {"csv", arguments.ticks},
                                       {"events_csv", arguments.events},
                                       {"second_samples", session.second.size()},
                                       {"second_csv", arguments.second}})
                   .dump(2));
}

}  // namespace

void add_export_command(CLI::App& app, CommandContext& context) {
  auto arguments = std::make_shared<ExportArguments>();
  CLI::App* command = add_command(app, "export", "Write a session as CSV", export_footer);
  add_text(*command, "SESSION", arguments->session, "Session file").required();
  add_text(*command, "--csv", arguments->ticks, "A row per tick; '-' for standard output");
  add_text(*command, "--events", arguments->events, "A row per event; '-' for standard output");
  add_text(*command, "--second", arguments->second, "A row per sample of the second hand; '-' for standard output");
  on_run(*command, [arguments, &context] { run_export(*arguments, context); });
}

}  // namespace bodkin::cli
