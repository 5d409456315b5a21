#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tracking/bead_centres.h"
#include "tracking/point_pairs.h"
#include "tracking/registration_chain.h"
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
  std::string fixed, moving, target, output, picture, first, then;
  bool scale = false, match = false;
};

constexpr double picture_zoom = 1.5;  // pixels per px of the picture

constexpr const char* register_footer = R"(Examples:
  bodkin register mannequin.csv patient.csv -o registration.json
  bodkin register mannequin.csv patient.csv --scale --target 0,60,20
  bodkin register mannequin.csv patient.csv --target 0,60,20 --picture errors.svg
  bodkin register camera.csv mannequin_ct --match       beads of a case's CT, paired by their distances
  bodkin register board.csv mannequin_ct --match -o board.json
  bodkin register mannequin.csv patient.csv --target 0,60,20 --then board.json -o registration.json
                                                        patient to mannequin to board
  bodkin register board.csv mannequin_ct --match --first moved.json -o registration.json
                                                        the same, moved.json being what 'case warp --placed' wrote

A file of points has one line "name,x,y,z" or "x,y,z" per point, in mm. Three more numbers in a line are the standard
deviations of x, y and z, from which the error at the target is then predicted. A folder is a case: its points are the
beads (balls of 1 to 4 mm radius above 300 HU) in its CT, which need --match.
MOVING is transformed to fit FIXED. docs/augmented-reality.md explains the numbers.)";

// Refuses an unsuitable image file before anything is read.
void require_picture(const std::filesystem::path& file) {
  if (file.empty()) return;
  if (file.extension() != ".png" && file.extension() != ".svg") {
    throw InputError(fmt::format("--picture is '{}'; expected a file that ends in .svg or .png", file.string()));
  }
  require_writable(file, "--picture");
}

std::string picture_of(const std::filesystem::path& file, const tracking::Registration& registration,
                       const tracking::PointPairs& pairs) {
  if (file.empty()) return {};
  const imaging::Canvas picture =
      tracking::registration_picture(registration, pairs.fixed, pairs.moving, pairs.names);
  return file.extension() == ".svg" ? picture.svg() : picture.png(picture_zoom);
}

// `whole`: the registration combined with that of `file` before or after it; data about its points are kept.
void take_chain(Console& console, tracking::Registration& registration, tracking::Registration whole,
                const std::string& file, bool has_errors) {
  if (!has_errors) {
    console.note(
        fmt::format("{} does not contain its errors, so none can be predicted through it; use a file that 'bodkin "
                    "register -o' wrote",
                    file));
  }
  std::string line = fmt::format("through {}: scale {:.5f}", file, whole.fixed_from_moving.scale);
  if (whole.at_target) {
    const tracking::ErrorInterval& tre = whole.at_target->tre;
    line += fmt::format(
        "; TRE at the target {:.2f} mm RMS; its RMS lies between {:.2f} and {:.2f} mm in 9 of 10 "
        "registrations",
        tre.estimate, tre.low, tre.high);
  }
  console.line(line);
  registration.fixed_from_moving = whole.fixed_from_moving;
  registration.scaled = whole.scaled;
  registration.at_target = whole.at_target;
  registration.errors = whole.errors;
}

bool is_folder(const std::string& name) {
  std::error_code code;
  return std::filesystem::is_directory(name, code);
}

tracking::NamedPoints points_of(const std::string& name, const Progress& progress) {
  if (!is_folder(name)) return tracking::read_points(name);
  tracking::NamedPoints points;
  for (const tracking::Bead& bead : tracking::find_beads(io::load_case(name, progress).ct))
    points.points.push_back(bead.centre);
  if (points.points.empty()) throw InputError(fmt::format("{}: there are no beads in its CT", name));
  return points;
}

// The beads of a CT are found in no particular order.
void require_match_for_folders(const RegisterArguments& arguments) {
  if (arguments.match) return;
  for (const std::string& name : {arguments.fixed, arguments.moving}) {
    if (!is_folder(name)) continue;
    throw InputError(fmt::format(
        "{}: the beads of a CT have neither names nor an order; give --match to pair them by their distances", name));
  }
}

void note_lonely_points(Console& console, const std::vector<std::string>& alone, const std::string& in,
                        const std::string& other) {
  constexpr std::size_t most_names = 8;
  if (alone.empty()) return;
  std::string names;
  for (std::size_t i = 0; i < std::min(alone.size(), most_names); ++i)
    names += fmt::format("{}'{}'", i == 0 ? "" : ", ", alone[i]);
  if (alone.size() > most_names) names += fmt::format(" and {} more", alone.size() - most_names);
  console.note(fmt::format("{}: no point of {} belongs to {}; left out", in, other, names));
}

// Requirements to check before anything is read.
void check_arguments(const RegisterArguments& arguments) {
  if (!arguments.output.empty()) {
    for (const std::string& input : {arguments.first, arguments.then})
      require_writable(arguments.output, "--output", input);
  }
  require_picture(arguments.picture);
  require_match_for_folders(arguments);
}

tracking::PointPairs pairs_of(Console& console, const RegisterArguments& arguments) {
  const Progress progress = console.progress();
  const tracking::NamedPoints fixed = points_of(arguments.fixed, progress),
                              moving = points_of(arguments.moving, progress);
  console.clear_bar();
  tracking::PointPairs pairs = tracking::pair_points(
      fixed, moving, arguments.match ? tracking::PairedBy::distance : tracking::PairedBy::name_or_order);
  note_lonely_points(console, pairs.fixed_alone, arguments.fixed, arguments.moving);
  note_lonely_points(console, pairs.moving_alone, arguments.moving, arguments.fixed);
  if (!arguments.match && fixed.names.empty() != moving.names.empty()) {
    console.note(fmt::format("{} has no names: its points are taken in the order of those of {}",
                             fixed.names.empty() ? arguments.fixed : arguments.moving,
                             fixed.names.empty() ? arguments.moving : arguments.fixed));
  }
  return pairs;
}

