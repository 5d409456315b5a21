#include "anatomy/grid.h"

namespace bodkin::anatomy {

std::string Grid::axes() const {
  static constexpr char positive[] = {'L', 'P', 'S'};
  static constexpr char negative[] = {'R', 'A', 'I'};
  std::string letters;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Eigen::Index largest = 0;
    direction.col(axis).cwiseAbs().maxCoeff(&largest);
    letters += direction(largest, axis) >= 0.0 ? positive[largest] : negative[largest];
  }
  return letters;
}

bool same_lattice(const Grid& a, const Grid& b, double tolerance) {
  if (a.size != b.size) return false;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 index((corner & 1) != 0 ? a.size[0] - 1 : 0, (corner & 2) != 0 ? a.size[1] - 1 : 0,
                     (corner & 4) != 0 ? a.size[2] - 1 : 0);
    if ((a.to_patient(index) - b.to_patient(index)).norm() > tolerance) return false;
  }
  return true;
}

}  // namespace bodkin::anatomy
