#include "training/plan.h"

#include <algorithm>

#include "io/resources.h"
#include "io/settings_xml.h"
#include "io/xml_document.h"

namespace bodkin::training {

namespace {

constexpr std::size_t largest_plan_file = 1 << 20;  // bytes

}  // namespace

Plan parse_plan(std::string_view document, const std::string& origin) {
  static const io::XmlSchema schema("plan.xsd");
  SettingsTree tree = io::tree_of(schema.read(document, origin, {.root = "plan"}));
  std::erase_if(tree.values, [](const auto& value) { return value.first == "version"; });
  return settings_from<Plan>(tree, origin);
}

Plan read_plan(const std::filesystem::path& file) {
  Plan plan = parse_plan(io::read_text_file(file, largest_plan_file), file.string());
  for (PlanStage& stage : plan.stages) stage.patient = (file.parent_path() / stage.patient).string();
  return plan;
}

}  // namespace bodkin::training
