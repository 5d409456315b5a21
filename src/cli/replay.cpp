#include "session/replay.h"

#include <memory>
#include <utility>

#include "patient/prepared_body.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "io/case_folder.h"

namespace bodkin::cli {

namespace {

constexpr int exit_different = 3;

struct ReplayArguments {
  std::string session;
  std::string case_folder;
};

constexpr const char* replay_footer = R"(Examples:
  bodkin replay session.bodkin                  recompute every tick and compare
  bodkin replay session.bodkin --case patient   if the case folder was moved

Exit code 0: identical to the last bit. 3: something differs; the first difference is shown.)";

int run_replay(const ReplayArguments& arguments, const CommandContext& context) {
  Console console(context);
  const session::Session session = session::read_session(arguments.session);
  session::check_recomputable(session);  // before the body is prepared in vain
  const std::string folder = arguments.case_folder.empty() ? session.header.case_folder : arguments.case_folder;
  anatomy::Case patient = io::load_case(folder, console.progress());
  session::check_same_case(session, patient, folder);
  patient.description.haptics = session.header.haptics;
  patient.left_needles = session.header.left_needles;
  const std::shared_ptr<const fem::BodyDescription> body = patient::prepare_body(
      patient, folder, session.header.path, console.progress(), [&](const std::string& text) { console.note(text); });
  const session::ReplayResult result =
      session::replay_session(session, std::move(patient), console.progress(), body.get());
  console.clear_bar();
  if (!session.finished) console.note("the session was not finished; what was saved is replayed");
  nlohmann::ordered_json json = {{"identical", !result.difference},
                                 {"ticks", result.ticks},
                                 {"resistance", anatomy::name_of(session.header.haptics.resistance)},
                                 {"constraint", anatomy::name_of(session.header.haptics.constraint)}};
  if (!result.body_difference.empty()) {
    console.note(result.body_difference);
    json["body_difference"] = result.body_difference;
  }
  if (result.difference) {
    const session::ReplayDifference& difference = *result.difference;
    console.line(fmt::format("different: tick {} at {:.3f} s, {}\n  recorded   {}\n  recomputed {}", difference.tick,
                             difference.time, difference.field, difference.recorded, difference.recomputed));
    json["difference"] = {{"tick", difference.tick},
                          {"time_s", difference.time},
                          {"field", difference.field},
                          {"recorded", difference.recorded},
                          {"recomputed", difference.recomputed}};
  } else {
    console.line(fmt::format("identical: {} ticks, digest {}", result.ticks, result.digest));
    json["digest"] = result.digest;
  }
  console.json(json.dump(2));
  return result.difference ? exit_different : 0;
}

}  // namespace

void add_replay_command(CLI::App& app, CommandContext& context) {
  add_command(app, "replay", "Recompute a session and check that every bit is the same", replay_footer,
              [&context](CLI::App& command) {
                auto arguments = std::make_shared<ReplayArguments>();
                add_text(command, "SESSION", arguments->session, "Session file").required();
                add_text(command, "--case", arguments->case_folder,
                         "Folder of the case (default: as the session says)");
                on_run(command, [arguments, &context] { context.exit_code = run_replay(*arguments, context); });
              });
}

}  // namespace bodkin::cli
