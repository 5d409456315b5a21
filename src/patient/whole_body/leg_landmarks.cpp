#include "patient/whole_body/body_landmarks.h"

namespace bodkin::patient {
namespace {

constexpr double knee = 450.0;  // the fold behind it, and the tip of the kneecap
constexpr double outer_ankle = 66.0, inner_ankle = 75.0;

}  // namespace

void add_leg_landmarks(SkinFinder& skin) {
  const auto leg = [&](double z, double angle) { return skin.leg(z, angle); };
  const auto line = [&](std::string_view name, double from, double to, double angle_from, double angle_to) {
    std::vector<Vec3> places;
    for (int i = 0; i <= 32; ++i) {
      const double t = i / 32.0;
      places.push_back(leg(from + t * (to - from), angle_from + t * (angle_to - angle_from)));
    }
    skin.line(name, std::move(places));
  };

  // Thigh.
  line("iliotibial_band_posterior_border", 820.0, 455.0, 345.0, 340.0);
  line("gracilis_sartorius_gap", 800.0, 480.0, 160.0, 186.0);
  skin.point("gluteal_fold_midpoint", skin.back(88.0, 792.0));

  // Knee.
  skin.level("patella_superior_border", leg(498.0, 90.0));
  skin.point("patella_base_lateral_end", leg(496.0, 66.0));
  skin.point("patella_base_medial_end", leg(496.0, 114.0));
  skin.point("patella_apex", leg(knee, 90.0));
  skin.point("infrapatellar_depression_lateral", leg(446.0, 66.0));
  line("popliteal_crease", knee, knee, 195.0, 345.0);
  skin.point("popliteal_crease_midpoint", leg(knee, 270.0));
  skin.point("popliteal_crease_medial_end", leg(knee, 198.0));
  line("biceps_femoris_tendon_medial_border", 520.0, 435.0, 304.0, 312.0);
  line("semitendinosus_tendon_lateral_border", 520.0, 430.0, 236.0, 228.0);
  skin.point("lateral_epicondyle_of_femur_posteroproximal_depression", leg(474.0, 346.0));

  // Leg.
  skin.point("head_of_fibula_anterodistal_depression", leg(408.0, 16.0));
  skin.level("medial_condyle_of_tibia_inferior_border", leg(400.0, 170.0));
  line("tibia_medial_border_posterior_edge", 408.0, 80.0, 188.0, 196.0);
  line("tibia_medial_surface_midline", 400.0, 90.0, 140.0, 152.0);
  line("tibialis_anterior_lateral_border", 420.0, 100.0, 52.0, 62.0);
  line("fibula_anterior_border", 415.0, 78.0, 12.0, 8.0);
  line("fibula_posterior_border", 415.0, 78.0, 344.0, 338.0);
  skin.point("gastrocnemius_calcaneal_tendon_junction", leg(knee - 0.5 * (knee - outer_ankle), 270.0));

  // Ankle.
  const auto outside = [&](double y, double z) { return skin.along(Vec3(80.0, y, z), Vec3::UnitX()); };
  const auto inside = [&](double y, double z) { return skin.along(Vec3(80.0, y, z), -Vec3::UnitX()); };
  skin.point("lateral_malleolus_prominence", outside(34.0, outer_ankle));
  skin.point("medial_malleolus_prominence", inside(24.0, inner_ankle));
  skin.point("lateral_malleolus_inferior_border", outside(34.0, outer_ankle - 17.0));
  skin.point("lateral_malleolus_anterodistal_depression", outside(14.0, outer_ankle - 15.0));
  std::vector<Vec3> tendon;
  for (double z = 180.0; z >= 40.0; z -= 5.0) tendon.push_back(leg(z, 270.0));
  skin.line("calcaneal_tendon", std::move(tendon));
  skin.point("calcaneal_tendon_anterior_border_at_medial_malleolus", inside(56.0, inner_ankle));
  skin.point("calcaneal_tendon_medial_attachment", inside(60.0, 52.0));
}

void add_foot_landmarks(SkinFinder& skin) {
  const auto top = [&](double x, double y) { return skin.foot(x, y); };
  const auto outside = [&](double x, double y, double z) { return skin.along(Vec3(x, y, z), Vec3::UnitX()); };
  const auto inside = [&](double x, double y, double z) { return skin.along(Vec3(x, y, z), -Vec3::UnitX()); };

  skin.level("sole", Vec3(80.0, 0.0, 0.0));
  skin.point("heel_posterior_border", Vec3(78.0, 82.0, 0.0));
  std::vector<Vec3> outer_border, inner_border;
  for (double y = 75.0; y >= -125.0; y -= 8.0) {
    const double middle = y > -80.0 ? 88.0 : 131.0;
    outer_border.push_back(outside(middle, y, y > -80.0 ? 12.0 : 8.0));
    if (y > -112.0) inner_border.push_back(inside(y > -70.0 ? 74.0 : 62.0, y, 16.0));
  }
  skin.line("red_white_flesh_border_lateral_foot", std::move(outer_border));
  skin.line("red_white_flesh_border_medial_foot", std::move(inner_border));

  // Inner side.
  skin.point("navicular_tuberosity", inside(76.0, -8.0, 48.0));
  skin.point("navicular_tuberosity_inferior_border", inside(76.0, -8.0, 38.0));
  skin.point("first_metatarsal_base_medial_side", inside(74.0, -44.0, 22.0));
  skin.point("first_metatarsophalangeal_joint_medial_side", inside(64.0, -106.0, 16.0));

  // The back of the foot.
  skin.point("second_metatarsal_intermediate_cuneiform_joint", top(82.0, -34.0));
  skin.point("first_second_metatarsal_bases_junction", top(73.0, -44.0));
  skin.point("fourth_fifth_metatarsal_bases_junction", top(106.0, -34.0));
  skin.line("second_intermetatarsal_space",
            {top(86.0, -45.0), top(88.0, -60.0), top(90.0, -75.0), top(91.0, -90.0), top(92.0, -108.0)});
  skin.line("fourth_intermetatarsal_space",
            {top(107.0, -36.0), top(112.0, -50.0), top(117.0, -65.0), top(121.0, -80.0), top(123.0, -92.0)});
  skin.level("second_metatarsophalangeal_joint", top(83.0, -108.0));
  skin.level("fourth_metatarsophalangeal_joint", top(117.0, -94.0));
  skin.point("first_second_toe_web_margin", top(72.0, -122.0));
  skin.point("second_third_toe_web_margin", top(92.0, -121.0));
  skin.point("fourth_fifth_toe_web_margin", top(124.5, -103.0));
  skin.point("great_toenail_medial_corner", top(52.0, -152.0));
  skin.point("great_toenail_lateral_corner", top(68.0, -152.0));
  skin.point("second_toenail_lateral_corner", top(89.0, -153.0));
  skin.point("fourth_toenail_lateral_corner", top(123.5, -132.0));
  skin.point("little_toenail_lateral_corner", top(138.5, -116.0));

  // Outer side.
  skin.point("cuboid_inferior_border", outside(88.0, -6.0, 16.0));
  skin.point("fifth_metatarsal_tuberosity_distal_border", outside(88.0, -32.0, 16.0));
  skin.point("fifth_metatarsophalangeal_joint_proximal_depression", outside(92.0, -74.0, 13.0));
  skin.point("fifth_metatarsophalangeal_joint_distal_depression", outside(128.0, -98.0, 10.0));
}

}  // namespace bodkin::patient
