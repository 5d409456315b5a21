#include "fem/solid/factor_layout.h"

#include <string>
#include <vector>

#include "tests/fem/lattice_body.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::fem;
namespace {

using ::testing::HasSubstr;
using Sizes = std::vector<FactorLayout::Size>;
using Numbers = std::vector<std::uint32_t>;

std::string refused(const Numbers& position, const Sizes& sizes, const Numbers& rows) {
  try {
    const FactorLayout layout(position, sizes, rows);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

Sizes sizes_of(const FactorLayout& layout) {
  Sizes sizes;
  for (const FactorLayout::Part& part : layout.parts) sizes.push_back({part.columns, part.rows});
  return sizes;
}

TEST(FactorLayout, is_the_same_from_its_sizes_as_from_the_analysis_it_came_from) {
  const FactorLayout layout(plan_body(lattice_body(7, 50.0, 0.1, 0)).symbolic);
  ASSERT_GT(layout.parts.size(), 3U);
  const FactorLayout again(layout.position, sizes_of(layout), layout.rows);
  EXPECT_EQ(again.part_of, layout.part_of);
  EXPECT_EQ(again.numbers, layout.numbers);
  EXPECT_EQ(again.bytes(), layout.bytes());
  for (std::size_t i = 0; i < layout.parts.size(); ++i) {
    EXPECT_EQ(again.parts[i].first, layout.parts[i].first);
    EXPECT_EQ(again.parts[i].rows_at, layout.parts[i].rows_at);
    EXPECT_EQ(again.parts[i].own_at, layout.parts[i].own_at);
    EXPECT_EQ(again.parts[i].below_at, layout.parts[i].below_at);
    EXPECT_EQ(again.parts[i].parent, layout.parts[i].parent);
  }
}

// Three nodes in a row, of which the last is eliminated second: 0 changes 2, 1 changes 2.
TEST(FactorLayout, refuses_what_no_elimination_brings_forth) {
  const Numbers order = {0, 1, 2};
  EXPECT_EQ(refused(order, {{1, 1}, {1, 1}, {1, 0}}, {2, 2}), "");
  EXPECT_EQ(refused(order, {{2, 1}, {1, 0}}, {2}), "");
  EXPECT_THAT(refused({0, 1, 1}, {{3, 0}}, {}), HasSubstr("does not name each node once"));
  EXPECT_THAT(refused({0, 1, 3}, {{3, 0}}, {}), HasSubstr("does not name each node once"));
  EXPECT_THAT(refused(order, {{2, 0}}, {}), HasSubstr("do not fit the number of nodes"));
  EXPECT_THAT(refused(order, {{3, 0}, {0, 0}}, {}), HasSubstr("do not fit the number of nodes"));
  EXPECT_THAT(refused(order, {{0xFFFFFFFF, 0}, {4, 0}}, {}), HasSubstr("do not fit the number of nodes"));
  EXPECT_THAT(refused(order, {{2, 1}, {1, 0}}, {2, 2}), HasSubstr("do not fit the number of nodes"));
  EXPECT_THAT(refused(order, {{2, 1}, {1, 0}}, {3}), HasSubstr("beyond the last node"));
  EXPECT_THAT(refused(order, {{2, 1}, {1, 0}}, {1}), HasSubstr("supernode 0 changes"));          // itself
  EXPECT_THAT(refused(order, {{1, 0}, {1, 1}, {1, 0}}, {0}), HasSubstr("supernode 1 changes"));  // what is done
  EXPECT_THAT(refused(order, {{1, 2}, {2, 0}}, {2, 1}), HasSubstr("supernode 0 changes"));       // not ascending
  EXPECT_THAT(refused(order, {{1, 2}, {2, 0}}, {1, 1}), HasSubstr("supernode 0 changes"));
  EXPECT_THAT(refused(order, {{1, 2}, {2, 0}}, {1, 9}), HasSubstr("supernode 0 changes"));
  // The parent of 0 is 1, which would have to change 2 as well.
  EXPECT_THAT(refused(order, {{1, 2}, {1, 0}, {1, 0}}, {1, 2}), HasSubstr("supernode 0 changes"));
  EXPECT_EQ(refused(order, {{1, 2}, {1, 1}, {1, 0}}, {1, 2, 2}), "");
}

TEST(FactorLayout, a_number_that_was_changed_is_refused_or_leads_to_no_row_outside_the_path_to_the_root) {
  const FactorLayout sound(plan_body(lattice_body(6, 50.0, 0.1, 0)).symbolic);
  Random random(8);
  int accepted = 0;
  for (int round = 0; round < 3000; ++round) {
    Numbers position = sound.position, rows = sound.rows;
    Sizes sizes = sizes_of(sound);
    const auto any = [&random](auto& values) -> auto& {
      return values[random.next() % values.size()];
    };
    const auto change = [&random](std::uint32_t& value) {
      value =
          random.uniform() < 0.8 ? value + 1 - 2 * (random.next() % 2) : static_cast<std::uint32_t>(random.next());
    };
    for (std::uint64_t i = 0; i <= random.next() % 2; ++i) {
      switch (random.next() % 4) {
        case 0:
          change(any(position));
          break;
        case 1:
          change(any(rows));
          break;
        case 2:
          change(any(sizes).columns);
          break;
        default:
          change(any(sizes).rows);
      }
    }
    try {
      const FactorLayout layout(position, sizes, rows);
      ++accepted;
      for (std::uint32_t part = 0; part < layout.parts.size(); ++part) {
        std::vector<bool> on_path(layout.parts.size(), false);
        for (std::uint32_t at = part; !on_path[at]; at = layout.parts[at].parent) on_path[at] = true;
        for (std::size_t i = 0; i < layout.parts[part].rows; ++i)
          ASSERT_TRUE(on_path[layout.part_of[layout.rows[layout.parts[part].rows_at + i]]]) << round;
      }
    } catch (const InputError&) {
    }
  }
  EXPECT_LT(accepted, 1500);
}

}  // namespace
}  // namespace bodkin
