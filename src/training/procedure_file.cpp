#include "training/procedure_file.h"

#include <algorithm>

#include "session/tick_codec.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "io/resources.h"
#include "io/settings_xml.h"
#include "io/xml_document.h"
#include "training/metric.h"

namespace bodkin::training {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_procedure_file = 1 << 20;  // bytes

// Texts are in elements; the table of parameters has them as values.
SettingsTree procedure_tree(const io::XmlElement& root) {
  SettingsTree tree{.name = root.name, .values = {}, .children = {}, .line = root.line};
  for (const auto& value : root.attributes)
    if (value.first != "version") tree.values.push_back(value);
  for (const io::XmlElement& child : root.children) {
    if (child.name == "description") {
      tree.values.emplace_back("description", io::one_line(child.text));
      continue;
    }
    tree.children.push_back(io::tree_of(child));
    if (child.name == "step") tree.children.back().values.emplace_back("text", io::one_line(child.text));
  }
  return tree;
}

bool is_shipped(const std::string& name) {
  const std::vector<std::string> shipped = shipped_procedures();
  return std::find(shipped.begin(), shipped.end(), name) != shipped.end();
}

void check_names(const io::XmlElement& root, const std::string& origin) {
  for (const io::XmlElement& child : root.children) {
    const std::string event = child.string("event"), metric = child.string("metric");
    if (!event.empty() && !session::event_kind_of(event)) {
      io::fail_at(origin, child.line,
                  fmt::format("{} event is {}, expected an event of docs/session-format.md, such as fluid_returned",
                              child.name, io::in_quotes(event)));
    }
    if (!metric.empty() && find_metric(metric) == nullptr) {
      io::fail_at(origin, child.line,
                  fmt::format("rule metric is {}, expected a metric of docs/metrics.md, such as final_distance_mm",
                              io::in_quotes(metric)));
    }
  }
}

}  // namespace

Procedure parse_procedure(std::string_view document, const std::string& origin) {
  static const io::XmlSchema schema("procedure.xsd");
  const io::XmlElement root = schema.read(document, origin, {.root = "procedure"});
  check_names(root, origin);
  return settings_from<Procedure>(procedure_tree(root), origin);
}

Procedure read_procedure(const fs::path& file) {
  return parse_procedure(io::read_text_file(file, largest_procedure_file), file.string());
}

std::vector<std::string> shipped_procedures() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(io::shared_file("procedure.xsd").parent_path() / "procedures")) {
    if (entry.path().extension() == ".xml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Procedure find_shipped_procedure(const std::string& name) {
  if (is_shipped(name)) return read_procedure(io::shared_file("procedures/" + name + ".xml"));
  throw InputError(fmt::format("there is no procedure {}, expected one of {}", io::in_quotes(name),
                               fmt::join(shipped_procedures(), ", ")));
}

Procedure find_procedure(const std::string& name) {
  std::error_code error;
  if (!is_shipped(name) && fs::is_regular_file(name, error)) return read_procedure(name);
  if (is_shipped(name)) return find_shipped_procedure(name);
  throw InputError(fmt::format("there is no procedure {}, expected one of {}, or the name of a procedure file",
                               io::in_quotes(name), fmt::join(shipped_procedures(), ", ")));
}

Procedure procedure_of_case(const std::string& name) {
  return find_shipped_procedure(is_shipped(name) ? name : "needle_insertion");
}

}  // namespace bodkin::training
