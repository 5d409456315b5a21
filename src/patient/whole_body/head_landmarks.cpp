#include "patient/whole_body/body_landmarks.h"

namespace bodkin::patient {
namespace {

constexpr double pupil_x = 31.0;

// The hairline: heights (drawn mm) over the face at a distance from the median plane, falling towards the temple.
double hairline_height(double x) {
  return 1683.0 - 0.0055 * x * x;
}

// Along the sternocleidomastoid: 0 at the mastoid process, 1 at the breastbone. The angle of its front edge about the
// neck; the muscle is 32 degrees wide.
double muscle_angle(double z) {
  return 18.0 + 62.0 * (1565.0 - z) / 165.0;
}

}  // namespace

void add_head_landmarks(SkinFinder& skin) {
  const auto middle = [&](double z) { return skin.front(0.0, z); };
  const auto face = [&](double x, double z) { return skin.front(x, z); };
  const auto side = [&](double y, double z) { return skin.side(y, z); };

  skin.point("vertex_of_head", skin.along(Vec3(0.0, 8.0, 1760.0), -Vec3::UnitZ()));
  skin.point("anterior_hairline_midpoint", middle(hairline_height(0.0)));
  skin.point("posterior_hairline_midpoint", skin.back(0.0, 1538.0));
  skin.point("forehead_hairline_corner", face(59.0, hairline_height(59.0)));
  skin.point("anterior_hairline_above_pupil", face(pupil_x, hairline_height(pupil_x)));
  skin.point("anterior_hairline_above_frontal_notch", face(18.0, hairline_height(18.0)));
  skin.point("posterior_hairline_on_pupil_plane", skin.back(pupil_x, 1538.0));
  skin.point("glabella", middle(1622.0));
  skin.point("pupil", face(pupil_x, 1608.0));
  skin.point("inner_canthus", face(17.0, 1606.0));
  skin.point("outer_canthus", face(46.0, 1608.0));
  skin.point("eyebrow_above_pupil", face(pupil_x, 1625.0));
  skin.point("eyebrow_lateral_end", face(53.0, 1622.0));
  skin.point("eyebrow_medial_end", face(18.0, 1621.0));
  skin.point("frontal_notch", face(18.0, 1620.0));
  skin.level("infraorbital_margin", face(pupil_x, 1595.0));
  skin.point("infraorbital_foramen", face(30.0, 1588.0));
  skin.level("zygomatic_bone_inferior_border", face(45.0, 1577.0));
  skin.point("tip_of_nose", middle(1579.0));
  skin.level("ala_of_nose_inferior_border", face(20.0, 1573.0));
  skin.level("ala_of_nose_lateral_border_midpoint", face(20.0, 1580.0));
  skin.point("nostril_lateral_margin", face(11.0, 1572.0));
  skin.line("nasolabial_sulcus", {face(20.0, 1588.0), face(21.0, 1580.0), face(25.0, 1568.0), face(31.0, 1553.0)});
  skin.point("philtrum_superior_end", middle(1567.0));
  skin.point("philtrum_inferior_end", middle(1559.0));
  skin.level("philtrum_midpoint", middle(1563.0));
  skin.point("upper_lip_tubercle_midpoint", middle(1557.5));
  skin.point("upper_lip_frenulum_gum_junction", middle(1563.0));
  skin.point("angle_of_mouth", face(27.0, 1554.0));
  skin.point("mentolabial_sulcus_midpoint", middle(1536.0));

  // The lower jaw, the cheek arch, and about the ear.
  skin.point("angle_of_mandible", side(4.0, 1543.0));
  skin.point("masseter_prominence", side(-12.0, 1556.0));
  skin.point("masseter_attachment_anterior_edge", side(-34.0, 1527.0));
  skin.point("mandibular_notch", side(-18.0, 1581.0));
  skin.point("condylar_process_of_mandible", side(-6.0, 1590.0));
  skin.point("zygomatic_arch_inferior_border_midpoint", side(-24.0, 1588.0));
  skin.point("zygomatic_arch_superior_border_midpoint", side(-24.0, 1597.0));
  skin.point("tragus_anterior_border_centre", side(1.0, 1591.0));
  skin.point("supratragic_notch", side(2.0, 1600.0));
  skin.point("intertragic_notch", side(1.0, 1582.0));
  skin.point("auricular_apex", side(20.0, 1625.0));
  skin.point("auricular_root_anterior_border", side(3.0, 1612.0));
  skin.line("temple_hairline_posterior_border", {side(-6.0, 1585.0), side(-6.0, 1605.0), side(-6.0, 1635.0)});
  skin.point("temporal_hairline_above_auricular_apex", side(20.0, 1631.0));
  skin.point("hairline_above_auricular_root_posterior_border", side(34.0, 1626.0));
  skin.point("mastoid_process", side(40.0, 1575.0));
  skin.point("mastoid_process_inferior_end", side(36.0, 1563.0));
  skin.point("mastoid_process_posteroinferior_depression", side(44.0, 1561.0));

  // The back of the head and the nape.
  skin.point("external_occipital_protuberance_superior_border", skin.back(0.0, 1596.0));
  skin.point("external_occipital_protuberance_inferior_depression", skin.back(0.0, 1564.0));
  skin.point("spinous_process_C2_superior_border", skin.back(0.0, 1550.0));
  skin.line("trapezius_lateral_border",
            {skin.back(18.0, 1600.0), skin.back(19.0, 1575.0), skin.back(20.0, 1550.0), skin.back(24.0, 1520.0)});
  skin.point("suboccipital_depression_lateral_to_trapezius", skin.back(38.0, 1564.0));

  // The neck.
  std::vector<Vec3> front_edge, middle_line, hind_edge;
  for (double z = 1565.0; z >= 1404.0; z -= 7.0) {
    front_edge.push_back(skin.neck(z, muscle_angle(z)));
    middle_line.push_back(skin.neck(z, std::max(0.0, muscle_angle(z) - 16.0)));
    hind_edge.push_back(muscle_angle(z) >= 32.0 ? skin.neck(z, muscle_angle(z) - 32.0)
                                                : skin.neck(z, 360.0 + muscle_angle(z) - 32.0));
  }
  skin.line("sternocleidomastoid_anterior_border", std::move(front_edge));
  skin.line("sternocleidomastoid_middle_line", std::move(middle_line));
  skin.line("sternocleidomastoid_posterior_border", std::move(hind_edge));
  skin.point("hyoid_bone_superior_border", middle(1492.0));
  skin.level("thyroid_cartilage_superior_border", middle(1476.0));
  skin.level("cricoid_cartilage", middle(1440.0));
  skin.point("lesser_supraclavicular_fossa", skin.front(20.0, 1404.0));
}

}  // namespace bodkin::patient
