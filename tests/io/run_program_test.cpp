#include "io/run_program.h"

#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::io;
namespace {

TEST(RunProgram, input_and_arguments_reach_the_program_as_they_are) {
  const std::string large(3'000'000, 'x');
  EXPECT_EQ(run_program({"cat"}, large, "coreutils").output, large);
  EXPECT_EQ(run_program({"printf", "%s", "$(id) `id` ; 'a b'"}, "", "coreutils").output, "$(id) `id` ; 'a b'");
  EXPECT_EQ(run_program({"sh", "-c", "echo oh >&2; exit 3"}, "", "dash").exit_code, 3);
  EXPECT_EQ(run_program({"sh", "-c", "echo oh >&2; exit 3"}, "", "dash").errors, "oh\n");
}

TEST(RunProgram, a_missing_program_is_a_system_error_that_names_the_package) {
  try {
    run_program({"no-such-program-of-bodkin"}, "", "the-package");
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("apt-get install the-package"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace bodkin
