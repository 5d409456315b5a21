#include "io/xml_expectations.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <libxml/xmlerror.h>

namespace bodkin::io {

namespace {

using Types = std::map<std::string, const XmlElement*>;  // named types of the schema

std::string collapsed(std::string_view text) {
  std::string words;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!blank) words += c;
    if (blank && !words.empty() && words.back() != ' ') words += ' ';
  }
  while (!words.empty() && words.back() == ' ') words.pop_back();
  return words;
}

std::string joined(const std::vector<std::string>& words, std::string_view last) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) list += i + 1 == words.size() ? fmt::format(" {} ", last) : ", ";
    list += words[i];
  }
  return list;
}

// The values allowed by the facets of a simple type; for each kind the nearest restriction applies.
struct Facets {
  std::string documentation, base;
  std::vector<std::string> values;
  std::map<std::string, std::string> bounds;  // facet name -> value
};

void collect(const XmlElement& simple_type, const Types& types, Facets& facets) {
  const XmlElement* annotation = simple_type.child("annotation");
  if (annotation != nullptr && annotation->child("documentation") != nullptr && facets.documentation.empty()) {
    facets.documentation = collapsed(annotation->child("documentation")->text);
  }
  const XmlElement* restriction = simple_type.child("restriction");
  if (restriction == nullptr) return;
  for (const XmlElement& facet : restriction->children) {
    if (facet.name == "enumeration")
      facets.values.push_back(facet.string("value"));
    else
      facets.bounds.emplace(facet.name, facet.string("value"));
  }
  facets.base = restriction->string("base");
  if (const auto parent = types.find(facets.base); parent != types.end()) collect(*parent->second, types, facets);
}

std::string in_words(const Facets& facets) {
  if (!facets.documentation.empty()) return facets.documentation;
  if (facets.values.size() == 1) return fmt::format("'{}'", facets.values.front());
  if (!facets.values.empty()) return joined(facets.values, "or");
  if (facets.base == "xs:boolean") return "true or false";
  std::string words = facets.base == "xs:double" ? "a number" : facets.base == "xs:int" ? "a whole number" : "a text";
  const auto bound = [&facets](const char* name) {
    const auto found = facets.bounds.find(name);
    return found == facets.bounds.end() ? std::optional<std::string>() : std::optional(found->second);
  };
  const auto low = bound("minInclusive"), above = bound("minExclusive");
  const auto high = bound("maxInclusive"), below = bound("maxExclusive");
  if (low && high) return words + fmt::format(" from {} to {}", *low, *high);
  std::vector<std::string> limits;
  if (low) limits.push_back("of at least " + *low);
  if (above) limits.push_back("above " + *above);
  if (high) limits.push_back("at most " + *high);
  if (below) limits.push_back("below " + *below);
  return limits.empty() ? words : words + " " + joined(limits, "and");
}

// The values allowed by the type of an element or attribute declaration.
std::string type_in_words(const XmlElement& declaration, const Types& types) {
  Facets facets;
  const std::string name = declaration.string("type");
  const auto named = types.find(name);
  const XmlElement* simple = named != types.end() ? named->second : declaration.child("simpleType");
  if (simple != nullptr)
    collect(*simple, types, facets);
  else
    facets.base = name;
  return in_words(facets);
}

void each_element(const XmlElement& schema, const auto& visit) {
  for (const XmlElement& child : schema.children) {
    if (child.name == "element" && child.find("name") != nullptr) visit(child);
    each_element(child, visit);
  }
}

// The direct child elements of a complex type.
void child_names(const XmlElement& type, std::vector<std::string>& names) {
  for (const XmlElement& child : type.children) {
    if (child.name == "element") {
      names.push_back(child.string("name", child.string("ref")));
    } else {
      child_names(child, names);
    }
  }
}

std::string between(const std::string& text, std::string_view before, std::string_view after) {
  const auto start = text.find(before);
  if (start == std::string::npos) return {};
  const auto end = text.find(after, start + before.size());
  return end == std::string::npos ? std::string() : text.substr(start + before.size(), end - start - before.size());
}

// libxml2's "Expected is one of ( a, b )." as <a> and <b>.
std::vector<std::string> expected_elements(const std::string& message) {
  const std::string list = between(message, "( ", " )");
  std::vector<std::string> names;
  std::string_view rest = list;
  while (!rest.empty()) {
    const auto comma = rest.find(", ");
    names.push_back(fmt::format("<{}>", rest.substr(0, comma)));
    rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 2);
  }
  return names;
}

// The same without optional ones.
std::vector<std::string> missing_elements(const std::string& message, const std::set<std::string>& optional) {
  std::vector<std::string> names = expected_elements(message);
  std::erase_if(names, [&optional](const std::string& name) { return optional.contains(name); });
  return names;
}

// Elements that are optional everywhere.
void collect_optional(const XmlElement& schema, std::set<std::string>& optional) {
  for (const XmlElement& child : schema.children) {
    if (child.name == "element" && child.string("minOccurs") == "0")
      optional.insert(fmt::format("<{}>", child.string("name", child.string("ref"))));
    collect_optional(child, optional);
  }
}

}  // namespace

