#include "core/shortest_turn.h"

namespace bodkin {

Eigen::Quaterniond shortest_turn(const Vec3& from, const Vec3& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to);
}

}  // namespace bodkin
