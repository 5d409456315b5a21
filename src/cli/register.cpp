#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tracking/bead_centres.h"
#include "tracking/registration_file.h"
#include "tracking/registration_picture.h"
#include <fmt/format.h>

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/tracking_commands.h"
#include "core/error.h"
#include "core/files.h"
#include "io/case_folder.h"

namespace bodkin::cli {

namespace {

struct RegisterArguments {
  std::string fixed, moving, target, output, picture;
  bool scale = false, match = false;
};

constexpr double picture_zoom = 1.5;  // pixels per px of the picture

constexpr const char* register_footer = R"(Examples:
  bodkin register mannequin.csv patient.csv -o registration.json
  bodkin register mannequin.csv patient.csv --scale --target 0,60,20
  bodkin register mannequin.csv patient.csv --target 0,60,20 --picture errors.svg
  bodkin register camera.csv mannequin_ct --match       beads of a case's CT, paired by their distances

A file of points has a line "name,x,y,z" or "x,y,z" for each, mm; three more numbers are the standard deviations of its x, y
and z, which the error at the target is then predicted from. A folder is a case: its points are the beads (balls of 1 to
4 mm radius above 300 HU) in its CT. FIXED says where things are, MOVING is laid upon it. docs/augmented-reality.md
explains the numbers.)";

// Refuses a file that cannot become a picture, before anything is read.
void require_picture(const std::filesystem::path& file) {
  if (file.empty()) return;
  if (file.extension() != ".png" && file.extension() != ".svg") {
    throw InputError(fmt::format("--picture is '{}'; expected a file that ends in .svg or .png", file.string()));
  }
  require_writable(file, "--picture");
}

tracking::NamedPoints points_of(const std::string& name, const Progress& progress) {
  std::error_code code;
  if (!std::filesystem::is_directory(name, code)) return tracking::read_points(name);
  tracking::NamedPoints points;
  for (const tracking::Bead& bead : tracking::find_beads(io::load_case(name, progress).ct))
    points.points.push_back(bead.centre);
  if (points.points.empty()) throw InputError(fmt::format("{}: there are no beads in its CT", name));
  return points;
}

void run_register(const RegisterArguments& arguments, const CommandContext& context) {
  if (!arguments.output.empty()) require_writable(arguments.output, "--output");
  require_picture(arguments.picture);
  Vec3 target = Vec3::Zero();
  if (!arguments.target.empty()) target = parse_point(arguments.target, "--target");
  Console console(context);
  const Progress progress = console.progress();
  const tracking::NamedPoints fixed = points_of(arguments.fixed, progress),
                              moving = points_of(arguments.moving, progress);
  console.clear_bar();
  std::vector<Vec3> to, from, to_deviations, from_deviations;
  std::vector<std::string> names;
  const auto pair = [&](std::size_t in_fixed, std::size_t in_moving, std::string name) {
    to.push_back(fixed.points[in_fixed]);
    from.push_back(moving.points[in_moving]);
    to_deviations.push_back(fixed.deviations.empty() ? Vec3(Vec3::Zero()) : fixed.deviations[in_fixed]);
    from_deviations.push_back(moving.deviations.empty() ? Vec3(Vec3::Zero()) : moving.deviations[in_moving]);
    names.push_back(std::move(name));
  };
  if (arguments.match) {
    const tracking::PointMatch match = tracking::match_points(fixed.points, moving.points);
    for (std::size_t i = 0; i < fixed.points.size(); ++i) {
      const std::optional<std::size_t>& partner = match.moving_of_fixed[i];
      if (partner) pair(i, *partner, fmt::format("{} - {}", i + 1, *partner + 1));
    }
    if (match.ambiguous) {
      throw InputError(
          "the points can be paired in more than one way that fits; move one of them so that their "
          "distances differ, or give them names");
    }
  } else if (!fixed.names.empty() && !moving.names.empty()) {
    for (std::size_t i = 0; i < fixed.names.size(); ++i) {
      const auto partner = std::find(moving.names.begin(), moving.names.end(), fixed.names[i]);
      if (partner == moving.names.end()) continue;
      pair(i, static_cast<std::size_t>(partner - moving.names.begin()), fixed.names[i]);
    }
  } else if (fixed.points.size() != moving.points.size()) {
    tracking::register_points(fixed.points, moving.points, arguments.scale);  // refuses them
  } else {
    for (std::size_t i = 0; i < fixed.points.size(); ++i) pair(i, i, std::to_string(i + 1));
  }
  tracking::Registration registration = tracking::register_points(to, from, arguments.scale);
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::string line = fmt::format("{:<16} residual {:.3f} mm", names[i], registration.residuals[i]);
    if (!registration.leave_one_out.empty())
      line += fmt::format(", placed by the others {:.3f} mm", registration.leave_one_out[i]);
    console.line(line);
  }
  console.line(fmt::format("FRE RMS {:.3f} mm, mean {:.3f} mm; scale {:.5f}", registration.fre_rms,
                           registration.fre_mean, registration.fixed_from_moving.scale));
  if (const auto swapped = tracking::swapped_pair(to, from, arguments.scale)) {
    console.note(fmt::format("points {} and {} fit far better when they are exchanged; check their names",
                             names[swapped->first], names[swapped->second]));
  } else if (const auto scale = arguments.scale ? std::nullopt : tracking::hidden_scale(to, from)) {
    console.note(fmt::format(
        "the points fit far better with a scale of {:.4f}: a print is not to scale, or the two are not of one size; "
        "measure the ruler on the print, or give --scale",
        *scale));
  }
  if (!arguments.target.empty()) {
    const bool unequal = !fixed.deviations.empty() || !moving.deviations.empty();
    std::vector<Mat3> covariances;
    const tracking::Similarity& place = registration.fixed_from_moving;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Mat3 of_moving = from_deviations[i].cwiseAbs2().asDiagonal(), turn = place.scale * place.turn;
      covariances.push_back(Mat3(to_deviations[i].cwiseAbs2().asDiagonal()) + turn * of_moving * turn.transpose());
    }
    const tracking::ErrorInterval tre = unequal ? tracking::tre_interval(registration, from, covariances, target)
                                                : tracking::tre_interval(registration, from, target);
    console.line(fmt::format("TRE at the target: {:.2f} mm, between {:.2f} and {:.2f} mm in 9 of 10 registrations",
                             tre.estimate, tre.low, tre.high));
    registration.at_target = tracking::TargetError{target, tre};
  }
  std::string json = tracking::registration_json(registration);
  if (!arguments.picture.empty()) {
    const std::filesystem::path file = arguments.picture;
    const imaging::Canvas picture = tracking::registration_picture(registration, to, from, names);
    write_file(file, file.extension() == ".svg" ? picture.svg() : picture.png(picture_zoom));
  }
  if (!arguments.output.empty()) write_file(arguments.output, json);
  json.pop_back();  // the console ends the line
  console.json(json);
}

}  // namespace

void add_register_command(CLI::App& app, CommandContext& context) {
  auto arguments = std::make_shared<RegisterArguments>();
  CLI::App* command =
      add_command(app, "register", "Lay one set of points on another, and say what it is worth", register_footer);
  add_text(*command, "FIXED", arguments->fixed, "File of points, or a case with beads").required();
  add_text(*command, "MOVING", arguments->moving, "The same points elsewhere").required();
  add_switch(*command, "--scale", arguments->scale, "Find a scale too");
  add_switch(*command, "--match", arguments->match, "Pair the points by their distances");
  add_text(*command, "--target", arguments->target, "Where the error matters, moving frame, mm: x,y,z");
  add_text(*command, "--picture", arguments->picture, "Picture of points, residuals and target, .svg or .png");
  add_text(*command, "-o,--output", arguments->output, "File for the registration (JSON)");
  on_run(*command, [arguments, &context] { run_register(*arguments, context); });
}

}  // namespace bodkin::cli
