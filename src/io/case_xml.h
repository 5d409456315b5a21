#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "anatomy/case.h"

namespace bodkin::io {

class XmlSchema;
struct XmlElement;

// Gives the tissue library that a case names: a file of the case folder, or Bodkin's own for an empty name.
using LibraryOf = std::function<anatomy::TissueLibrary(const std::string& file)>;

// Reads case.xml (share/bodkin/case.xsd and docs/case-format.md have the format). `origin` names it in messages and
// `schema` is case.xsd. Throws InputError naming file, line, attribute, what was found and what was expected.
anatomy::CaseDescription parse_case_xml(std::string_view document, const std::string& origin, const XmlSchema& schema,
                                        const LibraryOf& library_of);

// The needle and the device that elements of the types of case.xsd describe. Throw InputError where one value does
// not go with another.
anatomy::Needle read_needle(const XmlElement& element, const std::string& origin);
anatomy::DeviceLimits read_device(const XmlElement& element, const std::string& origin);

// The same as a document of its own, which a session keeps that was recorded on a device. `schema` is case.xsd.
std::string device_xml(const anatomy::DeviceLimits& device);
anatomy::DeviceLimits parse_device_xml(std::string_view document, const std::string& origin, const XmlSchema& schema);

// The document that parse_case_xml reads back to the same description, every number to the same bits. Texts are made
// valid: what is not UTF-8 or not allowed in XML becomes U+FFFD.
std::string case_xml(const anatomy::CaseDescription& description);

}  // namespace bodkin::io
