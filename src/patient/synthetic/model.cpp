#include "patient/synthetic/model.h"

#include <set>

#include "patient/synthetic/calcification.h"

#include "core/random.h"

namespace bodkin::patient {
namespace {

// Thickness of cortical bone (mm), our choice: bodies have a thin shell, arches and pelvis a thicker one.
constexpr double kBodyShell = 1.2, kArchShell = 1.7, kPelvisShell = 1.5;

// Smooth noise within -1 and 1 whose features are 8 mm wide: random values at the corners of a lattice, blended
// between them.
double patches(std::uint64_t seed, const Vec3& p) {
  const Vec3 place = p / 8.0 + Vec3::Constant(4096.0);
  const auto i = static_cast<std::int64_t>(place.x()), j = static_cast<std::int64_t>(place.y()),
             k = static_cast<std::int64_t>(place.z());
  const Vec3 share = place - Vec3(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const int a = corner & 1, b = corner >> 1 & 1, c = corner >> 2;
    const double weight = (a != 0 ? share.x() : 1.0 - share.x()) * (b != 0 ? share.y() : 1.0 - share.y()) *
                          (c != 0 ? share.z() : 1.0 - share.z());
    sum += weight * hash_noise(seed, i + a + ((j + b) << 20) + ((k + c) << 40));
  }
  return sum;
}

// Widths of the interspinous ligament, in front, in the middle and behind (Lawrence et al., layer_thickness.csv).
double interspinous_half_width(double v) {
  const double front = 3.65, middle = 2.25, back = 4.6;
  return front * (1.0 - v) * (1.0 - 2.0 * v) + 4.0 * middle * v * (1.0 - v) + back * v * (2.0 * v - 1.0);
}

}  // namespace

LumbarModel::LumbarModel(const LumbarSizes& sizes, std::uint64_t seed)
    : spine_(sizes.spine, sizes.torso.scale),
      torso_(sizes.torso, spine_, seed),
      calcification_(sizes.calcification),
      seed_(mix64(seed ^ 0x43414C43ULL)) {}

LumbarModel::Slice LumbarModel::slice(double z, double spacing) const {
  Slice slice;
  for (int i = 0; i < 3; ++i) slice.spine[static_cast<std::size_t>(i)] = spine_.section(z + (i - 1) * spacing);
  slice.torso = torso_.section(z, slice.here());
  slice.bones = spine_.bones_near(z, 0.0);
  slice.spacing = spacing;
  return slice;
}

double LumbarModel::skin_distance(const Vec3& p) const {
  const TorsoSection section = torso_.section(p.z(), spine_.section(p.z()));
  return Torso::outline_distance(p, section, section.skin);
}

double LumbarModel::bone_clearance(const Vec3& p) const {
  return spine_.bones_at(p, spine_.section(p.z()), spine_.bones_near(p.z(), 6.0)).distance;
}

Material LumbarModel::bone(const Vec3& p, const BoneHit& hit, const Slice& slice) const {
  Material material;
  double shell = kPelvisShell;
  if (hit.bone == Spine::ilium) {
    material.label = p.x() > 0.0 ? structure::hip_left : structure::hip_right;
  } else if (hit.bone == Spine::sacrum) {
    material.label = spine_.above_second_sacral(p) > 0.0 ? structure::s1 : structure::sacrum;
  } else {
    material.label = static_cast<std::uint16_t>(structure::t11 - hit.bone);
    shell = p.y() > slice.here().canal_y - 4.0 ? kArchShell : kBodyShell;
  }
  material.tissue = hit.distance > -shell ? anatomy::tissue::cortical_bone : anatomy::tissue::cancellous_bone;
  return material;
}

Material LumbarModel::sac(const Vec3& p, const Slice& slice, double distance) const {
  Material material{anatomy::tissue::cerebrospinal_fluid, structure::canal};
  const double step = slice.spacing;
  if (distance > -2.6 * step) {
    for (int n = 0; n < 27; ++n) {
      const int across = n % 3 - 1, back = n / 3 % 3 - 1, up = n / 9 - 1;
      const Vec3 q = p + step * Vec3(across, back, up);
      if (Spine::sac_distance(q, slice.spine[static_cast<std::size_t>(n / 9)]) >= 0.0) {
        material.tissue = anatomy::tissue::dura;
        return material;
      }
    }
  }
  const SpineSection& s = slice.here();
  const double x = p.x() - s.canal_x, y = (p.y() - s.canal_y) * s.tilt - s.sac_y;
  if (s.cord_half_depth > 0.4 && shapes::ellipse(x, y, s.cord_half_width, s.cord_half_depth) < 0.0) {
    material.tissue = anatomy::tissue::spinal_cord;
    return material;
  }
  // Cauda equina: in a prone patient the roots sink to the front of the sac.
  static constexpr std::array<std::array<double, 2>, 9> kRoots = {{{0.0, -0.62},
                                                                   {0.24, -0.52},
                                                                   {0.46, -0.44},
                                                                   {0.13, -0.30},
                                                                   {0.36, -0.16},
                                                                   {0.62, -0.28},
                                                                   {0.58, -0.02},
                                                                   {0.22, -0.72},
                                                                   {0.42, -0.66}}};
  const double root = 0.16 * s.sac_half_depth;
  for (const auto& place : kRoots) {
    const double dx = std::abs(x) - place[0] * s.sac_half_width, dy = y - place[1] * s.sac_half_depth;
    if (dx * dx + dy * dy < root * root) material.tissue = anatomy::tissue::nerve;
  }
  return material;
}

// Calcification spreads from behind: `front` and `back` are where the interspinous ligament begins and the
// supraspinous one ends. Its border is ragged by up to a sixth of the way.
bool LumbarModel::is_calcified(const Vec3& p, double front, double back) const {
  if (calcification_ <= 0.0) return false;
  const double ragged = 0.6 * calcification_ * (1.0 - calcification_) * patches(seed_, p);
  return (back - p.y()) / (back - front) < calcification_ + ragged;
}

Material LumbarModel::ligament(const Vec3& p, const Slice& slice, double canal) const {
  const SpineSection& s = slice.here();
  const double x = std::abs(p.x() - s.tip_x - s.midline_slope * (p.y() - s.tip_y));
  if (p.y() < s.canal_y || x > 16.0) return {};
  const double scale = torso_.sizes().scale;
  if (canal < s.flavum && x < 13.0 * scale && spine_.above_second_sacral(p) > 14.0 * scale)
    return {anatomy::tissue::ligamentum_flavum, 0};
  const double behind_tip = p.y() - s.tip_y;
  const double front = s.canal_y + (s.canal_back + s.flavum) / s.tilt;
  const double l5_tip = (spine_.pose(level::l5) * spine_.vertebra(level::l5).process_tip()).z();
  // 3.7 mm thick; where the fat begins a little further back, the ligament reaches up to it.
  const bool behind_bone = behind_tip > -0.3 && x < 4.5;
  if (behind_bone && (behind_tip < Torso::kSupraspinous ||
                      (behind_tip < 5.5 && Torso::outline_distance(p, slice.torso, slice.torso.fascia) < 0.0))) {
    // The supraspinous ligament ends at L5; below, fascia covers the gap.
    if (p.z() <= l5_tip) return {anatomy::tissue::soft, 0};
    const bool hard = is_calcified(p, front, s.tip_y + Torso::kSupraspinous);
    return {hard ? calcified_ligament : anatomy::tissue::supraspinous_ligament, 0};
  }
  if (behind_tip > 0.0 || x > 4.8) return {};
  const int upper = spine_.between_processes(p);
  if (upper < 0) return {};
  const double length = s.tip_y - front;
  const double v = std::clamp((p.y() - front) / length, 0.0, 1.0);
  if (x > interspinous_half_width(v)) return {};
  const bool gap = spine_.sizes().below[static_cast<std::size_t>(upper)].ligament_gap;
  if (gap && v > 0.12 && v < 0.12 + 3.5 / length) return {anatomy::tissue::fat, 0};
  const bool hard = is_calcified(p, front, s.tip_y + Torso::kSupraspinous);
  return {hard ? calcified_ligament : anatomy::tissue::interspinous_ligament, 0};
}

Material LumbarModel::at(const Vec3& p, const Slice& slice) const {
  const TorsoSection& torso = slice.torso;
  const double skin = Torso::outline_distance(p, torso, torso.skin);
  if (skin > 0.0) return {};
  if (skin > -std::max(torso_.sizes().skin, slice.spacing)) return {anatomy::tissue::skin, 0};

  const SpineSection& s = slice.here();
  const double sac_distance = Spine::sac_distance(p, s);
  if (sac_distance < 0.0) return sac(p, slice, sac_distance);

  const double scale = torso_.sizes().scale;
  const double lateral = std::abs(p.x() - s.body_x);
  const bool near_spine = lateral < 62.0 * scale && p.y() > s.body_y - 30.0 * scale && p.y() < s.tip_y + 6.0;
  unsigned bones = slice.bones;
  if (!near_spine) bones &= 1u << Spine::ilium;
  if (bones != 0) {
    const BoneHit hit = spine_.bones_at(p, s, bones);
    if (hit.distance < 0.0) return bone(p, hit, slice);
    if (hit.second < 1.4 && lateral > 5.0) return {anatomy::tissue::cartilage, 0};
  }
  if (near_spine) {
    const double canal = Spine::canal_distance(p, s);
    if (canal < 0.0) return {anatomy::tissue::epidural_fat, structure::canal};
    if (spine_.disc_at(p, slice.bones) >= 0) return {anatomy::tissue::disc, 0};
    if (const Material found = ligament(p, slice, canal); found.tissue != anatomy::tissue::air) return found;
    if (spine_.root_at(p)) return {anatomy::tissue::nerve, 0};
  }
  return torso_.soft_tissue(p, torso, s);
}

std::vector<anatomy::Structure> lumbar_structures(const anatomy::LabelVolume& labels) {
  static const std::vector<anatomy::Structure> kAll = {
      {structure::kidney_right, "kidney_right", "organ", true},
      {structure::kidney_left, "kidney_left", "organ", true},
      {structure::liver, "liver", "organ", true},
      {structure::small_bowel, "small_bowel", "", false},
      {structure::colon, "colon", "", true},
      {structure::sacrum, "sacrum", "bone", false},
      {structure::s1, "vertebrae_S1", "bone", false},
      {structure::l5, "vertebrae_L5", "bone", false},
      {structure::l5 + 1, "vertebrae_L4", "bone", false},
      {structure::l5 + 2, "vertebrae_L3", "bone", false},
      {structure::l5 + 3, "vertebrae_L2", "bone", false},
      {structure::l5 + 4, "vertebrae_L1", "bone", false},
      {structure::l5 + 5, "vertebrae_T12", "bone", false},
      {structure::t11, "vertebrae_T11", "bone", false},
      {structure::aorta, "aorta", "vessel", true},
      {structure::vena_cava, "inferior_vena_cava", "vessel", true},
      {structure::iliac_artery_left, "iliac_artery_left", "vessel", true},
      {structure::iliac_artery_right, "iliac_artery_right", "vessel", true},
      {structure::iliac_vein_left, "iliac_vena_left", "vessel", true},
      {structure::iliac_vein_right, "iliac_vena_right", "vessel", true},
      {structure::hip_left, "hip_left", "bone", false},
      {structure::hip_right, "hip_right", "bone", false},
      {structure::canal, "spinal_cord", "spinal_canal", false},
      {structure::autochthon_left, "autochthon_left", "muscle", false},
      {structure::autochthon_right, "autochthon_right", "muscle", false},
      {structure::iliopsoas_left, "iliopsoas_left", "muscle", false},
      {structure::iliopsoas_right, "iliopsoas_right", "muscle", false},
      {structure::lesion, "lesion", "mass", false},
  };
  const std::set<std::uint16_t> present(labels.voxels.begin(), labels.voxels.end());
  std::vector<anatomy::Structure> table;
  for (const anatomy::Structure& structure : kAll)
    if (present.contains(structure.label)) table.push_back(structure);
  return table;
}

}  // namespace bodkin::patient
