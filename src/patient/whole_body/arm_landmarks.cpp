#include "patient/whole_body/body_landmarks.h"

namespace bodkin::patient {
namespace {

constexpr double elbow = BodyShape::elbow, wrist = BodyShape::wrist, knuckles = BodyShape::knuckles;

}  // namespace

void add_arm_landmarks(SkinFinder& skin) {
  const auto arm = [&](double w, double angle) { return skin.arm(w, angle); };
  const auto line = [&](std::string_view name, double from, double to, double angle_from, double angle_to) {
    std::vector<Vec3> places;
    for (int i = 0; i <= 24; ++i) {
      const double t = i / 24.0;
      places.push_back(arm(from + t * (to - from), angle_from + t * (angle_to - angle_from)));
    }
    skin.line(name, std::move(places));
  };
  const auto around = [&](std::string_view name, double w, double angle_from, double angle_to) {
    line(name, w, w, angle_from, angle_to);
  };
  // From the side of a finger or the hand to the skin there.
  const auto beside = [&](double across, double w, double sign) {
    const Mat3& axes = skin.shape().arm_axes();
    return skin.along(skin.shape().from_arm(Vec3(across, 0.0, w)), sign * axes.col(0));
  };
  const auto palm = [&](double across, double w) { return skin.hand(across, w, 1.0); };
  const auto dorsum = [&](double across, double w) { return skin.hand(across, w, -1.0); };

  // Upper arm.
  skin.point("greater_tubercle_of_humerus", arm(16.0, 20.0));
  skin.point("anterior_axillary_fold", arm(88.0, 135.0));
  skin.point("posterior_axillary_fold", arm(88.0, 235.0));
  skin.point("biceps_brachii_heads_gap_at_anterior_axillary_fold", arm(88.0, 90.0));
  line("biceps_brachii_lateral_border", 60.0, elbow, 48.0, 58.0);
  line("deltoid_anterior_border", 20.0, 150.0, 62.0, 22.0);

  // Elbow.
  around("cubital_crease", elbow, 10.0, 172.0);
  skin.point("cubital_crease_medial_end", arm(elbow, 172.0));
  line("biceps_brachii_tendon_lateral_border", elbow - 40.0, elbow + 25.0, 72.0, 66.0);
  line("biceps_brachii_tendon_medial_border", elbow - 40.0, elbow + 25.0, 98.0, 94.0);
  skin.point("lateral_epicondyle_of_humerus", arm(elbow - 8.0, 355.0));
  skin.point("medial_epicondyle_of_humerus", arm(elbow - 8.0, 186.0));
  skin.point("olecranon_prominence", arm(elbow + 2.0, 270.0));

  // Forearm and wrist.
  around("wrist_crease_palmar", wrist, 5.0, 175.0);
  around("wrist_crease_dorsal", wrist + 4.0, 185.0, 355.0);
  skin.point("wrist_crease_palmar_midpoint", arm(wrist, 92.0));
  line("radial_artery", wrist - 60.0, wrist + 12.0, 52.0, 46.0);
  line("flexor_carpi_ulnaris_tendon_radial_border", wrist - 90.0, wrist + 10.0, 140.0, 146.0);
  line("abductor_pollicis_longus_groove", wrist - 70.0, wrist + 10.0, 20.0, 14.0);
  line("head_of_ulna_radial_edge", wrist - 70.0, wrist + 8.0, 238.0, 236.0);
  line("ulna_radial_border_posterior", elbow + 30.0, wrist, 248.0, 246.0);
  line("extensor_digitorum_tendon_ulnar_border", wrist - 40.0, wrist + 20.0, 256.0, 255.0);
  skin.point("ulnar_styloid_process", arm(wrist - 4.0, 205.0));
  skin.point("anatomical_snuffbox", arm(wrist + 6.0, 338.0));

  // Hand.
  skin.point("triquetrum", beside(-8.0, wrist + 14.0, -1.0));
  skin.point("fifth_metacarpal_base", beside(-8.0, wrist + 34.0, -1.0));
  const auto thumb = [&](double w, double across) {
    return skin.along(skin.shape().from_arm(Vec3(across, 15.0, w)), skin.shape().arm_axes().col(0));
  };
  line("red_white_flesh_border_radial_hand", 560.0, 640.0, 0.0, 0.0);
  {
    std::vector<Vec3> border;
    for (double w = 572.0; w <= 626.0; w += 3.0) border.push_back(thumb(w, 26.0 + 0.64 * (w - 572.0)));
    skin.line("red_white_flesh_border_radial_hand", std::move(border));
  }
  skin.level("first_metacarpal_midpoint", thumb(598.0, 42.0));
  skin.point("second_metacarpal_midpoint", dorsum(31.0, 612.0));
  skin.line("second_intermetacarpal_space",
            {palm(18.0, 590.0), palm(19.0, 605.0), palm(20.0, 620.0), palm(20.0, 635.0), palm(20.0, 646.0)});
  skin.point("second_metacarpophalangeal_joint_radial_side", beside(25.0, knuckles, 1.0));
  skin.point("third_metacarpophalangeal_joint", dorsum(10.0, knuckles + 1.0));
  skin.point("fourth_metacarpophalangeal_joint", dorsum(-10.5, knuckles - 2.0));
  skin.level("fifth_metacarpophalangeal_joint", dorsum(-30.0, knuckles - 6.0));
  skin.point("fifth_metacarpophalangeal_joint_ulnar_side", beside(-25.0, knuckles - 6.0, -1.0));
  skin.line("fourth_intermetacarpal_space",
            {palm(-16.0, 590.0), palm(-18.0, 605.0), palm(-19.0, 620.0), palm(-20.0, 635.0), palm(-20.0, 646.0)});
  skin.point("fourth_fifth_finger_web_margin", dorsum(-20.5, knuckles + 8.0));
  skin.point("middle_finger_pip_crease_radial_end", beside(10.5, knuckles + 42.0, 1.0));
  skin.point("middle_finger_dip_crease_radial_end", beside(10.7, knuckles + 65.0, 1.0));
  skin.point("index_finger_radial_side_at_pip_level", beside(33.0, knuckles + 42.0, 1.0));
  skin.point("little_finger_ulnar_side_at_pip_level", beside(-34.0, knuckles + 42.0, -1.0));
  skin.point("middle_fingertip_centre",
             skin.along(skin.shape().from_arm(Vec3(11.0, 0.0, knuckles + 60.0)), skin.shape().arm_axes().col(2)));
  // Corners of the nails: on the back of the finger, a little to its side.
  skin.point("index_fingernail_radial_corner", dorsum(39.5, knuckles + 68.0));
  skin.point("ring_fingernail_ulnar_corner", dorsum(-17.0, knuckles + 70.0));
  skin.point("little_fingernail_radial_corner", dorsum(-32.5, knuckles + 54.0));
  skin.point("little_fingernail_ulnar_corner", dorsum(-40.0, knuckles + 54.0));
  skin.point("thumbnail_radial_corner", dorsum(79.0, 672.0));
  skin.point("thumb_interphalangeal_joint_radial_side", thumb(648.0, 66.0));
  skin.point("thumb_interphalangeal_joint_ulnar_side",
             skin.along(skin.shape().from_arm(Vec3(66.0, 15.0, 648.0)), -skin.shape().arm_axes().col(0)));
  // With the arm hanging, the fingertip is this far below the shoulder's joint.
  const Vec3 joint = skin.shape().from_arm(Vec3::Zero());
  skin.level("middle_fingertip_arm_hanging", skin.leg(joint.z() - BodyShape::fingertip, 0.0));
}

}  // namespace bodkin::patient
