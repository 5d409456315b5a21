#include "patient/shoulder/shoulder_model.h"

#include <algorithm>
#include <cmath>

namespace bodkin::patient {
namespace {

namespace tissue = anatomy::tissue;
using shapes::degrees;

// Direction of the glenoid, forwards of straight to the side: the scapula lies 30 degrees in front of the coronal
// plane, the glenoid is turned back by 3 (means near 0 to 2, -10 to 10 seen: Friedman et al. 1992; Churchill et al.
// 2001).
constexpr double blade_angle = 30.0 * degrees, glenoid_angle = 27.0 * degrees;
// Half the glenoid's height and width: 39 and 29 mm, the upper half 23 mm (Iannotti et al. 1992).
constexpr double glenoid_half_height = 19.5, glenoid_half_width = 14.5, glenoid_upper_half_width = 11.5;
constexpr double glenoid_cartilage = 2.2, head_cartilage = 1.5;  // mm: 2.16 and 1.44 (Soslowsky et al. 1992)
constexpr double capsule_thickness = 2.0;                        // mm: our choice
constexpr double bone_shell = 1.6, shaft_shell = 3.5;            // mm: our choice
// Entry of the joint: 38 degrees around the head from the middle of the glenoid backwards, 7 mm above it.
constexpr double recess_angle = 38.0 * degrees, recess_height = 7.0;
constexpr double beside_nerve = 5.0;  // mm, of a block from the axis of the nerve: our choice
constexpr double below_corner = 20.0, medial_of_corner = 10.0;  // mm, of the entry

double square(double x) {
  return x * x;
}

shapes::Rod round_rod(const Vec3& a, const Vec3& b, double radius) {
  return {a, b, Vec3::Constant(radius), Vec3::Constant(radius)};
}

}  // namespace

ShoulderModel::ShoulderModel(const ShoulderSizes& sizes, double spacing) : sizes_(sizes), spacing_(spacing) {
  const double s = sizes.scale;
  const double c = shapes::cosine(glenoid_angle), n = shapes::sine(glenoid_angle);
  outwards_ = Vec3(c, -n, 0.0);
  backwards_ = Vec3(n, c, 0.0);
  blade_medial_ = Vec3(-shapes::cosine(blade_angle), shapes::sine(blade_angle), 0.0);
  blade_backwards_ = Vec3(shapes::sine(blade_angle), shapes::cosine(blade_angle), 0.0);
  articular_ = Vec3(-0.64, 0.30, 0.71).normalized();  // 45 degrees up, 25 backwards
  glenoid_ = -(sizes.head + sizes.glenoid_gap) * outwards_;
  coracoid_tip_ = s * Vec3(-36.0, -32.0, 11.0);

  // The line from the tip of the coracoid through the recess behind the head, to the skin.
  const double radius = sizes.head + 0.5 * sizes.fluid, height = recess_height * s;
  const double level = std::sqrt(square(radius) - square(height));
  const Vec3 recess = level * (shapes::sine(recess_angle) * backwards_ - shapes::cosine(recess_angle) * outwards_) +
                      Vec3(0.0, 0.0, height);
  const Vec3 out = (recess - coracoid_tip_).normalized();
  entry_ = skin_from(recess, out);
  direction_ = -out;
  acromion_corner_ = Vec3(entry_.x() + medial_of_corner, 30.0 * s, entry_.z() + below_corner);

  // 22 mm wide, 8 mm thick and about 50 mm long, 9 mm above the head (acromion: Nicholson et al. 1996; the space
  // under it 9 to 10 mm: Petersson and Redlund-Johnell 1984).
  const Vec3 flat = s * Vec3(11.0, 11.0, 4.2);
  const Vec3 behind = acromion_corner_ + s * Vec3(-9.0, -7.0, 2.0);
  const Vec3 before(behind.x() - 4.0 * s, -16.0 * s, sizes.head + 9.5 * s + 4.2 * s);
  acromion_ = {{{behind, Vec3(behind.x() - s, 4.0 * s, before.z()), flat, flat},
                {Vec3(behind.x() - s, 4.0 * s, before.z()), before, flat, flat}}};
  const Vec3 neck = glenoid_ + s * Vec3(-10.0, -2.0, 20.0);
  const Vec3 knee = s * Vec3(-41.0, -15.0, 27.0), reach = coracoid_tip_ + s * Vec3(-1.5, 4.5, 3.5);
  coracoid_ = {round_rod(neck, knee, 7.0 * s), round_rod(knee, reach, 6.0 * s)};
  const auto on_blade = [&](double medial, double back, double up) {
    return Vec3(glenoid_ + s * (medial * blade_medial_ + back * blade_backwards_ + Vec3(0.0, 0.0, up)));
  };
  const Vec3 root = on_blade(34.0, 25.0, 17.0);
  spine_ = {round_rod(on_blade(95.0, 3.0, 6.0), root, 4.5 * s),
            shapes::Rod{root, behind, Vec3::Constant(5.0 * s), s * Vec3(7.0, 7.0, 4.5)}};
  const Vec3 joint_end = s * Vec3(-17.0, -18.0, 0.0) + Vec3(0.0, 0.0, before.z());
  const Vec3 flat_bone = s * Vec3(6.0, 6.5, 5.0);
  clavicle_ = {{{joint_end, s * Vec3(-60.0, -36.0, 42.0), flat_bone, flat_bone},
                {s * Vec3(-60.0, -36.0, 42.0), s * Vec3(-120.0, -26.0, 44.0), flat_bone, s * Vec3(6.0, 6.0, 6.0)}}};

  // Artery, vein and cords under the coracoid and along the arm: places our choice after atlases. The axillary nerve
  // runs 5 to 6 cm below the acromion (Burkhead et al. 1992), the suprascapular nerve 18 mm medial of the glenoid's
  // rim behind (Warner et al. 1992).
  using namespace shoulder_label;
  const auto at = [s](double x, double y, double z) { return Vec3(s * Vec3(x, y, z)); };
  const Material a{tissue::vessel, artery}, v{tissue::vessel, vein}, p{tissue::nerve, plexus};
  const Material x{tissue::nerve, axillary_nerve}, u{tissue::nerve, suprascapular_nerve};
  strands_ = {{{round_rod(at(-110.0, -36.0, 22.0), at(-44.0, -30.0, -14.0), 3.6), a},
               {round_rod(at(-44.0, -30.0, -14.0), at(-17.0, -8.0, -54.0), 3.2), a},
               {round_rod(at(-17.0, -8.0, -54.0), at(-13.0, -4.0, -160.0), 2.6), a},
               {round_rod(at(-110.0, -44.0, 13.0), at(-46.0, -38.0, -23.0), 5.0), v},
               {round_rod(at(-46.0, -38.0, -23.0), at(-23.0, -12.0, -58.0), 4.2), v},
               {round_rod(at(-23.0, -12.0, -58.0), at(-18.0, -8.0, -160.0), 3.4), v},
               {round_rod(at(-110.0, -28.0, 29.0), at(-42.0, -22.0, -10.0), 3.6), p},
               {round_rod(at(-42.0, -22.0, -10.0), at(-19.0, -1.0, -54.0), 3.0), p},
               {round_rod(at(-19.0, -1.0, -54.0), at(-14.0, 3.0, -160.0), 2.6), p},
               {round_rod(at(-36.0, -16.0, -18.0), at(-9.0, 10.0, -40.0), 1.8), x},
               {round_rod(at(-9.0, 10.0, -40.0), at(9.0, 22.0, -36.0), 1.8), x},
               {round_rod(at(9.0, 22.0, -36.0), at(30.0, 6.0, -34.0), 1.6), x},
               {round_rod(on_blade(22.0, 9.0, 34.0), on_blade(20.0, 11.0, 14.0), 1.6), u},
               {round_rod(on_blade(20.0, 11.0, 14.0), on_blade(34.0, 9.0, -16.0), 1.5), u}}};

  // The block: from behind, above and somewhat medial. The line passes the nerve at a distance, so that a needle that
  // goes too far meets the blade and not the nerve.
  const Vec3 away = Vec3(-0.25, 0.72, 0.65).normalized();
  const Vec3 nerve_axis = (on_blade(20.0, 11.0, 14.0) - on_blade(22.0, 9.0, 34.0)).normalized();
  blocked_nerve_ = on_blade(21.2, 9.8, 26.0);
  block_ = blocked_nerve_ + beside_nerve * nerve_axis.cross(away).normalized();
  if (block_.x() > blocked_nerve_.x()) block_ = 2.0 * blocked_nerve_ - block_;  // on its medial side
  block_entry_ = skin_from(block_, away);
}

// Where a line from a point inside leaves the skin; `out` is of unit length.
Vec3 ShoulderModel::skin_from(const Vec3& inner, const Vec3& out) const {
  double inside = 0.0, outside = 200.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (inside + outside);
    (skin_distance(inner + middle * out) > 0.0 ? outside : inside) = middle;
  }
  return inner + inside * out;
}

