#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bodkin::io {

// One element of an XML document that its schema has accepted, so that every value has the declared type and range.
struct XmlElement {
  std::string name;
  int line = 0;  // 0: not named in messages
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string text;  // character data directly inside
  std::vector<XmlElement> children;

  // nullptr for an absent attribute.
  const std::string* find(std::string_view attribute) const noexcept;
  const XmlElement* child(std::string_view element) const noexcept;
  // An attribute's value, or `fallback` where the attribute is absent. The schema vouches for the type.
  std::string string(std::string_view attribute, const std::string& fallback = {}) const;
  double number(std::string_view attribute, double fallback) const noexcept;
  int integer(std::string_view attribute, int fallback) const noexcept;
  bool boolean(std::string_view attribute, bool fallback) const noexcept;
};

// Options for reading a document.
struct XmlReading {
  std::string root;   // name of the outermost element; empty: any that the schema has
  bool lines = true;  // false: the document has no useful line numbers, and messages omit them
};

// An XML schema (XSD 1.0) that documents are read against.
class XmlSchema {
 public:
  // Reads share/bodkin/`name` and what it includes from there. Throws SystemError when one of them is missing or is
  // not a schema.
  explicit XmlSchema(const std::string& name);
  XmlSchema(XmlSchema&&) noexcept;
  ~XmlSchema();

  // Reads and validates a document. No network, no document type, no entities, no namespaces, at most 16 levels;
  // `origin` names it in messages. Throws InputError with the first error: file, line, element and attribute, what
  // was found and what was expected.
  XmlElement read(std::string_view document, const std::string& origin, const XmlReading& how = {}) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// "case.xml, line 12: what is wrong", as an InputError; without the line where it is 0.
[[noreturn]] void fail_at(const std::string& origin, int line, const std::string& sentence);

// A value for messages: in quotes, shortened, without control characters.
std::string in_quotes(std::string_view value);

// A text with every run of blanks and line ends replaced by one space, none at its ends.
std::string one_line(std::string_view text);

}  // namespace bodkin::io
