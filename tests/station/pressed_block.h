#pragma once

#include <algorithm>
#include <memory>

#include "tests/fem/lattice_body.h"

#include "anatomy/case.h"
#include "fem/moving/deformable_body_solver.h"
#include "fem/solid/contact_body.h"
#include "fem/solid/patient_body.h"
#include "io/tissue_library_file.h"

namespace bodkin {

struct PressedBlock {
  Case patient;
  std::shared_ptr<const BodyDescription> body;
  std::shared_ptr<const ContactBody> whole;
  BodySolverSettings settings;
};

// A block of muscle, 120 x 50 x 80 mm below the plane y = 0, fixed at its bottom; the planned path goes down at
// x = -30; there is a probe with a face of 35 x 35 mm.
inline PressedBlock pressed_block() {
  PressedBlock made;
  Case& patient = made.patient;
  patient.library = io::default_tissue_library();
  Grid grid;
  grid.size = {60, 70, 40};
  grid.spacing = Vec3(2.0, 1.0, 2.0);
  grid.origin = Vec3(-59.0, -49.5, -39.0);
  patient.tissues = TissueVolume(grid, tissue::air);
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < grid.size[0]; ++i) patient.tissues.at(i, j, k) = tissue::muscle;
  patient.ct = CtVolume(grid, 40);
  patient.description.device = {"strong", 100.0, 50.0, 1e6, 100.0, 0.0};
  patient.description.haptics.constraint = NoConstraint{};
  EmbeddedNeedleSettings needle;
  needle.body.stiffness_scale = 1.0;
  needle.body.fix_cut = false;
  needle.body.fix_beyond = 45.0;
  patient.description.haptics.resistance = needle;
  patient.description.procedure.path = NeedlePath{Vec3(-30.0, 0.0, 0.0), Vec3(-30.0, -30.0, 0.0)};
  TetrahedralMesh mesh = kuhn_box({13, 6, 9}, Vec3(120.0, 50.0, 80.0));
  for (Vec3& node : mesh.nodes) node -= Vec3(60.0, 50.0, 40.0);
  std::fill(mesh.tissues.begin(), mesh.tissues.end(), tissue::muscle);
  const NeedlePath& path = *patient.description.procedure.path;
  made.body = std::make_shared<const BodyDescription>(describe_body(mesh, patient, needle.body, path));
  made.whole = std::make_shared<const ContactBody>(made.body);
  const auto sites = contact_sites_along(path, path.length() + 10.0, needle.point_spacing, patient);
  patient.prepared = {
      std::make_shared<const CondensedBody>(made.whole->contact_points(sites, path.direction(), needle.tip_radius)),
      path};
  made.settings.probe.width = made.settings.probe.thickness = 35.0;
  return made;
}

inline Pose straight_down(double x, double depth) {
  return needle_pose(Vec3(x, -depth, 0.0), -Vec3::UnitY());
}

}  // namespace bodkin
