#include <memory>
#include <string>

#include "patient/acupuncture/atlas.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/body_parameters.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "core/error.h"

namespace bodkin::cli {
namespace {

struct PointsOptions {
  std::string words;
  bool csv = false;
  BodyChoice body;
};

constexpr const char* points_footer = R"(Examples:
  bodkin points                    all 361 points on a body of 1.72 m
  bodkin points ST36               one of them: where it is, how deep, what lies under it
  bodkin points "liver" --csv      a meridian, as a table
  bodkin points GB30 --height 1.60 --weight 52 --sex female

Places are LPS in mm, of the left half: soles at z = 0, the middle of the body at x = 0. Depths are for training scenes, not for
treatment. docs/acupuncture.md says where they come from.)";

std::string words_of(const patient::Needling& how) {
  return fmt::format("{:.0f} to {:.0f} mm at {:.0f} deg{}", how.shallowest, how.deepest, how.angle,
                     how.derived ? ", derived" : "");
}

std::string quoted(const std::string& text) {
  return text.find(',') == std::string::npos ? text : fmt::format("\"{}\"", text);
}

nlohmann::ordered_json json_of(const patient::AtlasPoint& point, const patient::Needling& how) {
  nlohmann::ordered_json json = {{"code", point.code},
                                 {"name", point.pinyin},
                                 {"meridian", point.meridian},
                                 {"region", point.region},
                                 {"bilateral", point.bilateral},
                                 {"place_mm", {point.place.x(), point.place.y(), point.place.z()}},
                                 {"depth_mm", {how.shallowest, how.deepest}},
                                 {"angle_deg", how.angle},
                                 {"direction", how.direction},
                                 {"caution", how.caution},
                                 {"source", how.source},
                                 {"derived", how.derived}};
  if (point.bone_depth) json["bone_mm"] = *point.bone_depth;
  if (point.danger_depth) json["danger"] = {{"tissue", point.danger}, {"depth_mm", *point.danger_depth}};
  return json;
}

void run_points(const PointsOptions& options, const CommandContext& context) {
  const Console console(context);
  const patient::Atlas atlas(body_of(options.body));
  const auto found = atlas.search(options.words);
  if (found.empty()) {
    throw InputError(fmt::format(
        "there is no point '{}'; expected a code such as ST36, a name such as Zusanli or a meridian such as Stomach",
        options.words));
  }
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  if (options.csv)
    console.line(
        "code,name,meridian,region,x_mm,y_mm,z_mm,depth_min_mm,depth_max_mm,angle_deg,derived,caution,source");
  const bool one = found.size() == 1 || found.front()->code == options.words;
  for (const patient::AtlasPoint* point : found) {
    const patient::Needling how = atlas.needling(*point);
    json.push_back(json_of(*point, how));
    if (options.csv) {
      console.line(fmt::format("{},{},{},{},{:.1f},{:.1f},{:.1f},{:.1f},{:.1f},{:.0f},{},{},{}", point->code,
                               point->pinyin, point->meridian, point->region, point->place.x(), point->place.y(),
                               point->place.z(), how.shallowest, how.deepest, how.angle, how.derived ? 1 : 0,
                               quoted(how.caution), quoted(how.source)));
      continue;
    }
    console.line(fmt::format("{:<5} {:<15} {:<16} ({:6.1f}, {:6.1f}, {:6.1f})  {}", point->code, point->pinyin,
                             point->meridian, point->place.x(), point->place.y(), point->place.z(), words_of(how)));
    if (!one || point != found.front()) continue;
    if (!how.direction.empty()) console.line(fmt::format("      direction  {}", how.direction));
    if (!how.caution.empty()) console.line(fmt::format("      caution    {}", how.caution));
    if (point->bone_depth)
      console.line(fmt::format("      bone       {:.0f} mm straight under it", *point->bone_depth));
    if (point->danger_depth)
      console.line(fmt::format("      {:<10} {:.0f} mm straight under it", point->danger, *point->danger_depth));
    console.line(fmt::format("      source     {}", how.source));
  }
  console.json(json.dump(2));
}

}  // namespace

void add_points_command(CLI::App& app, CommandContext& context) {
  add_command(app, "points", "Acupuncture points: where they are, how deep, what lies under them", points_footer,
              [&context](CLI::App& command) {
                auto options = std::make_shared<PointsOptions>();
                add_text(command, "WORDS", options->words, "Code, name or meridian (default: all)");
                add_switch(command, "--csv", options->csv, "As a table");
                add_body_parameters(command, options->body);
                on_run(command, [options, &context] { run_points(*options, context); });
              });
}

}  // namespace bodkin::cli
