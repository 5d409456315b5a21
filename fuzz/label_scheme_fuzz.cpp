// An untrusted label scheme: refused with a sentence, or structures valid in a case.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/error.h"
#include "io/label_scheme.h"
#include "io/tissue_library_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bodkin::anatomy::TissueLibrary library = bodkin::io::default_tissue_library();
  try {
    const std::string text(reinterpret_cast<const char*>(data), size);
    for (const bodkin::anatomy::Structure& entry : bodkin::io::parse_label_scheme(text, "scheme.csv", library)) {
      if (entry.label == 0 || entry.name.empty() || entry.name.size() > 200) std::abort();
    }
  } catch (const bodkin::InputError&) {
  }
  return 0;
}
