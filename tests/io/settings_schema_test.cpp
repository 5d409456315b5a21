#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include <gtest/gtest.h>
#include <libxml/parser.h>
#include <libxml/tree.h>
#include <libxml/xmlschemas.h>

#include "anatomy/case.h"
#include "anatomy/ultrasound_probe.h"
#include "core/parameter.h"
#include "io/resources.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

std::string attribute_of(const xmlNode* node, const char* name) {
  xmlChar* const value = xmlGetProp(const_cast<xmlNode*>(node), reinterpret_cast<const xmlChar*>(name));
  const std::string text = value == nullptr ? "" : reinterpret_cast<const char*>(value);
  xmlFree(value);
  return text;
}

bool is(const xmlNode* node, std::string_view name) {
  return node->type == XML_ELEMENT_NODE && reinterpret_cast<const char*>(node->name) == name;
}

// The types of a schema and of what it includes.
class Schema {
 public:
  explicit Schema(const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      const int size = static_cast<int>(text.size());
      documents_.emplace_back(xmlReadMemory(text.data(), size, nullptr, nullptr, XML_PARSE_NOBLANKS), &xmlFreeDoc);
      for (const xmlNode* node = xmlDocGetRootElement(documents_.back().get())->children; node; node = node->next) {
        if (is(node, "complexType") || is(node, "simpleType")) types_[attribute_of(node, "name")] = node;
      }
    }
  }

  const xmlNode* type(const std::string& name) const {
    const auto found = types_.find(name);
    EXPECT_NE(found, types_.end()) << name;
    return found == types_.end() ? nullptr : found->second;
  }

  // Range and words of a type, from its own facets and those of the types that it restricts.
  struct Facets {
    Range range = any_number;
    std::vector<std::string> words;
    std::string base;  // xs:double, xs:int, xs:string or xs:boolean
    bool finite = false;
  };
  Facets facets(const std::string& name) const {
    Facets found;
    if (name.starts_with("xs:")) {
      found.base = name;
      return found;
    }
    const xmlNode* restriction = type(name)->children;
    while (!is(restriction, "restriction")) restriction = restriction->next;
    found = facets(attribute_of(restriction, "base"));
    for (const xmlNode* facet = restriction->children; facet; facet = facet->next) {
      const std::string value = attribute_of(facet, "value");
      if (is(facet, "enumeration")) found.words.push_back(value);
      if (is(facet, "minInclusive") || is(facet, "minExclusive"))
        found.range.low = std::stod(value), found.range.includes_low = is(facet, "minInclusive");
      if (is(facet, "maxInclusive") || is(facet, "maxExclusive"))
        found.range.high = std::stod(value), found.range.includes_high = is(facet, "maxInclusive");
      if (is(facet, "pattern")) found.finite = value.find("INF") == std::string::npos;
    }
    return found;
  }

 private:
  std::vector<std::unique_ptr<xmlDoc, decltype(&xmlFreeDoc)>> documents_;
  std::map<std::string, const xmlNode*> types_;
};

void collect(const xmlNode* node, std::string_view kind, std::map<std::string, const xmlNode*>& found) {
  for (const xmlNode* child = node->children; child; child = child->next) {
    if (is(child, kind)) {
      found[attribute_of(child, "name")] = child;
    } else if (is(child, "sequence") || is(child, "choice") || is(child, "all")) {
      collect(child, kind, found);
    }
  }
}

// Compares a type of a schema with a table of parameters.
class Comparison {
 public:
  // `unstated`: attributes whose default depends on others; `other`: what the file writes in a way of its own.
  Comparison(const Schema& schema, std::set<std::string_view> unstated = {}, std::set<std::string_view> other = {})
      : schema_(schema), unstated_(std::move(unstated)), other_(std::move(other)) {}

  template <typename Settings>
  void compare(const std::string& type) {
    compare_type(schema_.type(type), Settings{}, type);
  }

  int compared() const { return compared_; }

