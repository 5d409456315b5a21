// bodkin serve and its client, killed at random: a short form of `link_soak kills`.
#include "tests/cli/bodkin_command.h"
#include "tests/cli/killed_pair.h"

namespace bodkin_test {
namespace {

using ServeKilled = PatientCommand;

TEST_F(ServeKilled, either_side_goes_on_when_the_other_is_killed_and_what_was_saved_is_there) {
  KilledPair pair(folder_, patient(), 20);
  for (int i = 0; i < 7; ++i) pair.kill_one();
  const KillCounts& found = pair.counts();
  EXPECT_EQ(found.faults(), 0) << found.text();
  EXPECT_GE(found.servers, 1) << found.text();
  EXPECT_GE(found.clients, 1) << found.text();
  EXPECT_GT(found.rows_compared, 0U) << found.text();
}

}  // namespace
}  // namespace bodkin_test
