#include "fem/insertion_stations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace bodkin {

InsertionStations::InsertionStations(const CondensedBody& body, double radius, double spacing)
    : body_(body), radius_(radius), spacing_(spacing), candidates_(body.nodes.size()), stations_(body.nodes.size()) {}

void InsertionStations::begin(const Vec3& entry, const Vec3& direction, const ContactTissues& tissues) noexcept {
  std::size_t found = 0;
  for (std::size_t node = 0; node < body_.nodes.size(); ++node) {
    const Vec3 from_entry = body_.nodes[node] - entry;
    const double depth = from_entry.dot(direction);
    const double distance = (from_entry - depth * direction).squaredNorm();
    if (!(distance <= radius_ * radius_) || !(depth > -radius_)) continue;
    const double place = std::max(depth, 0.0);
    candidates_[found++] = {static_cast<std::uint32_t>(node), std::llround(std::floor(place / spacing_)), distance,
                            place};
  }
  const auto end = candidates_.begin() + static_cast<std::ptrdiff_t>(found);
  std::sort(candidates_.begin(), end, [](const Candidate& a, const Candidate& b) {
    return std::tie(a.cell, a.distance, a.node) < std::tie(b.cell, b.distance, b.node);
  });
  count_ = 0;
  for (std::size_t i = 0; i < found; ++i) {
    const Candidate& here = candidates_[i];
    if (i > 0 && here.cell == candidates_[i - 1].cell) continue;
    const TissueId at = body_.tissues[here.node];
    const double before = count_ == 0 ? 0.0 : tissues[stations_[count_ - 1].tissue].puncture_force;
    if (count_ > 0) stations_[count_ - 1].length = here.depth - stations_[count_ - 1].depth;
    stations_[count_] = {.node = here.node,
                         .tissue = at,
                         .depth = count_ == 0 ? 0.0 : here.depth,
                         .length = std::numeric_limits<double>::infinity(),
                         .resists = tissues[at].puncture_force > before};
    ++count_;
  }
}

}  // namespace bodkin
