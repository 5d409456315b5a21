#pragma once

#include <span>
#include <string_view>

namespace bodkin::patient {

// A collateral (luo mai). Twelve leave a meridian at its luo-connecting point for the meridian that is its partner;
// three spread. Ling Shu, chapter 10, says where each leaves and where it goes, but no course on the skin.
struct Collateral {
  std::string_view luo;      // code of the point at which it leaves: "LU7"
  std::string_view partner;  // code of the meridian that it goes to: "LI"; empty: it spreads
  std::string_view source;   // code of the partner's source point, to which schemes draw it: "LI4"
  std::string_view goes_to;  // of one that spreads, in words
};

// All fifteen, in the order of the meridians.
std::span<const Collateral> collaterals();
// Of this point; null where none leaves.
const Collateral* collateral_at(std::string_view luo);

}  // namespace bodkin::patient
