// A block of tissue under a probe, for tests of live ultrasound.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "station/scan_thread.h"
#include "tests/fem/lattice_body.h"

#include "anatomy/case.h"
#include "fem/solid/patient_body.h"
#include "imaging/ultrasound/acoustic_volume.h"
#include "io/probe_library_file.h"
#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using namespace bodkin::imaging;
using namespace bodkin::io;
using namespace bodkin::station;

struct SeenBlock {
  Case patient;
  std::shared_ptr<const BodyDescription> body;
  std::shared_ptr<const AcousticVolume> sounding;
  std::vector<std::uint32_t> shaft;  // nodes of the corridor around the path
};

// A block of muscle over fat, 80 x 50 x 80 mm below the plane y = 0, fixed at its bottom; the path goes straight down
// from the origin.
inline SeenBlock seen_block() {
  SeenBlock made;
  Case& patient = made.patient;
  patient.library = default_tissue_library();
  Grid grid;
  grid.size = {40, 70, 40};
  grid.spacing = Vec3(2.0, 1.0, 2.0);
  grid.origin = Vec3(-39.0, -49.5, -39.0);
  patient.tissues = TissueVolume(grid, tissue::air);
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 40; ++i) patient.tissues.at(i, j, k) = j % 10 < 5 ? tissue::muscle : tissue::fat;
  patient.ct = CtVolume(grid, -1000);
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 40; ++i) patient.ct.at(i, j, k) = j % 10 < 5 ? 50 : -100;
  patient.description.procedure.path = NeedlePath{Vec3::Zero(), Vec3(0.0, -30.0, 0.0)};
  DeformableBodySettings settings;
  settings.stiffness_scale = 1.0;
  settings.fix_cut = false;
  settings.fix_beyond = 45.0;
  TetrahedralMesh mesh = kuhn_box({11, 8, 11}, Vec3(80.0, 50.0, 80.0));
  for (Vec3& node : mesh.nodes) node -= Vec3(40.0, 50.0, 40.0);
  std::fill(mesh.tissues.begin(), mesh.tissues.end(), tissue::muscle);
  const NeedlePath& path = *patient.description.procedure.path;
  BodyDescription body = describe_body(mesh, patient, settings, path);
  body.corridor = nodes_of_picture(body, path);
  made.body = std::make_shared<const BodyDescription>(std::move(body));
  made.sounding = acoustic_volume(patient, {});
  return made;
}

inline UltrasoundDetail small_detail() {
  UltrasoundDetail detail;
  detail.lines = detail.samples = 96;
  detail.width = detail.height = 120;
  return detail;
}

inline UltrasoundSettings shallow() {
  UltrasoundSettings settings;
  settings.depth = 45.0;
  settings.focus = 20.0;
  return settings;
}

// On the skin at (x, 0, z), the array along z.
inline Pose on_skin(double x, double z, double press = 0.0) {
  return probe_pose(Vec3(x, -press, z), -Vec3::UnitY(), Vec3::UnitZ());
}

inline const Pose straight_in = needle_pose(Vec3(0.0, -20.0, 0.0), -Vec3::UnitY());

// Forces of some newtons on three nodes around the path, pushing and pulling.
inline NodeForces forces_on(const ElasticBody& elastic, const SeenBlock& block, float scale = 1.0F) {
  const std::vector<std::uint32_t> nodes =
      nodes_of_shaft(elastic, block.body->mesh, *block.patient.description.procedure.path, 15.0, 3);
  NodeForces forces;
  for (const std::uint32_t node : nodes) {
    const auto number = static_cast<float>(forces.count + 1);
    forces.nodes[forces.count++] = {node, {0.3F * scale * number, -2.0F * scale, 0.5F * scale}};
  }
  return forces;
}

inline const LiveImage* picture_where(ScanThread& thread, const std::function<bool(const LiveImage&)>& holds) {
  for (int tries = 0; tries < 4000; ++tries) {
    const LiveImage& now = thread.picture();
    if (now.number > 0 && holds(now)) return &now;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return nullptr;
}

struct SeenThread {
  SeenBlock block = seen_block();
  ElasticBody elastic{*block.body, plan_body(*block.body)};
  UltrasoundProbe probe = find_probe("L14-5");

  Ultrasound machine() const { return {block.sounding, probe, shallow(), small_detail()}; }
  std::unique_ptr<ScanThread> start(const Pose& pose, double rate = 200.0) {
    ScanBody body{block.body,
                  std::make_unique<NodeField>(elastic, *block.body, *block.patient.description.procedure.path)};
    return std::make_unique<ScanThread>(block.sounding, machine(), Needle(), std::move(body),
                                        ScanSetup{pose, shallow()}, rate);
  }
};

inline double mean_difference(const UltrasoundFrame& a, const UltrasoundFrame& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::abs(static_cast<int>(a.pixels[i]) - b.pixels[i]);
  return sum / static_cast<double>(a.pixels.size());
}

}  // namespace bodkin
