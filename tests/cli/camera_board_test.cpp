#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>

// `bodkin camera board` as a user runs it.

#ifdef BODKIN_HAS_TRACKING

namespace bodkin_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class CameraBoard : public BodkinCommand {};

TEST_F(CameraBoard, is_printed_and_must_fit_on_the_page) {
  ASSERT_EQ(bodkin("camera board board.pdf").exit_code, 0);
  EXPECT_THAT(text_of("board.pdf"), StartsWith("%PDF-"));
  const Outcome large = bodkin("camera board large.pdf --square 40");
  EXPECT_EQ(large.exit_code, 2);
  EXPECT_THAT(large.errors, HasSubstr("A4 page"));
}

}  // namespace
}  // namespace bodkin_test

#endif
