#include "imaging/markup.h"

#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::imaging;
namespace {

TEST(Markup, base64_agrees_with_the_examples_of_rfc_4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Markup, bytes_that_are_not_utf8_are_replaced_and_text_stays) {
  EXPECT_EQ(printable_utf8("22\u00b0 \u5f20 \U0001F600"), "22\u00b0 \u5f20 \U0001F600");
  EXPECT_EQ(printable_utf8("a\xff"
                           "b"),
            "a\uFFFD"
            "b");
  EXPECT_EQ(printable_utf8("\xc3"), "\uFFFD");                           // cut off
  EXPECT_EQ(printable_utf8("\xc0\xaf"), "\uFFFD\uFFFD");                 // an overlong slash
  EXPECT_EQ(printable_utf8("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD");       // a surrogate
  EXPECT_EQ(printable_utf8("\xf4\x90\x80\x80").substr(0, 3), "\uFFFD");  // beyond U+10FFFF
  EXPECT_EQ(printable_utf8("a\nb\x01"), "a b ");
}

}  // namespace
}  // namespace bodkin
