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

TEST(CalculiX, moves_and_resists_the_same_where_a_tissue_has_fibres) {
  if (!checks::calculix_is_there()) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  for (const Vec3& fibre : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitZ())}) {
    BodyDescription body = lattice_body(sanitized ? 6 : 9, 100.0, 0.1, 80);
    body.materials.set(tissue::ligamentum_flavum, {0.17, 0.3, fibre, 10.0, 0.4});
    checks::expect_what_calculix_says(body, 30);
  }
}

}  // namespace
}  // namespace bodkin
