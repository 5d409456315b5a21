#include "patient/synthetic/spine.h"

#include <tuple>

namespace bodkin::patient {
namespace {

// Facet joints and spinous processes of two bones stay this far apart (mm): the space of the joint's cartilage.
constexpr double kJointGap = 1.6;

double lower_facet(const SpineSizes& sizes, std::size_t i, bool angle) {
  if (i + 1 == sizes.vertebra.size()) return angle ? sizes.sacral_facet_angle : sizes.sacral_facet_half_distance;
  const VertebraSize& next = sizes.vertebra[i + 1];
  return angle ? next.facet_angle : next.facet_half_distance;
}

// A requested curve, over the fraction s of the way from the sacrum to T12: level at both ends, 1 in the middle, most
// inclined a fifth of the way from each end; and its slope.
double curve(double s) {
  return 16.0 * s * s * (1.0 - s) * (1.0 - s);
}
double curve_slope(double s) {
  return 32.0 * s * (1.0 - s) * (1.0 - 2.0 * s);
}

// Axial rotation of the apex for each degree of Cobb's angle: our choice. The spinous processes turn to the concave
// side, as in patients.
constexpr double kTurnOfCurve = 0.4;

Pose make_pose(const Mat3& rotation, const Vec3& origin) {
  Pose pose = Pose::Identity();
  pose.linear() = rotation;
  pose.translation() = origin;
  return pose;
}

}  // namespace

Spine::Spine(const SpineSizes& sizes, double scale)
    : sizes_(sizes), scale_(scale), sacrum_(sizes, scale), ilium_(scale) {
  for (std::size_t i = 0; i < sizes.vertebra.size(); ++i)
    vertebrae_.emplace_back(sizes.vertebra[i], sizes.below[i], lower_facet(sizes, i, false),
                            lower_facet(sizes, i, true), sizes.facet_scale, sizes.osteophyte);

  // The chain of vertebrae starts at L3, whose frame is the patient's. `angle` is the tilt about x; the angle between
  // neighbours is the disc's wedge and half of each body's.
  const Vec3 up = Vec3::UnitZ();
  const auto wedge = [&](int i) { return i < level::s1 ? sizes.vertebra[static_cast<std::size_t>(i)].wedge : 0.0; };
  const auto half = [&](int i) {
    return i < level::s1 ? 0.5 * sizes.vertebra[static_cast<std::size_t>(i)].height() : 0.0;
  };
  std::array<double, bones> angle{};
  std::array<Vec3, bones> origin;
  origin[level::l3] = Vec3::Zero();
  const auto gap_angle = [&](int upper) { return sizes.below[static_cast<std::size_t>(upper)].disc_wedge; };
  for (int i = level::l3; i < level::s1; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double end = angle[at] + 0.5 * wedge(i), next = end + gap_angle(i);
    angle[at + 1] = next + 0.5 * wedge(i + 1);
    origin[at + 1] = origin[at] - shapes::rotation(0, angle[at]) * up * half(i) -
                     shapes::rotation(0, 0.5 * (end + next)) * up * sizes.below[at].disc_height -
                     shapes::rotation(0, angle[at + 1]) * up * half(i + 1);
  }
  for (int i = level::l3 - 1; i >= 0; --i) {
    const auto at = static_cast<std::size_t>(i);
    const double end = angle[at + 1] - 0.5 * wedge(i + 1), next = end - gap_angle(i);
    angle[at] = next - 0.5 * wedge(i);
    origin[at] = origin[at + 1] + shapes::rotation(0, angle[at + 1]) * up * half(i + 1) +
                 shapes::rotation(0, 0.5 * (end + next)) * up * sizes.below[at].disc_height +
                 shapes::rotation(0, angle[at]) * up * half(i);
  }
  // A slight sideways bow over the length of the lumbar spine with its coupled axial rotation; none at the pelvis.
  const double length = origin[level::t12].z() - origin[level::s1].z();
  // Cobb's angle lies between the two vertebrae that are inclined most against each other.
  const auto share = [&](std::size_t at) {
    return std::clamp((origin[at].z() - origin[level::s1].z()) / length, 0.0, 1.0);
  };
  double least = 0.0, most = 0.0;
  for (std::size_t at = level::t12; at <= level::l5; ++at) {
    least = std::min(least, curve_slope(share(at)));
    most = std::max(most, curve_slope(share(at)));
  }
  const double inclination = sizes.cobb / (most - least);
  for (int i = 0; i < bones; ++i) {
    const auto at = static_cast<std::size_t>(std::min(i, level::s1));
    const double s = std::max((origin[at].z() - origin[level::s1].z()) / length, 0.0);
    const double bow = 4.0 * s * (1.0 - s);  // 0 at both ends, 1 in the middle
    const double slope = 4.0 * (1.0 - 2.0 * s) * sizes.scoliosis / length + inclination * curve_slope(share(at));
    const double sideways = sizes.scoliosis * bow + inclination * length * curve(share(at));
    const double axial = sizes.rotation * bow + kTurnOfCurve * sizes.cobb * curve(share(at));
    const Vec3 place = origin[at] + Vec3(sideways, 0.0, 0.0);
    const Mat3 turn = shapes::rotation(0, angle[at]);
    const Mat3 bend = shapes::rotation(1, slope) * shapes::rotation(2, axial);
    // The ilium's frame is the sacrum's turned upright: the sacrum leans by 38 degrees when the spine is straight.
    const Mat3 upright = i == ilium ? Mat3(shapes::rotation(0, -38.0 * shapes::degrees)) : Mat3(Mat3::Identity());
    poses_[static_cast<std::size_t>(i)] = make_pose(bend * turn * upright, place);
    inverses_[static_cast<std::size_t>(i)] = poses_[static_cast<std::size_t>(i)].inverse();
  }

  for (int i = 0; i < level::vertebrae; ++i) {
    const Vertebra& v = vertebra(i);
    const VertebraSize& size = v.size();
    const Vec3 canal = pose(i) * Vec3(0.0, v.canal_centre(), 0.0);
    canal_x_.add(canal.z(), canal.x());
    canal_y_.add(canal.z(), canal.y());
    canal_half_width_.add(canal.z(), 0.5 * size.canal_width);
    canal_half_depth_.add(canal.z(), 0.5 * size.canal_depth);
    const Vec3 tip = pose(i) * v.process_tip();
    tip_x_.add(tip.z(), tip.x());
    tip_y_.add(tip.z(), tip.y());
    if (i < level::l5) back_y_.add(tip.z(), tip.y());
    const Vec3 body = pose(i).translation();
    body_x_.add(body.z(), body.x());
    body_y_.add(body.z(), body.y());
    body_half_width_.add(body.z(), 0.5 * size.endplate_width);
    body_half_depth_.add(body.z(), 0.5 * size.endplate_depth);
    // Between the laminae the canal is deeper by the epidural fat behind the sac.
    const Vec3 lamina = pose(i) * v.lamina_middle();
    bulge_.add(lamina.z(), 0.0);
    // Each root leaves under the pedicle of its vertebra, downwards, forwards and outwards.
    const double under = 0.22 * size.height() - 0.5 * size.pedicle_height - 3.5;
    for (const double side : {-1.0, 1.0}) {
      const Vec3 inner(side * 0.5 * size.canal_width, v.canal_centre(), under + 2.0);
      const Vec3 outer(side * (0.5 * size.canal_width + size.pedicle_width + 10.0), v.canal_front() - 2.0,
                       under - 15.0);
      roots_.push_back({pose(i) * inner, pose(i) * outer, Vec3::Constant(2.2), Vec3::Constant(1.9)});
    }
    std::tie(lowest_[static_cast<std::size_t>(i)], highest_[static_cast<std::size_t>(i)]) = v.extent(pose(i));
  }
  const Pose& base = pose(sacrum);
  for (const double depth : {-8.0, -32.0, -60.0, -88.0}) {
    const double z = depth * scale;
    const Vec3 canal = base * Vec3(0.0, sacrum_.canal_front(z) + 0.5 * sacrum_.canal_depth(z), z);
    canal_x_.add(canal.z(), canal.x());
    canal_y_.add(canal.z(), canal.y());
    canal_half_width_.add(canal.z(), sacrum_.canal_half_width(z));
    canal_half_depth_.add(canal.z(), 0.5 * sacrum_.canal_depth(z));
    if (depth < -8.0) {
      const Vec3 crest = base * Vec3(0.0, sacrum_.crest_back(z), z);
      tip_x_.add(crest.z(), crest.x());
      tip_y_.add(crest.z(), crest.y());
      back_y_.add(crest.z(), crest.y() + 9.0 * scale);
    }
    const Vec3 body = base * Vec3(0.0, 0.13 * z, z);
    body_x_.add(body.z(), body.x());
    body_y_.add(body.z(), body.y());
    body_half_width_.add(body.z(), 0.5 * sizes.sacrum_width * (1.0 + 0.006 * depth));
    body_half_depth_.add(body.z(), 0.5 * sizes.sacrum_depth * (1.0 + 0.006 * depth));
  }
  lowest_[sacrum] = lowest_[ilium] = -1e6;
  highest_[sacrum] = base.translation().z() + 45.0 * scale;
  highest_[ilium] = base.translation().z() + 75.0 * scale;
  for (int i = 0; i < level::vertebrae; ++i) {
    const Vec3 middle = interspace(i);
    flavum_.add(middle.z(), sizes.below[static_cast<std::size_t>(i)].flavum_thickness);
    bulge_.add(middle.z(), 1.6 * scale);
  }
  const Vec3 last = base * Vec3(0.0, 0.0, -30.0 * scale);
  bulge_.add(last.z(), 0.0);
  conus_ = interspace(level::l1);  // the conus ends at L1/L2 in most adults
}

Vec3 Spine::interspace(int index) const {
  const Vec3 upper = pose(index) * vertebra(index).lamina_middle();
  const Vec3 lower = index + 1 < level::s1 ? Vec3(pose(index + 1) * vertebra(index + 1).lamina_middle())
                                           : Vec3(pose(sacrum) * Vec3(0.0, sacrum_.canal_front(0.0), -14.0 * scale_));
  const double upper_half = 0.5 * vertebra(index).size().lamina_height;
  const double lower_half = index + 1 < level::s1 ? 0.5 * vertebra(index + 1).size().lamina_height : 0.0;
  const double z = 0.5 * (upper.z() - upper_half + lower.z() + lower_half);
  return {canal_x_(z), canal_y_(z), z};
}

double Spine::top() const {
  const Vertebra& l1 = vertebra(level::l1);
  return (pose(level::l1) * Vec3(0.0, 0.0, 0.5 * l1.size().height())).z() + 10.0 * scale_;
}

double Spine::bottom() const {
  return (pose(sacrum) * Vec3(0.0, -0.5 * sizes_.sacrum_depth, -sacrum_.first_segment())).z() - 8.0 * scale_;
}

SpineSection Spine::section(double z) const {
  SpineSection s{};
  s.z = z;
  s.canal_x = canal_x_(z);
  s.canal_y = canal_y_(z);
  const double slope = (canal_y_(z + 1.0) - canal_y_(z - 1.0)) / 2.0;
  s.tilt = 1.0 / std::sqrt(1.0 + slope * slope);
  s.canal_half_width = canal_half_width_(z);
  s.canal_front = canal_half_depth_(z);
  s.canal_back = s.canal_front + std::max(bulge_(z), 0.0);
  s.flavum = flavum_(z);
  // Dural sac 12 x 16 mm, lying against the front of the canal; it narrows in the sacrum and ends at S2.
  const double end = std::clamp((z - pose(sacrum).translation().z()) / (40.0 * scale_) + 1.0, 0.0, 1.0);
  s.sac_half_depth = std::min(6.0 * scale_, 0.80 * s.canal_front) * std::sqrt(end);
  s.sac_half_width = std::min(8.2 * scale_, 0.75 * s.canal_half_width) * std::sqrt(end);
  s.sac_y = -s.canal_front + s.sac_half_depth + 0.8 * scale_;
  const double cord = std::clamp((z - conus_.z()) / (28.0 * scale_), 0.0, 1.0);
  s.cord_half_width = 4.6 * scale_ * std::sqrt(cord);
  s.cord_half_depth = 3.8 * scale_ * std::sqrt(cord);
  s.tip_x = tip_x_(z);
  s.tip_y = tip_y_(z);
  s.back_y = std::max(back_y_(z), s.tip_y);
  // The rotation of a curve separates tip and canal by up to a centimetre; that of any patient, less than half a
  // millimetre, does not affect the ligaments.
  s.midline_slope = sizes_.cobb == 0.0 ? 0.0 : (s.tip_x - s.canal_x) / (s.tip_y - s.canal_y);
  s.body_x = body_x_(z);
  s.body_y = body_y_(z);
  s.body_half_width = body_half_width_(z);
  s.body_half_depth = body_half_depth_(z);
  return s;
}

double Spine::canal_distance(const Vec3& p, const SpineSection& s) {
  const double y = (p.y() - s.canal_y) * s.tilt;
  const double depth = y > 0.0 ? s.canal_back : s.canal_front;
  // Narrower behind: the section is a rounded triangle.
  const double narrowing = 1.0 - 0.42 * std::clamp(y / s.canal_back, 0.0, 1.0);
  return shapes::ellipse((p.x() - s.canal_x) / narrowing, y, s.canal_half_width, depth);
}

double Spine::sac_distance(const Vec3& p, const SpineSection& s) {
  if (s.sac_half_depth <= 0.0) return 1e6;
  const double y = (p.y() - s.canal_y) * s.tilt - s.sac_y;
  return shapes::ellipse(p.x() - s.canal_x, y, s.sac_half_width, s.sac_half_depth);
}

unsigned Spine::bones_near(double z, double margin) const {
  unsigned mask = 0;
  for (std::size_t i = 0; i < bones; ++i)
    if (z > lowest_[i] - margin && z < highest_[i] + margin) mask |= 1u << i;
  return mask;
}

double Spine::bone_distance(int bone, const Vec3& p) const {
  const Vec3 local = inverses_[static_cast<std::size_t>(bone)] * p;
  if (bone == sacrum) return sacrum_.distance(local);
  if (bone == ilium) return ilium_.distance(local);
  return vertebra(bone).distance(local);
}

BoneHit Spine::bones_at(const Vec3& p, const SpineSection& s, unsigned mask) const {
  BoneHit hit;
  const double lateral = std::abs(p.x() - s.body_x);
  for (int bone = 0; bone < bones; ++bone) {
    if ((mask >> bone & 1u) == 0) continue;
    if (bone < sacrum && lateral > 62.0 * scale_) continue;
    const double distance = bone_distance(bone, p);
    if (distance < hit.distance) {
      hit.second = hit.distance;
      hit.second_bone = hit.bone;
      hit.distance = distance;
      hit.bone = bone;
    } else if (distance < hit.second) {
      hit.second = distance;
      hit.second_bone = bone;
    }
  }
  if (hit.bone < 0) return hit;
  // Where two bones would meet, each keeps to its side of the joint.
  hit.distance = std::max(hit.distance, 0.5 * (hit.distance - hit.second + kJointGap));
  if (hit.bone != ilium) hit.distance = std::max(hit.distance, -canal_distance(p, s));
  return hit;
}

int Spine::disc_at(const Vec3& p, unsigned mask) const {
  for (int i = 0; i < level::vertebrae; ++i) {
    const bool near = (mask >> i & 1u) != 0 && (mask >> (i + 1) & 1u) != 0;
    if (!near) continue;
    const Vec3 upper = inverses_[static_cast<std::size_t>(i)] * p;
    if (upper.z() > 0.0 || upper.z() < -2.0 * vertebra(i).size().height()) continue;
    const Vec3 lower = inverses_[static_cast<std::size_t>(i) + 1] * p;
    const bool below_upper = upper.z() < -vertebra(i).half_height(upper) + 0.5;
    const bool above_lower =
        i + 1 == sacrum ? lower.z() > -1.5 : lower.z() > vertebra(i + 1).half_height(lower) - 0.5;
    if (!below_upper || !above_lower) continue;
    const double section = i + 1 == sacrum ? sacrum_.body_section(lower) : vertebra(i + 1).body_section(lower);
    if (0.5 * (section + vertebra(i).body_section(upper)) < 0.0) return i;
  }
  return -1;
}

bool Spine::root_at(const Vec3& p) const {
  for (const shapes::Rod& root : roots_) {
    if (p.z() > root.a.z() + 6.0 || p.z() < root.b.z() - 6.0) continue;
    if (shapes::distance(root, p) < 0.0) return true;
  }
  return false;
}

int Spine::between_processes(const Vec3& p) const {
  for (int i = 0; i < level::vertebrae; ++i) {
    const Vec3 upper = inverses_[static_cast<std::size_t>(i)] * p;
    if (vertebra(i).process_outline(upper) < 0.0) return -1;
    const Vec3 lower = inverses_[static_cast<std::size_t>(i) + 1] * p;
    const double lower_outline =
        i + 1 == sacrum ? sacrum_.process_outline(lower) : vertebra(i + 1).process_outline(lower);
    if (lower_outline < 0.0) return -1;
    const double upper_axis = upper.z() - vertebra(i).process_tip().z();
    const double lower_axis =
        i + 1 == sacrum ? lower.z() + 20.0 * scale_ : lower.z() - vertebra(i + 1).process_tip().z();
    if (upper_axis < 0.0 && lower_axis > 0.0) return i;
  }
  return -1;
}

}  // namespace bodkin::patient
