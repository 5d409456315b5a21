#pragma once

#include <span>
#include <string_view>

namespace bodkin::patient {

// A collateral (luo mai). Twelve leave a meridian at its luo-connecting point for the partner meridian; three spread.
// Ling Shu, chapter 10, says where each begins and ends, but gives no course on the skin.
struct Collateral {
  std::string_view luo;      // code of the point at which it begins: "LU7"
  std::string_view partner;  // code of the meridian at which it ends: "LI"; empty: it spreads
  std::string_view source;   // code of the partner's source point, at which schemes let it end: "LI4"
  std::string_view goes_to;  // for a spreading one, in words
};

// All fifteen, in the order of the meridians.
std::span<const Collateral> collaterals();
// The one that begins at this point; null if none does.
const Collateral* collateral_at(std::string_view luo);

}  // namespace bodkin::patient
