#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "anatomy/case.h"
#include "anatomy/ultrasound_probe.h"
#include "core/parameter.h"

// The tables of settings in docs/ are generated from the parameter tables. With BODKIN_WRITE_PAGES=1 in the
// environment the test writes them; otherwise it compares.

namespace bodkin {

using namespace bodkin::anatomy;
namespace {

namespace fs = std::filesystem;

constexpr std::string_view head = "| element | attribute | range | default | meaning |\n|---|---|---|---|---|\n";

std::string in_table(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.replace(at, 1, "\\|");
  return text;
}

// The rows of an element and of what lies inside. Without origins: the numbers of a library have sources of their
// own.
template <typename Settings>
std::string rows(const std::string& element, const Settings& defaults, bool origins = true) {
  std::string text;
  std::string first = "`" + element + "`";
  std::string_view word;
  const auto row = [&](const std::string& attribute, const std::string& range, const std::string& by_default,
                       std::string_view meaning) {
    text += "| " + first + " | " + attribute + " | " + range + " | " + by_default + " | " +
            in_table(std::string(meaning)) + " |\n";
    first = "";
  };
  const auto add_parameters = [&] {
    for_each_parameter(
        [&](const auto& parameter, const auto& value) {
          using Value = std::remove_cvref_t<decltype(value)>;
          if (!counts_for(parameter, word)) return;
          std::string range = type_words<Value>();
          if constexpr (std::is_arithmetic_v<Value> && !std::same_as<Value, bool>)
            range = range_words(parameter.range, parameter.unit);
          row("`" + std::string(parameter.name) + "`", range,
              value_text(value) + (origins ? ", " + value_text(parameter.origin) : ""), parameter.description);
        },
        defaults);
  };
  bool alternatives = false;
  for_each_entry(
      [&](const auto& entry, const auto& value) {
        if constexpr (parameter_detail::is_alternatives<std::remove_cvref_t<decltype(entry)>>) {
          alternatives = true;
          for (const std::string_view each : enumeration_names(value)) {
            word = each;
            first = "`" + std::string(each) + "` in `" + element + "`";
            const std::size_t before = text.size();
            add_parameters();
            if (text.size() == before) row("", "", "", "");
          }
        }
      },
      defaults);
  if (!alternatives) add_parameters();
  for_each_inside(
      [&](const auto& entry, const auto& value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        const std::string name(entry.name);
        if constexpr (parameter_detail::is_list<std::remove_cvref_t<decltype(entry)>>) {
          text += rows(name, typename Value::value_type{}, origins);
        } else if constexpr (parameter_detail::is_optional<Value>) {
          text += rows(name, typename Value::value_type{}, origins);
        } else {
          text += rows(name, value, origins);
        }
      },
      defaults);
  if (text.empty()) row("", "", "", "");
  return text;
}

template <typename Models>
void add_models(const auto& names, const std::string& all, std::map<std::string, std::string>& tables) {
  [&]<std::size_t... Index>(std::index_sequence<Index...>) {
    (
        [&] {
          const std::string name(names[Index]);
          std::string model = rows(name, std::variant_alternative_t<Index, Models>{});
          tables[name] = std::string(head) + model;
          if (fs::exists(fs::path(BODKIN_REPOSITORY) / "docs/models" / (name + ".md")))
            model.insert(2, "[").insert(model.find("` |") + 1, "](models/" + name + ".md)");
          tables[all] += (tables[all].empty() ? std::string(head) : "") + model;
        }(),
        ...);
  }
  (std::make_index_sequence<std::variant_size_v<Models>>());
}

std::map<std::string, std::string> all_tables() {
  std::map<std::string, std::string> tables;
  add_models<ResistanceSettings>(resistance_names, "resistance", tables);
  add_models<ConstraintSettings>(constraint_names, "constraint", tables);
  const auto add = [&](const std::string& name, const auto& settings, bool origins = true) {
    tables[name] = std::string(head) + rows(name, settings, origins);
  };
  add("parts", ForceParts{});
  add("relaxation", PronyTerm{});
  add("needle_grasp", NeedleGraspSettings{});
  add("bevel_tip", BevelTipSettings{});
  add("csf_flow", CsfFlowSettings{});
  add("syringe", SyringeSettings{});
  add("fingertip", FingertipSettings{});
  add("compensation", GravitySettings{});
  add("needle", Needle{});
  add("device", DeviceLimits{});
  add("breathing", Breathing{});
  add("tissue", TissueProperties{}, false);
  add("probe", UltrasoundProbe{}, false);
  return tables;
}

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST(SettingsPages, tables_of_settings_are_those_of_the_code) {
  const bool write = std::getenv("BODKIN_WRITE_PAGES") != nullptr;
  const std::map<std::string, std::string> tables = all_tables();
  const std::string opening = "<!-- settings: ", closing = "<!-- end of settings -->";
  std::set<std::string> used;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(BODKIN_REPOSITORY) / "docs")) {
    if (entry.path().extension() != ".md") continue;
    const std::string page = content_of(entry.path());
    std::string wanted = page;
    for (std::size_t at = 0; (at = wanted.find(opening, at)) != std::string::npos;) {
      const std::size_t name_at = at + opening.size();
      const std::string name = wanted.substr(name_at, wanted.find(" -->", name_at) - name_at);
      const std::size_t begin = wanted.find('\n', at) + 1, end = wanted.find(closing, begin);
      ASSERT_NE(end, std::string::npos) << entry.path() << ": " << name << " has no end";
      ASSERT_TRUE(tables.contains(name)) << entry.path() << ": there are no settings " << name;
      wanted.replace(begin, end - begin, tables.at(name));
      used.insert(name);
      at = begin + tables.at(name).size();
    }
    if (write && wanted != page) std::ofstream(entry.path(), std::ios::binary) << wanted;
    EXPECT_TRUE(write || wanted == page)
        << entry.path() << " does not say what the code says; run the test with BODKIN_WRITE_PAGES=1";
  }
  for (const char* name : {"resistance", "constraint", "parts", "compensation", "needle", "device", "breathing",
                           "tissue", "probe", "tracking_wall", "rail"})
    EXPECT_TRUE(used.contains(name)) << name << " is on no page";
}

}  // namespace
}  // namespace bodkin
