#include "report/force_limits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/force_governor.h"

namespace bodkin {

using namespace bodkin::haptics;
using namespace bodkin::report;
namespace {

session::Session session_of(std::size_t ticks) {
  session::Session session;
  session.header.dt = 0.001;
  session.ticks.resize(ticks);
  return session;
}

TEST(ForceLimits, the_governors_work_is_counted_by_its_beginnings) {
  session::Session session = session_of(1000);
  for (std::size_t i = 200; i < 300; ++i) session.ticks[i].output.limits = force_limit::passivity;
  for (std::size_t i = 500; i < 550; ++i) session.ticks[i].output.limits = force_limit::slew;
  const ForceLimits limits = force_limits(session);
  EXPECT_EQ(limits.interventions, 2);
  EXPECT_NEAR(limits.time, 0.15, 1e-9);
  ASSERT_EQ(limits.limits.size(), 2U);
  EXPECT_NEAR(limits.limits[0].time, 0.1, 1e-9);
  const std::string sentence = limits.sentence({});
  EXPECT_THAT(sentence, ::testing::HasSubstr("twice, 0.15 s in all"));
  EXPECT_THAT(sentence, ::testing::HasSubstr("than the hand had put in, and was damped (0.10 s)"));
  EXPECT_THAT(sentence, ::testing::HasSubstr("would have risen faster than the limit allows (0.05 s)"));
}

TEST(ForceLimits, a_warning_of_stiff_tissue_is_no_limit) {
  session::Session session = session_of(1000);
  for (std::size_t i = 200; i < 400; ++i) session.ticks[i].output.limits = force_limit::stiffness;
  const ForceLimits limits = force_limits(session);
  EXPECT_EQ(limits.interventions, 0);
  EXPECT_EQ(limits.time, 0.0);
  EXPECT_EQ(limits.sentence({}), "");
}

}  // namespace
}  // namespace bodkin
