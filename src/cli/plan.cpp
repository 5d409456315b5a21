#include "training/plan.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "training/plan_progress.h"
#include "training/store/plan_attempts.h"
#include "training/store/store_place.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct PlanArguments {
  std::string plan;
  std::string trainee;
  std::string store;
};

constexpr const char* plan_footer = R"(Examples:
  bodkin plan check week.xml                                  check that every name in it exists
  bodkin plan show lumbar_puncture_first_steps                its stages, criteria and aids
  bodkin plan show week.xml --trainee trainee-07              and the progress of a trainee

In the window a trainee chooses a plan on the start page. docs/plans.md explains plans.)";

std::string shown_aids(const training::PlanAids& aids) {
  std::vector<std::string> names;
  if (aids.overlay) names.emplace_back("overlay");
  if (aids.slices) names.emplace_back("slices");
  if (aids.inside) names.emplace_back("inside");
  if (aids.ladder) names.emplace_back("ladder");
  if (aids.ultrasound) names.emplace_back("ultrasound");
  if (aids.needle) names.emplace_back("needle");
  if (aids.sound) names.emplace_back("sound");
  if (aids.hints) names.emplace_back("hints");
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

std::string ending_of(const training::PlanStage& stage) {
  std::vector<std::string> criteria;
  if (stage.passes > 0) criteria.push_back(fmt::format("{} passed in a row", stage.passes));
  if (stage.mastery) criteria.emplace_back("mastery shown by CUSUM");
  std::string words = fmt::format("{}", fmt::join(criteria, " and "));
  if (stage.passes > 0 && stage.score_from > 0.0)
    words += fmt::format(", each with a score from {:g}", stage.score_from);
  if (stage.must_pass) return words;
  return fmt::format("{}{} attempts", criteria.empty() ? "" : fmt::format("{}, or ", words), stage.attempts);
}

ordered_json json_of(const training::PlanStage& stage) {
  return {{"title", stage.title},
          {"case", stage.patient},
          {"procedure", stage.procedure.empty() ? ordered_json(nullptr) : ordered_json(stage.procedure)},
          {"attempts", stage.attempts},
          {"passes", stage.passes},
          {"score_from", stage.score_from},
          {"mastery", stage.mastery},
          {"must_pass", stage.must_pass},
          {"aids",
           {{"overlay", stage.aids.overlay},
            {"slices", stage.aids.slices},
            {"inside", stage.aids.inside},
            {"ladder", stage.aids.ladder},
            {"ultrasound", stage.aids.ultrasound},
            {"needle", stage.aids.needle},
            {"sound", stage.aids.sound},
            {"hints", stage.aids.hints}}}};
}

ordered_json show_progress(const Console& console, const training::Plan& plan, const PlanArguments& arguments) {
  training::check_label(arguments.trainee, "--trainee");
  training::ResultStore store(training::store_place(arguments.store));
  const training::PlanProgress progress =
      training::progress_in(plan, training::plan_attempts(store, plan.name, arguments.trainee));
  const auto stages = static_cast<int>(plan.stages.size());
  const bool is_finished = progress.stage > stages;
  const std::string words =
      is_finished
          ? std::string("finished")
          : training::progress_words(plan.stages[static_cast<std::size_t>(progress.stage - 1)], progress.here);
  console.line(is_finished ? fmt::format("{}: finished", arguments.trainee)
                           : fmt::format("{}: stage {} of {}, {}", arguments.trainee, progress.stage, stages, words));
  return {{"trainee", arguments.trainee},
          {"stage", is_finished ? ordered_json(nullptr) : ordered_json(progress.stage)},
          {"finished", is_finished},
          {"attempts_in_stage", progress.here.attempts},
          {"passed_in_a_row", progress.here.in_a_row},
          {"words", words}};
}

void run_plan(const PlanArguments& arguments, const CommandContext& context, bool checks) {
  Console console(context);
  const fs::path file = training::find_plan(arguments.plan);
  const training::Plan plan = training::read_plan(file);
  training::check_names(plan, file.string());
  console.line(fmt::format("{}: {}", plan.name, plan.title));
  ordered_json stages = ordered_json::array();
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    const training::PlanStage& stage = plan.stages[i];
    console.line(fmt::format("  {}. {}\n     patient   {}\n     procedure {}\n     until     {}\n     aids      {}",
                             i + 1, stage.title, stage.patient,
                             stage.procedure.empty() ? std::string("the one of the case") : stage.procedure,
                             ending_of(stage), shown_aids(stage.aids)));
    stages.push_back(json_of(stage));
  }
  ordered_json json = {{"name", plan.name}, {"title", plan.title}, {"file", file.string()}, {"stages", stages}};
  if (!arguments.trainee.empty()) json["progress"] = show_progress(console, plan, arguments);
  if (checks) console.line("every procedure and patient of it exists");
  console.json(json.dump(2));
}

}  // namespace

void add_plan_command(CLI::App& app, CommandContext& context) {
  CLI::App* group = add_command(app, "plan", "Plans of training: check and show", plan_footer);
  need_command(*group);
  auto check = std::make_shared<PlanArguments>();
  CLI::App* command = add_command(*group, "check", "Check a plan and every name in it", plan_footer);
  add_text(*command, "PLAN", check->plan, "File of the plan, or the name of one that comes with Bodkin").required();
  on_run(*command, [check, &context] { run_plan(*check, context, true); });
  auto show = std::make_shared<PlanArguments>();
  command = add_command(*group, "show", "Stages, criteria and aids of a plan", plan_footer);
  add_text(*command, "PLAN", show->plan, "File of the plan, or the name of one that comes with Bodkin").required();
  add_text(*command, "--trainee", show->trainee, "Trainee whose progress is shown");
  add_text(*command, "--store", show->store, "File or postgresql:// address of the store");
  on_run(*command, [show, &context] { run_plan(*show, context, false); });
}

}  // namespace bodkin::cli
