// Needles enter the back of the synthetic patient anywhere and at any angle, in a mesh independent of its layers.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "patient/synthetic/lumbar.h"
#include "tests/fem/lattice_body.h"
#include "tests/sanitized.h"
#include <gtest/gtest.h>

#include "core/random.h"
#include "fem/embedded_needle.h"
#include "fem/solid/contact_body.h"
#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
using namespace bodkin::io;
using namespace bodkin::patient;
namespace {

constexpr double deepest = 70.0;  // mm

struct Back {
  Case patient;
  NeedlePath planned;
  std::unique_ptr<const ContactBody> body;
};

const Back& back() {
  static const Back made = [] {
    Back back;
    back.patient.library = default_tissue_library();
    SyntheticPatient torso = synthesize_lumbar({}, back.patient.library);
    back.patient.tissues = std::move(torso.tissues);
    back.planned = torso.path;
    BodyDescription body;
    const double side = 160.0;
    body.mesh = kuhn_lattice(9, side, 0.1);
    const Vec3 middle = torso.path.entry + 0.3 * side * torso.path.direction();
    for (Vec3& node : body.mesh.nodes) node += middle - Vec3::Constant(0.5 * side);
    body.materials.set(tissue::soft, {2.0, 0.3});
    // Held far behind the deepest point.
    body.fixed =
        nodes_beyond(body.mesh, torso.path.entry + 0.65 * side * torso.path.direction(), torso.path.direction());
    back.body = std::make_unique<const ContactBody>(std::make_shared<const BodyDescription>(std::move(body)));
    return back;
  }();
  return made;
}

// A random line through the skin within 25 mm of the planned entry, up to 40 degrees from the planned direction.
NeedlePath random_path(Random& random) {
  const Back& here = back();
  const Vec3 along = here.planned.direction(), side = along.unitOrthogonal(), other = along.cross(side);
  // In sequence, so that every compiler draws the same numbers.
  const double right = random.uniform(-25.0, 25.0), up = random.uniform(-25.0, 25.0);
  const double angle = random.uniform(0.0, 0.7), turn = random.uniform(0.0, 6.28);
  const Vec3 from = here.planned.entry - 30.0 * along + right * side + up * other;
  const Vec3 direction = std::cos(angle) * along + std::sin(angle) * (std::cos(turn) * side + std::sin(turn) * other);
  for (double along_line = 0.0; along_line < 80.0; along_line += 0.01) {
    const Vec3 place = from + along_line * along;
    if (nearest<TissueId>(here.patient.tissues, place, tissue::air) != tissue::air)
      return {place, place + deepest * direction};
  }
  return here.planned;
}

struct LineLayer {
  TissueId tissue;
  double from, to;
};

bool is_rigid(TissueId id) {
  const TissueProperties* known = back().patient.library.find(id);
  return known != nullptr && known->layered.kind == LayeredKind::rigid;
}

// The tissues on the line, down to the first rigid one: what is thicker than 0.3 mm, neighbours of one tissue joined.
// Nothing where a rigid piece is about as thick as a layer has to be, so that either answer is right.
std::vector<LineLayer> layers_on_line(const NeedlePath& path) {
  std::vector<LineLayer> layers;
  const TissueVolume& tissues = back().patient.tissues;
  const double voxel = tissues.grid.spacing.minCoeff();
  const auto tissue_at = [&](double depth) {
    return nearest<TissueId>(tissues, path.entry + depth * path.direction(), tissue::air);
  };
  for (double depth = 0.0; depth < deepest; depth += 0.01) {
    const TissueId id = tissue_at(depth);
    if (is_rigid(id)) {
      double end = depth;
      while (end - depth < 0.4 && is_rigid(tissue_at(end))) end += 0.01;
      if (end - depth > 0.395) break;
      if (end - depth > 0.2) return {};
    }
    if (layers.empty() || layers.back().tissue != id) {
      // A piece that ends here and was not a layer joins the previous one.
      if (layers.size() > 1 && layers.back().to - layers.back().from < 0.3) {
        layers[layers.size() - 2].to = layers.back().to;
        layers.pop_back();
      }
      // So does a corner of the staircase between two pieces of one tissue.
      if (layers.size() > 1 && layers[layers.size() - 2].tissue == id &&
          layers.back().to - layers.back().from < 0.75 * voxel)
        layers.pop_back();
      if (!layers.empty() && layers.back().tissue == id)
        layers.back().to = depth;
      else
        layers.push_back({id, depth, depth});
    }
    layers.back().to = depth + 0.01;
    // Air behind a corner of the skin: the body begins later.
    if (layers.size() == 2 && id == tissue::air && layers[0].to - layers[0].from < 0.75 * voxel) layers.clear();
    if (layers.size() == 1 && id == tissue::air) layers.clear();
  }
  return layers;
}

double puncture_force_of(TissueId id) {
  const TissueProperties* tissue = back().patient.library.find(id);
  return tissue == nullptr ? 0.0 : tissue->deformable.puncture_force;
}

// The paths that meet the body, and the layers to be punctured on them.
struct PathCounts {
  std::size_t paths = 0, layers = 0;
};

// Pushes needles in and compares what gives way with the layers that have to: a tissue that takes more force than the
// one before it.
PathCounts expect_every_layer_once(int paths, std::uint64_t seed) {
  const Back& here = back();
  ContactTissues tissues;
  for (const TissueProperties& tissue : here.patient.library.tissues())
    tissues[tissue.id] = {0.001, tissue.deformable.puncture_force, 0.0};
  Random random(seed);
  PathCounts all;
  for (int path_number = 0; path_number < paths; ++path_number) {
    const NeedlePath path = random_path(random);
    const std::vector<ContactSite> sites = contact_sites_along(path, deepest, 2.0, here.patient);
    const std::vector<LineLayer> layers = layers_on_line(path);
    if (sites.empty() || layers.empty()) continue;
    // A wide disk, so that nothing has to be refined: it is the layers that count here.
    const CondensedBody points = here.body->contact_points(sites, path.direction(), 100.0);
    EmbeddedNeedle needle(points, tissues, {}, 1e-3);
    needle.begin(path.entry, path.direction());
    std::vector<TissueId> felt;
    for (double depth = 0.0; depth < deepest + 20.0; depth += 0.1) {
      const auto& now = needle.step(needle_pose(path.entry + depth * path.direction(), path.direction()));
      if (now.puncture) felt.push_back(now.puncture->tissue);
    }
    // A layer that begins in the last millimetre, or has about the minimum thickness, may be felt or not.
    std::vector<TissueId> expected, possible;
    double before = 0.0;
    for (const LineLayer& layer : layers) {
      const double force = puncture_force_of(layer.tissue);
      if (force > before) possible.push_back(layer.tissue);
      if (force > before && layer.to - layer.from >= 0.35 && layer.from < deepest - 1.0)
        expected.push_back(layer.tissue);
      before = force;
    }
    ++all.paths;
    all.layers += expected.size();
    if (felt != possible) {
      EXPECT_EQ(felt, expected) << "path " << path_number;
    }
  }
  return all;
}

TEST(NeedlePaths, every_layer_on_a_random_way_gives_way_once) {
  const PathCounts walked = expect_every_layer_once(8, 1);
  EXPECT_GT(walked.layers, 6U);
  EXPECT_GE(walked.paths, 7U);
}

TEST(NeedlePaths, of_1000_random_ways_no_layer_is_missed_and_none_felt_twice) {
  // Under a sanitizer a few of them, which take 20 s.
  const int paths = sanitized ? 20 : 1000;
  const PathCounts walked = expect_every_layer_once(paths, 2);
  EXPECT_GT(walked.layers, static_cast<std::size_t>(paths));
  EXPECT_GE(walked.paths, static_cast<std::size_t>(0.95 * paths));
}

}  // namespace
}  // namespace bodkin
