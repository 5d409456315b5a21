#include "scene/openness.h"

#include <array>
#include <cmath>
#include <numbers>

#include "core/parallel_for.h"

namespace bodkin::scene {

namespace {

constexpr int directions = 40;
constexpr double seen_within = 17.0, seen_step = 1.7;  // mm [D]

// A spiral over the hemisphere about z, denser towards the pole, for equal weights of all directions.
std::array<Vec3, directions> hemisphere() {
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  std::array<Vec3, directions> spiral;
  for (int i = 0; i < directions; ++i) {
    const double square = (i + 0.5) / directions, turn = golden * i;
    spiral[static_cast<std::size_t>(i)] =
        Vec3(std::sqrt(square) * std::cos(turn), std::sqrt(square) * std::sin(turn), std::sqrt(1.0 - square));
  }
  return spiral;
}

// Every point gets the mean of itself and its neighbours, because 40 directions are few.
void even_out(SceneMesh& mesh) {
  std::vector<float> sum = mesh.openness;
  std::vector<float> count(sum.size(), 1.0F);
  for (const auto& corners : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto a = static_cast<std::size_t>(corners[c]), b = static_cast<std::size_t>(corners[(c + 1) % 3]);
      sum[a] += mesh.openness[b];
      count[a] += 1.0F;
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) mesh.openness[i] = sum[i] / count[i];
}

}  // namespace

void find_openness(const anatomy::TissueVolume& tissues, const anatomy::TissueSet& occluders, double cell,
                   SceneMesh& mesh) {
  static const std::array<Vec3, directions> sky = hemisphere();
  const double clear = 0.6 + cell;  // the drawn surface and the voxels differ by parts of a cell
  std::array<bool, 256> hides{};
  for (std::size_t id = 0; id < hides.size(); ++id) hides[id] = occluders[id];
  mesh.openness.assign(mesh.points.size(), 1.0F);
  parallel_for(mesh.points.size(), [&](std::size_t i) {
    const Vec3 normal = mesh.normals[i].cast<double>();
    const Vec3 from = mesh.points[i].cast<double>() + clear * normal;
    const Vec3 across = normal.unitOrthogonal(), other = normal.cross(across);
    const Vec3 at = tissues.grid.to_index(from);
    double hidden = 0.0;
    for (const Vec3& local : sky) {
      const Vec3 direction = local.x() * across + local.y() * other + local.z() * normal;
      const Vec3 move = (tissues.grid.direction.transpose() * direction).cwiseQuotient(tissues.grid.spacing);
      for (double t = 0.0; t < seen_within; t += seen_step) {
        if (!hides[anatomy::nearest_at_index(tissues, at + t * move, anatomy::tissue::air)]) continue;
        hidden += 1.0 - t / seen_within;
        break;
      }
    }
    mesh.openness[i] = static_cast<float>(1.0 - hidden / directions);
  });
  even_out(mesh);
}

}  // namespace bodkin::scene
