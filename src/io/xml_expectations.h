#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/xml_document.h"

namespace bodkin::io {

// What libxml2 says of a document that its schema refuses, and the element it says it of.
struct SchemaError {
  int code = 0;         // xmlParserErrors
  std::string message;  // libxml2's words
  std::string element;
  std::string parent;  // of the element
  std::string text;    // of the element
  std::vector<std::pair<std::string, std::string>> attributes;
};

// What a schema expects where, in words taken from the schema itself, so that an error message can say so.
class SchemaExpectations {
 public:
  // `schema` is the schema's own document.
  explicit SchemaExpectations(const XmlElement& schema);

  // The error as a part of a sentence: "needle length_mm is '-3', expected a number above 0".
  std::string plain(const SchemaError& error) const;

  // What an attribute must be ("a number from 0 to 1"), or nothing when the schema does not know it. The attribute ""
  // is the text of the element.
  std::string expected(const std::string& element, const std::string& attribute) const;

 private:
  std::map<std::string, std::map<std::string, std::string>> expected_;  // element -> attribute -> words
  std::map<std::string, std::vector<std::string>> children_;            // element -> names of elements in it
  std::set<std::string> optional_;                                      // "<element>", of those that may be missing
};

// What to say of a document whose outermost element is another one's.
std::string misplaced_root(std::string_view name);

// The same for a document that is not well-formed XML.
std::string plain_parse_error(int code, const std::string& message);

}  // namespace bodkin::io
