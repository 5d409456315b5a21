#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "anatomy/case.h"

namespace bodkin::io {

class XmlSchema;
struct XmlElement;

// Provides the tissue library named in a case: a file of the case folder, or Bodkin's own for an empty name.
using LibraryOf = std::function<anatomy::TissueLibrary(const std::string& file)>;

// Reads case.xml (share/bodkin/case.xsd and docs/case-format.md have the format). `origin` names it in messages and
// `schema` is case.xsd. Throws InputError naming file, line, attribute, what was found and what was expected.
anatomy::CaseDescription parse_case_xml(std::string_view document, const std::string& origin, const XmlSchema& schema,
                                        const LibraryOf& library_of);

// The needle and the device described by elements of the types of case.xsd. Throw InputError for incompatible values.
anatomy::Needle read_needle(const XmlElement& element, const std::string& origin);
anatomy::DeviceLimits read_device(const XmlElement& element, const std::string& origin);

// The device as a document of its own, for sessions recorded on a device. `schema` is case.xsd.
std::string device_xml(const anatomy::DeviceLimits& device);
anatomy::DeviceLimits parse_device_xml(std::string_view document, const std::string& origin, const XmlSchema& schema);

// The document that parse_case_xml reads back to the same description, every number to the same bits. Invalid UTF-8
// and characters not allowed in XML become U+FFFD.
std::string case_xml(const anatomy::CaseDescription& description);

}  // namespace bodkin::io
