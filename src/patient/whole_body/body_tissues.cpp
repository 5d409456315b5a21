#include "patient/whole_body/body_tissues.h"

#include <array>
#include <cmath>

#include "patient/whole_body/body_landmarks.h"

namespace bodkin::patient {
namespace {

namespace tissue = anatomy::tissue;
using anatomy::TissueId;

constexpr double bone_shell = 2.0;       // mm of cortical bone
constexpr double conus_height = 1108.0;  // the cord ends at L1
constexpr double breastbone_top = 1396.0, breastbone_bottom = 1200.0;

double inside_ball(const Vec3& q, double x, double y, double z, double rx, double ry, double rz) {
  return shapes::ellipsoid(q - Vec3(x, y, z), Vec3(rx, ry, rz));
}

TissueId bone_at(double distance) {
  return distance > -bone_shell ? tissue::cortical_bone : tissue::cancellous_bone;
}

// From the skin of the chest to the ribs: muscles of the back, thin side, muscles of the breast.
double over_ribs(double position) {
  const double behind = 26.0, side = 13.0, front = 14.0;
  return position < 0.5 ? behind + 2.0 * position * (side - behind) : side + (2.0 * position - 1.0) * (front - side);
}
constexpr double rib_thickness = 8.0, rib_half_height = 6.5;

// Height of the diaphragm, a dome that reaches lower at its rim and behind.
double diaphragm(const Vec3& q) {
  const double x = q.x() / 130.0, y = (q.y() + 10.0) / 100.0;
  return 1238.0 - 75.0 * (x * x + y * y) - (q.y() > 0.0 ? 0.3 * q.y() : 0.0);
}

}  // namespace

void BodyTissues::add(std::vector<Rod>& rods, const Vec3& a, const Vec3& b, double ra, double rb, TissueId id) {
  rods.push_back(
      {{a, b, Vec3::Constant(ra), Vec3::Constant(rb)}, 0.5 * (a + b), 0.5 * (b - a).norm() + std::max(ra, rb), id});
}

BodyTissues::BodyTissues(const BodyShape& shape) : shape_(shape) {
  BodyLandmarks unused;
  const SkinFinder skin(shape, unused);
  for (double z = 860.0; z <= 1600.0; z += 20.0) back_.add(z, skin.back(0.0, z).y());

  const auto bone = [this](const Vec3& a, const Vec3& b, double ra, double rb) {
    add(body_rods_, a, b, ra, rb, tissue::cortical_bone);
  };
  const auto soft = [this](const Vec3& a, const Vec3& b, double r, TissueId id) { add(body_rods_, a, b, r, r, id); };
  const auto back_at = [this](double z) { return back_(z); };
  // Skull's face and jaw.
  bone({44.0, -4.0, 1546.0}, {16.0, -66.0, 1514.0}, 7.0, 8.0);
  bone({46.0, -2.0, 1546.0}, {50.0, -4.0, 1588.0}, 6.0, 6.0);
  bone({48.0, -56.0, 1590.0}, {61.0, -8.0, 1592.0}, 6.0, 4.0);
  bone({18.0, -58.0, 1572.0}, {18.0, -58.0, 1590.0}, 18.0, 18.0);
  // Shoulder girdle.
  const double joint = shape.from_arm(Vec3::Zero()).x();
  bone({14.0, -40.0, 1390.0}, {joint - 22.0, 8.0, 1392.0}, 7.0, 7.0);
  bone({76.0, back_at(1358.0) - 14.0, 1358.0}, {joint - 24.0, 62.0, 1382.0}, 6.0, 6.0);
  bone({joint - 24.0, 62.0, 1382.0}, {joint - 8.0, 22.0, 1396.0}, 7.0, 8.0);
  for (int i = 0; i <= 4; ++i) {  // the blade
    const double z = 1372.0 - 26.0 * i;
    bone({78.0 + 2.0 * i, back_at(z) - 20.0, z}, {136.0 - 11.0 * i, back_at(z) - 32.0, z}, 4.0, 4.0);
  }
  // Pelvis.
  bone({118.0, -66.0, 962.0}, {124.0, 10.0, 990.0}, 8.0, 9.0);
  bone({124.0, 10.0, 990.0}, {48.0, back_at(930.0) - 16.0, 932.0}, 9.0, 9.0);
  bone({112.0, -40.0, 955.0}, {96.0, 8.0, 890.0}, 9.0, 22.0);
  bone({100.0, 40.0, 960.0}, {96.0, 8.0, 890.0}, 9.0, 22.0);
  bone({60.0, 62.0, 935.0}, {96.0, 8.0, 890.0}, 10.0, 22.0);
  bone({90.0, -6.0, 884.0}, {6.0, -66.0, 888.0}, 12.0, 11.0);
  bone({90.0, 20.0, 880.0}, {58.0, 48.0, 826.0}, 14.0, 14.0);
  bone({0.0, back_at(950.0) - 40.0, 952.0}, {0.0, back_at(900.0) - 30.0, 888.0}, 30.0, 14.0);
  bone({0.0, back_at(880.0) - 26.0, 888.0}, {0.0, back_at(862.0) - 20.0, 858.0}, 7.0, 4.0);
  // Leg and foot.
  bone({98.0, 8.0, 888.0}, {148.0, 14.0, 880.0}, 22.0, 17.0);
  bone({144.0, 14.0, 872.0}, {92.0, 6.0, 500.0}, 16.0, 15.0);
  bone({88.0, 8.0, 492.0}, {88.0, 8.0, 468.0}, 30.0, 33.0);
  bone({87.0, -42.0, 478.0}, {87.0, -42.0, 468.0}, 13.0, 12.0);
  bone({84.0, 8.0, 440.0}, {78.0, 0.0, 400.0}, 32.0, 17.0);
  bone({78.0, 0.0, 400.0}, {68.0, 18.0, 84.0}, 16.0, 14.0);
  bone({118.0, 22.0, 424.0}, {106.0, 34.0, 62.0}, 8.0, 7.0);
  bone({78.0, 24.0, 66.0}, {78.0, 8.0, 52.0}, 18.0, 18.0);
  bone({78.0, 66.0, 34.0}, {80.0, 6.0, 36.0}, 20.0, 16.0);
  static constexpr std::array<std::array<double, 3>, 5> rays = {{{62.0, -106.0, -150.0},
                                                                 {83.0, -110.0, -154.0},
                                                                 {101.0, -106.0, -146.0},
                                                                 {117.0, -96.0, -134.0},
                                                                 {130.0, -84.0, -118.0}}};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double x = rays[i][0], base = 66.0 + 10.0 * static_cast<double>(i);
    bone({base, -38.0, 38.0}, {x, rays[i][1], 16.0}, 7.0, 6.0);
    bone({x, rays[i][1], 13.0}, {x + 1.0, rays[i][2], 8.0}, 5.0, 4.0);
  }
  // Great vessels and nerves (right and left alike).
  soft({22.0, 4.0, 1396.0}, {28.0, 2.0, 1545.0}, 3.5, tissue::vessel);
  soft({30.0, 6.0, 1396.0}, {35.0, 8.0, 1545.0}, 4.5, tissue::vessel);
  soft({20.0, 0.0, 1380.0}, {joint - 40.0, 4.0, 1352.0}, 4.0, tissue::vessel);
  soft({44.0, -30.0, 940.0}, {66.0, -62.0, 905.0}, 4.5, tissue::vessel);
  soft({66.0, -62.0, 905.0}, {70.0, -20.0, 640.0}, 4.0, tissue::vessel);
  soft({70.0, -20.0, 640.0}, {86.0, 36.0, 480.0}, 4.0, tissue::vessel);
  soft({86.0, 36.0, 480.0}, {86.0, 40.0, 410.0}, 3.5, tissue::vessel);
  soft({86.0, 40.0, 410.0}, {56.0, 44.0, 75.0}, 2.0, tissue::vessel);
  soft({90.0, 8.0, 400.0}, {80.0, -2.0, 85.0}, 1.8, tissue::vessel);
  soft({80.0, -2.0, 85.0}, {75.0, -50.0, 56.0}, 1.5, tissue::vessel);
  soft({54.0, 44.0, 880.0}, {86.0, 36.0, 600.0}, 5.0, tissue::nerve);
  soft({86.0, 36.0, 600.0}, {90.0, 48.0, 410.0}, 4.0, tissue::nerve);
  soft({112.0, 44.0, 470.0}, {124.0, 16.0, 408.0}, 2.0, tissue::nerve);

