#include "patient/acupuncture/collaterals.h"

#include <algorithm>
#include <array>

namespace bodkin::patient {

namespace {

constexpr std::array<Collateral, 15> all = {{{"LU7", "LI", "LI4", ""},
                                             {"LI6", "LU", "LU9", ""},
                                             {"ST40", "SP", "SP3", ""},
                                             {"SP4", "ST", "ST42", ""},
                                             {"HT5", "SI", "SI4", ""},
                                             {"SI7", "HT", "HT7", ""},
                                             {"BL58", "KI", "KI3", ""},
                                             {"KI4", "BL", "BL64", ""},
                                             {"PC6", "TE", "TE4", ""},
                                             {"TE5", "PC", "PC7", ""},
                                             {"GB37", "LR", "LR3", ""},
                                             {"LR5", "GB", "GB40", ""},
                                             {"CV15", "", "", "spreads over the abdomen"},
                                             {"GV1", "", "", "runs up beside the spine and spreads over the head"},
                                             {"SP21", "", "", "spreads over chest and flanks"}}};

}  // namespace

std::span<const Collateral> collaterals() {
  return all;
}

const Collateral* collateral_at(std::string_view luo) {
  const auto found = std::find_if(all.begin(), all.end(), [luo](const Collateral& each) { return each.luo == luo; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace bodkin::patient
