#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

// `bodkin markers` as a user runs it.

#ifdef BODKIN_HAS_TRACKING

namespace bodkin_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class Markers : public BodkinCommand {};

TEST_F(Markers, are_printed_and_saved) {
  const Outcome made = bodkin("markers --pdf markers.pdf --save bodies.json");
  ASSERT_EQ(made.exit_code, 0) << made.text();
  EXPECT_THAT(text_of("markers.pdf"), StartsWith("%PDF-"));
  EXPECT_EQ(bodkin("markers --pdf again.pdf --bodies bodies.json").exit_code, 0);
}

TEST_F(Markers, a_print_that_is_not_to_scale_is_saved_as_it_came_out) {
  ASSERT_EQ(bodkin("markers --save exact.json").exit_code, 0);
  ASSERT_EQ(bodkin("markers --save small.json --ruler 99").exit_code, 0);
  const auto exact = nlohmann::json::parse(text_of("exact.json")),
             small = nlohmann::json::parse(text_of("small.json"));
  const auto &face = exact["bodies"][1]["faces"][1], &printed = small["bodies"][1]["faces"][1];
  EXPECT_NEAR(printed["side"], 0.99 * face["side"].get<double>(), 1e-9);
  EXPECT_NEAR(printed["place"][3], 0.99 * face["place"][3].get<double>(), 1e-9);
  EXPECT_EQ(small["bodies"][1]["tip"], exact["bodies"][1]["tip"]);
}

TEST_F(Markers, nothing_to_write_and_bad_bodies_are_refused) {
  EXPECT_THAT(bodkin("markers").errors, HasSubstr("--pdf or --save"));
  EXPECT_THAT(bodkin("markers surplus").errors, HasSubstr("has no command 'surplus'"));
  write("bad.json", R"({"bodies": [{"name": "a", "faces": []}]})");
  const Outcome bad = bodkin("markers --pdf x.pdf --bodies bad.json");
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_THAT(bad.errors, HasSubstr("body \"a\""));
}

}  // namespace
}  // namespace bodkin_test

#endif