Vec3 ShoulderModel::lowest() const {
  return {-100.0 * sizes_.scale, -86.0 * sizes_.scale - sizes_.fat - 9.0, -105.0 * sizes_.scale};
}
Vec3 ShoulderModel::highest() const {
  const double out = sizes_.fat + sizes_.skin + 9.0;
  return {sizes_.scale * 48.0 + sizes_.deltoid + out - 14.0 * sizes_.scale, 80.0 * sizes_.scale + out,
          72.0 * sizes_.scale + out};
}

// The outer surface of the muscles: the ball of the shoulder with its deltoid, the arm, and the trunk with the
// shoulder's slope. Our choice after atlases and CTs.
double ShoulderModel::fascia(const Vec3& p) const {
  const double s = sizes_.scale, more = sizes_.deltoid - 14.0 * s;
  const double ball =
      shapes::ellipsoid(p - s * Vec3(2.0, 1.0, 0.0), Vec3(46.0 * s + more, 51.0 * s + more, 44.0 * s + 0.3 * more));
  const double arm =
      shapes::distance(shapes::Rod{s * Vec3(4.0, 1.0, -8.0), s * Vec3(12.0, 0.0, -170.0),
                                   Vec3(41.0 * s + more, 46.0 * s + more, 40.0 * s), Vec3(36.0, 38.0, 36.0) * s},
                       p);
  const double half_width = s * (125.0 + 30.0 * std::clamp((p.z() / s + 90.0) / 70.0, 0.0, 1.0));
  const double wall = shapes::superellipse(p.x() + 165.0 * s, p.y() + 4.0 * s, half_width, 80.0 * s);
  const double slope = (p.z() - 36.0 * s + 0.3 * std::min(p.x(), 0.0)) * 0.957;
  const double trunk = shapes::rounded_intersection(wall, slope, 28.0 * s);
  return shapes::blend(shapes::blend(ball, arm, 20.0 * s), trunk, 24.0 * s);
}