  // The arm, in its frame.
  const auto arm_bone = [this](const Vec3& a, const Vec3& b, double ra, double rb) {
    add(arm_rods_, a, b, ra, rb, tissue::cortical_bone);
  };
  const auto arm_soft = [this](const Vec3& a, const Vec3& b, double r, TissueId id) {
    add(arm_rods_, a, b, r, r, id);
  };
  arm_bone({0.0, 0.0, 2.0}, {4.0, 0.0, 40.0}, 22.0, 12.0);
  arm_bone({4.0, 0.0, 40.0}, {0.0, -4.0, 260.0}, 11.0, 11.0);
  arm_bone({-28.0, -4.0, 282.0}, {28.0, -4.0, 282.0}, 11.0, 10.0);
  arm_bone({-8.0, -22.0, 288.0}, {-14.0, -8.0, 340.0}, 11.0, 8.0);
  arm_bone({-14.0, -8.0, 340.0}, {-17.0, -7.0, 546.0}, 8.0, 6.0);
  arm_bone({14.0, 0.0, 306.0}, {15.0, -2.0, 549.0}, 8.0, 10.0);
  arm_bone({12.0, 0.0, 566.0}, {-12.0, 0.0, 566.0}, 9.0, 8.0);
  static constexpr std::array<double, 4> knuckle = {30.0, 10.0, -10.5, -29.0}, end = {35.0, 11.0, -13.0, -36.0},
                                         reach = {70.0, 79.0, 72.0, 56.0};
  for (std::size_t i = 0; i < knuckle.size(); ++i) {
    arm_bone({0.55 * knuckle[i], -1.0, 582.0}, {knuckle[i], -1.0, 644.0}, 5.0, 5.0);
    arm_bone({knuckle[i], -1.0, 652.0}, {end[i], -0.5, 648.0 + reach[i]}, 4.8, 3.6);
  }
  arm_bone({24.0, 6.0, 572.0}, {56.0, 13.0, 618.0}, 5.5, 5.5);
  arm_bone({58.0, 14.0, 626.0}, {75.0, 16.0, 668.0}, 5.0, 3.8);
  arm_soft({-30.0, 8.0, 60.0}, {-4.0, 16.0, 300.0}, 2.6, tissue::vessel);
  arm_soft({-4.0, 16.0, 300.0}, {17.0, 13.0, 550.0}, 1.6, tissue::vessel);
  arm_soft({-8.0, 15.0, 310.0}, {-18.0, 9.0, 555.0}, 1.6, tissue::vessel);
  arm_soft({-28.0, 4.0, 80.0}, {-2.0, 7.0, 320.0}, 2.2, tissue::nerve);
  arm_soft({-2.0, 7.0, 320.0}, {-1.0, 9.0, 580.0}, 2.0, tissue::nerve);
  arm_soft({-30.0, 2.0, 80.0}, {-27.0, -20.0, 286.0}, 2.0, tissue::nerve);
}