 private:
  template <typename Settings>
  void compare_type(const xmlNode* type, const Settings& defaults, const std::string& place) {
    std::map<std::string, const xmlNode*> elements;
    collect(type, "element", elements);
    bool alternatives = false;
    for_each_entry(
        [&](const auto& entry, const auto& value) {
          if constexpr (parameter_detail::is_alternatives<std::remove_cvref_t<decltype(entry)>>) {
            alternatives = true;
            for (const std::string_view word : enumeration_names(value)) {
              ASSERT_TRUE(elements.contains(std::string(word))) << place << " " << word;
              compare_attributes(type_of(elements[std::string(word)]), defaults, place + " " + std::string(word),
                                 word);
            }
            EXPECT_EQ(elements.size(), enumeration_names(value).size()) << place;
          }
        },
        defaults);
    if (alternatives) return;
    compare_attributes(type, defaults, place, "");
    for_each_inside(
        [&](const auto& entry, const auto& value) {
          using Value = std::remove_cvref_t<decltype(value)>;
          const std::string inside = place + " " + std::string(entry.name);
          ASSERT_TRUE(elements.contains(std::string(entry.name))) << inside;
          const xmlNode* element = elements[std::string(entry.name)];
          elements.erase(std::string(entry.name));
          if constexpr (parameter_detail::is_list<std::remove_cvref_t<decltype(entry)>>) {
            if (attribute_of(element, "maxOccurs") != "") {
              EXPECT_EQ(attribute_of(element, "maxOccurs"), std::to_string(entry.most)) << inside;
            }
            compare_type(type_of(element), typename Value::value_type{}, inside);
          } else if constexpr (parameter_detail::is_optional<Value>) {
            compare_type(type_of(element), typename Value::value_type{}, inside);
          } else {
            compare_type(type_of(element), value, inside);
          }
        },
        defaults);
    for (const auto& [name, element] : elements) EXPECT_TRUE(other_.contains(name)) << place << " " << name;
  }

  const xmlNode* type_of(const xmlNode* element) const {
    if (const std::string name = attribute_of(element, "type"); !name.empty()) return schema_.type(name);
    const xmlNode* type = element->children;
    while (type != nullptr && !is(type, "complexType")) type = type->next;
    return type;
  }

  template <typename Settings>
  void compare_attributes(const xmlNode* type, const Settings& defaults, const std::string& place,
                          std::string_view word) {
    std::map<std::string, const xmlNode*> attributes;
    collect(type, "attribute", attributes);
    for_each_parameter(
        [&](const auto& parameter, const auto& value) {
          if (!counts_for(parameter, word) || other_.contains(parameter.name)) return;
          const std::string name = place + " " + std::string(parameter.name);
          const auto found = attributes.find(std::string(parameter.name));
          ASSERT_NE(found, attributes.end()) << name;
          compare_facets(parameter, value, schema_.facets(attribute_of(found->second, "type")), name);
          const std::string stated = attribute_of(found->second, "default");
          auto by_default = value;
          if (!stated.empty()) {
            EXPECT_TRUE(parse_value(stated, by_default)) << name;
            EXPECT_EQ(value_text(by_default), value_text(value)) << name;
          } else {
            EXPECT_TRUE(attribute_of(found->second, "use") == "required" || parameter.is_joint ||
                        unstated_.contains(parameter.name))
                << name << " has no default";
          }
          attributes.erase(found);
          ++compared_;
        },
        defaults);
    for (const EarlierName& earlier : earlier_names_of<Settings>()) {
      EXPECT_EQ(attributes.erase(std::string(earlier.name)), 1U) << place << " " << earlier.name;
    }
    for (const auto& [name, attribute] : attributes) EXPECT_TRUE(other_.contains(name)) << place << " " << name;
  }

  template <typename Value>
  static void compare_facets(const auto& parameter, const Value&, const Schema::Facets& facets,
                             const std::string& name) {
    if constexpr (std::same_as<Value, bool>) {
      EXPECT_EQ(facets.base, "xs:boolean") << name;
    } else if constexpr (NamedEnumeration<Value>) {
      const auto names = enumeration_names(Value{});
      EXPECT_EQ(facets.words, std::vector<std::string>(names.begin(), names.end())) << name;
    } else if constexpr (std::is_arithmetic_v<Value>) {
      EXPECT_EQ(facets.base, std::floating_point<Value> ? "xs:double" : "xs:int") << name;
      EXPECT_EQ(facets.range.low, parameter.range.low) << name;
      EXPECT_EQ(facets.range.high, parameter.range.high) << name;
      EXPECT_EQ(facets.range.includes_low, parameter.range.includes_low) << name;
      if (parameter.range.high < unbounded) {
        EXPECT_EQ(facets.range.includes_high, parameter.range.includes_high) << name;
      }
      if (std::floating_point<Value>) {
        EXPECT_EQ(facets.finite, parameter.range.high < unbounded) << name;
      }
    }
  }

