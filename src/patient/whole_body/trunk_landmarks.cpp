#include <array>

#include "patient/whole_body/body_landmarks.h"

namespace bodkin::patient {
namespace {

// Bodkin's own names of the vertebrae in the order of spinous_height().
constexpr std::array<const char*, 18> vertebra_names = {"C7", "T1",  "T2",  "T3",  "T4", "T5", "T6", "T7", "T8",
                                                        "T9", "T10", "T11", "T12", "L1", "L2", "L3", "L4", "L5"};

// The skin of the front at a distance from the median plane, at the gap below `rib`.
Vec3 in_space(const SkinFinder& skin, int rib, double x) {
  double z = 0.5 * (rib_height(rib, 1.0) + rib_height(rib + 1, 1.0));
  Vec3 place = skin.front(x, z);
  for (int i = 0; i < 12; ++i) {
    const double along_rib = position_along_ribs(place);
    z = 0.5 * (rib_height(rib, along_rib) + rib_height(rib + 1, along_rib));
    place = skin.front(x, z);
  }
  return place;
}

// The same on the side of the chest at a depth.
Vec3 in_space_at_side(const SkinFinder& skin, int rib, double y) {
  double z = 1280.0;
  Vec3 place = skin.side(y, z);
  for (int i = 0; i < 12; ++i) {
    const double along_rib = position_along_ribs(place);
    z = 0.5 * (rib_height(rib, along_rib) + rib_height(rib + 1, along_rib));
    place = skin.side(y, z);
  }
  return place;
}

// Height of the collar bone's lower edge, rising outwards.
double clavicle_height(double x) {
  return 1383.0 + 0.09 * x;
}

constexpr double axilla_y = 20.0;

}  // namespace

void add_trunk_landmarks(SkinFinder& skin) {
  const auto front = [&](double x, double z) { return skin.front(x, z); };
  const auto back = [&](double x, double z) { return skin.back(x, z); };

  // In front.
  skin.point("suprasternal_notch", front(0.0, 1396.0));
  skin.point("sternal_angle", front(0.0, 1347.0));
  skin.point("xiphisternal_junction", front(0.0, 1200.0));
  skin.point("umbilicus", front(0.0, 1020.0));
  skin.point("pubic_symphysis_superior_border", front(0.0, 905.0));
  skin.level("pubic_symphysis_inferior_border", front(0.0, 868.0));
  std::vector<Vec3> median;
  for (double z = 1396.0; z >= 900.0; z -= 8.0) median.push_back(front(0.0, z));
  skin.line("anterior_median_line", std::move(median));
  std::vector<Vec3> lower, upper;
  for (double x = 0.0; x <= 150.0; x += 7.5) {
    lower.push_back(front(x, clavicle_height(x) - 7.0));
    upper.push_back(front(x, clavicle_height(x) + 9.0));
  }
  skin.line("clavicle_inferior_border", std::move(lower));
  skin.line("clavicle_superior_border", std::move(upper));
  for (int rib = 1; rib <= 7; ++rib) {
    std::vector<Vec3> space;
    for (double x = 0.0; x <= 138.0; x += 6.0) space.push_back(in_space(skin, rib, x));
    // Around the side, where the arm leaves it free.
    if (rib >= 4) {
      for (double y = space.back().y() + 10.0; y < axilla_y + 6.0; y += 6.0)
        space.push_back(in_space_at_side(skin, rib, y));
    }
    std::string name = "intercostal_space_";
    skin.line(name.append(std::to_string(rib)), std::move(space));
  }
  skin.point("nipple", in_space(skin, 4, 90.0));
  skin.point("anterior_superior_iliac_spine", front(124.0, 962.0));
  skin.point("femoral_artery_at_inguinal_crease", front(64.0, 924.0));
  skin.point("axillary_fossa_centre", skin.along(Vec3(178.0, axilla_y, 1170.0), Vec3::UnitZ()));
  std::vector<Vec3> midaxillary;
  for (double z = 1286.0; z >= 1110.0; z -= 8.0) midaxillary.push_back(skin.side(axilla_y, z));
  skin.line("midaxillary_line", std::move(midaxillary));
  skin.point("rib_11_free_end", skin.side(8.0, 1092.0));
  skin.point("rib_12_free_end", skin.side(52.0, 1084.0));
  skin.point("anus", skin.along(Vec3(0.0, 52.0, 600.0), Vec3::UnitZ()));
  skin.point("external_genitalia_posterior_border", skin.along(Vec3(0.0, 10.0, 600.0), Vec3::UnitZ()));

  // The spine and the sacrum.
  for (int i = 0; i < 18; ++i) {
    std::string name = "spinous_process_";
    name.append(vertebra_names[static_cast<std::size_t>(i)]);
    const double z = spinous_height(i);
    if (i == 0 || i == 2) skin.point(name, back(0.0, z + 5.0));
    if (i != 8) skin.point(name.append("_inferior_border"), back(0.0, z));
  }
  std::vector<Vec3> hind_median, crest;
  for (double z = 1540.0; z >= 880.0; z -= 10.0) hind_median.push_back(back(0.0, z));
  skin.line("posterior_median_line", std::move(hind_median));
  for (double z = 952.0; z >= 888.0; z -= 4.0) crest.push_back(back(0.0, z));
  skin.line("median_sacral_crest", std::move(crest));
  skin.point("posterior_superior_iliac_spine", back(46.0, 928.0));
  skin.point("iliac_crest_highest_point", skin.side(8.0, 1000.0));
  skin.point("posterior_sacral_foramen_1", back(27.0, 943.0));
  skin.point("posterior_sacral_foramen_2", back(23.0, 925.0));
  skin.point("posterior_sacral_foramen_3", back(20.0, 909.0));
  skin.point("posterior_sacral_foramen_4", back(17.0, 894.0));
  skin.point("sacral_hiatus", back(0.0, 894.0));
  skin.point("coccyx_tip", back(0.0, 858.0));
  skin.point("greater_trochanter_prominence", skin.side(12.0, 885.0));

  // The shoulder blade and the shoulder.
  std::vector<Vec3> inner_edge;
  for (double z = 1380.0; z >= 1260.0; z -= 8.0) inner_edge.push_back(back(72.0, z));
  skin.line("medial_border_of_scapula", std::move(inner_edge));
  skin.point("superior_angle_of_scapula", back(74.0, 1384.0));
  skin.point("inferior_angle_of_scapula", back(88.0, spinous_height(7)));
  skin.point("spine_of_scapula_midpoint", back(114.0, 1364.0));
  skin.point("spine_of_scapula_lateral_end", back(150.0, 1380.0));
  skin.level("spine_of_scapula_inferior_border", back(140.0, 1362.0));
  const double shoulder = skin.shape().from_arm(Vec3::Zero()).x();
  const auto top = [&](double x, double y) { return skin.along(Vec3(x, y, 1560.0), -Vec3::UnitZ()); };
  skin.point("clavicle_acromial_end", top(shoulder - 30.0, 8.0));
  skin.point("acromion_lateral_end", top(shoulder - 4.0, 20.0));
  skin.point("acromion_lateral_border_anterior_end", top(shoulder - 4.0, 2.0));
  skin.point("acromial_angle", top(shoulder - 4.0, 42.0));
}

}  // namespace bodkin::patient
