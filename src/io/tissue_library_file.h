#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "anatomy/tissue.h"

namespace bodkin::io {

class XmlSchema;
struct XmlElement;

// Reads a tissue library (share/bodkin/tissues.xml shows the format and the defaults with their sources). Throws
// InputError naming file, line, attribute, what was found and what was expected.
anatomy::TissueLibrary read_tissue_library(const std::filesystem::path& file);

// As above, from a document in memory; `origin` names it in messages and `schema` is tissues.xsd.
anatomy::TissueLibrary parse_tissue_library(std::string_view document, const std::string& origin,
                                            const XmlSchema& schema);

// Reads the force parameters that are children of `element` (the types of tissue_forces.xsd) into `entry`; models
// without an element are not changed. Throws InputError for incompatible values.
void read_tissue_forces(const XmlElement& element, const std::string& origin, anatomy::TissueProperties& entry);

// The library as such a file; read_tissue_library() gives the same bits back.
std::string tissue_library_xml(const anatomy::TissueLibrary& library);

// The library that comes with Bodkin. Throws SystemError when the installation lacks it.
anatomy::TissueLibrary default_tissue_library();

}  // namespace bodkin::io
