#include <filesystem>
#include <memory>
#include <set>

#include "report/experiment_page.h"
#include "report/experiment_plot.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "core/error.h"
#include "core/files.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

struct FiguresArguments {
  std::string folder;
  std::vector<std::string> files;
};

constexpr const char* figures_footer = R"(Examples:
  bodkin figures figures                          every published experiment that comes with Bodkin
  bodkin figures mine --experiment my_needle.xml  an experiment of your own, on layers or on a patient

Writes DIR/NAME.svg and DIR/NAME.csv for each experiment and DIR/index.html (and index.md) with all of
them and their captions.
docs/figures.md explains the format of an experiment file; share/bodkin/experiments has some to copy.)";

nlohmann::json json_of(const report::Figure& figure, const fs::path& folder) {
  nlohmann::json result = {{"name", figure.experiment.name},
                           {"title", figure.experiment.title},
                           {"svg", (folder / (figure.experiment.name + ".svg")).string()},
                           {"csv", (folder / (figure.experiment.name + ".csv")).string()},
                           {"published", nlohmann::json::array()}};
  for (const study::PublishedComparison& comparison : figure.run.comparisons) {
    result["published"].push_back(
        {{"what", comparison.published.what},
         {"source", comparison.published.source},
         {"quantity", io::quantity_names[static_cast<std::size_t>(comparison.published.quantity)].name},
         {"paper", comparison.published.value},
         {"found", comparison.found},
         {"agrees", comparison.agrees}});
  }
  return result;
}

void print(const Console& console, const report::Figure& figure) {
  console.line(figure.experiment.title);
  for (const study::PublishedComparison& comparison : figure.run.comparisons) {
    const io::PublishedValue& published = comparison.published;
    console.line(fmt::format("  {:<7} {:<58} expected {:>12}   found {:>12}",
                             comparison.agrees ? "agrees" : "DIFFERS", published.what,
                             report::with_unit(published.value, published.quantity),
                             report::with_unit(comparison.found, published.quantity)));
  }
}

void run_figures(const FiguresArguments& arguments, const CommandContext& context) {
  Console console(context);
  std::vector<fs::path> files(arguments.files.begin(), arguments.files.end());
  if (files.empty()) files = io::shipped_experiments();
  // All are read before the first is played, so that errors show at once.
  std::vector<report::Figure> figures;
  std::vector<std::shared_ptr<const fem::ContactBody>> bodies;  // of each figure's patient
  std::set<std::string> names;
  for (const fs::path& file : files) {
    figures.push_back(
        {study::load_experiment(
             file, console.progress(), [&](const std::string& text) { console.note(text); }, &bodies.emplace_back()),
         {}});
    const std::string& name = figures.back().experiment.name;
    if (!names.insert(name).second)
      throw InputError(fmt::format("{}: there is another experiment called '{}'; give one of them another name",
                                   file.string(), name));
  }
  const fs::path folder = fs::absolute(arguments.folder);
  nlohmann::json result = {{"figures", nlohmann::json::array()}};
  const Progress progress = console.progress();
  std::size_t done = 0;
  for (report::Figure& figure : figures) {
    if (progress)
      progress(fmt::format("{} ({} of {})", figure.experiment.name, done + 1, figures.size()),
               static_cast<double>(done) / static_cast<double>(figures.size()));
    figure.run = study::play(figure.experiment, {}, std::move(bodies[done]));
    const std::string base = (folder / figure.experiment.name).string();
    write_file(base + ".svg", report::draw_plots(report::plots_of(figure.experiment, figure.run)).svg());
    write_file(base + ".csv", study::experiment_csv(figure.experiment, figure.run));
    figure.run.ticks = {};  // the page needs the comparisons only
    figure.experiment.patient.reset();
    console.clear_bar();
    print(console, figure);
    result["figures"].push_back(json_of(figure, folder));
    ++done;
  }
  write_file(folder / "index.html", report::figures_html(figures));
  write_file(folder / "index.md", report::figures_markdown(figures));
  console.line(fmt::format("\n{}", (folder / "index.html").string()));
  result["index"] = (folder / "index.html").string();
  console.json(result.dump(2));
}

}  // namespace

void add_figures_command(CLI::App& app, CommandContext& context) {
  add_command(
      app, "figures", "Simulate published experiments and plot the results", figures_footer,
      [&context](CLI::App& command) {
        auto arguments = std::make_shared<FiguresArguments>();
        add_text(command, "DIR", arguments->folder, "Folder for the pictures, tables and index.html").required();
        add_texts(command, "--experiment", arguments->files,
                  "Experiment file instead of those that come with Bodkin, may be repeated");
        on_run(command, [arguments, &context] { run_figures(*arguments, context); });
      });
}

}  // namespace bodkin::cli
