#include "fem/moving/corotational_elements.h"

#include <algorithm>

#include "core/simd.h"
#include "fem/solid/element_stiffness.h"

namespace bodkin::fem {

namespace {

// Lanes whose rotation is too far from the previous one for Newton's method.
[[gnu::noinline]] void settle_rotations(const LaneMatrix& deformation, const LaneMask& settled,
                                        LaneQuaternion& rotation) noexcept {
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    if (settled[lane] != 0) continue;
    Mat3 f;
    for (int j = 0; j < 3; ++j) {
      const LaneVector& column = deformation.column[j];
      f.col(j) = Vec3(column.x[lane], column.y[lane], column.z[lane]);
    }
    const Eigen::Quaterniond q = nearest_rotation(f);
    rotation.w[lane] = q.w();
    rotation.x[lane] = q.x();
    rotation.y[lane] = q.y();
    rotation.z[lane] = q.z();
  }
}

// The places of four nodes.
BODKIN_LANES_INLINE void gather(const double* places, const std::array<std::uint32_t, lane_count>& nodes,
                                LaneVector& found) {
  const double *a = places + 4 * std::size_t{nodes[0]}, *b = places + 4 * std::size_t{nodes[1]},
               *c = places + 4 * std::size_t{nodes[2]}, *d = places + 4 * std::size_t{nodes[3]};
  found.x = Lanes{a[0], b[0], c[0], d[0]};
  found.y = Lanes{a[1], b[1], c[1], d[1]};
  found.z = Lanes{a[2], b[2], c[2], d[2]};
}

BODKIN_LANES_INLINE void larger(const Lanes& a, Lanes& b) {
  b = a > b ? a : b;
}
BODKIN_LANES_INLINE void magnitude(Lanes& a) {
  a = a < 0.0 ? -a : a;
}

// b of TurnedElement over 2 mu. The exact stiffness against turning has the principal values 2 mu + 2 (lambda tr(S -
// 1) - 2 mu) / (s_i + s_j), s_i + s_j the principal values of Y. None exceeds this, by Gershgorin's bound of the
// largest of them, unless lambda tr(S - 1) is above 2 mu: an element inflated by half or more.
BODKIN_LANES_INLINE void stiffening(const LaneMatrix& y, const Lanes& lambda, const Lanes& mu, const Lanes& stretch,
                                    Lanes& half) {
  Lanes xy = y.column[0].y, xz = y.column[0].z, yz = y.column[1].z;
  magnitude(xy);
  magnitude(xz);
  magnitude(yz);
  Lanes most = y.column[0].x + xy + xz;
  larger(y.column[1].y + xy + yz, most);
  larger(y.column[2].z + xz + yz, most);
  larger(Lanes{} + 1e-3, most);
  half = mu + (lambda * stretch - 2.0 * mu) / most;
  half = half > 0.0 ? half : Lanes{};
  half = half < 2.0 * mu ? half : 2.0 * mu;
}

}  // namespace

CorotationalElements::CorotationalElements(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials)
    : count_(mesh.elements.size()),
      batches_((count_ + lane_count - 1) / lane_count),
      turned_(batches_.size() * lane_count) {
  for (std::size_t i = 0; i < turned_.size(); ++i) {
    const std::size_t element = std::min(i, count_ - 1), lane = i % lane_count;
    Batch& batch = batches_[i / lane_count];
    std::array<Vec3, 4> corners;
    for (std::size_t a = 0; a < 4; ++a) {
      batch.nodes[a][lane] = mesh.elements[element][a];
      corners[a] = mesh.nodes[mesh.elements[element][a]];
    }
    const TetrahedronGradients shape = tetrahedron_gradients(corners);
    const ElasticMaterial& tissue = *materials.find(mesh.tissues[element]);
    const LameConstants material = lame_constants({.young = tissue.young, .poisson = tissue.poisson});
    for (std::size_t a = 0; a < 3; ++a) {
      batch.gradient[a].x[lane] = shape.gradient[a + 1].x();
      batch.gradient[a].y[lane] = shape.gradient[a + 1].y();
      batch.gradient[a].z[lane] = shape.gradient[a + 1].z();
    }
    const double volume = i < count_ ? shape.volume : 0.0;
    batch.lambda[lane] = volume * material.lambda;
    batch.mu[lane] = volume * material.mu;
  }
  reset();
}

void CorotationalElements::reset() noexcept {
  for (Batch& batch : batches_) batch.rotation = {Lanes{} + 1.0, Lanes{}, Lanes{}, Lanes{}};
}

