#include "core/random_id.h"

#include <random>
#include <string_view>

namespace bodkin {

std::string random_id() {
  constexpr std::string_view digits = "0123456789abcdef";
  constexpr int words = 4, digits_of_word = 8;
  std::random_device source;
  std::string id;
  for (int word = 0; word < words; ++word) {
    auto bits = source();
    for (int digit = 0; digit < digits_of_word; ++digit, bits >>= 4) id += digits[bits & 15U];
  }
  return id;
}

}  // namespace bodkin
