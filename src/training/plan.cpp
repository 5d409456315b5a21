#include "training/plan.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "io/case_folder.h"
#include "io/resources.h"
#include "io/settings_xml.h"
#include "io/xml_document.h"
#include "training/procedure_file.h"

namespace bodkin::training {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_plan_file = 1 << 20;  // bytes

void check_stage(const PlanStage& stage, const std::string& where) {
  if (!stage.procedure.empty()) {
    try {
      find_procedure(stage.procedure);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", where, error.what()));
    }
  }
  if (stage.patient == built_in_patient) return;
  std::error_code failure;
  if (!fs::is_regular_file(fs::path(stage.patient) / "case.xml", failure)) {
    throw InputError(fmt::format(
        "{}: the case {} is not a folder with a case.xml; make one there with 'bodkin case synthesize', or name {}",
        where, io::in_quotes(stage.patient), built_in_patient));
  }
  if (!io::read_case_description(stage.patient).procedure.path) {
    throw InputError(fmt::format("{}: the case {} has no planned path; plan one with 'bodkin case new'", where,
                                 io::in_quotes(stage.patient)));
  }
}

}  // namespace

Plan parse_plan(std::string_view document, const std::string& origin) {
  static const io::XmlSchema schema("plan.xsd");
  SettingsTree tree = io::tree_of(schema.read(document, origin, {.root = "plan"}));
  std::erase_if(tree.values, [](const auto& value) { return value.first == "version"; });
  Plan plan = settings_from<Plan>(tree, origin);
  for (const PlanStage& stage : plan.stages) {
    if (!stage.must_pass || stage.passes > 0 || stage.mastery) continue;
    throw InputError(fmt::format("{}: stage {} must be passed but does not say by what; give it passes or mastery",
                                 origin, io::in_quotes(stage.title)));
  }
  return plan;
}

Plan read_plan(const fs::path& file) {
  Plan plan = parse_plan(io::read_text_file(file, largest_plan_file), file.string());
  for (PlanStage& stage : plan.stages) {
    if (stage.patient != built_in_patient) stage.patient = (file.parent_path() / stage.patient).string();
    const fs::path beside = file.parent_path() / stage.procedure;
    std::error_code failure;
    if (!stage.procedure.empty() && fs::is_regular_file(beside, failure)) stage.procedure = beside.string();
  }
  return plan;
}

void check_names(const Plan& plan, const std::string& origin) {
  for (const PlanStage& stage : plan.stages)
    check_stage(stage, fmt::format("{}: stage {}", origin, io::in_quotes(stage.title)));
}

std::vector<std::string> shipped_plans() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(io::shared_file("plan.xsd").parent_path() / "plans"))
    if (entry.path().extension() == ".xml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

fs::path find_plan(const std::string& name) {
  const std::vector<std::string> shipped = shipped_plans();
  std::error_code failure;
  if (std::find(shipped.begin(), shipped.end(), name) != shipped.end())
    return io::shared_file("plans/" + name + ".xml");
  if (fs::is_regular_file(name, failure)) return name;
  throw InputError(fmt::format("there is no plan {}, expected one of {}, or the name of a plan file",
                               io::in_quotes(name), fmt::join(shipped, ", ")));
}

}  // namespace bodkin::training
