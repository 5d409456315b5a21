#pragma once

#include <string>
#include <string_view>

#include "anatomy/force_settings.h"
#include "core/settings_tree.h"

namespace bodkin::anatomy {
struct HapticSettings;
}  // namespace bodkin::anatomy

namespace bodkin::io {

struct XmlElement;
class XmlSchema;
class XmlWriter;

// The settings in a <haptics> element that the schema (case.xsd) has accepted. Throws InputError naming file, line,
// attribute, what was found and what was expected for incompatible values.
anatomy::HapticSettings read_haptics(const XmlElement& element, const std::string& origin);

// As a tree of texts: models, parts and compensation with all their values.
SettingsTree haptics_tree(const anatomy::HapticSettings& haptics);

// Writes a <haptics> element that read_haptics reads back to the same bits. The direction against gravity is a unit
// vector.
void write_haptics(XmlWriter& xml, const anatomy::HapticSettings& haptics);

// As separate documents, for sessions. `schema` is case.xsd.
std::string haptics_xml(const anatomy::HapticSettings& haptics);
anatomy::HapticSettings parse_haptics_xml(std::string_view document, const std::string& origin,
                                          const XmlSchema& schema);

}  // namespace bodkin::io
