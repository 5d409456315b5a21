#pragma once

#include "core/settings_tree.h"
#include "io/xml_document.h"
#include "io/xml_writer.h"

namespace bodkin::io {

// Settings in XML: values are attributes, members with members of their own are elements.

SettingsTree tree_of(const XmlElement& element);

// Writes one element with its children.
void write_settings(XmlWriter& xml, const SettingsTree& tree);

// An element that its schema has accepted. Throws InputError for relations between values that no schema can state.
template <Parameterized Settings>
Settings settings_from(const XmlElement& element, const std::string& origin) {
  return settings_from<Settings>(tree_of(element), origin);
}

}  // namespace bodkin::io