TissueId BodyTissues::in_rods(const std::vector<Rod>& rods, const Vec3& q) const {
  TissueId found = tissue::air;
  for (const Rod& rod : rods) {
    if ((q - rod.centre).squaredNorm() > rod.reach * rod.reach) continue;
    const double d = shapes::distance(rod.rod, q);
    if (d >= 0.0) continue;
    if (rod.tissue != tissue::cortical_bone) {
      if (found == tissue::air) found = rod.tissue;
    } else if (found != tissue::cancellous_bone) {
      found = bone_at(d);
    }
  }
  return found;
}

TissueId BodyTissues::head(const Vec3& q) const {
  if (q.z() < 1570.0) return tissue::air;
  const double d = inside_ball(q, 0.0, 8.0, 1628.0, 75.0, 97.0, 92.0);
  if (inside_ball(q, 31.0, -70.0, 1608.0, 13.0, 13.0, 13.0) < 0.0) return tissue::organ;  // eye
  if (d > -5.0) return tissue::air;
  if (d > -12.0) return d > -7.0 || d < -10.0 ? tissue::cortical_bone : tissue::cancellous_bone;
  return d > -14.0 ? tissue::dura : tissue::organ;
}

TissueId BodyTissues::spine(const Vec3& q) const {
  const double x = q.x(), z = q.z();
  if (x > 46.0 || z < 948.0 || z > 1575.0) return tissue::air;
  const bool neck = z > 1428.0;
  const double behind = back_(z), canal = behind - (neck ? 46.0 : 44.0);
  const double y = q.y() - canal;
  const double r = std::sqrt(x * x + y * y);
  if (r < 9.5) {
    if (r < 5.0)
      return z > conus_height ? tissue::spinal_cord : (r < 3.5 ? tissue::nerve : tissue::cerebrospinal_fluid);
    if (r < 7.4) return tissue::cerebrospinal_fluid;
    return r < 8.4 ? tissue::dura : tissue::epidural_fat;
  }
  // The two enclosing spinous processes, and the distance down from the upper one.
  double top = 0.0, pitch = 22.0;
  if (neck) {
    top = 1428.0 + 18.0 * std::ceil((z - 1428.0) / 18.0);
    pitch = 18.0;
  } else {
    int vertebra = 1;
    while (vertebra < 17 && spinous_height(vertebra) > z) ++vertebra;
    top = spinous_height(vertebra - 1);
    pitch = top - spinous_height(vertebra);
  }
  const double down = (top - z) / pitch;     // 0: lower border of the process above, 1: of the next
  const double process = neck ? 0.5 : 0.45;  // share of the interval that the next process fills
  const double body_x = neck ? 11.0 : 15.0 + 7.0 * std::clamp((1290.0 - z) / 250.0, 0.0, 1.0);
  const double body_y = neck ? 9.0 : 13.0 + 4.0 * std::clamp((1290.0 - z) / 250.0, 0.0, 1.0);
  const double body = shapes::ellipse(x, y + 9.5 + body_y, body_x, body_y);
  if (body < 0.0) return down > 0.25 && down < 0.45 ? tissue::disc : bone_at(body);
  if (r < 13.5) return down > process ? tissue::cortical_bone : tissue::ligamentum_flavum;
  const double tip = behind - 9.0 - canal;
  if (y > 0.0 && x < 4.0 && y < tip)
    return down > 1.0 - process ? tissue::cortical_bone : tissue::interspinous_ligament;
  if (y > 0.0 && x < 4.0 && y < tip + 3.0) return tissue::supraspinous_ligament;
  // Transverse processes and joints.
  if (x < 32.0 && std::abs(y - 2.0) < 5.0 && down > 0.62 && down < 0.92) return tissue::cortical_bone;
  if (x > 9.0 && x < 19.0 && y > -2.0 && y < 12.0) return tissue::cortical_bone;
  return tissue::air;
}

