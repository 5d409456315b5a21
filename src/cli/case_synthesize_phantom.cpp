#include <algorithm>
#include <filesystem>
#include <memory>

#include "study/phantom.h"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "core/error.h"
#include "io/experiment_file.h"

namespace bodkin::cli {
namespace {

namespace fs = std::filesystem;

struct CaseSynthesizePhantomOptions {
  std::string folder, experiment, name;
  bool overwrite = false;
};

constexpr const char* case_synthesize_phantom_footer = R"(Examples:
  bodkin case synthesize phantom shoulder --experiment alamilla_2018_fig_9   nine layers of a half ball
  bodkin case synthesize phantom mine --experiment my_layers.xml
  bodkin perform shoulder omega                                              feel it with a device

bodkin figures recomputes the published experiments; docs/figures.md explains their format.)";

// The file itself, or the supplied experiment of that name.
io::Experiment experiment_of(const std::string& wanted) {
  std::error_code failure;
  if (fs::is_regular_file(wanted, failure)) return io::read_experiment(wanted);
  std::vector<std::string> names;
  for (const fs::path& file : io::shipped_experiments()) {
    names.push_back(file.stem().string());
    if (names.back() == wanted) return io::read_experiment(file);
  }
  throw InputError(
      fmt::format("--experiment is '{}', which is neither a file nor one of {}", wanted, fmt::join(names, ", ")));
}

void run_case_synthesize_phantom(const CaseSynthesizePhantomOptions& options, const CommandContext& context) {
  Console console(context);
  const io::Experiment experiment = experiment_of(options.experiment);
  const anatomy::CaseDescription made =
      study::write_phantom(experiment, {options.folder, options.overwrite, options.name}, console.progress());
  console.clear_bar();
  const anatomy::NeedlePath& path = *made.procedure.path;
  console.line(fmt::format("{} is ready: {}", options.folder, made.description));
  console.line(fmt::format("  layers    {}, from outside: {}", experiment.body.layers.size(),
                           experiment.library.title(experiment.library.find(experiment.body.layers[0].tissue)->id)));
  console.line(fmt::format("  path      {:.1f} mm long, needle of {:g} mm", path.length(), made.needle.length));
  console.line(fmt::format("Next: bodkin app {0}, bodkin perform {0} DEVICE, bodkin profile {0}", options.folder));
  const nlohmann::ordered_json json = {{"folder", options.folder},
                                       {"name", made.name},
                                       {"layers", experiment.body.layers.size()},
                                       {"entry_mm", {path.entry.x(), path.entry.y(), path.entry.z()}},
                                       {"target_mm", {path.target.x(), path.target.y(), path.target.z()}}};
  console.json(json.dump());
}

}  // namespace

void add_case_synthesize_phantom_command(CLI::App& group, CommandContext& context) {
  add_command(group, "phantom", "The layers of an experiment, to feel with any device",
              case_synthesize_phantom_footer, [&context](CLI::App& command) {
                auto options = std::make_shared<CaseSynthesizePhantomOptions>();
                add_text(command, "DIR", options->folder, "Folder of the case; it must not exist yet").required();
                add_text(command, "--experiment", options->experiment,
                         "Name of a published experiment, or file of your own")
                    .required();
                add_text(command, "--name", options->name, "Name of the case (default: the experiment's)");
                add_switch(command, "--overwrite", options->overwrite, "Replace a case that is already there");
                on_run(command, [options, &context] { run_case_synthesize_phantom(*options, context); });
              });
}

}  // namespace bodkin::cli
