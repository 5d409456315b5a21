#pragma once

#include "anatomy/tissue.h"
#include "io/tissue_library_file.h"

namespace bodkin::checks {

using namespace bodkin::anatomy;
using namespace bodkin::io;

// The library supplied with Bodkin.
inline const TissueLibrary& default_tissues() {
  static const TissueLibrary library = default_tissue_library();
  return library;
}

// The same with one tissue changed: `change(TissueProperties&)`.
template <typename Change>
TissueLibrary with_tissue(TissueId id, Change&& change, const TissueLibrary& from = default_tissues()) {
  std::vector<TissueProperties> tissues = from.tissues();
  for (TissueProperties& tissue : tissues) {
    if (tissue.id == id) change(tissue);
  }
  return TissueLibrary(std::move(tissues));
}

}  // namespace bodkin::checks
