// Needles that were left in the body, in the header of a session.
#include "session/left_needles.h"

#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "session/session_file.h"
#include "tests/session/session_samples.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::session;
namespace {

using ::testing::HasSubstr;

const std::vector<anatomy::NeedlePath> two_left = {{Vec3(1.0 / 3.0, -2.0, 3e-7), Vec3(10.0, 20.5, -30.0)},
                                                   {Vec3(0.1 + 0.2, 5.0, 5.0), Vec3(5.0, 5.0, 105.0)}};

std::string refusal_of_left(const std::vector<anatomy::NeedlePath>& left) {
  try {
    check_left_needles(left);
  } catch (const InputError& refused) {
    return refused.what();
  }
  return "they were accepted";
}

TEST(LeftNeedles, come_back_bit_for_bit_with_the_session) {
  const ScratchSession scratch;
  SessionHeader header = sample_header();
  header.left_needles = two_left;
  {
    SessionWriter writer(scratch.path(), header, true);
    writer.append(sample_record(0));
    writer.finish();
  }
  const std::vector<anatomy::NeedlePath> read = read_session(scratch.path()).header.left_needles;
  ASSERT_EQ(read.size(), two_left.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(read[i].entry[axis]),
                std::bit_cast<std::uint64_t>(two_left[i].entry[axis]));
      EXPECT_EQ(std::bit_cast<std::uint64_t>(read[i].target[axis]),
                std::bit_cast<std::uint64_t>(two_left[i].target[axis]));
    }
  }
}

TEST(LeftNeedles, texts_that_are_none_are_refused) {
  EXPECT_TRUE(parse_left_needles("")->empty());
  EXPECT_EQ(parse_left_needles(left_needles_text(two_left))->size(), 2U);
  for (const char* text : {"1 2 3 4 5 6", "1 2 3 4 5\n", "1 2 3 4 5 6 7\n", "1 2 3 4 5 x\n", " 1 2 3 4 5 6\n",
                           "1 2 3 nan 5 6\n", "1 2 3 inf 5 6\n", "1 2 3 1 2 3\n", "1e9 2 3 4 5 6\n", "\n"}) {
    EXPECT_FALSE(parse_left_needles(text).has_value()) << text;
  }
  std::string many;
  for (int i = 0; i < 101; ++i) many += "0 0 0 0 0 9\n";
  EXPECT_FALSE(parse_left_needles(many).has_value());
}

TEST(LeftNeedles, that_no_body_can_have_are_one_sentence) {
  EXPECT_EQ(refusal_of_left(two_left), "they were accepted");
  EXPECT_THAT(refusal_of_left({two_left[0], {Vec3::Zero(), Vec3(0.0, 0.0, 0.5)}}),
              HasSubstr("needle 2 that was left"));
  EXPECT_THAT(refusal_of_left({{Vec3::Zero(), Vec3(0.0, 0.0, 501.0)}}), HasSubstr("expected 1 to 500 mm"));
  EXPECT_THAT(refusal_of_left({{Vec3(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0), Vec3::UnitZ()}}),
              HasSubstr("needle 1"));
  EXPECT_THAT(refusal_of_left(std::vector<anatomy::NeedlePath>(101, two_left[0])), HasSubstr("101 needles"));
}

}  // namespace
}  // namespace bodkin
