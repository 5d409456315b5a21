#include <algorithm>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

// `bodkin points` as a user runs it.

namespace bodkin_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Points : public BodkinCommand {};

TEST_F(Points, a_code_a_name_and_a_meridian_are_found) {
  const Outcome one = bodkin("points ST36");
  EXPECT_EQ(one.exit_code, 0) << one.errors;
  EXPECT_THAT(one.output, HasSubstr("Zusanli"));
  EXPECT_THAT(bodkin("points zusanli").output, HasSubstr("ST36"));
  const Outcome table = bodkin("points heart --csv");
  EXPECT_EQ(std::count(table.output.begin(), table.output.end(), '\n'), 10);  // nine points and the names
}

TEST_F(Points, json_has_all_361_with_places_and_depths) {
  const json points = json::parse(bodkin("--json points").output);
  ASSERT_EQ(points.size(), 361u);
  for (const json& point : points) {
    EXPECT_EQ(point.at("place_mm").size(), 3u);
    EXPECT_LE(point.at("depth_mm").at(0).get<double>(), point.at("depth_mm").at(1).get<double>());
  }
}

TEST_F(Points, what_there_is_not_is_one_sentence) {
  const Outcome none = bodkin("points ST99");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.errors, HasSubstr("there is no point 'ST99'"));
  EXPECT_EQ(bodkin("points --sex neither").exit_code, 2);
}

}  // namespace
}  // namespace bodkin_test
