#include <limits>
#include <memory>

#include "patient/acupuncture/body_case.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/body_parameters.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/new_case_options.h"
#include "core/parameter_value.h"

namespace bodkin::cli {
namespace {

struct CaseSynthesizeBodyOptions {
  std::string folder, name, point;
  bool overwrite = false;
  double width = 200.0, spacing = 0.0;
  std::int64_t seed = 1;
  BodyChoice body;
};

constexpr const char* case_synthesize_body_footer = R"(Examples:
  bodkin case synthesize body whole                              the whole body, voxels of 4 mm
  bodkin case synthesize body buttock --point GB30               a block of 200 mm about a point, voxels of 1 mm
  bodkin case synthesize body back --point BL13 --sex female --height 1.62 --weight 55

bodkin points lists the points; docs/acupuncture.md says what is in the body.)";

void run_case_synthesize_body(const CaseSynthesizeBodyOptions& options, const CommandContext& context) {
  Console console(context);
  const patient::Atlas atlas(body_of(options.body));
  const anatomy::CaseDescription made =
      patient::write_body_case(atlas,
                               {options.folder, options.overwrite, options.name, options.point, options.width,
                                options.spacing, static_cast<std::uint64_t>(options.seed)},
                               console.progress());
  console.clear_bar();
  console.line(fmt::format("{} is ready: {}", options.folder, made.description));
  nlohmann::ordered_json json = {
      {"folder", options.folder}, {"name", made.name}, {"mechanics", value_text(made.haptics.mechanics)}};
  if (const auto& path = made.procedure.path) {
    console.line(fmt::format("  path      from ({:.1f}, {:.1f}, {:.1f}) mm, {:.1f} mm long", path->entry.x(),
                             path->entry.y(), path->entry.z(), path->length()));
    json["entry_mm"] = {path->entry.x(), path->entry.y(), path->entry.z()};
    json["target_mm"] = {path->target.x(), path->target.y(), path->target.z()};
  }
  console.line(forces_line(made.haptics.mechanics));
  console.line(fmt::format("Next: bodkin case show {0}{1}", options.folder,
                           made.procedure.path ? fmt::format(", bodkin profile {}", options.folder) : std::string()));
  console.json(json.dump());
}

}  // namespace

void add_case_synthesize_body_command(CLI::App& group, CommandContext& context) {
  add_command(group, "body", "A whole body, or a block about an acupuncture point", case_synthesize_body_footer,
              [&context](CLI::App& command) {
                auto options = std::make_shared<CaseSynthesizeBodyOptions>();
                add_text(command, "DIR", options->folder, "Folder of the case; it must not exist yet").required();
                add_text(command, "--name", options->name, "Name of the patient (default: the folder's)");
                add_text(command, "--point", options->point, "Code or name of the point (default: the whole body)");
                add_body_parameters(command, options->body);
                add_number(command, "--width", options->width, 40.0, 400.0,
                           "mm, of the block about the point, 40 to 400");
                add_number(command, "--spacing", options->spacing, 0.8, 8.0,
                           "mm, of the voxels: 0.8 to 3 of a block, 3 to 8 of the whole body (default: 1, 4)")
                    .without_default();
                constexpr std::int64_t any = std::numeric_limits<std::int64_t>::max();
                add_whole_number(command, "--seed", options->seed, 0, any, "Noise of the image");
                add_switch(command, "--overwrite", options->overwrite, "Replace a case that is already there");
                on_run(command, [options, &context] { run_case_synthesize_body(*options, context); });
              });
}

}  // namespace bodkin::cli
