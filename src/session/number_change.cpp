#include "session/number_change.h"

#include <algorithm>
#include <span>
#include <utility>

#include "session/session_schema.h"

#include "io/haptics_xml.h"
#include "io/tissue_library_file.h"
#include "io/xml_document.h"

namespace bodkin::session {

std::vector<anatomy::TissueProperties> changed_tissues(const std::vector<anatomy::TissueProperties>& now,
                                                       const anatomy::TissueLibrary& before) {
  const auto text = [](const anatomy::TissueProperties& tissue) {
    return io::tissue_library_xml(anatomy::TissueLibrary({tissue}));
  };
  std::vector<anatomy::TissueProperties> changed;
  for (const anatomy::TissueProperties& tissue : now) {
    const anatomy::TissueProperties* const was = before.find(tissue.id);
    if (was == nullptr || text(*was) != text(tissue)) changed.push_back(tissue);
  }
  // A library contains air.
  const auto is_air = [](const anatomy::TissueProperties& tissue) { return tissue.id == anatomy::tissue::air; };
  const anatomy::TissueProperties* const air = before.find(anatomy::tissue::air);
  if (!changed.empty() && air != nullptr && std::none_of(changed.begin(), changed.end(), is_air))
    changed.push_back(*air);
  return changed;
}

void apply(const NumberChange& change, anatomy::Case& patient) {
  patient.description.haptics = change.haptics;
  std::vector<anatomy::TissueProperties> tissues = patient.library.tissues();
  for (const anatomy::TissueProperties& changed : change.tissues) {
    const auto same = [&changed](const anatomy::TissueProperties& tissue) { return tissue.id == changed.id; };
    const auto found = std::find_if(tissues.begin(), tissues.end(), same);
    if (found != tissues.end())
      *found = changed;
    else
      tissues.push_back(changed);
  }
  patient.library = anatomy::TissueLibrary(std::move(tissues));
}

NumberChangeTexts texts_of(const NumberChange& change) {
  return {io::haptics_xml(change.haptics),
          change.tissues.empty() ? std::string() : io::tissue_library_xml(anatomy::TissueLibrary(change.tissues))};
}

void read_texts(const NumberChangeTexts& texts, const std::string& origin, NumberChange& change) {
  change.haptics = io::parse_haptics_xml(texts.haptics, origin + ": haptics", io::XmlSchema("case.xsd"));
  change.tissues.clear();
  if (!texts.tissues.empty()) {
    change.tissues =
        io::parse_tissue_library(texts.tissues, origin + ": tissues", io::XmlSchema("tissues.xsd")).tissues();
  }
}

std::int64_t checksum_of(const NumberChange& change, const NumberChangeTexts& texts) {
  const std::string all = std::to_string(change.from_tick) + '\n' + texts.haptics + '\n' + texts.tissues;
  const std::vector<std::uint8_t> bytes(all.begin(), all.end());
  return chunk_checksum(change.tick, 0, 0, bytes);
}

}  // namespace bodkin::session
