// Untrusted case.xml: any bytes are either refused with a sentence, or give a case that reads back as written.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/error.h"
#include "io/case_xml.h"
#include "io/tissue_library_file.h"
#include "io/xml_document.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bodkin::io::XmlSchema schema("case.xsd");
  static const bodkin::anatomy::TissueLibrary library = bodkin::io::default_tissue_library();
  const auto library_of = [](const std::string&) { return library; };
  const std::string_view document(reinterpret_cast<const char*>(data), size);
  std::string written;
  try {
    written = bodkin::io::case_xml(bodkin::io::parse_case_xml(document, "case.xml", schema, library_of));
  } catch (const bodkin::InputError&) {
    return 0;
  }
  if (bodkin::io::case_xml(bodkin::io::parse_case_xml(written, "written", schema, library_of)) != written)
    std::abort();
  return 0;
}