TissueId BodyTissues::chest_and_belly(const Vec3& q, double depth) const {
  const Vec3 p(std::abs(q.x()), q.y(), q.z());
  const double along_rib = position_along_ribs(p), wall = over_ribs(along_rib) + fat(p);
  const bool breastbone = p.x() < 17.0 && p.y() < 0.0 && p.z() > breastbone_bottom && p.z() < breastbone_top;
  if (breastbone && depth > 7.0 && depth < 19.0)
    return depth < 9.0 || depth > 17.0 ? tissue::cortical_bone : tissue::cancellous_bone;
  const bool caged = p.z() < 1402.0 && p.z() > 1084.0 && p.x() < 150.0;
  if (caged && depth > wall && depth < wall + rib_thickness) {
    for (int rib = 1; rib <= 12; ++rib) {
      const double end = rib == 11 ? 0.5 : rib == 12 ? 0.38 : 1.0;
      if (along_rib > end || std::abs(p.z() - rib_height(rib, along_rib)) > rib_half_height) continue;
      return depth < wall + 1.6 || depth > wall + rib_thickness - 1.6 ? tissue::cortical_bone
                                                                      : tissue::cancellous_bone;
    }
  }
  const double front_of_spine = back_(std::clamp(p.z(), 870.0, 1420.0)) - 44.0 - 34.0;
  if (inside_ball(q, 8.0, front_of_spine - 6.0, 1180.0, 10.0, 10.0, 250.0) < 0.0 && p.z() > 960.0)
    return tissue::vessel;
  if (inside_ball(q, -16.0, front_of_spine - 8.0, 1080.0, 10.0, 9.0, 160.0) < 0.0 && p.z() > 960.0)
    return tissue::vessel;
  if (depth < wall + rib_thickness + 1.0) return tissue::air;
  if (caged && p.z() > diaphragm(p) && p.z() < 1400.0 && p.x() < 142.0 && (p.x() < 70.0 || p.z() < 1370.0)) {
    if (inside_ball(q, 18.0, -42.0, 1272.0, 50.0, 42.0, 54.0) < 0.0) return tissue::organ;  // heart
    if (p.x() < 24.0) {
      return inside_ball(q, 0.0, -30.0, 1340.0, 16.0, 18.0, 40.0) < 0.0 ? tissue::vessel : tissue::soft;
    }
    return tissue::lung;
  }
  if (p.z() > 1250.0 || p.z() < 880.0 || p.x() > 140.0) return tissue::air;
  if (inside_ball(q, -64.0, -10.0, 1180.0, 88.0, 84.0, 66.0) < 0.0) return tissue::organ;  // liver
  if (inside_ball(q, 96.0, 28.0, 1176.0, 26.0, 34.0, 44.0) < 0.0) return tissue::organ;    // spleen
  if (inside_ball(p, 62.0, 38.0, 1092.0, 27.0, 21.0, 54.0) < 0.0) return tissue::organ;    // kidneys
  if (inside_ball(p, 0.0, -42.0, 905.0, 36.0, 28.0, 28.0) < 0.0) return tissue::organ;     // bladder
  // Behind, the psoas; below, the pelvic floor and its muscles; else stomach and bowel.
  if (p.y() > front_of_spine + 12.0 || p.z() < 900.0) return tissue::air;
  if (shapes::ellipse(p.x() - 42.0, p.y() - front_of_spine - 8.0, 22.0, 20.0) < 0.0 && p.z() < 1110.0)
    return tissue::muscle;
  return p.x() < 118.0 && p.y() > -110.0 ? tissue::organ : tissue::air;
}

