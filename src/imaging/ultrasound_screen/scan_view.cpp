#include "imaging/ultrasound_screen/scan_view.h"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "imaging/slice.h"
#include "imaging/ultrasound_screen/skin.h"

namespace bodkin::imaging {

namespace {

constexpr double beside_midline = 15.0;  // mm on the skin
constexpr double beside_probe = 8.0;     // mm of skin between the probe's end and the needle
constexpr double entry_reach = 60.0;     // mm up or down to the skin beside the entry

constexpr std::array<std::pair<std::string_view, ScanView>, 5> scan_views = {{
    {"paramedian", ScanView::paramedian},
    {"sagittal", ScanView::sagittal},
    {"transverse", ScanView::transverse},
    {"needle", ScanView::needle},
    {"kidney", ScanView::kidney},
}};

std::string point_words(const Vec3& point) {
  return fmt::format("{:.1f},{:.1f},{:.1f}", point.x(), point.y(), point.z());
}

Vec3 middle_of_body(const anatomy::Case& patient) {
  const PatientBox body = body_box(patient.tissues);
  return 0.5 * (body.low + body.high);
}

Vec3 kidney_of(const anatomy::Case& patient) {
  for (const char* name : {"kidney_left", "left_kidney", "kidney_right", "right_kidney", "kidney"}) {
    if (const std::optional<Vec3> place = place_named(patient, name)) return *place;
  }
  throw InputError("the case has no structure kidney_left or kidney_right to look at; say where with --at x,y,z");
}

Vec3 view_target(const anatomy::Case& patient, const ScanRequest& request) {
  if (request.at) return *request.at;
  if (request.view == ScanView::kidney) return kidney_of(patient);
  const std::optional<anatomy::NeedlePath>& path = patient.description.procedure.path;
  return path ? path->target : middle_of_body(patient);
}

// Towards the probe, before a view tilts it.
Vec3 outward_direction(const anatomy::Case& patient, const ScanRequest& request, const Vec3& at) {
  if (request.outward) return request.outward->normalized();
  if (request.view == ScanView::kidney) {
    const double side = at.x() < middle_of_body(patient).x() ? -1.0 : 1.0;
    return Vec3(side, 0.8, 0.0).normalized();  // from the flank, behind the bowel and its gas
  }
  const std::optional<anatomy::NeedlePath>& path = patient.description.procedure.path;
  return path && !request.at ? Vec3(-path->direction()) : Vec3(Vec3::UnitY());
}

Vec3 marked_side(ScanView view, const Vec3& outward) {
  if (view != ScanView::transverse) return std::abs(outward.normalized().z()) > 0.9 ? Vec3::UnitY() : Vec3::UnitZ();
  return std::abs(outward.normalized().x()) > 0.9 ? Vec3::UnitY() : Vec3(-Vec3::UnitX());
}

SkinPoint skin_from(const anatomy::Case& patient, const Vec3& at, const Vec3& outward) {
  if (anatomy::nearest(patient.tissues, at, anatomy::tissue::air) == anatomy::tissue::air) {
    throw InputError(
        fmt::format("the point {} to look at is not in the body, expected one inside it, LPS mm", point_words(at)));
  }
  const std::optional<SkinPoint> skin = skin_along(patient.tissues, at, outward);
  if (skin) return *skin;
  throw InputError(
      fmt::format("the CT ends before the skin is reached from {} towards {}; choose another side with --from",
                  point_words(at), direction_letters(outward)));
}

// Beside the entry, on the head's side, or on the feet's if the image ends there.
ProbeOnSkin beside_needle(const anatomy::Case& patient, const anatomy::UltrasoundProbe& probe) {
  const std::optional<anatomy::NeedlePath>& path = patient.description.procedure.path;
  if (!path)
    throw InputError("the case has no planned path, which the view 'needle' looks at; choose another --view");
  const Vec3 in = path->direction();
  const Vec3 along = Vec3::UnitZ() - Vec3::UnitZ().dot(in) * in;
  if (!(along.norm() > 0.1))
    throw InputError("the planned path runs along the body, so that no probe can stand next to it");
  for (const double side : {1.0, -1.0}) {
    const Vec3 beside = path->entry + side * (0.5 * probe.aperture() + beside_probe) * along.normalized();
    const std::optional<SkinPoint> skin = skin_near(patient.tissues, beside, -in, entry_reach);
    if (!skin) continue;
    // Half-way between upright, with the best contact, and facing the target; the plane remains the path's.
    const Vec3 normal = along.cross(in).normalized();
    const Vec3 upright = (normal.dot(skin->outward) * normal - skin->outward).normalized();
    return {probe_pose(skin->place, upright + (path->target - skin->place).normalized(), Vec3::UnitZ()),
            skin->outward};
  }
  throw InputError("there is no skin next to the planned entry for the probe to stand on; choose another --view");
}

}  // namespace

std::optional<ScanView> scan_view_from(std::string_view name) {
  for (const auto& [word, view] : scan_views) {
    if (word == name) return view;
  }
  return std::nullopt;
}

std::string scan_view_names() {
  std::string names;
  for (const auto& [word, view] : scan_views) names += (names.empty() ? "" : ", ") + std::string(word);
  return names;
}

std::optional<Vec3> place_named(const anatomy::Case& patient, std::string_view name) {
  for (const anatomy::Landmark& landmark : patient.description.landmarks) {
    if (landmark.name == name) return landmark.position;
  }
  for (const anatomy::Structure& structure : patient.description.structures) {
    if (structure.name != name) continue;
    const anatomy::LabelVolume& labels = patient.structures;
    Vec3 sum = Vec3::Zero();
    double voxels = 0.0;
    for (int k = 0; k < labels.grid.size[2]; ++k) {
      for (int j = 0; j < labels.grid.size[1]; ++j) {
        for (int i = 0; i < labels.grid.size[0]; ++i) {
          if (labels.at(i, j, k) != structure.label) continue;
          sum += Vec3(i, j, k);
          voxels += 1.0;
        }
      }
    }
    if (voxels > 0.0) return labels.grid.to_patient(sum / voxels);
  }
  return std::nullopt;
}

ProbeOnSkin place_probe(const anatomy::Case& patient, const anatomy::UltrasoundProbe& probe,
                        const ScanRequest& request) {
  if (request.view == ScanView::needle && !request.at && !request.outward) return beside_needle(patient, probe);
  const Vec3 at = view_target(patient, request);
  Vec3 outward = outward_direction(patient, request, at);
  SkinPoint skin = skin_from(patient, at, outward);
  if (request.view == ScanView::paramedian) {
    const double side = skin.place.x() < at.x() - 1.0 ? -1.0 : 1.0;
    const Vec3 beside = skin.place + side * beside_midline * Vec3::UnitX();
    if (const std::optional<SkinPoint> found = skin_near(patient.tissues, beside, outward, entry_reach))
      skin = *found;
    outward = skin.place - at;
  }
  return {probe_pose(skin.place, -outward, marked_side(request.view, outward)), skin.outward};
}

}  // namespace bodkin::imaging
