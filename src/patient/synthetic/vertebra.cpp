#include "patient/synthetic/vertebra.h"

namespace bodkin::patient {

using shapes::blend;

Vertebra::Vertebra(const VertebraSize& size, const InterspaceSize& below, double lower_facet_half_distance,
                   double lower_facet_angle, double facet_scale, double osteophyte)
    : size_(size), osteophyte_(osteophyte) {
  const double height = size.height();
  const double half = 0.5 * height;
  const double front = canal_front(), centre = canal_centre(), back = canal_back();
  const double pedicle_x = 0.5 * (size.canal_width + size.pedicle_width);
  const double pedicle_z = 0.22 * height;  // pedicles spring from the upper half of the body
  lamina_z_ = -0.28 * height;
  base_y_ = back + 2.5;
  tip_back_ = back + size.process_reach;
  tip_z_ = lamina_z_ - 1.0 - size.process_drop;

  const double joint = 5.4 * facet_scale;  // half thickness of an articular process
  const auto rod = [&](const Vec3& a, const Vec3& b, const Vec3& radii_a, const Vec3& radii_b) {
    const double thickest = std::max(radii_a.maxCoeff(), radii_b.maxCoeff());
    arch_rods_.push_back({{a, b, radii_a, radii_b}, 0.5 * (a + b), 0.5 * (b - a).norm() + thickest + kFar});
  };
  const Vec3 pedicle_radii(0.5 * size.pedicle_width, 4.0, 0.5 * size.pedicle_height);
  const Vec3 pillar(pedicle_x - 0.5, centre + 0.15 * size.canal_depth, pedicle_z - 1.5);
  rod({pedicle_x, front - 6.0, pedicle_z}, pillar, pedicle_radii, pedicle_radii);
  // Transverse process: flat from front to back, pointing a little backwards.
  rod({pedicle_x + 1.0, front + 4.0, pedicle_z - 1.0},
      {0.5 * size.transverse_span - 3.0, front + 10.0, pedicle_z + 1.0}, {4.5, 4.0, 6.0}, {3.0, 2.4, 4.6});

  // The facing surfaces of a facet joint are where upper and lower process meet (spine.cpp keeps a gap), so each
  // process is set off from the joint's centre along the joint's normal, which points forwards and outwards.
  const double offset = 0.8 * joint;
  const Vec3 upper_normal(shapes::cosine(size.facet_angle), -shapes::sine(size.facet_angle), 0.0);
  const Vec3 upper_joint(size.facet_half_distance, centre + 4.0, half + 1.5);
  rod(pillar, upper_joint + offset * upper_normal + Vec3(0.0, 0.0, 5.0), {joint, joint, joint},
      {joint, joint, 1.1 * joint});
  const Vec3 lower_normal(shapes::cosine(lower_facet_angle), -shapes::sine(lower_facet_angle), 0.0);
  const Vec3 lower_joint(lower_facet_half_distance, centre + 4.5, -half - below.disc_height);
  const Vec3 lower_end = lower_joint - offset * lower_normal + Vec3(0.0, 0.0, -4.0);
  const Vec3 isthmus(0.5 * (pillar.x() + lower_end.x()) + 1.0, back + 0.5, lamina_z_ + 1.0);
  rod(pillar, isthmus, {joint, joint, joint}, {4.4, 4.0, 5.5});
  rod(isthmus, lower_end, {4.4, 4.0, 5.5}, {0.95 * joint, 0.95 * joint, 1.1 * joint});

  // Lamina: a plate whose upper edge leans forwards.
  const double lamina_half = 0.5 * size.lamina_height;
  rod(isthmus + Vec3(-0.5, 0.0, -1.0), {0.0, back + 2.8, lamina_z_}, {3.4, 3.4, lamina_half},
      {3.2, 3.2, lamina_half});
}

std::pair<double, double> Vertebra::extent(const Pose& pose) const {
  const double half = 0.5 * size_.height() + 3.0, front = -0.5 * size_.endplate_depth;
  const double tip_half = 0.5 * size_.process_tip_height + 2.0;
  std::vector<Vec3> points = {{0.0, front, half},
                              {0.0, front, -half},
                              {0.0, tip_back_, tip_z_ + tip_half},
                              {0.0, tip_back_, tip_z_ - tip_half}};
  for (const BoundedRod& bounded : arch_rods_) {
    const Vec3 up(0.0, 0.0, std::max(bounded.rod.radii_a.z(), bounded.rod.radii_b.z()) + 2.0);
    for (const Vec3& end : {bounded.rod.a, bounded.rod.b})
      for (const double side : {-1.0, 1.0})
        for (const double sign : {-1.0, 1.0}) points.push_back(Vec3(side * end.x(), end.y(), end.z()) + sign * up);
  }
  double low = 1e6, high = -1e6;
  for (const Vec3& point : points) {
    const double z = (pose * point).z();
    low = std::min(low, z);
    high = std::max(high, z);
  }
  return {low - 3.0, high + 3.0};
}

double Vertebra::half_height(const Vec3& p) const {
  const double u = 2.0 * p.x() / size_.endplate_width, v = 2.0 * p.y() / size_.endplate_depth;
  const double hollow = 1.3 * std::max(0.0, 1.0 - u * u - v * v);
  return 0.5 * size_.height() - 0.5 * size_.wedge * p.y() - hollow;
}

double Vertebra::body_section(const Vec3& p) const {
  const double t = std::min(std::abs(2.0 * p.z() / size_.height()), 1.0);
  const double t2 = t * t, t8 = t2 * t2 * t2 * t2;
  const double waist = 1.0 - 0.11 * (1.0 - t2) + osteophyte_ * t8;
  const double half_width = 0.5 * size_.endplate_width, half_depth = 0.5 * size_.endplate_depth;
  // Only sides and front are concave: the back wall follows the canal.
  const double depth = p.y() > 0.0 ? half_depth : half_depth * waist;
  return shapes::superellipse(p.x(), p.y(), half_width * waist, depth);
}

double Vertebra::process_outline(const Vec3& p) const {
  const double length = tip_back_ - base_y_;
  const double u = std::clamp((p.y() - base_y_) / length, 0.0, 1.0);
  const double axis_z = lamina_z_ + u * (tip_z_ - lamina_z_);
  // Half height: the lamina's at the base, narrower behind it, swelling into the drop-shaped tip.
  const double base = 0.42 * size_.lamina_height, middle = 0.5 * size_.process_height,
               tip = 0.5 * size_.process_tip_height;
  const double half_height =
      base * (1.0 - u) * (1.0 - 2.0 * u) + 4.0 * middle * u * (1.0 - u) + tip * u * (2.0 * u - 1.0);
  const double vertical = std::abs(p.z() - axis_z) - half_height;
  const double along = std::max(p.y() - tip_back_, base_y_ - 3.0 - p.y());
  return shapes::rounded_intersection(vertical, along, 5.5);
}

double Vertebra::arch(const Vec3& p) const {
  const double u = std::clamp((p.y() - base_y_) / (tip_back_ - base_y_), 0.0, 1.0);
  const double half_thickness = 3.4 - 5.6 * u * (1.0 - u) + 0.6 * u;  // 3.4 at the base, 2.3 midway, 4.0 at the tip
  double result = shapes::rounded_intersection(process_outline(p), std::abs(p.x()) - half_thickness, 1.6);
  const Vec3 mirrored(std::abs(p.x()), p.y(), p.z());
  for (const BoundedRod& bounded : arch_rods_) {
    if ((mirrored - bounded.centre).squaredNorm() > bounded.reach * bounded.reach) continue;
    result = blend(result, shapes::distance(bounded.rod, mirrored), 2.5);
  }
  return result;
}

double Vertebra::distance(const Vec3& p) const {
  double body = kFar + 1.0;
  if (p.y() < canal_front() + kFar) {
    const double height = half_height(p);
    const double vertical = std::abs(p.z()) - height;
    if (vertical < kFar) body = shapes::rounded_intersection(body_section(p), vertical, 1.5);
  }
  if (p.y() < canal_front() - 8.0 - kFar) return body;
  return blend(body, arch(p), 3.0);
}

}  // namespace bodkin::patient
