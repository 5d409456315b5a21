#include <memory>
#include <string>

#include "tracking/marker_body.h"
#include "tracking/marker_sheet.h"
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/tracking_commands.h"
#include "core/error.h"
#include "core/files.h"

namespace bodkin::cli {

namespace {

struct MarkersArguments {
  std::string pdf, json, bodies;
  double ruler = 100.0;
};

constexpr const char* markers_footer = R"(Examples:
  bodkin markers --pdf markers.pdf --save bodies.json     the board, and cubes for needle and probe
  bodkin markers --pdf mine.pdf --bodies mine.json        bodies of your own
  bodkin markers --ruler 99.5 --save bodies.json          the ruler on the print measures 99.5 mm
  bodkin markers calibrate pictures --body needle -o calibrated.json

Print at 100 % on stiff paper, measure the ruler, fold along the light lines. docs/augmented-reality.md describes the bodies
and the file.)";

void run_markers(const MarkersArguments& arguments, const CommandContext& context) {
  if (arguments.pdf.empty() && arguments.json.empty()) {
    throw InputError("bodkin markers has nothing to write; name a file with --pdf or --save");
  }
  if (!arguments.pdf.empty()) require_writable(arguments.pdf, "--pdf", arguments.bodies);
  if (!arguments.json.empty()) require_writable(arguments.json, "--save", arguments.bodies);
  auto bodies = arguments.bodies.empty() ? tracking::station_bodies() : tracking::read_bodies(arguments.bodies);
  if (!arguments.pdf.empty()) write_file(arguments.pdf, tracking::marker_sheets_pdf(bodies));
  if (arguments.ruler != 100.0) {
    // The print is not to scale: its faces are as large as printed. Tips are not part of the print.
    for (tracking::MarkerBody& body : bodies) {
      for (tracking::MarkerFace& face : body.faces) {
        face.side *= 0.01 * arguments.ruler;
        face.sheet *= 0.01 * arguments.ruler;
        face.place.translation() *= 0.01 * arguments.ruler;
      }
    }
  }
  if (!arguments.json.empty()) write_file(arguments.json, tracking::bodies_json(bodies));
  const Console console(context);
  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  for (const tracking::MarkerBody& body : bodies) {
    names.push_back(body.name);
    console.line(
        fmt::format("{:<12} {} faces, markers of {:.1f} mm", body.name, body.faces.size(), body.faces.front().side));
  }
  console.json(nlohmann::ordered_json{{"bodies", names}}.dump(2));
}

}  // namespace

CLI::App* add_markers_command(CLI::App& app, CommandContext& context) {
  auto arguments = std::make_shared<MarkersArguments>();
  CLI::App* command = add_command(app, "markers", "Print marker bodies to scale", markers_footer);
  add_text(*command, "--pdf", arguments->pdf, "File to print, A4");
  add_text(*command, "--save", arguments->json, "File for the bodies (JSON)");
  add_text(*command, "--bodies", arguments->bodies, "Bodies to print (default: those of a teaching station)");
  add_number(*command, "--ruler", arguments->ruler, 80.0, 120.0,
             "What the ruler of 100 mm on the print measures, for --save, mm, 80 to 120");
  // The command itself prints, unless a subcommand is given.
  on_run(*command, [arguments, command, &context] {
    if (command->get_subcommands().empty()) run_markers(*arguments, context);
  });
  return command;
}

}  // namespace bodkin::cli
