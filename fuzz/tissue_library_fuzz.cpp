// An untrusted tissue library: refused with a sentence, or a library with valid tissues.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/error.h"
#include "io/tissue_library_file.h"
#include "io/xml_document.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bodkin::io::XmlSchema schema("tissues.xsd");
  try {
    const auto library =
        bodkin::io::parse_tissue_library({reinterpret_cast<const char*>(data), size}, "tissues.xml", schema);
    for (const bodkin::anatomy::TissueProperties& entry : library.tissues()) {
      const bodkin::anatomy::LayeredTissue& layered = entry.layered;
      const bool sound = entry.id < 255 && std::isfinite(entry.hounsfield) &&
                         (layered.kind != bodkin::anatomy::LayeredKind::viscoelastic ||
                          (layered.stiffness > 0.0 && layered.break_force > 0.0 && layered.shaft_stiffness > 0.0 &&
                           layered.static_friction >= layered.dynamic_friction && layered.roughness < 1.0));
      if (!sound) std::abort();
    }
  } catch (const bodkin::InputError&) {
  }
  return 0;
}
