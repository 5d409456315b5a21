// Left needles and nodes held by a probe, with a needle inserted beside them: against a dense solution of the whole
// body with all of them at once.
#include "fem/solid/bound_points.h"

#include <cmath>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "tests/fem/lattice_body.h"
#include "tests/fem/solid/whole_body.h"
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "core/error.h"
#include "fem/embedded_needle.h"
#include "fem/solid/contact_body.h"
#include "fem/solid/line_points.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using checks::pressed_nodes;
using checks::small_block;
using checks::spread_of;
using checks::top;
using checks::WholeBody;
namespace {

// A needle's line beside a left needle, at least 0.7 mm away, and one farther away.
const Vec3 entry_of_line(17.0, 14.0, top);
const Vec3 along_line = Vec3(0.1, -0.05, -1.0).normalized();
const NeedlePath beside{Vec3(17.9, 13.4, top), Vec3(18.4, 14.1, 4.0)};
const NeedlePath aslant{Vec3(8.0, 20.0, top), Vec3(14.0, 17.0, 10.3)};

std::vector<ContactSite> sites_of_line() {
  std::vector<ContactSite> sites;
  for (int i = 0; i < 9; ++i)
    sites.push_back({entry_of_line + (0.4 + 2.1 * i) * along_line, 0.4 + 2.1 * i, tissue::soft, false, false});
  return sites;
}

struct Bound {
  std::vector<NeedlePath> left;
  bool probe = false;
};

const std::vector<Bound> all_bound = {
    {{beside}, false}, {{beside, aslant}, false}, {{}, true}, {{beside, aslant}, true}};

TEST(BoundPoints, needles_and_a_probe_are_coupled_as_in_a_dense_solution_of_the_whole_body) {
  const auto description = small_block();
  const ContactBody body(description);
  const std::vector<ContactSite> sites = sites_of_line();
  const CondensedBody alone = body.contact_points(sites, along_line, 1.0);
  const Eigen::MatrixXd loads = spread_of(alone.in_mesh, description->mesh.nodes.size());
  const Eigen::MatrixXd dense_alone = loads.transpose() * WholeBody(*description).solve(loads).moved;
  for (const Bound& one : all_bound) {
    WholeBody whole(*description);
    for (const NeedlePath& needle : one.left) whole.leave(needle.entry, needle.target);
    std::vector<std::uint32_t> held;
    if (one.probe) held = pressed_nodes(description->mesh);
    for (const std::uint32_t node : held) whole.hold(node);
    const BoundPoints bound = body.bind(one.left, held);
    const CondensedBody together = body.contact_points(sites, along_line, 1.0, 1, bound);
    ASSERT_EQ(together.compliance.rows(), alone.compliance.rows());
    EXPECT_EQ(together.compliance, together.compliance.transpose());

    const WholeBody::Solution dense = whole.solve(loads);
    const Eigen::MatrixXd expected = loads.transpose() * dense.moved;
    // The mesh's missing compliance at the needle's own points is the same with and without the others.
    const Eigen::MatrixXd found = together.compliance - alone.compliance + dense_alone;
    double change = 0.0;
    for (Eigen::Index i = 0; i < expected.rows(); ++i) {
      for (Eigen::Index j = 0; j < expected.cols(); ++j) {
        const double scale = std::sqrt(expected(i, i) * expected(j, j));
        ASSERT_NEAR(found(i, j), expected(i, j), 1e-9 * scale) << i << " " << j;
        if (i / 3 != j / 3) {
          ASSERT_NEAR(together.compliance(i, j), expected(i, j), 1e-9 * scale);
        }
        change = std::max(change, std::abs(expected(i, j) - dense_alone(i, j)) / scale);
      }
    }
    EXPECT_GT(change, 0.05) << "it is to be felt";
    // The energy of body, needles and missing compliance equals that of only the needle's forces.
    for (Eigen::Index j = 0; j < expected.cols(); ++j)
      EXPECT_NEAR(0.5 * found(j, j), dense.energy(j), 1e-9 * dense.energy(j));
  }
}

TEST(BoundPoints, forces_on_needles_that_were_left_are_those_of_the_dense_solution_and_in_balance) {
  const auto description = small_block();
  const ContactBody body(description);
  const std::vector<PointInMesh> places =
      find_points(description->mesh, std::vector<Vec3>{entry_of_line + 5.0 * along_line});
  const BoundPoints bound = body.bind(std::vector{beside, aslant}, {});
  const std::vector<PointResponse> point = body.factor().respond(std::vector{body.carried(places[0])});
  const Vec3 force(0.3, -0.2, 0.5);
  const Eigen::VectorXd found = bound.forces(bound.shares(point), force);
  WholeBody whole(*description);
  for (const NeedlePath& needle : {beside, aslant}) whole.leave(needle.entry, needle.target);
  const Eigen::MatrixXd load =
      spread_of({{places[0].nodes, places[0].weights}}, description->mesh.nodes.size()) * force;
  const Eigen::VectorXd expected = whole.solve(load).forces.col(0);
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_LT((found - expected).norm(), 1e-9 * expected.norm());
  Vec3 sum = Vec3::Zero(), torque = Vec3::Zero();
  const auto points_of_first = static_cast<Eigen::Index>(std::floor((beside.target - beside.entry).norm() + 0.5));
  for (Eigen::Index p = 0; p < points_of_first; ++p) {
    const Vec3 f = found.segment<3>(3 * p);
    sum += f;
    torque += ((static_cast<double>(p) + 0.5) * (beside.target - beside.entry).normalized()).cross(f);
  }
  EXPECT_LT(sum.norm(), 1e-10) << "nothing but the tissue holds it";
  EXPECT_LT(torque.norm(), 1e-9);
}

// The hand feels both in the tick: tissue beside a left needle, and under a probe, is laterally stiffer.
TEST(BoundPoints, a_needle_beside_another_one_feels_it_and_one_far_away_does_not) {
  const auto description = small_block();
  const ContactBody body(description);
  const auto pushed_aside = [&](const Vec3& entry, const BoundPoints& bound) {
    std::vector<ContactSite> sites;
    for (int i = 0; i < 9; ++i)
      sites.push_back({entry - (0.1 + 2.0 * i) * Vec3::UnitZ(), 0.1 + 2.0 * i, tissue::soft, false, false});
    const CondensedBody points = body.contact_points(sites, -Vec3::UnitZ(), 1.0, 1, bound);
    EmbeddedNeedle needle(points, default_contact_tissues(), {}, 1e-3);
    needle.begin(entry, -Vec3::UnitZ());
    for (double depth = -0.5; depth < 15.0; depth += 0.02)
      needle.step(needle_pose(entry - depth * Vec3::UnitZ(), -Vec3::UnitZ()));
    const Vec3 before = needle.step(needle_pose(entry - 15.0 * Vec3::UnitZ(), -Vec3::UnitZ())).on_hand.force;
    const Vec3 aside = entry + Vec3(0.3, 0.0, -15.0);
    return (needle.step(needle_pose(aside, -Vec3::UnitZ())).on_hand.force - before).norm();
  };
  const NeedlePath left{Vec3(14.0, 14.0, top), Vec3(14.0, 14.0, 6.0)};
  const BoundPoints bound = body.bind(std::vector{left}, {}), probe = body.bind({}, pressed_nodes(description->mesh));
  const Vec3 near(15.5, 14.0, top), far(30.0, 25.0, top);
  const double more_near = pushed_aside(near, bound) / pushed_aside(near, {}) - 1.0;
  const double more_far = pushed_aside(far, bound) / pushed_aside(far, {}) - 1.0;
  EXPECT_GT(more_near, 0.003) << "a left needle follows the tissue, but does not bend with it";
  EXPECT_LT(std::abs(more_far), 0.1 * more_near);
  const Vec3 at_probe(22.0, 10.0, top);
  EXPECT_GT(pushed_aside(at_probe, probe), 1.03 * pushed_aside(at_probe, {}));
}

TEST(BoundPoints, any_number_of_needles_close_together_leaves_the_compliance_positive) {
  const auto description = small_block();
  const ContactBody body(description);
  std::vector<NeedlePath> needles;
  for (int i = 0; i < 6; ++i) {
    const Vec3 apart(0.05 + 0.1 * i, 0.0, 0.0);
    needles.push_back({entry_of_line + apart, entry_of_line + 18.0 * along_line + apart});
  }
  const BoundPoints bound = body.bind(needles, pressed_nodes(description->mesh));
  const CondensedBody points = body.contact_points(sites_of_line(), along_line, 1.0, 1, bound);
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(points.compliance, Eigen::EigenvaluesOnly).eigenvalues();
  EXPECT_GT(values.minCoeff(), 0.0);
  // The same points one after another, and on three threads, have the same bits.
  std::size_t at = 0;
  LinePoints line(body, 1.0, bound);
  line.add(sites_of_line(), along_line);
  line.stream(0, [&](const ContactPoint& point) {
    for (std::size_t i = 0; i < point.between.size(); ++i) {
      const Mat3 block =
          points.compliance.block<3, 3>(static_cast<Eigen::Index>(3 * i), static_cast<Eigen::Index>(3 * at));
      EXPECT_EQ(std::memcmp(block.data(), point.between[i].data(), sizeof(Mat3)), 0);
    }
    ++at;
    return true;
  });
  EXPECT_EQ(at, points.nodes.size());
  EXPECT_EQ(body.contact_points(sites_of_line(), along_line, 1.0, 3, bound).compliance, points.compliance);
}

TEST(BoundPoints, what_cannot_be_bound_is_refused_in_a_sentence) {
  const auto description = small_block();
  const ContactBody body(description);
  EXPECT_THROW(body.bind(std::vector<NeedlePath>{{beside.entry, beside.entry}}, {}), InputError);
  EXPECT_TRUE(body.bind(std::vector<NeedlePath>{{Vec3(200.0, 0.0, 0.0), Vec3(210.0, 0.0, 0.0)}}, {}).empty())
      << "beside the mesh";
  EXPECT_THROW(body.bind(std::vector<NeedlePath>{{Vec3(NAN, 0.0, 0.0), Vec3::Zero()}}, {}), InputError);
  EXPECT_THROW(body.bind({}, std::vector<std::uint32_t>{70000}), InputError);
  EXPECT_THROW(body.bind({}, std::vector<std::uint32_t>{200, 200}), InputError);
  EXPECT_TRUE(body.bind({}, description->fixed).empty()) << "fixed anyway";
  EXPECT_TRUE(body.bind({}, {}).empty());
}

}  // namespace
}  // namespace bodkin
