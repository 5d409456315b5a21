#include "fem/moving/rigid_needles.h"

#include "fem/solid/left_points.h"

namespace bodkin::fem {

RigidNeedles::RigidNeedles(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials,
                           std::span<const anatomy::NeedlePath> needles) {
  if (needles.empty()) return;
  const PointFinder finder(mesh);
  for (const anatomy::NeedlePath& path : needles) {
    Needle needle{points_.size(), points_.size(), 0.0};
    double moment = 0.0;
    for (const LeftPoint& found : left_points(mesh, finder, materials, path)) {
      // Without fibres the gain is isotropic.
      const double stiffness = 1.0 / found.gain(0, 0);
      points_.push_back({found.in_mesh.nodes, found.in_mesh.weights, found.depth, stiffness});
      needle.stiffness += stiffness;
      moment += stiffness * found.depth;
    }
    needle.last = points_.size();
    if (needle.last == needle.first) continue;
    for (std::size_t i = needle.first; i < needle.last; ++i) points_[i].along -= moment / needle.stiffness;
    needles_.push_back(needle);
  }
}

Vec3 RigidNeedles::place_of(const Point& point, const NodeVectors& places) noexcept {
  Vec3 place = Vec3::Zero();
  for (std::size_t corner = 0; corner < 4; ++corner)
    place += point.weights[corner] * places.col(point.nodes[corner]).head<3>();
  return place;
}

// With s_i minus its weighted mean, c is the weighted mean of the x_i, and a along the weighted sum of s_i x_i.
double RigidNeedles::add_forces(const NodeVectors& places, NodeVectors& forces) const noexcept {
  double energy = 0.0;
  for (const Needle& needle : needles_) {
    Vec3 middle = Vec3::Zero(), sum = Vec3::Zero();
    for (std::size_t i = needle.first; i < needle.last; ++i) {
      const Vec3 place = place_of(points_[i], places);
      middle += points_[i].stiffness / needle.stiffness * place;
      sum += points_[i].stiffness * points_[i].along * place;
    }
    const double length = sum.norm();
    const Vec3 axis = length > 0.0 ? Vec3(sum / length) : Vec3(Vec3::Zero());  // a single point has none
    for (std::size_t i = needle.first; i < needle.last; ++i) {
      const Point& point = points_[i];
      const Vec3 apart = place_of(point, places) - middle - point.along * axis;
      energy += 0.5 * point.stiffness * apart.squaredNorm();
      for (std::size_t corner = 0; corner < 4; ++corner)
        forces.col(point.nodes[corner]).head<3>() -= point.weights[corner] * point.stiffness * apart;
    }
  }
  return energy;
}

void RigidNeedles::add_stiffness(std::span<double> diagonal) const noexcept {
  for (const Point& point : points_)
    for (std::size_t corner = 0; corner < 4; ++corner)
      diagonal[point.nodes[corner]] += point.weights[corner] * point.stiffness;
}

}  // namespace bodkin::fem
