#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/xml_document.h"

namespace bodkin::io {

// An error of libxml2 about a document that its schema rejects, and the element concerned.
struct SchemaError {
  int code = 0;         // xmlParserErrors
  std::string message;  // libxml2's words
  std::string element;
  std::string parent;  // of the element
  std::string text;    // of the element
  std::vector<std::pair<std::string, std::string>> attributes;
};

// The requirements of a schema in words, derived from the schema itself, for error messages.
class SchemaExpectations {
 public:
  // `schema` is the schema's own document.
  explicit SchemaExpectations(const XmlElement& schema);

  // The error as a part of a sentence: "needle length_mm is '-3', expected a number above 0".
  std::string plain(const SchemaError& error) const;

  // The requirement of an attribute ("a number from 0 to 1"), or nothing when the schema does not have it. The
  // attribute "" is the text of the element.
  std::string expected(const std::string& element, const std::string& attribute) const;

 private:
  std::map<std::string, std::map<std::string, std::string>> expected_;  // element -> attribute -> words
  std::map<std::string, std::vector<std::string>> children_;            // element -> names of elements in it
  std::set<std::string> optional_;                                      // "<element>", of those that may be missing
};

// The message about a document with another document's outermost element.
std::string misplaced_root(std::string_view name);

// The message about a document that is not well-formed XML.
std::string plain_parse_error(int code, const std::string& message);

}  // namespace bodkin::io