double ShoulderModel::humerus(const Vec3& p) const {
  const double s = sizes_.scale, head = sizes_.head - head_cartilage;
  const double tuberosity = shapes::ellipsoid(p - s * Vec3(14.0, -5.0, 1.0), (head / 22.5) * Vec3(13.0, 15.0, 14.0));
  const double shaft = shapes::distance(shapes::Rod{s * Vec3(6.0, -2.0, -8.0), s * Vec3(11.0, 0.0, -45.0),
                                                    Vec3::Constant(15.0 * s), Vec3::Constant(11.5 * s)},
                                        p);
  const double below =
      shapes::distance(round_rod(s * Vec3(11.0, 0.0, -45.0), s * Vec3(13.0, 0.0, -170.0), 11.5 * s), p);
  return std::min({p.norm() - head, tuberosity, shaft, below});
}

// The glenoid's vault, medial of a face that follows the head.
bool ShoulderModel::in_vault(const Vec3& p) const {
  const double s = sizes_.scale;
  const double medial = -(p - glenoid_).dot(outwards_);
  if (medial < -8.0 * s || medial > 30.0 * s) return false;
  const double taper = std::clamp(medial / (30.0 * s), 0.0, 1.0);
  const double upper = std::clamp(p.z() / (glenoid_half_height * s), 0.0, 1.0);
  const double width = glenoid_half_width + upper * (glenoid_upper_half_width - glenoid_half_width);
  return shapes::ellipse((p - glenoid_).dot(backwards_), p.z(), s * (width - 8.0 * taper),
                         s * (glenoid_half_height - 6.0 * taper)) < 0.0;
}

