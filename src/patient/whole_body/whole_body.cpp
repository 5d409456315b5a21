#include "patient/whole_body/whole_body.h"

#include <cmath>
#include <string>

#include "core/error.h"
#include "core/parallel_for.h"

namespace bodkin::patient {
namespace {

constexpr double air = 10.0;  // mm about the whole body

void require_range(double value, double from, double to, const char* name) {
  if (value >= from && value <= to) return;
  std::string sentence = "synthetic body: the ";
  sentence.append(name).append(" is ").append(std::to_string(value)).append(" mm, expected ");
  sentence.append(std::to_string(from)).append(" to ").append(std::to_string(to));
  throw InputError(sentence);
}

anatomy::Grid grid_of(const BodyShape& shape, const BodyBlock& block) {
  anatomy::Grid grid;
  grid.spacing = Vec3::Constant(block.spacing);
  Vec3 low, high;
  if (block.middle) {
    require_range(block.width, 40.0, 400.0, "width of the block");
    require_range(block.spacing, 0.8, 3.0, "spacing of a block's voxels");
    low = *block.middle - Vec3::Constant(0.5 * block.width);
    high = *block.middle + Vec3::Constant(0.5 * block.width);
  } else {
    require_range(block.spacing, 3.0, 8.0, "spacing of the whole body's voxels");
    const double s = shape.scale(), girth = std::max(1.0, shape.girth());
    const double reach = (shape.from_arm(Vec3(90.0, 0.0, BodyShape::fingertip)).x() + 10.0) * s + air;
    low = Vec3(-reach, -215.0 * s * girth - air, -air);
    high = Vec3(reach, 160.0 * s * girth + air, 1722.0 * s + air);
  }
  for (int axis = 0; axis < 3; ++axis)
    grid.size[static_cast<std::size_t>(axis)] = static_cast<int>(std::ceil((high[axis] - low[axis]) / block.spacing));
  grid.origin = low + 0.5 * grid.spacing;
  return grid;
}

}  // namespace

anatomy::TissueVolume body_volume(const BodyShape& shape, const BodyTissues& tissues, const BodyBlock& block,
                                  const Progress& progress) {
  anatomy::TissueVolume volume(grid_of(shape, block));
  const anatomy::Grid& grid = volume.grid;
  parallel_for(grid.size[2], "tissues", progress, [&](int k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0];) {
        const Vec3 p = grid.to_patient(Vec3(i, j, k));
        const double distance = shape.distance(p);
        if (distance >= 0.0) {
          // Only air for about that distance: distances are accurate to some percent only near the skin.
          i += std::max(1, static_cast<int>(std::min(0.5 * distance, 40.0) / block.spacing));
          continue;
        }
        volume.at(i, j, k) = tissues.at(p, distance, block.spacing);
        ++i;
      }
    }
  });
  return volume;
}

}  // namespace bodkin::patient
