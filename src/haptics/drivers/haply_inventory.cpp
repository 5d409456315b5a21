#include "haptics/drivers/haply_inventory.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>

#include <nlohmann/json.hpp>

#include "haptics/bodkin_driver.h"
#include "haptics/drivers/driver_adapter.h"

namespace bodkin::haptics {

namespace {

using Json = nlohmann::json;

constexpr std::size_t longest_identity = 64;
constexpr double same_number = 1e-6;  // of a transform's numbers

const Json& part(const Json& json, const char* key) {
  static const Json nothing;
  if (!json.is_object()) return nothing;
  const auto found = json.find(key);
  return found == json.end() ? nothing : *found;
}

std::string text_in(const Json& json, const char* key) {
  const Json& text = part(json, key);
  return text.is_string() ? text.get<std::string>() : "";
}

bool is_identity(const std::string& text) {
  return !text.empty() && text.size() <= longest_identity && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == ':' ||
           c == '_' || c == '-';
  });
}

std::string model_of(const std::string& type) {
  if (type == "inverse3x") return "Inverse3x";
  if (type == "minverse") return "Minverse";
  return "Inverse3";
}

// Whether all numbers given in an object are `expected`.
bool are(const Json& json, std::initializer_list<const char*> keys, double expected) {
  return std::all_of(keys.begin(), keys.end(), [&](const char* key) {
    const Json& value = part(json, key);
    return value.is_null() || (value.is_number() && std::abs(value.get<double>() - expected) < same_number);
  });
}

// Absent parts count as unmoved.
bool is_unmoved(const Json& transform) {
  return are(part(transform, "position"), {"x", "y", "z"}, 0.0) &&
         are(part(transform, "rotation"), {"x", "y", "z"}, 0.0) &&
         are(part(transform, "scale"), {"x", "y", "z"}, 1.0);
}

// A value that the vendor's pages give alone or within an object of the same name.
std::string name_in(const Json& config, const char* key, const char* inner) {
  const std::string name = text_in(config, key);
  return name.empty() ? text_in(part(config, key), inner) : name;
}

std::string moved_by(const Json& entry) {
  const Json& config = part(entry, "config");
  const std::string basis = name_in(config, "basis", "permutation");
  if (!basis.empty() && basis != "XYZ" && basis != "xyz") return "the basis " + basis;
  const std::string preset = name_in(config, "preset", "preset");
  if (!preset.empty() && preset != "defaults") return "the preset " + preset;
  const Json& mount = part(config, "mount");
  if (!is_unmoved(mount) || !is_unmoved(part(mount, "transform"))) return "a mount that is moved or turned";
  return is_unmoved(part(part(entry, "state"), "transform")) ? "" : "a transform of its own";
}

}  // namespace

HaplyVersion parse_haply_version(std::string_view body) {
  const Json json = Json::parse(body, nullptr, false);
  const std::string project = text_in(json, "project_name");
  if (!project.empty() && project != "haply-inverse-service") {
    throw DriverFailure(BODKIN_WRONG_VERSION, "it calls itself '" + project.substr(0, longest_identity) + "'");
  }
  HaplyVersion version;
  version.text = text_in(json, "project_version");
  if (version.text.empty()) version.text = text_in(json, "git_tag");
  const std::size_t skip = version.text.starts_with('v') ? 1 : 0;
  const char* const end = version.text.data() + version.text.size();
  const auto [dot, error] = std::from_chars(version.text.data() + skip, end, version.major);
  if (error != std::errc()) throw DriverFailure(BODKIN_WRONG_VERSION, "it reports no version");
  if (dot != end && *dot == '.') std::from_chars(dot + 1, end, version.minor);
  return version;
}

HaplyInventory parse_haply_inventory(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) throw DriverFailure(BODKIN_BAD_DATA, "its first message is not a JSON object");
  HaplyInventory inventory;
  for (const Json& entry : part(json, "inverse3")) {
    const std::string identity = text_in(entry, "device_id");
    if (!is_identity(identity)) continue;
    const Json& calibrated = part(part(entry, "status"), "calibrated");
    inventory.devices.push_back({.identity = identity,
                                 .model = model_of(text_in(part(entry, "config"), "type")),
                                 .calibrated = !calibrated.is_boolean() || calibrated.get<bool>(),
                                 .moved = moved_by(entry)});
  }
  for (const char* kind : {"verse_grip", "wireless_verse_grip", "custom_verse_grip"}) {
    for (const Json& entry : part(json, kind)) {
      if (const std::string identity = text_in(entry, "device_id"); is_identity(identity)) {
        inventory.grips.push_back(identity);
      }
    }
  }
  return inventory;
}

}  // namespace bodkin::haptics
