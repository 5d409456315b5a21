#include "tests/views/made_up.h"

#include <cmath>

#include "io/tissue_library_file.h"

namespace bodkin_test {

namespace {

using bodkin::Vec3;
namespace tissue = bodkin::anatomy::tissue;

constexpr double skin_at = 30.0;  // mm of y

bodkin::anatomy::TissueId layer_at(const Vec3& point) {
  const double depth = skin_at - point.y();
  if (depth < 0.0) return tissue::air;
  if (std::hypot(point.y() + 25.0, point.z() - 20.0) < 4.0) return tissue::vessel;
  if (depth < skin_to) return tissue::skin;
  if (depth < fat_to) return tissue::fat;
  if (depth < muscle_to) return tissue::muscle;
  if (depth < flavum_to) return tissue::ligamentum_flavum;
  return tissue::cerebrospinal_fluid;
}

}  // namespace

double layered_hounsfield(const Vec3& point) {
  return 40.0 + 2.0 * point.x() + 5.0 * point.z();
}

std::shared_ptr<const bodkin::views::OpenCase> layered_patient() {
  static const std::shared_ptr<const bodkin::views::OpenCase> made = [] {
    auto open = std::make_shared<bodkin::views::OpenCase>();
    bodkin::anatomy::Case& patient = open->patient;
    bodkin::anatomy::Grid grid;
    grid.size = {101, 200, 101};
    grid.spacing = Vec3(1.0, 0.5, 1.0);
    grid.origin = Vec3(-50.0, -49.75, -50.0);  // borders of layers lie between voxels
    patient.ct = bodkin::anatomy::CtVolume(grid);
    patient.tissues = bodkin::anatomy::TissueVolume(grid);
    for (int k = 0; k < grid.size[2]; ++k) {
      for (int j = 0; j < grid.size[1]; ++j) {
        for (int i = 0; i < grid.size[0]; ++i) {
          const Vec3 point = grid.to_patient(Vec3(i, j, k));
          patient.ct.at(i, j, k) = static_cast<std::int16_t>(std::lround(layered_hounsfield(point)));
          patient.tissues.at(i, j, k) = layer_at(point);
        }
      }
    }
    patient.library = bodkin::io::default_tissue_library();
    patient.description.name = "layers";
    patient.description.procedure.path =
        bodkin::anatomy::NeedlePath{Vec3(0.0, skin_at, 0.0), Vec3(0.0, skin_at - 40.0, 0.0)};
    open->title = "Layers";
    open->procedure = "Lumbar puncture";
    return open;
  }();
  return made;
}

bodkin::views::Frame frame_at(double depth) {
  bodkin::views::Frame frame;
  const auto open = layered_patient();
  frame.state = depth > 0.0 ? bodkin::views::State::in_tissue : bodkin::views::State::aiming;
  frame.has_needle = true;
  frame.depth = depth;
  frame.plan = open->description().procedure.path;
  const Vec3 tip = frame.plan->entry + depth * frame.plan->direction();
  frame.needle = bodkin::needle_pose(tip, frame.plan->direction());
  if (depth > 0.0) frame.entry = frame.plan->entry;
  frame.tissue = bodkin::anatomy::nearest(open->patient.tissues, tip, tissue::air);
  frame.place = open->patient.library.title(frame.tissue);
  frame.target_distance = (frame.plan->target - tip).norm();
  frame.crosshair = tip;
  return frame;
}

}  // namespace bodkin_test