  const Schema& schema_;
  std::set<std::string_view> unstated_, other_;
  int compared_ = 0;
};

template <typename Models>
void compare_models(Comparison& comparison, const auto& names) {
  [&]<std::size_t... Index>(std::index_sequence<Index...>) {
    (
        [&] {
          if (names[Index] != "none")
            comparison.compare<std::variant_alternative_t<Index, Models>>(std::string(names[Index]));
        }(),
        ...);
  }
  (std::make_index_sequence<std::variant_size_v<Models>>());
}

// --- what the schema lacks ---------------------------------------------------------------------------------------

std::string schema_text(const std::string& file) {
  return read_text_file(shared_file(file), 1 << 20);
}

// An element's name and attributes: element("a", {{"b", "c"}}) is `a b="c"`.
std::string element(std::string name, const std::vector<std::pair<std::string, std::string>>& attributes) {
  for (const auto& [attribute, value] : attributes) name += " " + attribute + "=\"" + value + "\"";
  return name;
}

// What a type called `name` has inside, as a table of parameters says it: elements, then attributes. `types`: those
// of the attributes.
template <typename Settings>
std::string inside_type(const Settings& defaults, const std::string& name, const std::string& indent,
                        std::string& types) {
  std::string elements, attributes;
  bool has_list = false;
  for_each_inside(
      [&](const auto& entry, const auto& value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        const std::string child(entry.name);
        const auto add = [&](const auto& its_defaults) {
          elements += indent + "  <" + element("xs:element", {{"name", child}, {"minOccurs", "0"}}) + ">\n" + indent +
                      "    <xs:complexType>\n" +
                      inside_type(its_defaults, name + "_" + child, indent + "      ", types) + indent +
                      "    </xs:complexType>\n" + indent + "  </xs:element>\n";
        };
        has_list = has_list || parameter_detail::is_list<std::remove_cvref_t<decltype(entry)>>;
        if constexpr (Parameterized<Value>)
          add(value);
        else
          add(typename Value::value_type{});
      },
      defaults);
  for_each_parameter(
      [&](const auto& parameter, const auto& value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        std::string type = "xs:boolean", base = "xs:string", facets;
        const auto facet = [&](const char* kind, std::string_view bound) {
          facets += "<" + element(std::string("xs:") + kind, {{"value", std::string(bound)}}) + "/>";
        };
        if constexpr (NamedEnumeration<Value>) {
          for (const std::string_view word : enumeration_names(value)) facet("enumeration", word);
        } else if constexpr (std::is_arithmetic_v<Value> && !std::same_as<Value, bool>) {
          const Range& range = parameter.range;
          base = WholeNumber<Value> ? "xs:int" : range.high < unbounded ? "finite" : "finite_or_infinite";
          if (range.low > -unbounded)
            facet(range.includes_low ? "minInclusive" : "minExclusive", number_text(range.low));
          if (range.high < unbounded)
            facet(range.includes_high ? "maxInclusive" : "maxExclusive", number_text(range.high));
        }
        if constexpr (!std::same_as<Value, bool>) {
          type = name + "_" + std::string(parameter.name);
          types += "  <" + element("xs:simpleType", {{"name", type}}) + ">\n    <" +
                   element("xs:restriction", {{"base", base}}) + ">" + facets +
                   "</xs:restriction>\n  </xs:simpleType>\n";
        }
        attributes +=
            indent + "<" +
            element("xs:attribute",
                    {{"name", std::string(parameter.name)}, {"default", value_text(value)}, {"type", type}}) +
            "/>\n";
      },
      defaults);
  if (elements.empty()) return attributes;
  const std::string group = has_list ? "choice" : "all";
  const std::string often = has_list ? " minOccurs=\"0\" maxOccurs=\"unbounded\"" : "";
  return indent + "<xs:" + group + often + ">\n" + elements + indent + "</xs:" + group + ">\n" + attributes;
}

