#include <memory>
#include <string>

#include "tracking/calibration_board.h"
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/tracking_commands.h"
#include "core/files.h"

namespace bodkin::cli {

namespace {

struct CameraBoardArguments {
  std::string file;
  double square = tracking::CalibrationBoard{}.square;
};

constexpr const char* camera_board_footer = R"(Examples:
  bodkin camera board board.pdf
  bodkin camera board board.pdf --square 20

Print it at 100 % and glue it flat onto glass or a stiff board; a bent board falsifies the calibration of the lens.)";

void run_camera_board(const CameraBoardArguments& arguments, const CommandContext& context) {
  require_writable(arguments.file, "FILE");
  tracking::CalibrationBoard board;
  board.square = arguments.square;
  write_file(arguments.file, tracking::calibration_board_pdf(board));
  const Console console(context);
  console.line(
      fmt::format("{}: {} x {} squares of {:.1f} mm", arguments.file, board.columns, board.rows, board.square));
  console.json(nlohmann::ordered_json{{"file", arguments.file}, {"square_mm", board.square}}.dump(2));
}

}  // namespace

void add_camera_board_command(CLI::App& camera_group, CommandContext& context) {
  add_command(camera_group, "board", "Print the board that a camera is calibrated with", camera_board_footer,
              [&context](CLI::App& command) {
                auto arguments = std::make_shared<CameraBoardArguments>();
                add_text(command, "FILE", arguments->file, "PDF to print, A4").required();
                add_number(command, "--square", arguments->square, 10.0, 40.0, "Edge of a square, mm, 10 to 40");
                on_run(command, [arguments, &context] { run_camera_board(*arguments, context); });
              });
}

}  // namespace bodkin::cli
