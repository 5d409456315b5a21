#include "station/pressed_scan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "patient/meshing/mesh_record.h"
#include "station/body_supervisor.h"
#include <fmt/format.h>

#include "core/repeatable.h"
#include "core/rotation.h"
#include "fem/solid/patient_body.h"
#include "imaging/ultrasound/acoustic_volume.h"
#include "imaging/warped_slice.h"

namespace bodkin::station {

namespace {

constexpr double pressed_spacing = 2.0;     // mm between the points at which the tissue's motion is sampled
constexpr double longest_pause = 0.5;       // s between two images; longer pauses are not made up for
constexpr double probe_speed = 300.0;       // mm/s
constexpr double probe_turn = 3.0;          // rad/s
constexpr double comes_from = 40.0;         // mm before the place where a probe first appears
constexpr double housing = 15.0;            // mm, thickness
constexpr double thickest = 40.0;           // mm
constexpr std::size_t edges_judged = 3000;  // of a mesh, for its mean edge

// Moves towards `goal` by one step.
void go(Pose& face, const Pose& goal) {
  const Vec3 offset = goal.translation() - face.translation();
  const double way = probe_speed * body_step_time;
  face.translation() += std::min(1.0, way / std::max(offset.norm(), 1e-12)) * offset;
  const Eigen::Quaterniond from(face.linear()), to(goal.linear());
  const double angle = angle_between(from, to), turn = probe_turn * body_step_time;
  face.linear() = interpolate(from, to, std::min(1.0, turn / std::max(angle, 1e-12))).normalized().toRotationMatrix();
}

}  // namespace

fem::ProbeFace face_of(const anatomy::UltrasoundProbe& probe, const anatomy::TetrahedralMesh& mesh) {
  fem::ProbeFace face;
  const double along = probe.elements * probe.pitch;
  face.radius = probe.kind == anatomy::ProbeKind::curvilinear ? probe.radius : 0.0;
  face.width =
      face.radius > 0.0 ? 2.0 * face.radius * repeatable::sin(std::min(1.2, 0.5 * along / face.radius)) : along;
  face.width = std::clamp(face.width, 5.0, 200.0);
  double sum = 0.0;
  const std::size_t stride = std::max<std::size_t>(1, mesh.elements.size() / edges_judged);
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.elements.size(); i += stride, ++count)
    sum += (mesh.nodes[mesh.elements[i][0]] - mesh.nodes[mesh.elements[i][1]]).norm();
  const double edge = count > 0 ? sum / static_cast<double>(count) : 0.0;
  face.thickness = std::clamp(2.0 * edge, housing, thickest);
  return face;
}

Pose tool_of_probe(const Pose& probe) {
  Pose tool = probe;
  tool.linear().col(1) = -probe.linear().col(2);
  tool.linear().col(2) = probe.linear().col(1);
  return tool;
}

PressedScan::PressedScan(const anatomy::Case& patient, const std::filesystem::path& folder,
                         const UltrasoundChoice& choice, const std::function<void(const std::string&)>& note)
    : patient_(patient),
      machine_(imaging::acoustic_volume(patient, {}), choice.probe, choice.settings, choice.detail) {
  const std::optional<anatomy::NeedlePath>& path = patient.description.procedure.path;
  std::optional<patient::CaseMesh> mesh;
  if (!folder.empty() && path) mesh = patient::read_case_mesh(folder, patient.library);
  if (!mesh) return;
  const anatomy::DeformableBodySettings* const of_case = anatomy::body_of(patient.description.haptics.resistance);
  anatomy::DeformableBodySettings settings = of_case != nullptr ? *of_case : anatomy::DeformableBodySettings();
  settings.stiffness_scale = 1.0;  // a probe presses the tissue as it is; the scale is meant for needles
  body_ = std::make_shared<const fem::BodyDescription>(
      fem::describe_body(std::move(mesh->mesh), patient, settings, *path));
  if (const auto tissue = fem::tissue_with_fibres(body_->mesh, body_->materials)) {
    if (note)
      note(fmt::format(
          "the probe presses the patient layer by layer: tissue {} has fibres, which a moving body does not support",
          *tissue));
    return;
  }
  const std::string slow = slow_motion_warning(body_->mesh.nodes.size());
  if (note && !slow.empty()) note(slow);
  fem::BodySolverSettings motion;
  motion.motion.dt = body_step_time;
  motion.probe = face_of(choice.probe, body_->mesh);
  solver_ = std::make_unique<fem::DeformableBodySolver>(*body_, motion);
  field_ = std::make_unique<SliceField>(body_);
  lattice_ = std::make_unique<TissueLattice>(*body_);
  nodes_.assign(3 * body_->mesh.nodes.size(), 0.0F);
}