double ShoulderModel::scapula(const Vec3& p) const {
  const double s = sizes_.scale;
  double found = 1e6;
  for (const auto* rods : {&acromion_, &coracoid_, &spine_})
    for (const shapes::Rod& rod : *rods) found = std::min(found, shapes::distance(rod, p));
  const Vec3 q = (p - glenoid_) / s;
  const double u = q.dot(blade_medial_), w = q.dot(blade_backwards_), z = q.z();
  if (u < 8.0 || u > 104.0) return found;
  // The blade, its thicker border at the side, and the crest that carries the spine.
  const double border = -16.0 - 1.45 * (u - 12.0), top = 22.0 + 0.2 * (u - 12.0);
  const double thickness = z < border + 9.0 ? 4.0 : 1.9;
  const double blade = std::max({std::abs(w) - thickness, border - z, z - top});
  const double way = std::clamp((u - 34.0) / 61.0, 0.0, 1.0);
  const double crest = std::max({std::abs(z - (17.0 - 11.0 * way)) - 2.2, -w, w - (25.0 - 22.0 * way), 26.0 - u});
  return std::min(found, s * std::min(blade, crest));
}

Material ShoulderModel::bones(const Vec3& p) const {
  const double s = sizes_.scale;
  const auto shelled = [](double distance, double shell, std::uint16_t label) {
    return Material{distance > -shell ? tissue::cortical_bone : tissue::cancellous_bone, label};
  };
  const double arm = humerus(p);
  if (arm < 0.0) {
    if (p.z() > -40.0 * s) return shelled(arm, bone_shell, shoulder_label::humerus);
    return {arm > -shaft_shell ? tissue::cortical_bone : tissue::fat, shoulder_label::humerus};
  }
  if (in_vault(p)) {
    const double depth = p.norm() - sizes_.head - sizes_.glenoid_gap;
    const double cartilage = std::max(glenoid_cartilage, 1.2 * spacing_);
    if (depth > 0.0 && depth < cartilage) return {tissue::cartilage, shoulder_label::scapula};
    if (depth >= cartilage) return shelled(cartilage - depth, bone_shell, shoulder_label::scapula);
  }
  const double blade = scapula(p);
  if (blade < 0.0 && p.norm() > sizes_.head + sizes_.fluid + capsule_thickness)
    return shelled(blade, bone_shell, shoulder_label::scapula);
  const double collar = std::min(shapes::distance(clavicle_[0], p), shapes::distance(clavicle_[1], p));
  if (collar < 0.0) return shelled(collar, bone_shell + 0.4, shoulder_label::clavicle);
  return {};
}

// Cartilage of the head, fluid and capsule, from the head outwards.
Material ShoulderModel::joint(const Vec3& p, double radius) const {
  const double covered = p.dot(articular_) / std::max(radius, 1.0);  // cosine of the angle from the surface's axis
  const double cartilage = std::max(head_cartilage, 1.2 * spacing_);
  if (radius < sizes_.head && radius > sizes_.head - cartilage && covered > 0.17)
    return {tissue::cartilage, shoulder_label::humerus};
  if (radius < sizes_.head || humerus(p) < 0.0 || covered < -0.2) return {};
  const double lining = std::max(capsule_thickness, 1.5 * spacing_);
  if (radius > sizes_.head + sizes_.fluid + lining) return {};
  if (radius < sizes_.head + sizes_.fluid && covered > -0.1) return {joint_space, shoulder_label::joint};
  return {joint_capsule, 0};
}