BODKIN_LANES_INLINE double CorotationalElements::evaluate_batch(Batch& batch, const double* places, double* forces,
                                                                TurnedElement* turned) noexcept {
  LaneVector first{};
  gather(places, batch.nodes[0], first);
  LaneMatrix deformation{};  // F
  for (std::size_t a = 0; a < 3; ++a) {
    LaneVector edge{};
    gather(places, batch.nodes[a + 1], edge);
    edge.x -= first.x;
    edge.y -= first.y;
    edge.z -= first.z;
    add_lanes(edge, batch.gradient[a].x, deformation.column[0]);
    add_lanes(edge, batch.gradient[a].y, deformation.column[1]);
    add_lanes(edge, batch.gradient[a].z, deformation.column[2]);
  }
  LaneMatrix rotation;
  LaneMask settled;
  turn_to_nearest(deformation, batch.rotation, rotation, settled);
  if ((settled[0] & settled[1] & settled[2] & settled[3]) == 0) {
    settle_rotations(deformation, settled, batch.rotation);
    rotation_of(batch.rotation, rotation);
  }
  LaneMatrix strain;  // S, then S - 1, then the stress times V
  multiply_transposed_lanes(rotation, deformation, strain);
  const Lanes xx = strain.column[0].x - 1.0, yy = strain.column[1].y - 1.0, zz = strain.column[2].z - 1.0;
  const Lanes xy = 0.5 * (strain.column[0].y + strain.column[1].x),
              xz = 0.5 * (strain.column[0].z + strain.column[2].x),
              yz = 0.5 * (strain.column[1].z + strain.column[2].y);
  const Lanes stretch = xx + yy + zz;
  const Lanes energy = batch.mu * (xx * xx + yy * yy + zz * zz + 2.0 * (xy * xy + xz * xz + yz * yz)) +
                       0.5 * batch.lambda * (stretch * stretch);
  const Lanes twice_mu = 2.0 * batch.mu, pressure = batch.lambda * stretch;
  strain.column[0] = {twice_mu * xx + pressure, twice_mu * xy, twice_mu * xz};
  strain.column[1] = {twice_mu * xy, twice_mu * yy + pressure, twice_mu * yz};
  strain.column[2] = {twice_mu * xz, twice_mu * yz, twice_mu * zz + pressure};
  const LaneMatrix y{{{yy + zz + 2.0, -xy, -xz}, {-xy, xx + zz + 2.0, -yz}, {-xz, -yz, xx + yy + 2.0}}};
  Lanes half;
  stiffening(y, batch.lambda, batch.mu, stretch, half);
  const Lanes along = batch.mu - half, both = batch.mu + half;
  LaneVector gradient[4] = {}, force[4] = {};
  for (std::size_t a = 0; a < 3; ++a) {
    multiply_lanes(rotation, batch.gradient[a], gradient[a + 1]);
    LaneVector inside;
    multiply_lanes(strain, batch.gradient[a], inside);
    multiply_lanes(rotation, inside, force[a + 1]);
    add_lanes(gradient[a + 1], Lanes{} - 1.0, gradient[0]);
    add_lanes(force[a + 1], Lanes{} - 1.0, force[0]);
  }
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    TurnedElement& element = turned[lane];
    for (std::size_t a = 0; a < 4; ++a) {
      element.gradient[a] = {static_cast<float>(gradient[a].x[lane]), static_cast<float>(gradient[a].y[lane]),
                             static_cast<float>(gradient[a].z[lane])};
      double* on = forces + 4 * std::size_t{batch.nodes[a][lane]};
      on[0] -= force[a].x[lane];
      on[1] -= force[a].y[lane];
      on[2] -= force[a].z[lane];
    }
    element.across = static_cast<float>(batch.lambda[lane]);
    element.along = static_cast<float>(along[lane]);
    element.both = static_cast<float>(both[lane]);
  }
  return (energy[0] + energy[1]) + (energy[2] + energy[3]);
}

BODKIN_PROCESSOR_CLONES
double CorotationalElements::evaluate_all(std::vector<Batch>& batches, const double* places, double* forces,
                                          TurnedElement* turned) noexcept {
  double energy = 0.0;
  for (Batch& batch : batches) {
    energy += evaluate_batch(batch, places, forces, turned);
    turned += lane_count;
  }
  return energy;
}

double CorotationalElements::evaluate(const NodeVectors& places, NodeVectors& forces) noexcept {
  forces.setZero();
  return evaluate_all(batches_, places.data(), forces.data(), turned_.data());
}

}  // namespace bodkin::fem
