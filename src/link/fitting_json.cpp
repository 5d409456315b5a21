#include "link/fitting_json.h"

#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

namespace bodkin::link {

namespace {

constexpr const char* left_out = "left_out";

}  // namespace

std::string fitting_json(const std::string& object, std::size_t most) {
  if (object.size() <= most) return object;
  nlohmann::ordered_json json = nlohmann::ordered_json::parse(object, nullptr, false);
  if (!json.is_object()) return object;
  std::set<std::string> shortened;
  std::string text = object;
  while (text.size() > most) {
    std::string longest;
    std::size_t length = 0;
    for (const auto& [name, value] : json.items()) {
      const std::size_t size = value.dump().size();
      if (name == left_out || size <= length) continue;
      length = size;
      longest = name;
    }
    if (longest.empty()) break;
    nlohmann::ordered_json& member = json[longest];
    if (member.is_array() && member.size() > 1) {
      const auto half = static_cast<std::ptrdiff_t>(member.size() / 2);
      member.erase(member.begin() + half, member.end());
    } else {
      json.erase(longest);
    }
    shortened.insert(longest);
    json[left_out] = shortened;
    text = json.dump();
  }
  return text;
}

}  // namespace bodkin::link
