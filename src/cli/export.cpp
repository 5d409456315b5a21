#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <utility>

#include "session/session_export.h"
#include "session/session_poses.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/force_options.h"
#include "core/error.h"
#include "io/pose_log.h"

namespace bodkin::cli {

namespace {

struct ExportArguments {
  std::string session;
  std::string ticks;
  std::string events;
  std::string second;
  std::string sequence;
  std::string recorder_log;
  double pose_rate = 60.0;
};

constexpr const char* export_footer = R"(Examples:
  bodkin export session.bodkin --csv ticks.csv
  bodkin export session.bodkin --csv - | head
  bodkin export session.bodkin --csv ticks.csv --events events.csv
  bodkin export session.bodkin --second plunger.csv       the second hand of 'perform --second'
  bodkin export session.bodkin --sequence needle.igs.mha  poses for PLUS and 3D Slicer
  bodkin export session.bodkin --recorder-log log.xml     poses and events for 3D Slicer's Perk Tutor

'-' is standard output. Every number can be read back to the same bits. docs/running.md lists the columns.)";

// A file that appears complete or not at all, or standard output.
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

void write(const std::string& name,
           const std::function<void(const session::Session&, const session::TextSink&)>& exporter,
           const session::Session& session) {
  OutputFile file(name);
  exporter(session, [&](std::string_view text) { file.write(text); });
  file.close();
}

void run_export(const ExportArguments& arguments, const CommandContext& context) {
  Console console(context);
  const std::array<std::pair<const char*, const std::string*>, 5> places = {
      {{"--csv", &arguments.ticks},
       {"--events", &arguments.events},
       {"--second", &arguments.second},
       {"--sequence", &arguments.sequence},
       {"--recorder-log", &arguments.recorder_log}}};
  if (std::all_of(places.begin(), places.end(), [](const auto& place) { return place.second->empty(); })) {
    throw InputError(
        "there is nothing to export, give --csv FILE, --events FILE, --second FILE, "
        "--sequence FILE or --recorder-log FILE");
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
  const auto write_poses = [&](const std::string& name, std::string (*text_of)(const io::PoseLog&)) {
    if (name.empty()) return;
    const std::string text = text_of(session::poses_of(session, arguments.pose_rate));
    write(
        name, [&](const session::Session&, const session::TextSink& sink) { sink(text); }, session);
  };
  write_poses(arguments.sequence, io::sequence_of_poses);
  write_poses(arguments.recorder_log, io::recorder_log);
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
                                       {"second_csv", arguments.second},
                                       {"sequence", arguments.sequence},
                                       {"recorder_log", arguments.recorder_log}})
                   .dump(2));
}

}  // namespace

void add_export_command(CLI::App& app, CommandContext& context) {
  add_command(app, "export", "Write a session as CSV, or for 3D Slicer and PLUS", export_footer,
              [&context](CLI::App& command) {
                auto arguments = std::make_shared<ExportArguments>();
                add_text(command, "SESSION", arguments->session, "Session file").required();
                add_text(command, "--csv", arguments->ticks, "A row per tick; '-' for standard output");
                add_text(command, "--events", arguments->events, "A row per event; '-' for standard output");
                add_text(command, "--second", arguments->second,
                         "A row per sample of the second hand; '-' for standard output");
                add_text(command, "--sequence", arguments->sequence, "Poses as a sequence of PLUS, .igs.mha");
                add_text(command, "--recorder-log", arguments->recorder_log,
                         "Poses and events as a log of 3D Slicer's transform recorder, .xml");
                add_number(command, "--pose-rate", arguments->pose_rate, 1.0, 4000.0,
                           "Poses per second of those two, 1 to 4000, at most one a tick");
                on_run(command, [arguments, &context] { run_export(*arguments, context); });
              });
}

}  // namespace bodkin::cli