void PressedScan::advance(const std::optional<Pose>& probe, double seconds) {
  if (!deforms()) return;
  owed_ = std::min(owed_ + std::max(0.0, seconds), longest_pause);
  std::optional<Pose> goal;
  if (probe) goal = tool_of_probe(*probe);
  for (; owed_ >= body_step_time; owed_ -= body_step_time) {
    if (goal && !at_) {
      at_ = *goal;
      at_->translation() -= comes_from * goal->linear().col(2);
    }
    if (!goal) at_.reset();
    if (goal) go(*at_, *goal);
    if (solver_->step(at_).fault) {
      failed_ = true;
      return;
    }
  }
  force_ = at_ && solver_->press().held() > 0
               ? std::max(0.0, -solver_->press().on_probe(solver_->body()).force.dot(at_->linear().col(2)))
               : 0.0;
  take_displacements();
}

void PressedScan::take_displacements() {
  const fem::CorotationalBody& body = solver_->body();
  for (std::uint32_t node = 0; node < body.nodes(); ++node) {
    const Vec3 moved = body.position(node) - body.at_rest(node);
    Eigen::Map<Eigen::Vector3f>(nodes_.data() + 3 * std::size_t{node}) = moved.cast<float>();
  }
}

std::shared_ptr<const imaging::TissueDisplacement> PressedScan::moved_tissue() const {
  return deforms() ? lattice_->moved(nodes_) : nullptr;
}

imaging::SlicePlane PressedScan::plane_of_image(const Pose& probe) const {
  return plane_of_frame(frame_, probe);
}

const imaging::UltrasoundFrame& PressedScan::image(const Pose& probe,
                                                   const std::optional<imaging::NeedleInUltrasound>& needle) {
  most_ = 0.0;
  if (!deforms()) return frame_ = machine_.image(probe, needle);
  // How large a picture of these settings is, only a picture says.
  if (sized_for_ != machine_.settings().depth) frame_ = machine_.image(probe, needle);
  sized_for_ = machine_.settings().depth;
  const imaging::SlicePlane grid = imaging::warp_grid(plane_of_image(probe), pressed_spacing);
  places_ = imaging::displacements_of_places(grid, field_->displacements(grid, nodes_));
  for (std::size_t i = 0; i + 2 < places_.size(); i += 3)
    most_ = std::max(most_, static_cast<double>(Eigen::Map<const Eigen::Vector3f>(places_.data() + i).norm()));
  const imaging::ScanDisplacement moved{frame_.corner, grid.pixel, grid.width, grid.height, places_};
  return frame_ = machine_.image(probe, needle, moved);
}

imaging::ImageRgb PressedScan::slice(const Pose& probe, double pixel) {
  imaging::SlicePlane plane = plane_of_image(probe);
  plane.width = std::max(2, static_cast<int>(plane.width * plane.pixel / pixel));
  plane.height = std::max(2, static_cast<int>(plane.height * plane.pixel / pixel));
  plane.pixel = pixel;
  if (!deforms()) return imaging::paint(imaging::cut(plane, patient_.ct, patient_.tissues), patient_.library);
  const imaging::SlicePlane grid = imaging::warp_grid(plane, pressed_spacing);
  return imaging::paint(
      imaging::cut_deformed(plane, patient_.ct, patient_.tissues, grid, field_->displacements(grid, nodes_)),
      patient_.library);
}

}  // namespace bodkin::station
