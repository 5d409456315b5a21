#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "anatomy/tissue.h"

namespace bodkin::io {

class XmlSchema;
struct XmlElement;

// Reads a tissue library (share/bodkin/tissues.xml has the format and the defaults with their sources). Throws
// InputError naming file, line, attribute, what was found and what was expected.
anatomy::TissueLibrary read_tissue_library(const std::filesystem::path& file);

// The same from a document already in memory; `origin` names it in messages and `schema` is tissues.xsd.
anatomy::TissueLibrary parse_tissue_library(std::string_view document, const std::string& origin,
                                            const XmlSchema& schema);

// Takes the force parameters that are children of `element` (the types of tissue_forces.xsd) into `entry`; models
// without an element keep what they have. Throws InputError where one value does not go with another.
void read_tissue_forces(const XmlElement& element, const std::string& origin, anatomy::TissueProperties& entry);

// The library as such a file; read_tissue_library() gives the same bits back.
std::string tissue_library_xml(const anatomy::TissueLibrary& library);

// The library that comes with Bodkin. Throws SystemError when the installation lacks it.
anatomy::TissueLibrary default_tissue_library();

}  // namespace bodkin::io
