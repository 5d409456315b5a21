#include "io/case_folder.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/files.h"
#include "io/case_xml.h"
#include "io/digest.h"
#include "io/nrrd_writer.h"
#include "io/resources.h"
#include "io/tissue_library_file.h"
#include "io/xml_document.h"

namespace bodkin::io {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t case_limit = 16 << 20;  // bytes of case.xml

anatomy::TissueLibrary library_of_case(const fs::path& folder, const std::string& file) {
  if (file.empty()) return default_tissue_library();
  return read_tissue_library(file_inside(folder, file, (folder / "case.xml").string() + ": tissue_library file"));
}

}  // namespace

anatomy::CaseDescription read_case_description(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    throw InputError(
        fmt::format("{}: there is no such case folder; 'bodkin case new' and 'bodkin case synthesize' make one",
                    folder.string()));
  }
  const fs::path file = folder / "case.xml";
  const std::string text = read_text_file(file, case_limit);
  return parse_case_xml(text, file.string(), XmlSchema("case.xsd"),
                        [&folder](const std::string& name) { return library_of_case(folder, name); });
}

anatomy::TissueLibrary read_case_library(const fs::path& folder, const anatomy::CaseDescription& description) {
  return library_of_case(folder, description.tissue_library_file);
}

void write_case_description(const anatomy::CaseDescription& description, const fs::path& folder) {
  const fs::path file = folder / "case.xml";
  const std::string text = case_xml(description);
  // Values that could not be read back must not be written.
  parse_case_xml(text, file.string(), XmlSchema("case.xsd"),
                 [&folder](const std::string& name) { return library_of_case(folder, name); });
  if (!std::filesystem::is_directory(file.parent_path())) {
    throw SystemError(file.string() + " cannot be written: there is no such folder");
  }
  write_file(file, text);
}

void write_case(anatomy::CaseDescription& description, const anatomy::CtVolume& ct,
                const anatomy::TissueVolume& tissues, const anatomy::LabelVolume& structures,
                const anatomy::TissueLibrary* library, const fs::path& folder) {
  const auto write = [&folder](const auto& volume, const char* name, std::string& file, std::string& digest) {
    if (volume.empty()) return;
    file = name;
    write_nrrd(volume, folder / file);
    digest = volume_digest(volume);
  };
  if (library != nullptr) {
    description.tissue_library_file = "tissues.xml";
    write_file(folder / description.tissue_library_file, tissue_library_xml(*library));
  }
  write(ct, "ct.nrrd", description.ct_file, description.ct_digest);
  write(structures, "structures.nrrd", description.structures_file, description.structures_digest);
  write(tissues, "tissues.nrrd", description.tissues_file, description.tissues_digest);
  write_case_description(description, folder);
}

}  // namespace bodkin::io
