#include "io/settings_xml.h"

namespace bodkin::io {

SettingsTree tree_of(const XmlElement& element) {
  SettingsTree tree{.name = element.name, .values = element.attributes, .children = {}, .line = element.line};
  for (const XmlElement& child : element.children) tree.children.push_back(tree_of(child));
  return tree;
}

void write_settings(XmlWriter& xml, const SettingsTree& tree) {
  xml.open(tree.name);
  for (const auto& [name, value] : tree.values) xml.attribute(name, value);
  for (const SettingsTree& child : tree.children) write_settings(xml, child);
  xml.close();
}

}  // namespace bodkin::io