Material ShoulderModel::bundle(const Vec3& p) const {
  for (const Strand& strand : strands_) {
    const shapes::Rod& rod = strand.rod;
    const Vec3 axis = rod.b - rod.a;
    const double t = std::clamp((p - rod.a).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
    if ((p - rod.a - t * axis).squaredNorm() < square(rod.radii_a.x())) return strand.material;
  }
  return {};
}

// Ribs, the tissue between them, and the lung.
Material ShoulderModel::chest(const Vec3& p) const {
  const double s = sizes_.scale;
  const double wall = shapes::ellipse(p.x() + 165.0 * s, p.y() + 8.0 * s, 110.0 * s, 64.0 * s);
  const double dome = p.z() - s * 14.0 + 0.6 * (p.x() + 55.0 * s);
  const double cage = shapes::rounded_intersection(wall, dome, 20.0 * s);
  if (cage >= 0.0) return {};
  if (cage < -9.0 * s) return {tissue::lung, shoulder_label::lung_left};
  const double turn = (p.z() + 0.5 * p.y()) / (27.0 * s) + 64.0;
  const double in_rib = std::abs(turn - std::floor(turn) - 0.5) * 27.0 * s - 6.5 * s;
  if (in_rib < 0.0 && cage < -1.5 * s && cage > -8.0 * s) {
    const double depth = std::max({in_rib, cage + 1.5 * s, -8.0 * s - cage});
    return {depth > -bone_shell ? tissue::cortical_bone : tissue::cancellous_bone, 0};
  }
  return {tissue::muscle, 0};
}

Material ShoulderModel::muscles(const Vec3& p, double radius, double fascia) const {
  const double s = sizes_.scale;
  const double capsule = sizes_.head + sizes_.fluid + std::max(capsule_thickness, 1.5 * spacing_);
  // The cuff lies on the capsule above, behind and in front; its last 3 cm to the tuberosity are tendon.
  if (radius < capsule + sizes_.cuff && p.z() > -18.0 * s) {
    const bool is_tendon = (p - s * Vec3(20.0, -4.0, 4.0)).squaredNorm() < square(31.0 * s);
    return {is_tendon ? tendon : tissue::muscle, 0};
  }
  if (fascia > -sizes_.deltoid && p.x() > -30.0 * s) return {tissue::muscle, 0};
  // A thin layer of fat lets the deltoid slide on the cuff.
  if (fascia > -sizes_.deltoid - 1.6 && p.x() > -26.0 * s && p.z() > -40.0 * s) return {tissue::fat, 0};
  const Vec3 armpit(-30.0 * s, -14.0 * s, -48.0 * s);
  const Vec3 hollow(26.0 * s, 24.0 * s, 40.0 * s);
  return {shapes::ellipsoid(p - armpit, hollow) < 0.0 ? tissue::fat : tissue::muscle, 0};
}

Material ShoulderModel::at(const Vec3& p) const {
  const double muscle = fascia(p), skin = muscle - sizes_.fat - sizes_.skin;
  if (skin > 0.0) return {};
  if (skin > -std::max(sizes_.skin, 1.2 * spacing_)) return {tissue::skin, 0};
  const double radius = p.norm();
  if (radius > sizes_.head + sizes_.glenoid_gap && in_vault(p)) return bones(p);
  if (const Material found = joint(p, radius); found.tissue != tissue::air) return found;
  if (const Material found = bones(p); found.tissue != tissue::air) return found;
  if (muscle > 0.0) return {tissue::fat, 0};
  if (const Material found = bundle(p); found.tissue != tissue::air) return found;
  if (const Material found = chest(p); found.tissue != tissue::air) return found;
  return muscles(p, radius, muscle);
}

}  // namespace bodkin::patient