// Under the skin: thin on head, hands and feet, thick on belly and buttocks; with the square of the girth.
double BodyTissues::fat(const Vec3& q) const {
  const double g = shape_.girth() * shape_.girth() * (shape_.parameters().sex == Sex::female ? 1.25 : 1.0);
  if (q.z() > 1440.0) return 2.0 + g;
  if (q.z() < 110.0) return 1.5;
  const double z = q.z();
  double thickness = z < 520.0 ? 4.0 : z < 850.0 ? 4.0 + 3.0 * (z - 520.0) / 330.0 : 7.0;
  if (z > 850.0 && z < 1160.0 && std::abs(q.x()) < 190.0) thickness = q.y() < 0.0 ? 14.0 : z < 960.0 ? 18.0 : 9.0;
  if (z >= 1160.0 && z < 1440.0) thickness = 5.0;
  return std::max(1.5, thickness * g);
}

TissueId BodyTissues::at(const Vec3& p, double distance, double spacing) const {
  if (distance >= 0.0) return tissue::air;
  if (distance > -std::max(1.8, spacing)) return tissue::skin;
  const Vec3 q = p / shape_.scale();
  const Vec3 half(std::abs(q.x()), q.y(), q.z());
  const double depth = -distance / shape_.scale();
  if (q.z() > 1480.0) {
    if (const TissueId found = head(half); found != tissue::air) return found;
  }
  if (const TissueId found = spine(half); found != tissue::air) return found;
  const Vec3 arm = shape_.in_arm(half);
  const bool is_arm = arm.z() > -20.0 && arm.head<2>().norm() < 62.0 && half.x() > 120.0;
  if (is_arm || arm.z() > 500.0) {
    if (const TissueId found = in_rods(arm_rods_, arm); found != tissue::air) return found;
  }
  if (const TissueId found = in_rods(body_rods_, half); found != tissue::air) return found;
  if (q.z() > 870.0 && q.z() < 1410.0 && half.x() < 175.0) {
    const double trunk = -shape_.trunk_distance(half);
    if (trunk > 5.0) {
      if (const TissueId found = chest_and_belly(q, trunk); found != tissue::air) return found;
    }
  }
  const double layer = arm.z() > 540.0 && is_arm ? 1.5 : fat(q);
  return depth < 2.0 + layer ? tissue::fat : tissue::muscle;
}

}  // namespace bodkin::patient
