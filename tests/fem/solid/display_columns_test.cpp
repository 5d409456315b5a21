#include "fem/solid/display_columns.h"

#include <numeric>

#include "tests/fem/lattice_body.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::fem;
namespace {

using ::testing::HasSubstr;

struct SeenBody {
  BodyDescription description = lattice_body(7, 60.0, 0.1, 40);
  ElasticBody body{description, plan_body(description)};
  std::vector<Vec3> points;
  std::vector<PointInMesh> places;

  SeenBody() {
    Random random(3);
    for (int i = 0; i < 200; ++i)
      points.emplace_back(random.uniform(0.0, 60.0), random.uniform(0.0, 60.0), random.uniform(0.0, 60.0));
    points.emplace_back(200.0, 0.0, 0.0);  // does not move
    places = find_points(description.mesh, points);
  }
};

std::string refusal_of(const std::function<void()>& what) {
  try {
    what();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(DisplayColumns, are_the_displacement_of_the_whole_body_at_the_points) {
  const SeenBody seen;
  std::vector<std::uint32_t> nodes, places;
  for (std::uint32_t place = 0; place < seen.body.corridor().size(); place += 2) {  // more than a batch
    nodes.push_back(seen.body.corridor()[place]);
    places.push_back(place);
  }
  const DisplayField field = display_columns(seen.body, seen.places, nodes);
  ASSERT_EQ(field.points(), 201U);
  ASSERT_EQ(field.nodes(), nodes.size());
  Random random(4);
  NodeForces forces;
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(seen.body.corridor().size()), 1);
  for (const std::uint32_t place : places) {
    NodeForce& here = forces.nodes[forces.count++];
    here.node = seen.body.corridor()[place];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      here.force[axis] = static_cast<float>(0.01 * random.normal());
      loads(3 * Eigen::Index{place} + static_cast<Eigen::Index>(axis)) = static_cast<double>(here.force[axis]);
    }
  }
  const Eigen::MatrixXd all = seen.body.displacement_by_corridor(loads);
  std::vector<float> moved(3 * seen.points.size());
  field.evaluate(forces, moved);
  const double largest = all.cwiseAbs().maxCoeff();
  for (std::size_t p = 0; p < seen.points.size(); ++p) {
    Vec3 expected = Vec3::Zero();
    for (std::size_t corner = 0; corner < 4; ++corner)
      expected +=
          seen.places[p].weights[corner] * all.col(0).segment<3>(3 * Eigen::Index{seen.places[p].nodes[corner]});
    const Vec3 found = Eigen::Map<const Eigen::Vector3f>(moved.data() + 3 * p).cast<double>();
    EXPECT_LT((found - expected).norm(), 2e-6 * largest) << p;
  }
  EXPECT_EQ(moved[600], 0.0F);
  EXPECT_EQ(field.left_out(forces), 0.0);
}

TEST(DisplayColumns, tell_how_much_force_the_picture_leaves_out) {
  const SeenBody seen;
  const DisplayField field =
      display_columns(seen.body, seen.places, {seen.body.corridor()[5], seen.body.corridor()[3]});
  NodeForces forces;
  forces.count = 2;
  forces.nodes[0] = {seen.body.corridor()[3], {0.0F, 0.3F, 0.0F}};
  forces.nodes[1] = {seen.body.corridor()[4], {0.0F, 0.3F, 0.4F}};
  EXPECT_NEAR(field.left_out(forces), 0.5, 1e-6);
  std::vector<float> both(3 * seen.points.size()), one = both;
  field.evaluate(forces, both);
  forces.count = 1;
  field.evaluate(forces, one);
  EXPECT_EQ(both, one);
}

TEST(DisplayColumns, refuse_what_they_cannot_show) {
  const SeenBody seen;
  EXPECT_THAT(refusal_of([&] { display_columns(seen.body, {}, {0}); }), HasSubstr("0 points"));
  EXPECT_THAT(refusal_of([&] { display_columns(seen.body, seen.places, {}); }), HasSubstr("0 nodes"));
  EXPECT_THAT(refusal_of([&] { display_columns(seen.body, seen.places, {400000}); }), HasSubstr("node 400000"));
  EXPECT_THAT(refusal_of([&] {
                display_columns(seen.body, seen.places, {seen.body.corridor()[1], seen.body.corridor()[1]});
              }),
              HasSubstr("named twice"));
}

}  // namespace
}  // namespace bodkin
