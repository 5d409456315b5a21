// The same body solved by CalculiX; tests/cli/deformable_case_test.cpp does it with patients.
#include "tests/fem/calculix.h"

#include "tests/fem/lattice_body.h"
#include "tests/sanitized.h"

namespace bodkin {
namespace {

TEST(CalculiX, moves_and_resists_the_same) {
  if (!checks::calculix_is_there()) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  checks::expect_what_calculix_says(lattice_body(sanitized ? 6 : 11, 100.0, 0.1, 80), 40);
}

}  // namespace
}  // namespace bodkin
