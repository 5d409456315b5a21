// A body has the same bits on any processor.
#include "fem/solid/body_digests.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "tests/fem/lattice_body.h"
#include "tests/sanitized.h"
#include <gtest/gtest.h>

#include "fem/solid/contact_body.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

constexpr double lattice_side = 60.0;  // mm

std::vector<ContactSite> sites_of_lattice() {
  std::vector<ContactSite> sites;
  for (int depth = 0; depth <= 20; ++depth) {
    const bool border = depth == 0 || depth == 10;
    sites.push_back({Vec3(28.7, 31.3, lattice_side - depth), 1.0 * depth,
                     depth < 10 ? tissue::skin : tissue::ligamentum_flavum, border, border});
  }
  return sites;
}

// Of the factor, and of the contact points.
std::pair<std::uint64_t, std::uint64_t> digests_with(const std::shared_ptr<const BodyDescription>& body,
                                                     const FactorOptions& options) {
  const ContactBody contact(body, options);
  return {digest_of(contact.factor()),
          digest_of(contact.contact_points(sites_of_lattice(), -Vec3::UnitZ(), 1.0, options.threads))};
}

TEST(BodyDigests, are_the_same_with_every_instruction_set_and_number_of_threads) {
  const auto body = std::make_shared<const BodyDescription>(lattice_body(sanitized ? 6 : 10, lattice_side, 0.1, 40));
  const auto first = digests_with(body, {.threads = 1});
  const std::uint64_t of_nodes = digest_of(condense(*body, {.threads = 1}));
  for (const DenseTiles& tiles : dense_tiles()) {
    for (const int threads : {1, 3}) {
      const FactorOptions options = {.threads = threads, .tiles = &tiles};
      EXPECT_EQ(digests_with(body, options), first) << tiles.name << " on " << threads;
      EXPECT_EQ(digest_of(condense(*body, options)), of_nodes) << tiles.name << " on " << threads;
    }
  }
}

TEST(BodyDigests, change_with_the_last_bit) {
  CondensedBody body = condense(lattice_body(6, lattice_side, 0.1, 40));
  const std::uint64_t before = digest_of(body);
  body.compliance(7, 5) = std::nextafter(body.compliance(7, 5), 1e9);
  EXPECT_NE(digest_of(body), before);
}

}  // namespace
}  // namespace bodkin
