#include "tracking/augmented_view.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "tracking/station_footage.h"
#include <fmt/format.h>

#include "imaging/canvas.h"
#include "imaging/slice.h"

namespace bodkin::tracking {

namespace {

constexpr double unseen_motion = 0.1;  // pixels
constexpr double unseen_press = 0.05;  // mm of tissue, less than such a pixel at an arm's length
constexpr int pictures_to_rest = 3;    // without motion, until the rays are dense again

constexpr std::uint32_t steel = 0xDDE6EE, alarm = 0xFF4B3E, good = 0x7BE38B, warning = 0xFFC84A, planned = 0x59B8FF;

imaging::RayCaster caster_of(std::shared_ptr<const imaging::PreparedVolume> volume, const AugmentedLook& look) {
  imaging::VolumeLook colours;
  colours.transfer = imaging::preset_function(look.preset);
  const double step = imaging::step_of(*volume, look.step);
  return {std::move(volume), colours, step};
}

std::uint32_t colour_of(TrackingStatus status) {
  return status == TrackingStatus::ok ? good : status == TrackingStatus::uncertain ? warning : alarm;
}

Similarity composed(const Pose& outer, const Similarity& inner) {
  Similarity made;
  made.turn = outer.linear() * inner.turn;
  made.scale = inner.scale;
  made.shift = outer * inner.shift;
  return made;
}

// The tissue now at a place (LPS mm).
anatomy::TissueId tissue_at(const anatomy::Case& patient, const Vec3& place,
                            const imaging::TissueDisplacement* moved) {
  return anatomy::nearest(patient.tissues, moved != nullptr ? moved->at_rest(place) : place, anatomy::tissue::air);
}

// mm from the body's origin to where its sheets end in the direction of its axis, where the shaft begins.
double end_of_hub(const MarkerBody& body) {
  double end = 0.0;
  for (const MarkerFace& face : body.faces) {
    const double half = 0.5 * face.sheet;
    for (const Vec3& corner :
         {Vec3(-half, -half, 0.0), Vec3(half, -half, 0.0), Vec3(half, half, 0.0), Vec3(-half, half, 0.0)})
      end = std::max(end, body.axis.dot(face.place * corner));
  }
  return end;
}

// The faces of a body remain as the camera saw them.
void keep_in_front(const ShownBody& tool, const CameraModel& camera, const imaging::ImageRgb& before,
                   imaging::ImageRgb& picture) {
  for (const MarkerFace& face : tool.body->faces) {
    const Pose place = tool.pose->camera_from_body * face.place;
    if (place.linear().col(2).dot(place.translation()) <= 0.0) continue;
    const double half = 0.5 * face.sheet;
    const Vec3 corners[4] = {{-half, -half, 0.0}, {half, -half, 0.0}, {half, half, 0.0}, {-half, half, 0.0}};
    Eigen::Vector2d at[4];
    Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
    bool before_camera = true;
    for (int c = 0; c < 4; ++c) {
      const Vec3 point = place * corners[c];
      before_camera = before_camera && point.z() > 10.0;
      at[c] = camera.project(point);
      low = low.cwiseMin(at[c]);
      high = high.cwiseMax(at[c]);
    }
    if (!before_camera) continue;
    const int right = std::min(picture.width - 1, static_cast<int>(high.x()));
    const int bottom = std::min(picture.height - 1, static_cast<int>(high.y()));
    for (int y = std::max(0, static_cast<int>(low.y())); y <= bottom; ++y) {
      for (int x = std::max(0, static_cast<int>(low.x())); x <= right; ++x) {
        bool inside = true;
        for (int c = 0; c < 4; ++c) {
          const Eigen::Vector2d edge = at[(c + 1) % 4] - at[c], to = Eigen::Vector2d(x, y) - at[c];
          inside = inside && edge.x() * to.y() - edge.y() * to.x() >= -edge.norm();  // and a pixel around
        }
        if (inside) picture.at(x, y) = before.at(x, y);
      }
    }
  }
}

}  // namespace

Similarity placed_at(const anatomy::Case& patient, const Vec3& at) {
  if (patient.description.procedure.path) return placed_along(*patient.description.procedure.path, at);
  const anatomy::Grid& grid = patient.ct.grid;
  Vec3 middle = Vec3::Zero();
  if (!patient.ct.empty()) middle = grid.to_patient(0.5 * Vec3(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1));
  return placed_along({middle, middle - Vec3::UnitY()}, at);
}

AugmentedView::AugmentedView(const anatomy::Case& patient, const CameraModel& camera,
                             const Similarity& mannequin_from_patient, const AugmentedLook& look)
    : patient_(patient),
      camera_(camera),
      mannequin_from_patient_(mannequin_from_patient),
      look_(look),
      volume_(std::make_shared<const imaging::PreparedVolume>(
          imaging::prepare_volume(patient.ct, patient.tissues, patient.library))),
      caster_(caster_of(volume_, look)),
      rays_(ray_table(camera)) {}

void AugmentedView::set_look(const AugmentedLook& look) {
  if (look.preset != look_.preset || look.step != look_.step) {
    caster_ = caster_of(volume_, look);
    cast_tissue_.reset();
  }
  look_ = look;
  cast_at_.reset();
}

Vec3 AugmentedView::region() const {
  if (look_.region) return *look_.region;
  if (patient_.description.procedure.path) return patient_.description.procedure.path->target;
  if (patient_.ct.empty()) return Vec3::Zero();
  const auto& size = patient_.ct.grid.size;
  return patient_.ct.grid.to_patient(0.5 * Vec3(size[0] - 1, size[1] - 1, size[2] - 1));
}

// Maximum displacement in pixels of the patient around the region between two places.
double AugmentedView::moved(const Similarity& from, const Similarity& to) const {
  constexpr double around = 80.0;  // mm
  double most = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 offset(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    const Vec3 point = region() + around * (2.0 * offset - Vec3::Ones());
    const std::optional<Eigen::Vector2d> before = pixel_of(from * point), after = pixel_of(to * point);
    if (before && after) most = std::max(most, (*after - *before).norm());
  }
  return most;
}

// Gives the rays the tissue's displacements; true if these have changed since the last cast.
bool AugmentedView::press(const imaging::TissueDisplacement* tissue) {
  const bool known = tissue != nullptr && cast_tissue_.has_value();
  if (known ? tissue->most_difference(*cast_tissue_) <= unseen_press
            : (tissue != nullptr) == cast_tissue_.has_value())
    return false;
  cast_tissue_.reset();
  if (tissue != nullptr) {
    cast_tissue_.emplace(*tissue);
    const imaging::RestOffsets offsets = tissue->rest_offsets();
    caster_.set_moved(&offsets);
  } else {
    caster_.set_moved(nullptr);
  }
  return true;
}

// The rays of an earlier image are reused if neither the patient nor his tissue has moved; while either moves they
// are half as dense in both directions.
void AugmentedView::draw_patient(imaging::ImageRgb& picture, const Similarity& camera_from_patient,
                                 const imaging::TissueDisplacement* tissue) {
  const bool pressed = press(tissue);
  if (pressed) cast_at_.reset();
  const bool still = !last_ || (!pressed && moved(*last_, camera_from_patient) <= unseen_motion);
  at_rest_ = !last_ ? pictures_to_rest : still ? std::min(at_rest_ + 1, pictures_to_rest) : 0;
  last_ = camera_from_patient;
  const bool moves = look_.coarse_while_moving && at_rest_ < pictures_to_rest;
  const std::optional<Eigen::Vector2d> centre = pixel_of(camera_from_patient * region());
  if (!centre) return;
  if (!cast_at_ || moved(*cast_at_, camera_from_patient) > unseen_motion || (coarse_by_motion_ && !moves)) {
    const auto begin = std::chrono::steady_clock::now();
    const Similarity patient_from_camera = camera_from_patient.inverse();
    imaging::PictureCamera eye;
    eye.patient_from_camera.linear() = patient_from_camera.turn;
    eye.patient_from_camera.translation() = patient_from_camera.shift;
    eye.scale = patient_from_camera.scale;
    eye.ray = [this](const Eigen::Vector2d& pixel) -> Vec3 {
      const int x = static_cast<int>(pixel.x()), y = static_cast<int>(pixel.y());
      if (x < 0 || y < 0 || x >= camera_.width || y >= camera_.height) return camera_.ray(pixel);
      const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(y) * camera_.width + x;
      const Eigen::Vector2f& ray = rays_[static_cast<std::size_t>(at)];
      return {static_cast<double>(ray.x()), static_cast<double>(ray.y()), 1.0};
    };
    cutaway_ = imaging::cast_cutaway(caster_, eye, {*centre, look_.radii, look_.threshold}, picture.width,
                                     picture.height, pool_, moves);
    cast_at_ = camera_from_patient;
    coarse_by_motion_ = moves;
    cast_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  imaging::blend_cutaway(cutaway_, pool_, picture);
  is_shown_ = cutaway_.rays > 0;
}

std::optional<Eigen::Vector2d> AugmentedView::pixel_of(const Vec3& in_camera) const {
  if (in_camera.z() < 10.0) return std::nullopt;
  // Far outside the image the lens's polynomial folds back.
  const Eigen::Vector2d slope = in_camera.head<2>() / in_camera.z();
  if (slope.norm() > 1.5 * std::hypot(0.5 * camera_.width / camera_.fx, 0.5 * camera_.height / camera_.fy))
    return std::nullopt;
  return camera_.project(in_camera);
}

void AugmentedView::draw(imaging::ImageRgb& picture, const TrackedPose* mannequin,
                         const std::vector<ShownBody>& tools, const imaging::TissueDisplacement* moved) {
  needle_.reset();
  is_shown_ = false;
  cast_seconds_ = 0.0;
  const TrackedPose* needle = nullptr;
  const MarkerBody* needle_body = nullptr;
  for (const ShownBody& tool : tools) {
    if (tool.body->name != "needle") continue;
    needle = tool.pose;
    needle_body = tool.body;
  }
  if (mannequin != nullptr && mannequin->status == TrackingStatus::ok) {
    const Similarity camera_from_patient = composed(mannequin->camera_from_body, mannequin_from_patient_);
    before_ = picture;
    draw_patient(picture, camera_from_patient, moved);
    const auto keep_tools = [&] {
      for (const ShownBody& tool : tools) {
        if (tool.pose->status == TrackingStatus::ok) keep_in_front(tool, camera_, before_, picture);
      }
    };
    // A needle that points away from the camera begins behind its cube.
    const bool away = needle == nullptr || (needle->camera_from_body.linear() * needle_body->axis).z() > 0.0;
    if (!away) keep_tools();
    draw_tools(picture, camera_from_patient, needle, needle_body, moved);
    if (away) keep_tools();
    if (look_.front_view && needle_) draw_front_view(picture, moved);
  } else {
    last_.reset();
  }
  if (!look_.status) return;
  imaging::Canvas canvas(picture.width, picture.height);
  double line = 24.0;
  const auto write = [&](const std::string& text, std::uint32_t colour) {
    canvas.text({14.0, line}, text, {.size = 16.0, .ink = colour, .bold = true, .halo = true});
    line += 22.0;
  };
  const auto write_status = [&](const char* name, const TrackedPose* pose, const Vec3& point) {
    if (pose == nullptr) return;
    std::string text = fmt::format("{}: {}", name, name_of(pose->status));
    if (pose->status == TrackingStatus::ok) {
      text += fmt::format(" (±{:.2f} mm)", std::sqrt(point_covariance(*pose, point).trace()));
    }
    write(text, colour_of(pose->status));
  };
  write_status("mannequin", mannequin, Vec3::Zero());
  write_status("needle", needle, needle_body != nullptr ? needle_body->tip : Vec3::Zero());
  if (needle_) {
    write(needle_->tissue.empty() ? "tip outside the patient"
                                  : fmt::format("tip in {}, {:.0f} mm deep", needle_->tissue, needle_->depth),
          needle_->bone ? alarm : steel);
  }
  if (is_large()) write("large cutaway: drawn at half the resolution", warning);
  canvas.draw_over(picture);
}

void AugmentedView::draw_tools(imaging::ImageRgb& picture, const Similarity& camera_from_patient,
                               const TrackedPose* needle, const MarkerBody* needle_body,
                               const imaging::TissueDisplacement* moved) {
  imaging::Canvas canvas(picture.width, picture.height);
  if (look_.plan && patient_.description.procedure.path) {
    const anatomy::NeedlePath& path = *patient_.description.procedure.path;
    const auto now = [&](const Vec3& rest) { return moved != nullptr ? Vec3(rest + moved->of(rest)) : rest; };
    const auto entry = pixel_of(camera_from_patient * now(path.entry)),
               target = pixel_of(camera_from_patient * now(path.target));
    if (entry && target) {
      canvas.stroke(imaging::Path::segment(*entry, *target), {imaging::Ink(planned, 0.9), 2.0, {6.0, 4.0}});
      canvas.stroke(imaging::Path::circle(*target, 7.0), {imaging::Ink(planned, 0.95), 2.0});
      canvas.stroke(imaging::Path::cross(*target, 3.0), {imaging::Ink(planned, 0.95), 1.5});
    }
  }
  if (look_.needle && needle != nullptr && needle_body != nullptr && needle->status == TrackingStatus::ok) {
    const Similarity patient_from_camera = camera_from_patient.inverse();
    const Vec3 tip = needle->camera_from_body * needle_body->tip;
    const Vec3 axis = needle->camera_from_body.linear() * needle_body->axis;
    const double length = std::max(1.0, needle_body->axis.dot(needle_body->tip) - end_of_hub(*needle_body));
    NeedleInPatient inside;
    inside.tip = patient_from_camera * tip;
    struct Piece {
      Eigen::Vector2d from, to;
      double width;  // pixels
      std::uint32_t colour;
    };
    std::vector<Piece> shaft;
    constexpr double piece = 1.0;  // mm
    const int pieces = static_cast<int>(length / piece);
    for (int n = 0; n < pieces; ++n) {
      const double back = length - n * piece;  // from the hub to the tip: what is nearer to it stands on top
      const Vec3 from = tip - back * axis, to = tip - (back - piece) * axis;
      const auto first = pixel_of(from), last = pixel_of(to);
      if (!first || !last) continue;
      const anatomy::TissueId id = tissue_at(patient_, patient_from_camera * (0.5 * (from + to)), moved);
      std::uint32_t colour = steel;
      if (id != anatomy::tissue::air) {
        inside.depth += piece;
        if (const anatomy::TissueProperties* tissue = patient_.library.find(id)) colour = tissue->colour;
      }
      // Thicker when nearer to the camera.
      shaft.push_back({*first, *last, std::clamp(2.4 * camera_.fx / from.z(), 2.0, 9.0), colour});
    }
    // A dark rim, below all of them, sets it off. Each begins a pixel early, so that no rim is seen between two.
    for (const Piece& one : shaft)
      canvas.stroke(imaging::Path::segment(one.from, one.to), {imaging::Ink(0x10151A, 0.55), one.width + 2.0});
    for (const Piece& one : shaft) {
      const Eigen::Vector2d early = one.from - (one.to - one.from).normalized();
      canvas.stroke(imaging::Path::segment(early, one.to), {imaging::Ink(one.colour, 1.0), one.width});
    }
    const anatomy::TissueId at = tissue_at(patient_, inside.tip, moved);
    inside.bone = at == anatomy::tissue::cortical_bone || at == anatomy::tissue::cancellous_bone;
    if (at != anatomy::tissue::air) {
      const anatomy::TissueProperties* tissue = patient_.library.find(at);
      inside.tissue = tissue != nullptr ? tissue->title : "unknown tissue";
    }
    if (const auto pixel = pixel_of(tip)) {
      canvas.stroke(imaging::Path::circle(*pixel, 6.0), {imaging::Ink(inside.bone ? alarm : 0xFFFFFF, 0.95), 2.0});
    }
    needle_ = inside;
  }
  canvas.draw_over(picture);
}

// The CT as seen from the front with a crosshair at the needle's tip.
void AugmentedView::draw_front_view(imaging::ImageRgb& picture, const imaging::TissueDisplacement* moved) const {
  const double side = 0.3 * picture.height, extent = 140.0;  // px, mm
  const imaging::SlicePlane plane =
      imaging::view_plane(imaging::View::coronal, needle_->tip, extent, extent, extent / side);
  const imaging::Slice slice = moved != nullptr ? imaging::cut_moved(plane, patient_.ct, patient_.tissues, *moved)
                                                : imaging::cut(plane, patient_.ct, patient_.tissues);
  imaging::ImageRgb image = imaging::paint(slice, patient_.library);
  imaging::Canvas canvas(picture.width, picture.height);
  const double x = picture.width - side - 12.0, y = picture.height - side - 12.0;
  canvas.image(std::move(image), x, y, side, side);
  canvas.stroke(imaging::Path::rectangle(x, y, side, side), {imaging::Ink(0xFFFFFF, 0.8), 1.0});
  const Eigen::Vector2d tip = Eigen::Vector2d(x, y) + plane.place(needle_->tip) * side / plane.width;
  canvas.stroke(imaging::Path::segment({x, tip.y()}, {x + side, tip.y()}), {imaging::Ink(warning, 0.8), 1.0});
  canvas.stroke(imaging::Path::segment({tip.x(), y}, {tip.x(), y + side}), {imaging::Ink(warning, 0.8), 1.0});
  canvas.text({x + 8.0, y + 18.0}, "front view", {.size = 13.0, .ink = 0xFFFFFF, .halo = true});
  canvas.draw_over(picture);
}

}  // namespace bodkin::tracking