// The document with those of the models that the choice `role` lacks.
template <typename... Models>
std::string with_models(std::string document, const std::string& role, std::type_identity<std::variant<Models...>>) {
  const auto add = [&](const auto& defaults) {
    const std::string name(defaults.element);
    const auto insert_before = [&document](const std::string& mark, std::size_t from, const std::string& text) {
      document.insert(document.find(mark, from), text);
    };
    const std::size_t choice = document.find("<xs:complexType name=\"" + role + "\">");
    const std::string line = "<" + element("xs:element", {{"name", name}});
    if (document.substr(choice, document.find("</xs:choice>", choice) - choice).find(line) == std::string::npos)
      insert_before("    </xs:choice>", choice, "      " + line + " type=\"" + name + "\"/>\n");
    const std::string type = "  <" + element("xs:complexType", {{"name", name}}) + ">\n";
    if (name == "none" || document.find(type) != std::string::npos) return;
    std::string types;
    const std::string inside = inside_type(defaults, name, "    ", types);
    insert_before("</xs:schema>", choice, "\n" + type + inside + "  </xs:complexType>\n" + types);
  };
  (add(Models()), ...);
  return document;
}

std::string with_every_model(const std::string& document) {
  const std::string resistances = with_models(document, "resistance", std::type_identity<ResistanceSettings>());
  return with_models(resistances, "constraint", std::type_identity<ConstraintSettings>());
}

// With BODKIN_WRITE_PAGES=1 in the environment the test adds what is missing.
TEST(SettingsSchema, every_model_has_a_type) {
  const std::string document = schema_text("case.xsd"), whole = with_every_model(document);
  if (std::getenv("BODKIN_WRITE_PAGES") != nullptr)
    std::ofstream(std::filesystem::path(BODKIN_REPOSITORY) / "share/bodkin/case.xsd", std::ios::binary) << whole;
  else
    EXPECT_EQ(document, whole) << "run the test with BODKIN_WRITE_PAGES=1";
}

TEST(SettingsSchema, a_type_that_is_added_says_what_the_table_says) {
  std::string document = schema_text("case.xsd");
  for (const std::string name : {"volume_proxy", "three_component", "fracture", "beam"}) {
    const std::string type = "  <xs:complexType name=\"" + name + "\">\n", end = "\n  </xs:complexType>\n";
    const std::size_t line = document.find("      <xs:element name=\"" + name + "\"");
    document.erase(line, document.find('\n', line) + 1 - line);
    const std::size_t begin = document.find(type);
    ASSERT_NE(begin, std::string::npos) << name;
    document.erase(begin, document.find(end, begin) + end.size() - begin);
  }
  document = with_every_model(document);
  const Schema schema({document});
  Comparison comparison(schema);
  comparison.compare<VolumeProxySettings>("volume_proxy");
  comparison.compare<ThreeComponentSettings>("three_component");
  comparison.compare<FractureSettings>("fracture");
  comparison.compare<BeamSettings>("beam");
  EXPECT_GT(comparison.compared(), 40);
  xmlSchemaParserCtxtPtr parser = xmlSchemaNewMemParserCtxt(document.data(), static_cast<int>(document.size()));
  xmlSchemaPtr parsed = xmlSchemaParse(parser);
  EXPECT_NE(parsed, nullptr);
  xmlSchemaFree(parsed);
  xmlSchemaFreeParserCtxt(parser);
}

// --- what it has -------------------------------------------------------------------------------------------------

TEST(SettingsSchema, case_files_allow_what_the_tables_allow) {
  const Schema schema({schema_text("case.xsd")});
  Comparison comparison(schema);
  compare_models<ResistanceSettings>(comparison, resistance_names);
  compare_models<ConstraintSettings>(comparison, constraint_names);
  comparison.compare<ForceParts>("parts");
  comparison.compare<GravitySettings>("compensation");
  comparison.compare<DeviceLimits>("device");
  EXPECT_GT(comparison.compared(), 110);
  Comparison rest(schema, {"outer_diameter_mm", "inner_diameter_mm"},
                  {"gauge", "resistance", "constraint", "parts", "compensation"});
  rest.compare<HapticSettings>("haptics");
  rest.compare<Needle>("needle");
  rest.compare<Breathing>("breathing");
}

TEST(SettingsSchema, tissue_libraries_allow_what_the_tables_allow) {
  const Schema schema({schema_text("tissues.xsd"), schema_text("tissue_forces.xsd")});
  Comparison comparison(schema, {}, {"source", "colour"});
  comparison.compare<TissueProperties>("tissue");
  EXPECT_GT(comparison.compared(), 40);
}

TEST(SettingsSchema, probe_libraries_allow_what_the_table_allows) {
  const Schema schema({schema_text("probes.xsd")});
  Comparison comparison(schema, {}, {"source"});
  comparison.compare<UltrasoundProbe>("probe");
  EXPECT_EQ(comparison.compared(), 14);
}

}  // namespace
}  // namespace bodkin
