#include "patient/acupuncture/meridian_line.h"

#include <cmath>

namespace bodkin::patient {

void append_skin_line(const BodyShape& shape, const Vec3& to, std::vector<Vec3>& line) {
  constexpr double step = 5.0;
  const double straight = (to - line.back()).norm();
  const int most = static_cast<int>(3.0 * straight / step) + 4;
  Vec3 here = line.back();
  for (int i = 0; i < most; ++i) {
    const Vec3 rest = to - here;
    if (rest.norm() < 1.3 * step) break;
    const Vec3 normal = shape.normal(here);
    Vec3 way = rest - rest.dot(normal) * normal;
    if (way.norm() < 1e-6) break;
    here = shape.nearest_skin(here + step * way.normalized());
    line.push_back(here);
  }
  line.push_back(to);
}

}  // namespace bodkin::patient