std::string misplaced_root(std::string_view name) {
  return fmt::format("the outermost element is <{}>, which does not belong there", name);
}

SchemaExpectations::SchemaExpectations(const XmlElement& schema) {
  Types types;
  for (const XmlElement& child : schema.children) {
    if (child.name == "simpleType" || child.name == "complexType") types.emplace(child.string("name"), &child);
  }
  collect_optional(schema, optional_);
  each_element(schema, [&](const XmlElement& element) {
    auto& attributes = expected_[element.string("name")];
    const auto named = types.find(element.string("type"));
    const XmlElement* type = named != types.end() ? named->second : element.child("complexType");
    if (type == nullptr || type->name == "simpleType") {
      attributes.emplace("", type_in_words(element, types));
      return;
    }
    child_names(*type, children_[element.string("name")]);
    for (const XmlElement& child : type->children) {
      if (child.name == "attribute") attributes.emplace(child.string("name"), type_in_words(child, types));
    }
  });
}

std::string SchemaExpectations::expected(const std::string& element, const std::string& attribute) const {
  const auto found = expected_.find(element);
  if (found == expected_.end()) return {};
  const auto words = found->second.find(attribute);
  return words == found->second.end() ? std::string() : words->second;
}

std::string SchemaExpectations::plain(const SchemaError& error) const {
  const std::string name = error.element.empty() ? between(error.message, "Element '", "'") : error.element;
  const std::string attribute = between(error.message, "attribute '", "'");
  switch (error.code) {
    case XML_SCHEMAV_CVC_ELT_1:
      return misplaced_root(name);
    case XML_SCHEMAV_CVC_COMPLEX_TYPE_3_2_1: {
      std::vector<std::string> known;
      if (const auto found = expected_.find(name); found != expected_.end()) {
        for (const auto& [attribute_name, words] : found->second) {
          if (!attribute_name.empty()) known.push_back(attribute_name);
        }
      }
      const std::string remedy = known.empty() ? "it takes none" : "it takes " + joined(known, "and");
      return fmt::format("<{}> has the unknown attribute {}; {}", name, in_quotes(attribute), remedy);
    }
    case XML_SCHEMAV_CVC_COMPLEX_TYPE_4: {
      const std::string missing = between(error.message, "The attribute '", "'");
      return fmt::format("<{}> lacks the attribute {}, expected {}", name, missing, expected(name, missing));
    }
    case XML_SCHEMAV_ELEMENT_CONTENT: {
      if (error.message.find("Missing child") != std::string::npos)
        return fmt::format("<{}> lacks {}", name, joined(missing_elements(error.message, optional_), "or"));
      if (const auto wanted = expected_elements(error.message); !wanted.empty()) {
        return fmt::format("the element <{}> is not allowed here, expected {}", name, joined(wanted, "or"));
      }
      std::vector<std::string> known;
      if (const auto found = children_.find(error.parent); found != children_.end()) {
        for (const std::string& child : found->second) known.push_back(fmt::format("<{}>", child));
      }
      if (std::find(known.begin(), known.end(), fmt::format("<{}>", name)) != known.end()) {
        return fmt::format("<{}> has the element <{}> once more, expected it once at most", error.parent, name);
      }
      const std::string remedy = known.empty() ? "it takes none" : "it takes " + joined(known, "and");
      return fmt::format("<{}> has the unknown element <{}>; {}", error.parent, name, remedy);
    }
    case XML_SCHEMAV_CVC_COMPLEX_TYPE_2_1:
      return fmt::format("<{}> must be empty, but has something inside", name);
    case XML_SCHEMAV_CVC_COMPLEX_TYPE_2_3:
      return fmt::format("<{}> has text inside ({}), expected elements only", name, in_quotes(collapsed(error.text)));
    default:
      break;
  }
  if (!attribute.empty()) {
    const auto value = std::find_if(error.attributes.begin(), error.attributes.end(),
                                    [&attribute](const auto& entry) { return entry.first == attribute; });
    if (value != error.attributes.end()) {
      return fmt::format("{} {} is {}, expected {}", name, attribute, in_quotes(value->second),
                         expected(name, attribute));
    }
  }
  if (const std::string words = expected(name, ""); !words.empty()) {
    return fmt::format("<{}> holds {}, expected {}", name, in_quotes(error.text), words);
  }
  return collapsed(error.message);
}

std::string plain_parse_error(int code, const std::string& message) {
  switch (code) {
    case XML_ERR_DOCUMENT_EMPTY:
      return "the file is not XML; expected it to begin with '<'";
    case XML_ERR_DOCUMENT_END:
    case XML_ERR_TAG_NOT_FINISHED:
      return "the file ends before its elements are closed; is it cut short?";
    case XML_ERR_INVALID_CHAR:
    case XML_ERR_INVALID_ENCODING:
      return "there is a character that is not UTF-8 or not allowed in XML";
    case XML_ERR_UNKNOWN_ENCODING:
    case XML_ERR_UNSUPPORTED_ENCODING:
      return "the encoding is unknown, expected UTF-8";
    default:
      break;
  }
  if (message.find("Excessive depth") != std::string::npos) return "the elements are nested too deeply";
  return "the XML is broken: " + collapsed(message);
}

}  // namespace bodkin::io
