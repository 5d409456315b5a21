// The compliance of points anywhere in a body, against a solution of the whole body.
#include "fem/solid/packed_factor.h"

#include <cmath>
#include <cstring>
#include <memory>

#include "tests/fem/lattice_body.h"
#include <gtest/gtest.h>

#include "core/random.h"
#include "fem/solid/contact_body.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

std::shared_ptr<const BodyDescription> jittered_body(std::uint32_t n) {
  return std::make_shared<const BodyDescription>(lattice_body(n, 40.0, 0.2, 1));
}

// Points of two needles at an angle to each other, 1 mm apart.
std::vector<Vec3> places_of_two_needles() {
  std::vector<Vec3> places;
  const Vec3 first = Vec3(0.2, 0.1, -1.0).normalized(), second = Vec3(-0.3, -0.2, -1.0).normalized();
  for (int i = 0; i < 12; ++i) {
    places.emplace_back(Vec3(15.0, 17.0, 39.9) + i * first);
    places.emplace_back(Vec3(24.0, 22.0, 39.9) + 2.0 * i * second);
  }
  return places;
}

std::vector<CarriedPoint> carried(const ContactBody& body, const std::vector<PointInMesh>& places) {
  std::vector<CarriedPoint> points;
  for (const PointInMesh& place : places) points.push_back(body.carried(place));
  return points;
}

bool same_numbers(const PointResponse& a, const PointResponse& b) {
  return a.numbers.size() == b.numbers.size() &&
         std::memcmp(a.numbers.data(), b.numbers.data(), a.numbers.size() * sizeof(double)) == 0;
}

TEST(PackedFactor, the_compliance_between_the_points_of_two_needles_is_that_of_the_whole_body) {
  for (const std::uint32_t n : {6U, 11U}) {
    const auto description = jittered_body(n);
    const ContactBody body(description);
    const std::vector<PointInMesh> places = find_points(description->mesh, places_of_two_needles());
    const std::vector<PointResponse> responses = body.factor().respond(carried(body, places));

    const ElasticBody elastic(*description, plan_body(*description));
    const auto rows = 3 * static_cast<Eigen::Index>(description->mesh.nodes.size());
    const auto columns = 3 * static_cast<Eigen::Index>(places.size());
    Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(rows, columns);
    for (Eigen::Index p = 0; p < columns / 3; ++p) {
      const PointInMesh& place = places[static_cast<std::size_t>(p)];
      for (std::size_t corner = 0; corner < 4; ++corner)
        spread.block<3, 3>(3 * Eigen::Index{place.nodes[corner]}, 3 * p) += place.weights[corner] * Mat3::Identity();
    }
    const Eigen::MatrixXd everywhere = elastic.displacement(spread);
    std::vector<std::uint32_t> some;  // a fixed node among them
    for (std::uint32_t node = 0; node < description->mesh.nodes.size(); node += 5) some.push_back(node);
    const Eigen::MatrixXd there = body.displacements(carried(body, places), some);
    for (std::size_t i = 0; i < some.size(); ++i)
      ASSERT_LT((there.middleRows<3>(3 * static_cast<Eigen::Index>(i)) -
                 everywhere.middleRows<3>(3 * Eigen::Index{some[i]}))
                    .cwiseAbs()
                    .maxCoeff(),
                1e-12 * everywhere.cwiseAbs().maxCoeff())
          << some[i];
    const Eigen::MatrixXd expected = spread.transpose() * everywhere;
    for (Eigen::Index i = 0; i < columns / 3; ++i) {
      for (Eigen::Index j = 0; j < columns / 3; ++j) {
        const Mat3 found =
            compliance_between(responses[static_cast<std::size_t>(i)], responses[static_cast<std::size_t>(j)]);
        const double scale = std::sqrt(expected(3 * i, 3 * i) * expected(3 * j, 3 * j));
        ASSERT_LT((found - expected.block<3, 3>(3 * i, 3 * j)).cwiseAbs().maxCoeff(), 1e-12 * scale) << i << " " << j;
      }
    }
  }
}

TEST(PackedFactor, a_point_alone_has_the_bits_it_has_among_others_and_with_every_instruction_set) {
  const auto description = jittered_body(9);
  const ContactBody body(description);
  const std::vector<CarriedPoint> points = carried(body, find_points(description->mesh, places_of_two_needles()));
  const std::vector<PointResponse> together = body.factor().respond(points);
  const std::vector<PointResponse> plain = body.factor().respond(points, PackedFactor::Kernel::plain);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::vector<PointResponse> alone = body.factor().respond({&points[i], 1});
    EXPECT_TRUE(same_numbers(together[i], alone[0])) << i;
    EXPECT_TRUE(same_numbers(together[i], plain[i])) << i;
    const Mat3 wide = compliance_between(together[0], together[i]);
    const Mat3 narrow = compliance_between(together[0], together[i], PackedFactor::Kernel::plain);
    const Mat3 turned = compliance_between(together[i], together[0]).transpose();
    EXPECT_EQ(std::memcmp(wide.data(), narrow.data(), sizeof(Mat3)), 0) << i;
    EXPECT_EQ(std::memcmp(wide.data(), turned.data(), sizeof(Mat3)), 0) << i;
  }
}

TEST(PackedFactor, a_point_that_is_held_moves_by_nothing) {
  const auto description = jittered_body(6);
  const ContactBody body(description);
  const std::vector<Vec3> ends = {Vec3(20.0, 20.0, 0.0), Vec3(20.0, 20.0, 30.0)};
  const std::vector<PointInMesh> places = find_points(description->mesh, ends);
  const std::vector<PointResponse> responses = body.factor().respond(carried(body, places));
  EXPECT_TRUE(responses[0].path.empty());
  EXPECT_EQ(compliance_between(responses[0], responses[1]), Mat3::Zero());
  EXPECT_GT(compliance_between(responses[1], responses[1])(2, 2), 0.0);
}

}  // namespace
}  // namespace bodkin
