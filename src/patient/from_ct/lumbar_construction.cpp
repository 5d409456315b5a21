#include "patient/from_ct/lumbar_construction.h"

#include <algorithm>
#include <cmath>

#include "patient/from_ct/hounsfield_classes.h"

#include "core/parallel_for.h"

namespace bodkin::patient {
namespace {

using namespace lumbar_size;

// The data of one height for the drawing; y and x are LPS mm.
struct ConstructedSection {
  double x, front, back, half_width;  // canal; `back` with its bulge in the midline
  double bulge;
  double flavum;  // thickness along y; 0 = none here
  double tip, tip_x;
  bool ligaments;
  double epidural;                               // posterior, in the midline
  double taper;                                  // of the sac towards its end, 1 to 0
  double sac_y, sac_half_depth, sac_half_width;  // 0 = below the end of the sac
};

double square(double v) {
  return v * v;
}

// 1 inside an interspace, falling to 0 over 4 mm beyond its edges.
double nearness(const Interspace& gap, double z) {
  const double beyond = std::max({gap.low - z, z - gap.high, 0.0});
  return std::max(0.0, 1.0 - square(beyond / 4.0));
}

ConstructedSection section_at(const LumbarSpine& spine, double z) {
  const CanalSection canal = spine.canal.at(z);
  const double cosine = std::max(0.64, spine.canal.cosine(z));
  const auto last = static_cast<double>(spine.tip.size()) - 1.0;
  const auto n = static_cast<std::size_t>(std::lround(std::clamp(z - spine.canal.lowest, 0.0, last)));
  ConstructedSection s{};
  s.x = canal.x, s.front = canal.front, s.half_width = canal.half_width;
  s.tip = spine.tip[n], s.tip_x = spine.tip_x[n];
  double open = 0.0, nearest = 1e9;
  std::optional<Measured> fat;
  for (const Interspace& gap : spine.interspaces) {
    const double near = nearness(gap, z);
    if (near > open) {
      open = near;
      s.bulge = near * gap.bulge;
      fat = gap.seen.epidural;
    }
    if (const double away = std::abs(z - gap.middle()); away < nearest)
      nearest = away, s.flavum = gap.flavum / cosine;
  }
  s.back = canal.back + s.bulge;
  if (!spine.interspaces.empty()) {
    const double top = spine.interspaces.front().high + 8.0, bottom = spine.interspaces.back().low - 8.0;
    s.ligaments = z <= top && z >= bottom;
  }
  if (!s.ligaments) s.flavum = 0.0;
  const double usual = std::min(epidural_depth / cosine, epidural_share * (s.back - s.front));
  s.epidural = open * (fat ? std::max(fat->value, least_epidural) : usual) + (1 - open) * epidural_under_lamina;
  s.sac_half_width = s.half_width - lateral_epidural;
  if (!spine.interspaces.empty() && spine.interspaces.back().name.ends_with("_S1")) {
    const double above_end = z - (spine.interspaces.back().middle() - dural_end);
    const double taper = std::sqrt(std::clamp(above_end / 15.0, 0.0, 1.0));
    s.sac_half_width *= taper;
    s.taper = taper;
  } else {
    s.taper = 1.0;
  }
  return s;
}

// Sections `step` mm apart along the whole canal. The back of the sac is drawn taut: fat fills the bulges of the
// canal's wall between the laminae.
std::vector<ConstructedSection> sections_of(const LumbarSpine& spine, double step) {
  std::vector<ConstructedSection> sections;
  std::vector<double> backs;
  for (double z = spine.canal.lowest - 0.5; z <= spine.canal.highest() + 0.5; z += step) {
    sections.push_back(section_at(spine, z));
    backs.push_back(sections.back().back - sections.back().epidural);
  }
  const auto taut = moving_average(backs, static_cast<int>(10.0 / step));
  for (std::size_t n = 0; n < sections.size(); ++n) {
    ConstructedSection& s = sections[n];
    const double low = s.front + anterior_epidural;
    const double back =
        std::clamp(taut[n], low + 4.0, std::max(low + 4.0, s.back - std::max(least_epidural, 0.75 * s.epidural)));
    s.sac_half_depth = 0.5 * (back - low) * s.taper;
    s.sac_y = 0.5 * (back + low);
  }
  return sections;
}

// Height of the conus. With unknown levels it may be anywhere, so everything counts as cord.
double conus_of(const LumbarSpine& spine) {
  return spine.conus.value_or(-1e9);
}

// 1 on the oval |u/a|^2.5 + |v/b|^2.5 = 1, less inside.
double oval(double u, double v) {
  return std::pow(std::pow(std::abs(u), 2.5) + std::pow(std::abs(v), 2.5), 0.4);
}

bool in_sac(const ConstructedSection& s, double x, double y) {
  if (s.sac_half_depth < 1.0 || s.sac_half_width < 1.0) return false;
  return oval((x - s.x) / s.sac_half_width, (y - s.sac_y) / s.sac_half_depth) < 1.0;
}

// The cord, 9 mm wide and 8 mm deep, thins out over the last 28 mm above the conus.
bool is_cord(const ConstructedSection& s, double x, double y, double above_conus) {
  const double thin = std::sqrt(std::clamp(above_conus / 28.0, 0.0, 1.0));
  if (thin <= 0.0) return false;
  const double u = (x - s.x) / (4.5 * thin), v = (y - s.sac_y) / (std::min(4.0, 0.6 * s.sac_half_depth) * thin);
  return square(u) + square(v) < 1.0;
}

// Cauda equina: the roots hang in two bundles on either side of the midline, towards the back.
bool is_root(const ConstructedSection& s, double x, double y) {
  const double u = x - s.x, v = y - s.sac_y;
  const double side = (std::abs(u) - 0.72 * s.sac_half_width) / (0.14 * s.sac_half_width);
  return square(side) + square((v - 0.15 * s.sac_half_depth) / (0.5 * s.sac_half_depth)) < 1.0;
}

// The constructed tissue at a point, or air for none. The sac becomes cerebrospinal fluid.
anatomy::TissueId tissue_at(const ConstructedSection& s, double x, double y) {
  const double middle = 0.5 * (s.front + s.back), u = x - s.x;
  const double wall = s.back - s.bulge * std::min(1.0, square(u / 9.0));  // the bulge is in the midline
  const double v = y - middle;
  const double rho = oval(u / s.half_width, v / (v > 0.0 ? wall - middle : middle - s.front));
  if (rho < 1.0) return in_sac(s, x, y) ? anatomy::tissue::cerebrospinal_fluid : anatomy::tissue::epidural_fat;
  if (!s.ligaments || v <= 0.0) return anatomy::tissue::air;
  const double beyond = std::hypot(u, v) * (1.0 - 1.0 / rho);
  if (beyond < s.flavum) return anatomy::tissue::ligamentum_flavum;
  // Interspinous ligament: from the flavum to the tips, in the plane of the processes.
  const double begin = wall + s.flavum, end = s.tip - 1.0;
  if (y < begin - 1.0 || y > end + supraspinous_depth) return anatomy::tissue::air;
  const double f = std::clamp((y - begin) / std::max(1.0, end - begin), 0.0, 1.0);
  const double centre = s.x + f * (s.tip_x - s.x);
  if (y >= end)
    return std::abs(x - centre) < 0.5 * interspinous_back ? anatomy::tissue::supraspinous_ligament
                                                          : anatomy::tissue::air;
  const double width = interspinous_front * (1 - f) * (1 - 2 * f) + interspinous_middle * 4 * f * (1 - f) +
                       interspinous_back * f * (2 * f - 1);  // parabola through the three widths
  return std::abs(x - centre) < 0.5 * width ? anatomy::tissue::interspinous_ligament : anatomy::tissue::air;
}

bool may_become(anatomy::TissueId old) {
  return !is_bone(old) && old != anatomy::tissue::disc && old != anatomy::tissue::skin && old != anatomy::tissue::air;
}

// The indices of a lattice whose voxels may lie in a box.
struct IndexBox {
  std::array<int, 3> low, high;
};

IndexBox indices_of(const anatomy::Grid& grid, const Vec3& low, const Vec3& high) {
  Vec3 least = Vec3::Constant(1e9), most = Vec3::Constant(-1e9);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 point((corner & 1) != 0 ? high.x() : low.x(), (corner & 2) != 0 ? high.y() : low.y(),
                     (corner & 4) != 0 ? high.z() : low.z());
    const Vec3 index = grid.to_index(point);
    least = least.cwiseMin(index), most = most.cwiseMax(index);
  }
  IndexBox box{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    box.low[a] = std::clamp(static_cast<int>(std::floor(least[axis])), 0, grid.size[a] - 1);
    box.high[a] = std::clamp(static_cast<int>(std::ceil(most[axis])), 0, grid.size[a] - 1);
  }
  return box;
}

IndexBox box_about(const anatomy::Grid& grid, const LumbarSpine& spine) {
  Vec3 low = Vec3::Constant(1e9), high = Vec3::Constant(-1e9);
  for (std::size_t n = 0; n < spine.tip.size(); ++n) {
    const CanalSection& s = spine.canal.sections[n];
    const double z = spine.canal.lowest + static_cast<double>(n);
    low = low.cwiseMin(Vec3(std::min(s.x - s.half_width - 8.0, spine.tip_x[n] - 8.0), s.front - 2.0, z - 1.0));
    high = high.cwiseMax(Vec3(std::max(s.x + s.half_width + 8.0, spine.tip_x[n] + 8.0), spine.tip[n] + 8.0, z + 1.0));
  }
  return indices_of(grid, low, high);
}

bool touches_other(const anatomy::TissueVolume& tissues, int i, int j, int k) {
  for (int dk = -1; dk <= 1; ++dk) {
    for (int dj = -1; dj <= 1; ++dj) {
      for (int di = -1; di <= 1; ++di) {
        if (!tissues.grid.contains(i + di, j + dj, k + dk)) continue;
        const anatomy::TissueId other = tissues.at(i + di, j + dj, k + dk);
        if (other != anatomy::tissue::cerebrospinal_fluid && other != anatomy::tissue::dura) return true;
      }
    }
  }
  return false;
}

}  // namespace