void print_points(Console& console, const tracking::PointPairs& pairs, const tracking::Registration& registration) {
  for (std::size_t i = 0; i < pairs.names.size(); ++i) {
    std::string line = fmt::format("{:<16} residual {:.3f} mm", pairs.names[i], registration.residuals[i]);
    if (!registration.leave_one_out.empty())
      line += fmt::format(", placed by the others {:.3f} mm", registration.leave_one_out[i]);
    console.line(line);
  }
  console.line(fmt::format("FRE RMS {:.3f} mm, mean {:.3f} mm; scale {:.5f}", registration.fre_rms,
                           registration.fre_mean, registration.fixed_from_moving.scale));
}

// Doubtful properties of the points.
void note_doubts(Console& console, const tracking::PointPairs& pairs, bool with_scale) {
  const auto swapped = tracking::swapped_pairs(pairs.fixed, pairs.moving, with_scale);
  if (!swapped.empty()) {
    std::string points;
    for (const auto& [one, other] : swapped)
      points += fmt::format("{}{} and {}", points.empty() ? "" : ", or ", pairs.names[one], pairs.names[other]);
    console.note(fmt::format("points {} fit far better when they are exchanged; check their names", points));
  } else if (const auto scale = with_scale ? std::nullopt : tracking::hidden_scale(pairs.fixed, pairs.moving)) {
    console.note(fmt::format(
        "the points fit far better with a scale of {:.4f}: a print is not to scale, or the two are not of one size; "
        "measure the ruler on the print, or give --scale",
        *scale));
  }
}

tracking::TargetError error_at(Console& console, const Vec3& target, const tracking::PointPairs& pairs,
                               const tracking::Registration& registration) {
  const tracking::ErrorInterval tre =
      pairs.unequal ? tracking::tre_interval(registration, pairs.moving,
                                             covariances_of(pairs, registration.fixed_from_moving), target)
                    : tracking::tre_interval(registration, pairs.moving, target);
  console.line(fmt::format(
      "TRE at the target: {:.2f} mm RMS; its RMS lies between {:.2f} and {:.2f} mm in 9 of 10 registrations",
      tre.estimate, tre.low, tre.high));
  return {target, tre};
}

void run_register(const RegisterArguments& arguments, const CommandContext& context) {
  check_arguments(arguments);
  std::optional<Vec3> target;
  if (!arguments.target.empty()) target = parse_point(arguments.target, "--target");
  std::optional<tracking::Registration> first, then;
  if (!arguments.first.empty()) first = tracking::read_registration(arguments.first);
  if (!arguments.then.empty()) then = tracking::read_registration(arguments.then);
  Console console(context);
  const tracking::PointPairs pairs = pairs_of(console, arguments);
  tracking::Registration registration = tracking::register_points(pairs.fixed, pairs.moving, arguments.scale);
  print_points(console, pairs, registration);
  note_doubts(console, pairs, arguments.scale);
  if (target) {
    const Vec3 here = first ? first->fixed_from_moving * *target : *target;
    registration.at_target = error_at(console, here, pairs, registration);
  }
  const std::string picture = picture_of(arguments.picture, registration, pairs);
  registration.errors =
      tracking::placement_errors(registration, pairs.moving,
                                 pairs.unequal ? covariances_of(pairs, registration.fixed_from_moving)
                                               : std::vector<Mat3>(pairs.moving.size(), Mat3::Identity()));
  if (first) {
    first->at_target.reset();
    if (target) first->at_target = tracking::TargetError{*target, {}};
    take_chain(console, registration, followed_by(*first, registration), arguments.first, first->errors.has_value());
  }
  if (then)
    take_chain(console, registration, followed_by(registration, *then), arguments.then, then->errors.has_value());
  std::string json = tracking::registration_json(registration);
  if (!picture.empty()) write_file(arguments.picture, picture);
  if (!arguments.output.empty()) write_file(arguments.output, json);
  json.pop_back();  // the console ends the line
  console.json(json);
}

}  // namespace

void add_register_command(CLI::App& app, CommandContext& context) {
  add_command(
      app, "register", "Register one set of points to another, and estimate the error", register_footer,
      [&context](CLI::App& command) {
        auto arguments = std::make_shared<RegisterArguments>();
        add_text(command, "FIXED", arguments->fixed, "File of points, or a case with beads").required();
        add_text(command, "MOVING", arguments->moving, "The same points in another frame").required();
        add_switch(command, "--scale", arguments->scale, "Find a scale too");
        add_switch(command, "--match", arguments->match, "Pair the points by their distances");
        add_text(command, "--target", arguments->target, "Where the error matters, moving frame, mm: x,y,z");
        add_text(
            command, "--first", arguments->first,
            "Registration to apply first, from another frame to MOVING's: file and target are then in that frame");
        add_text(command, "--then", arguments->then,
                 "Registration to apply last, from FIXED's frame to another: the file then leads to that frame");
        add_text(command, "--picture", arguments->picture, "Picture of points, residuals and target, .svg or .png");
        add_text(command, "-o,--output", arguments->output, "File for the registration (JSON)");
        on_run(command, [arguments, &context] { run_register(*arguments, context); });
      });
}

}  // namespace bodkin::cli
