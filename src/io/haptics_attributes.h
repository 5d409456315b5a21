#pragma once

#include "anatomy/force_settings.h"

namespace bodkin {

// What case files call the settings of the force models: each_attribute(settings, visit) calls visit(name, member)
// for each number, word or truth of the settings, in the order in which they are written. Names end with their unit.
// Ranges and defaults stand in share/bodkin/case.xsd. Lists and parts inside a model (layers, transfer points,
// directions of friction) are elements of their own.

void each_attribute(LayeredSettings& s, const auto& visit) {
  visit("law", s.law);
  visit("strict", s.strict);
  visit("layer_mm", s.layer);
}

void each_attribute(SpringDamperWallSettings& s, const auto& visit) {
  visit("stiffness_N_per_mm", s.stiffness);
  visit("damping_N_s_per_mm", s.damping);
  visit("wall_mm", s.wall);
  visit("limit_N", s.limit);
}

void each_attribute(TrackingWallSettings& s, const auto& visit) {
  visit("leash", s.leash);
  visit("surface_mm", s.surface);
  visit("catch_up_s", s.catch_up);
  visit("strict", s.strict);
  visit("limit_N", s.limit);
  visit("channel_radius_mm", s.channel_radius);
  visit("channel_tilt_deg", s.channel_tilt);
}

void each_attribute(TrackingWallDepthLayer& s, const auto& visit) {
  visit("from_mm", s.from);
  visit("stiffness_N_per_mm", s.layer.stiffness);
  visit("force_N", s.layer.force);
}

void each_attribute(DepthProfileSettings& s, const auto& visit) {
  visit("skin_stiffness_N_per_mm", s.skin_stiffness);
  visit("puncture_depth_mm", s.puncture_depth);
  visit("trailing_mm", s.trailing);
  visit("bone_stiffness_N_per_mm", s.bone_stiffness);
  visit("limit_N", s.limit);
  visit("release_s", s.release);
  visit("filter_Hz", s.filter);
  visit("stiffening_N_per_mm_s", s.stiffening);
  visit("hysteresis_mm", s.hysteresis);
  visit("channel_radius_mm", s.channel_radius);
  visit("channel_tilt_deg", s.channel_tilt);
}

void each_attribute(VolumeProxySettings& s, const auto& visit) {
  visit("stiffness_N_per_mm", s.stiffness);
  visit("gradient_reference_per_mm", s.gradient_reference);
  visit("gradient_least_per_mm", s.gradient_least);
  visit("variant", s.variant);
  visit("two_sided", s.two_sided);
  visit("limit_N", s.limit);
  visit("field_ct_range", s.field.ct_range);
  visit("field_lowest_HU", s.field.lowest_hounsfield);
  visit("field_highest_HU", s.field.highest_hounsfield);
  visit("field_smoothing_voxels", s.field.smoothing);
}

void each_attribute(TransferPoint& s, const auto& visit) {
  visit("value", s.value);
  visit("penetrability_N", s.properties.penetrability);
  visit("friction_N", s.properties.friction);
  visit("drag_N", s.properties.drag);
  visit("viscosity_N_s_per_mm", s.properties.viscosity);
}

void each_attribute(ThreeComponentSettings& s, const auto& visit) {
  visit("linear_N_per_mm", s.linear);
  visit("quadratic_N_per_mm2", s.quadratic);
  visit("puncture_force_N", s.puncture_force);
  visit("cutting_force_N", s.cutting_force);
  visit("cutting_stiffness_N_per_mm", s.cutting_stiffness);
  visit("dead_band_mm_per_s", s.dead_band);
  visit("hold_N_per_mm2", s.hold);
  visit("limit_N", s.limit);
}

void each_attribute(KarnoppFriction& s, const auto& visit) {
  visit("coulomb_N_per_mm", s.coulomb);
  visit("viscous_N_s_per_mm2", s.viscous);
  visit("static_N_per_mm", s.static_force);
}

void each_attribute(FractureSettings& s, const auto& visit) {
  visit("stiffness_N_per_mm", s.stiffness);
  visit("spacing_mm", s.spacing);
  visit("toughness_N_per_mm", s.toughness);
  visit("width_mm", s.width);
  visit("thickness_mm", s.thickness);
  visit("cutting_stiffness_N_per_mm", s.cutting_stiffness);
  visit("cutting_toughness_N_per_mm", s.cutting_toughness);
  visit("limit_N", s.limit);
}

void each_attribute(ShaftFrictionSettings& s, const auto& visit) {
  visit("stribeck_velocity_mm_per_s", s.stribeck_velocity);
}

void each_attribute(DeformableBodySettings& s, const auto& visit) {
  visit("corridor_radius_mm", s.corridor_radius);
  visit("corridor_beyond_mm", s.corridor_beyond);
  visit("corridor_nodes", s.corridor_nodes);
  visit("stiffness_scale", s.stiffness_scale);
  visit("fix_bone", s.fix_bone);
  visit("fix_cut", s.fix_cut);
  visit("fix_beyond_mm", s.fix_beyond);
}

void each_attribute(NeedleBendingSettings& s, const auto& visit) {
  visit("flexible", s.flexible);
  visit("modulus_MPa", s.modulus);
  visit("stylet", s.stylet);
  visit("hold", s.hold);
  visit("cut_offset_mm", s.cut_offset);
}

void each_attribute(EmbeddedNeedleSettings& s, const auto& visit) {
  visit("capture_radius_mm", s.capture_radius);
  visit("spacing_mm", s.spacing);
  visit("puncture_time_s", s.puncture_time);
  each_attribute(s.bending, visit);
  each_attribute(s.body, visit);
}

void each_attribute(ClosestNodeSettings& s, const auto& visit) {
  visit("capture_radius_mm", s.capture_radius);
  visit("presliding_N_per_mm", s.presliding);
  visit("relaxation_s", s.relaxation);
  visit("layer_mm", s.layer);
  visit("longest_mm", s.longest);
  each_attribute(s.body, visit);
}

void each_attribute(LineSpringSettings& s, const auto& visit) {
  visit("stiffness_N_per_mm", s.stiffness);
  visit("damping_N_s_per_mm", s.damping);
  visit("limit_N", s.limit);
}

void each_attribute(PivotSettings& s, const auto& visit) {
  visit("stiffness_N_per_mm", s.stiffness);
  visit("gain", s.gain);
  visit("limit_N", s.limit);
  visit("shortest_outside_mm", s.shortest_outside);
  visit("largest_angle_rad", s.largest_angle);
}

void each_attribute(RailSettings& s, const auto& visit) {
  visit("stiffness_N_per_mm", s.stiffness);
  visit("limit_N", s.limit);
  visit("torsion_N_mm_per_rad", s.torsion);
  visit("full_depth_mm", s.full_depth);
  visit("torque_limit_N_mm", s.torque_limit);
}

void each_attribute(BeamSettings& s, const auto& visit) {
  visit("modulus_MPa", s.modulus);
  visit("stylet", s.stylet);
  visit("largest_stiffness_N_per_mm", s.largest_stiffness);
  visit("limit_N", s.limit);
  visit("smoothing_Hz", s.smoothing);
}

void each_attribute(NoConstraint&, const auto&) {}

void each_attribute(PronyTerm& s, const auto& visit) {
  visit("share", s.share);
  visit("time_s", s.time);
}

void each_attribute(NeedleGraspSettings& s, const auto& visit) {
  visit("one_way", s.one_way);
  visit("two_way", s.two_way);
  visit("point", s.point);
  visit("turns_to_wind", s.turns_to_wind);
}

// Without the direction `up`, which is given whole or not at all.
void each_attribute(GravitySettings& s, const auto& visit) {
  visit("weight_N", s.weight);
  visit("slope_x_N_per_mm", s.slope.x());
  visit("slope_y_N_per_mm", s.slope.y());
  visit("slope_z_N_per_mm", s.slope.z());
  visit("centre_x_mm", s.centre.x());
  visit("centre_y_mm", s.centre.y());
  visit("centre_z_mm", s.centre.z());
  visit("limit_N", s.limit);
}

}  // namespace bodkin
