#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/app_window.h"
#include "cli/arguments.h"
#include "cli/commands.h"

namespace bodkin::cli {

namespace {

struct AppArguments {
  std::string patient, script, shots, size, language, connect;
  bool benchmark = false, allow_late = false;
};

constexpr const char* app_footer = R"(Examples:
  bodkin app                                   the start page
  bodkin app patient                           practise on this patient at once
  bodkin app dicom_folder                      a CT becomes a patient first
  bodkin app --script walk.txt --shots pictures
  bodkin app --connect room3                   show the session of 'bodkin serve' on the machine room3
  bodkin app --benchmark                       how fast the window is on this machine

docs/app.md describes the window and the lines of a script.)";

void run_app(const AppArguments& arguments) {
  require_window();
  std::vector<std::string> words;
  const std::pair<const char*, const std::string*> options[] = {{"--script", &arguments.script},
                                                                {"--shots", &arguments.shots},
                                                                {"--size", &arguments.size},
                                                                {"--language", &arguments.language},
                                                                {"--connect", &arguments.connect}};
  for (const auto& [option, value] : options) {
    if (!value->empty()) words.insert(words.end(), {option, *value});
  }
  if (arguments.allow_late) words.emplace_back("--allow-late");
  if (arguments.benchmark) words.emplace_back("--benchmark");
  if (!arguments.patient.empty()) words.insert(words.end(), {"--", arguments.patient});
  exec_app(words);
}

}  // namespace

void add_app_command(CLI::App& app, CommandContext& /*context*/) {
  add_command(app, "app", "Practise in a window: patient, needle and force", app_footer, [](CLI::App& command) {
    auto arguments = std::make_shared<AppArguments>();
    add_text(command, "CASE", arguments->patient, "A case, a DICOM folder or an image to begin with");
    add_text(command, "--script", arguments->script, "Run the commands in this file, then quit");
    add_text(command, "--shots", arguments->shots, "Folder for the script's screenshots");
    add_text(command, "--size", arguments->size, "Size of the window in pixels, such as 1280x720");
    add_text(command, "--language", arguments->language,
             "Language of the window, such as de (default: the one chosen last, or the system's)");
    add_text(
        command, "--connect", arguments->connect,
        "Show the session of the 'bodkin serve' at HOST or HOST:PORT; CASE is a local copy of its case (default: "
        "looked for in this folder and among the window's patients)");
    add_switch(command, "--allow-late", arguments->allow_late,
               "Allow the full force without real-time priority, although the system may then delay the servo");
    add_switch(
        command, "--benchmark", arguments->benchmark,
        "Measure how fast the window draws needle, camera and volume of the built-in patient, print it, then quit");
    on_run(command, [arguments] { run_app(*arguments); });
  });
}

}  // namespace bodkin::cli
