#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>

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
