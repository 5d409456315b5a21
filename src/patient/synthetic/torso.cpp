#include "patient/synthetic/torso.h"

namespace bodkin::patient {
namespace {

// Depth of the groove between the two columns of back muscle (mm): our choice. Cross-sections of the other muscles:
// also our choice, after CT.
constexpr double kMuscleFurrow = 9.0;

double square(double x) {
  return x * x;
}

// 0 to 1 to 0 with period 1.
double wave(double x) {
  const double t = x - std::floor(x);
  return 16.0 * square(t * (1.0 - t));
}

}  // namespace

Torso::Torso(const TorsoSizes& sizes, const Spine& spine, std::uint64_t seed) : sizes_(sizes) {
  const double s = sizes.scale;
  l1_z_ = spine.pose(level::l1).translation().z();
  l4_z_ = spine.pose(level::l4).translation().z();
  l5_z_ = spine.pose(level::l5).translation().z();
  s1_z_ = spine.pose(Spine::sacrum).translation().z();
  // The left kidney lies between T12 and L3, the right one a little lower.
  const double back_y = spine.pose(level::l1 + 1).translation().y();
  kidney_left_ = Vec3(68.0 * s, back_y + 4.0 * s, l1_z_ - 20.0 * s);
  kidney_right_ = Vec3(-68.0 * s, back_y + 4.0 * s, l1_z_ - 34.0 * s);
  bowel_ = Bowel({-half_width(), front(), spine.bottom() - 30.0}, {half_width(), 0.0, spine.top() + 40.0}, seed,
                 [&](const Vec3& centre) {
                   const SpineSection at = spine.section(centre.z());
                   if (centre.y() > at.body_y - at.body_half_depth - 34.0 * s) return false;
                   const TorsoSection torso = section(centre.z(), at);
                   return outline_distance(centre, torso, torso.fascia) < -wall_thickness(centre, torso) - 13.0;
                 });
}

TorsoSection Torso::section(double z, const SpineSection& spine) const {
  TorsoSection section{};
  const double s = sizes_.scale;
  section.middle_x = spine.tip_x;
  const double waist = z / (100.0 * s);  // 0 at L3, about 1 at T12 and -1 at S1
  const double width = (136.0 + 6.0 * waist * waist - (waist < 0.0 ? 8.0 * waist : 0.0)) * (1.0 + sizes_.visceral);
  TorsoSection::Outline& fascia = section.fascia;
  fascia.half_width = width * s;
  fascia.back = spine.back_y + kSupraspinous + kMuscleFurrow;
  fascia.front = (-112.0 - 6.0 * waist) * s * (1.0 + 1.6 * sizes_.visceral);
  fascia.furrow = kMuscleFurrow;
  TorsoSection::Outline& skin = section.skin;
  skin.half_width = fascia.half_width + sizes_.flank_fat + sizes_.skin;
  skin.back = fascia.back + sizes_.back_fat + sizes_.skin;
  skin.front = fascia.front - sizes_.belly_fat - sizes_.skin;
  skin.furrow = kMuscleFurrow + sizes_.back_fat - sizes_.back_fat_midline;
  return section;
}

double Torso::outline_distance(const Vec3& p, const TorsoSection& section, const TorsoSection::Outline& outline) {
  const double centre = 0.5 * (outline.back + outline.front), half = 0.5 * (outline.back - outline.front);
  double y = p.y() - centre;
  if (y > 0.0) {
    const double lateral = square((p.x() - section.middle_x) / 15.0);
    y += outline.furrow * std::min(y / (half - outline.furrow), 1.0) / square(1.0 + lateral);
  }
  return shapes::superellipse(p.x(), y, outline.half_width, half);
}

double Torso::half_width() const {
  return 152.0 * sizes_.scale * (1.0 + sizes_.visceral) + sizes_.flank_fat + sizes_.skin;
}
double Torso::front() const {
  return -121.0 * sizes_.scale * (1.0 + 1.6 * sizes_.visceral) - sizes_.belly_fat - sizes_.skin;
}

// Muscle of the abdominal wall: thin in front (rectus), thick at the flanks.
double Torso::wall_thickness(const Vec3& p, const TorsoSection& torso) const {
  const double middle = 0.5 * (torso.fascia.back + torso.fascia.front);
  const double forwards = std::clamp((middle - p.y()) / (middle - torso.fascia.front), 0.0, 1.0);
  return (19.0 - 8.0 * square(forwards)) * sizes_.scale;
}

Material Torso::back_muscle(const Vec3& p, double fascia, const TorsoSection& torso,
                            const SpineSection& spine) const {
  const double s = sizes_.scale;
  const double x = std::abs(p.x() - spine.tip_x);
  const bool left = p.x() > spine.tip_x;
  const double pelvis = std::clamp((s1_z_ + 20.0 * s - p.z()) / (60.0 * s), 0.0, 1.0);
  const double plane = spine.canal_y + 7.0 * s;  // of the transverse processes
  const double middle = 0.5 * (torso.fascia.back + plane), half_depth = 0.5 * (torso.fascia.back - plane) + 2.0;
  const double half_width = (37.0 - 9.0 * pelvis) * s;
  const double erector = shapes::ellipse(x - half_width + 1.0, p.y() - middle, half_width, half_depth);
  if (erector < 0.0 || (x < half_width && p.y() > plane)) {
    // Fat in the cleft between multifidus and longissimus, in front of the column and, with age, between its fibres.
    const double depth = torso.fascia.back - p.y();
    const double cleft = 13.0 * s + depth * (0.62 - 0.006 * depth) + 2.0 * wave(p.z() / (41.0 * s));
    const double cleft_half = (0.3 + 0.8 * wave(depth / 17.0 + p.z() / 23.0)) * (1.0 + 3.0 * sizes_.muscle_fat);
    const bool in_cleft = std::abs(x - cleft) < cleft_half && p.y() > plane + 4.0 && depth > 6.0;
    const bool in_front = erector > -1.1 && p.y() < middle && x > 20.0 * s;
    if (in_cleft || in_front) return {anatomy::tissue::fat, 0};
    return {anatomy::tissue::muscle, left ? structure::autochthon_left : structure::autochthon_right};
  }
  if (erector < 1.0 || x < half_width) return {x < half_width ? anatomy::tissue::muscle : anatomy::tissue::fat, 0};
  // Lateral to the column the wall of the flank curves round to the back, with fat in front of it that ends above the
  // pelvis.
  const double arch = s1_z_ + 20.0 * s + 0.9 * (p.y() - spine.canal_y) + 12.0 * s * square((x / s - 88.0) / 18.0);
  const bool fat = fascia < -wall_thickness(p, torso) && p.z() > arch;
  return {fat ? anatomy::tissue::fat : anatomy::tissue::muscle, 0};
}

Material Torso::vessel(const Vec3& p, const SpineSection& spine) const {
  const double s = sizes_.scale;
  const double front = spine.body_y - spine.body_half_depth;
  // Aorta to the left, vena cava to the right, in front of the bodies; they divide into iliac vessels at L4 and L5.
  const double artery_drop = std::max(l4_z_ - 8.0 * s - p.z(), 0.0),
               vein_drop = std::max(l5_z_ + 6.0 * s - p.z(), 0.0);
  const double y = p.y() - front;
  if (artery_drop <= 0.0) {
    if (shapes::ellipse(p.x() - 9.0 * s, y + 11.0 * s, 8.5 * s, 8.5 * s) < 0.0)
      return {anatomy::tissue::vessel, structure::aorta};
  } else {
    const double spread = (4.0 + 0.55 * artery_drop / s) * s;
    for (const double side : {-1.0, 1.0})
      if (shapes::ellipse(p.x() - 5.0 * s - side * spread, y + 10.0 * s, 5.5 * s, 5.5 * s) < 0.0)
        return {anatomy::tissue::vessel, side > 0.0 ? structure::iliac_artery_left : structure::iliac_artery_right};
  }
  if (vein_drop <= 0.0) {
    if (shapes::ellipse(p.x() + 15.0 * s, y + 9.0 * s, 11.0 * s, 8.0 * s) < 0.0)
      return {anatomy::tissue::vessel, structure::vena_cava};
  } else {
    const double spread = (6.0 + 0.6 * vein_drop / s) * s;
    for (const double side : {-1.0, 1.0})
      if (shapes::ellipse(p.x() + 8.0 * s - side * spread, y + 6.0 * s, 6.5 * s, 5.5 * s) < 0.0)
        return {anatomy::tissue::vessel, side > 0.0 ? structure::iliac_vein_left : structure::iliac_vein_right};
  }
  return {};
}

Material Torso::kidney(const Vec3& p) const {
  const double s = sizes_.scale;
  const bool left = p.x() > 0.0;
  Vec3 q = p - (left ? kidney_left_ : kidney_right_);
  if (std::abs(q.z()) > 60.0 * s) return {};
  const double side = left ? 1.0 : -1.0;
  q.x() += side * 0.22 * q.z();  // the lower pole lies further out and further forward
  q.y() -= 0.15 * q.z();
  if (shapes::ellipsoid(q, Vec3(26.0, 23.0, 54.0) * s) > 0.0) return {};
  // The sinus: fat around the collecting system, open towards the spine.
  const Vec3 sinus = q + side * Vec3(15.0 * s, 0.0, 0.0);
  if (shapes::ellipsoid(sinus, Vec3(15.0, 8.0, 25.0) * s) < 0.0) {
    const bool pelvis = shapes::ellipsoid(sinus - side * Vec3(3.0 * s, 0.0, 0.0), Vec3(9.0, 4.0, 15.0) * s) < 0.0;
    return pelvis ? Material{anatomy::tissue::soft, 0} : Material{anatomy::tissue::fat, 0};
  }
  return {anatomy::tissue::organ, left ? structure::kidney_left : structure::kidney_right};
}

Material Torso::gut(const Vec3& p, const SpineSection& spine) const {
  const double s = sizes_.scale;
  // Liver: the lower part of the right lobe.
  const Vec3 liver = p - Vec3(-74.0 * s, -58.0 * s, l1_z_ + 40.0 * s);
  if (shapes::ellipsoid(liver, Vec3(62.0, 66.0, 82.0) * s) < 0.0) return {anatomy::tissue::organ, structure::liver};
  // Ascending and descending colon with haustra. Gas rises to the back of a prone patient.
  for (const double side : {-1.0, 1.0}) {
    const Vec3 centre(side * 88.0 * s, spine.body_y - 38.0 * s, 0.0);
    const double radius = (15.0 + 4.0 * wave(p.z() / (34.0 * s) + 0.3 * side)) * s;
    const double dx = p.x() - centre.x(), dy = p.y() - centre.y();
    const double r = std::sqrt(dx * dx + dy * dy);
    if (r > radius) continue;
    const bool gas = r < radius - 2.5 && dy > (side > 0.0 ? 1.0 : 6.0) * s;
    return {gas ? anatomy::tissue::gas : anatomy::tissue::soft, structure::colon};
  }
  double depth = 0.0;
  const Bowel::Loop* loop = bowel_.at(p, depth);
  if (loop == nullptr) return {};
  const bool gas = loop->gas && depth > 2.5 && p.y() > loop->centre.y() + 2.0;
  return {gas ? anatomy::tissue::gas : anatomy::tissue::soft, structure::small_bowel};
}

Material Torso::soft_tissue(const Vec3& p, const TorsoSection& torso, const SpineSection& spine) const {
  const double s = sizes_.scale;
  const double fascia = outline_distance(p, torso, torso.fascia);
  if (fascia > 0.0) return {anatomy::tissue::fat, 0};
  const double x = std::abs(p.x() - spine.body_x);
  const bool left = p.x() > spine.body_x;

  // Psoas: lateral to the bodies from L1 downwards, growing.
  const double down = std::clamp((l1_z_ + 12.0 * s - p.z()) / (l1_z_ - s1_z_), 0.0, 1.3);
  if (down > 0.0) {
    const double radius = (7.0 + 14.0 * down) * std::sqrt(std::min(down / 0.12, 1.0)) * s;
    const double centre_x = spine.body_half_width + (0.62 + 0.25 * down) * radius;
    const double centre_y = (down > 0.8 ? spine.body_y - 40.0 * s * (down - 0.8) : spine.body_y) + 2.0 * s;
    const double psoas = shapes::ellipse(x - centre_x, p.y() - centre_y, radius, 1.12 * radius);
    if (psoas < 0.0) return {anatomy::tissue::muscle, left ? structure::iliopsoas_left : structure::iliopsoas_right};
    if (psoas < 1.2) return {anatomy::tissue::fat, 0};
  }
  // Quadratus lumborum: from the transverse processes outwards, above the crest of the ilium.
  const double quadratus =
      shapes::ellipse(x - 61.0 * s, p.y() - spine.canal_y + 0.12 * (x - 61.0 * s), 22.0 * s, 8.0 * s);
  if (quadratus < 0.0) return {anatomy::tissue::muscle, 0};
  if (quadratus < 1.0) return {anatomy::tissue::fat, 0};
  // The foramina hold fat around the roots.
  const bool beside_canal = p.y() < spine.canal_y + 6.0 * s && p.y() > spine.body_y;
  if (beside_canal &&
      shapes::ellipse(x, p.y() - spine.canal_y + 4.0 * s, spine.canal_half_width + 11.0 * s, 13.0 * s) < 0.0)
    return {anatomy::tissue::fat, 0};

  if (p.y() > spine.canal_y) return back_muscle(p, fascia, torso, spine);
  if (fascia > -wall_thickness(p, torso)) {
    // Thin layers of fat separate the three muscles of the flank.
    const bool layer = std::abs(fascia + 6.8 * s) < 0.6 || std::abs(fascia + 13.0 * s) < 0.6;
    return {x > 66.0 * s && layer ? anatomy::tissue::fat : anatomy::tissue::muscle, 0};
  }
  if (const Material found = vessel(p, spine); found.label != 0) return found;
  if (const Material found = kidney(p); found.tissue != anatomy::tissue::air) return found;
  if (const Material found = gut(p, spine); found.label != 0) return found;
  return {anatomy::tissue::fat, 0};
}

}  // namespace bodkin::patient
