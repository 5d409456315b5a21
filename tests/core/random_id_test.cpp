#include "core/random_id.h"

#include <set>

#include <gtest/gtest.h>

namespace bodkin {
namespace {

TEST(RandomId, is_another_one_at_each_call_in_32_hexadecimal_digits) {
  std::set<std::string> ids;
  constexpr int calls = 1000;
  for (int i = 0; i < calls; ++i) {
    const std::string id = random_id();
    EXPECT_EQ(id.size(), 32U);
    EXPECT_EQ(id.find_first_not_of("0123456789abcdef"), std::string::npos) << id;
    ids.insert(id);
  }
  EXPECT_EQ(ids.size(), static_cast<std::size_t>(calls));
}

}  // namespace
}  // namespace bodkin
