#include "anatomy/tissue.h"

#include <algorithm>
#include <utility>

#include "core/error.h"

namespace bodkin::anatomy {

TissueLibrary::TissueLibrary(std::vector<TissueProperties> tissues) : tissues_(std::move(tissues)) {
  for (std::size_t position = 0; position < tissues_.size(); ++position) {
    const TissueProperties& entry = tissues_[position];
    if (entry.id == 255) throw InputError("tissue '" + entry.name + "' has id 255, which is reserved; use 0 to 254");
    if (by_id_[entry.id] >= 0) {
      throw InputError("tissues '" + tissues_[static_cast<std::size_t>(by_id_[entry.id])].name + "' and '" +
                       entry.name + "' share id " + std::to_string(entry.id) + "; give one of them another");
    }
    if (find(entry.name) != &entry) throw InputError("tissue name '" + entry.name + "' is used twice");
    by_id_[entry.id] = static_cast<int>(position);
  }
}

const TissueProperties* TissueLibrary::find(std::string_view name) const noexcept {
  const auto found =
      std::find_if(tissues_.begin(), tissues_.end(), [name](const TissueProperties& t) { return t.name == name; });
  return found == tissues_.end() ? nullptr : &*found;
}

std::string TissueLibrary::title(TissueId id) const {
  const TissueProperties* entry = find(id);
  return entry != nullptr ? entry->title : "tissue " + std::to_string(id);
}

}  // namespace bodkin::anatomy