Vec3 sac_centre(const LumbarSpine& spine, double z) {
  const auto sections = sections_of(spine, 1.0);
  const double n = std::round(z - spine.canal.lowest + 0.5);
  const ConstructedSection& s =
      sections[static_cast<std::size_t>(std::clamp(n, 0.0, static_cast<double>(sections.size()) - 1.0))];
  return {s.x, s.sac_y, z};
}

void draw_lumbar(anatomy::TissueVolume& tissues, const LumbarSpine& spine) {
  const anatomy::Grid& grid = tissues.grid;
  const IndexBox box = box_about(grid, spine);
  constexpr double fine = 0.25;  // mm between prepared sections
  const std::vector<ConstructedSection> sections = sections_of(spine, fine);
  const auto section_of = [&](double z) -> const ConstructedSection& {
    const double n = std::round((z - spine.canal.lowest + 0.5) / fine);
    return sections[static_cast<std::size_t>(std::clamp(n, 0.0, static_cast<double>(sections.size()) - 1.0))];
  };
  const auto each = [&](const auto& work) {
    parallel_for(box.high[2] - box.low[2] + 1, [&](int n) {
      const int k = box.low[2] + n;
      for (int j = box.low[1]; j <= box.high[1]; ++j) {
        for (int i = box.low[0]; i <= box.high[0]; ++i) work(i, j, k);
      }
    });
  };
  each([&](int i, int j, int k) {
    anatomy::TissueId& voxel = tissues.at(i, j, k);
    if (!may_become(voxel)) return;
    const Vec3 p = grid.to_patient(Vec3(i, j, k));
    if (!spine.canal.covers(p.z())) return;
    const anatomy::TissueId drawn = tissue_at(section_of(p.z()), p.x(), p.y());
    if (drawn == anatomy::tissue::supraspinous_ligament && voxel == anatomy::tissue::fat) return;
    if (drawn != anatomy::tissue::air) voxel = drawn;
  });

  // The rim of the sac becomes dura; it is marked first, so that it does not grow inwards.
  MaskVolume rim;
  rim.grid = grid;
  for (std::size_t axis = 0; axis < 3; ++axis) rim.grid.size[axis] = box.high[axis] - box.low[axis] + 1;
  rim.voxels.assign(rim.grid.voxel_count(), 0);
  each([&](int i, int j, int k) {
    if (tissues.at(i, j, k) != anatomy::tissue::cerebrospinal_fluid || !touches_other(tissues, i, j, k)) return;
    rim.at(i - box.low[0], j - box.low[1], k - box.low[2]) = 1;
  });
  const double conus = conus_of(spine);
  each([&](int i, int j, int k) {
    anatomy::TissueId& voxel = tissues.at(i, j, k);
    if (voxel != anatomy::tissue::cerebrospinal_fluid) return;
    if (rim.at(i - box.low[0], j - box.low[1], k - box.low[2]) == 1) {
      voxel = anatomy::tissue::dura;
      return;
    }
    const Vec3 p = grid.to_patient(Vec3(i, j, k));
    const ConstructedSection& section = section_of(p.z());
    if (is_cord(section, p.x(), p.y(), p.z() - conus)) {
      voxel = anatomy::tissue::spinal_cord;
    } else if (is_root(section, p.x(), p.y())) {
      voxel = anatomy::tissue::nerve;
    }
  });
}

void muscle_behind(anatomy::TissueVolume& tissues, const SpinalCanal& canal) {
  const anatomy::Grid& grid = tissues.grid;
  parallel_for(grid.size[2], [&](int k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      anatomy::TissueId* row = &tissues.at(0, j, k);
      for (int i = 0; i < grid.size[0]; ++i) {
        if (row[i] != anatomy::tissue::soft) continue;
        const Vec3 p = grid.to_patient(Vec3(i, j, k));
        if (canal.covers(p.z()) && p.y() > canal.at(p.z()).front) row[i] = anatomy::tissue::muscle;
      }
    }
  });
}

}  // namespace bodkin::patient
