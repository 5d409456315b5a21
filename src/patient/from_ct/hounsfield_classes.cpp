#include "patient/from_ct/hounsfield_classes.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <string>

#include "patient/from_ct/row_sampler.h"
#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel_for.h"

namespace bodkin::patient {
namespace {

// Borders between classes, HU. Fat is about -100, muscle 10 to 40, cortical bone 400 and more, lung -900
// (reference/hounsfield.csv); each border lies where the partial volumes of its two sides meet.
constexpr float gas_below = -400.0F;
constexpr float fat_below = -30.0F;
constexpr float clear_fat_below = -60.0F;
constexpr float bone_above = 200.0F;         // as measured
constexpr float bone_smooth_above = 140.0F;  // and after smoothing, so that single noisy voxels are not bone
constexpr float cortical_above = 400.0F;
constexpr float metal_above = 2500.0F;
constexpr float viscera_depth = 45.0F;  // mm below the skin: deeper unlabelled soft tissue is not body wall

// The effect of a label on its voxels; a tissue id stands for itself.
using LabelAction = std::uint16_t;
constexpr LabelAction by_bone = 1000, by_hounsfield = 1001;

const std::map<std::string, anatomy::TissueId, std::less<>>& tissue_names() {
  static const std::map<std::string, anatomy::TissueId, std::less<>> names = {
      {"air", anatomy::tissue::air},
      {"skin", anatomy::tissue::skin},
      {"fat", anatomy::tissue::fat},
      {"muscle", anatomy::tissue::muscle},
      {"soft", anatomy::tissue::soft},
      {"cortical_bone", anatomy::tissue::cortical_bone},
      {"cancellous_bone", anatomy::tissue::cancellous_bone},
      {"disc", anatomy::tissue::disc},
      {"supraspinous_ligament", anatomy::tissue::supraspinous_ligament},
      {"interspinous_ligament", anatomy::tissue::interspinous_ligament},
      {"ligamentum_flavum", anatomy::tissue::ligamentum_flavum},
      {"epidural_fat", anatomy::tissue::epidural_fat},
      {"dura", anatomy::tissue::dura},
      {"cerebrospinal_fluid", anatomy::tissue::cerebrospinal_fluid},
      {"nerve", anatomy::tissue::nerve},
      {"vessel", anatomy::tissue::vessel},
      {"organ", anatomy::tissue::organ},
      {"lung", anatomy::tissue::lung},
      {"gas", anatomy::tissue::gas},
      {"metal", anatomy::tissue::metal},
      {"mass", anatomy::tissue::mass},
      {"cartilage", anatomy::tissue::cartilage},
      {"spinal_cord", anatomy::tissue::spinal_cord}};
  return names;
}

std::vector<LabelAction> label_actions(const std::vector<anatomy::Structure>& table,
                                       const anatomy::TissueLibrary& library) {
  std::vector<LabelAction> actions(65536, by_hounsfield);
  for (const anatomy::Structure& structure : table) {
    LabelAction& action = actions[structure.label];
    if (structure.tissue.empty() || structure.tissue == "spinal_canal") continue;
    if (structure.tissue == "bone") {
      action = by_bone;
    } else if (const auto found = tissue_names().find(structure.tissue); found != tissue_names().end()) {
      action = found->second;
    } else if (const anatomy::TissueProperties* entry = library.find(structure.tissue); entry != nullptr) {
      action = entry->id;
    } else {
      throw InputError(
          fmt::format("structure {} ({}) names the tissue \"{}\", which is neither Bodkin's nor in the "
                      "tissue library; use a name of the library, \"bone\", \"spinal_canal\", or nothing for HU",
                      structure.label, structure.name, structure.tissue));
    }
  }
  return actions;
}

// CT with noise finer than about a millimetre averaged out; coarse voxels remain nearly unchanged.
anatomy::CtVolume smoothed(const anatomy::CtVolume& ct) {
  constexpr double sigma = 1.0;  // mm
  anatomy::CtVolume out = ct;
  const auto& size = ct.grid.size;
  // One line of voxels, `step` apart in memory.
  const auto smooth_line = [](std::int16_t* line, int count, std::size_t step, float side) {
    const auto clean = [](std::int16_t value) { return std::clamp(static_cast<float>(value), -1024.0F, 3000.0F); };
    float before = clean(line[0]);
    for (int n = 0; n < count; ++n) {
      std::int16_t& voxel = line[static_cast<std::size_t>(n) * step];
      const float here = clean(voxel);
      const float after = n + 1 < count ? clean(line[static_cast<std::size_t>(n + 1) * step]) : here;
      voxel = static_cast<std::int16_t>(std::lround(here + side * (before + after - 2 * here)));
      before = here;
    }
  };
  std::array<float, 3> side{};
  for (int axis = 0; axis < 3; ++axis) {
    const double w = std::exp(-0.5 * std::pow(ct.grid.spacing[axis] / sigma, 2));
    side[static_cast<std::size_t>(axis)] = static_cast<float>(w / (1 + 2 * w));
  }
  const auto row = static_cast<std::size_t>(size[0]), slice = row * static_cast<std::size_t>(size[1]);
  parallel_for(size[2], [&](int k) {
    for (int j = 0; j < size[1]; ++j) smooth_line(&out.at(0, j, k), size[0], 1, side[0]);
    for (int i = 0; i < size[0]; ++i) smooth_line(&out.at(i, 0, k), size[1], row, side[1]);
  });
  parallel_for(size[1], [&](int j) {
    for (int i = 0; i < size[0]; ++i) smooth_line(&out.at(i, j, 0), size[2], slice, side[2]);
  });
  return out;
}

// Whether a label voxel has a neighbour of another label.
bool at_border(const anatomy::LabelVolume& labels, int i, int j, int k) {
  const std::uint16_t here = labels.at(i, j, k);
  for (int n = 0; n < 6; ++n) {
    const int step = n % 2 == 0 ? -1 : 1;
    const int x = i + (n / 2 == 0 ? step : 0), y = j + (n / 2 == 1 ? step : 0), z = k + (n / 2 == 2 ? step : 0);
    if (labels.grid.contains(x, y, z) && labels.at(x, y, z) != here) return true;
  }
  return false;
}

struct Sample {
  float raw, smooth;  // HU as measured, and smoothed
  float depth;        // mm below the skin
  bool in_lung;
};

anatomy::TissueId soft_class(const Sample& s) {
  if (s.smooth < fat_below) return anatomy::tissue::fat;
  return s.in_lung || s.depth > viscera_depth ? anatomy::tissue::soft : anatomy::tissue::muscle;
}

anatomy::TissueId by_hounsfield_alone(const Sample& s) {
  if (s.raw < gas_below) return s.in_lung ? anatomy::tissue::lung : anatomy::tissue::gas;
  if (s.raw > metal_above) return anatomy::tissue::metal;
  const bool bone = (s.raw > bone_above && s.smooth > bone_smooth_above) || s.smooth > bone_above + 20;
  if (bone) return s.raw > cortical_above ? anatomy::tissue::cortical_bone : anatomy::tissue::cancellous_bone;
  return soft_class(s);
}

anatomy::TissueId by_label(LabelAction action, const Sample& s, bool border) {
  const anatomy::TissueId alone = by_hounsfield_alone(s);
  if (action == by_hounsfield || alone == anatomy::tissue::metal) return alone;
  if (action == anatomy::tissue::lung)
    return alone == anatomy::tissue::gas    ? anatomy::tissue::lung
           : anatomy::tissue::soft == alone ? anatomy::tissue::lung
                                            : alone;
  if (alone == anatomy::tissue::gas || alone == anatomy::tissue::lung) return alone;
  if (action == by_bone) {
    if (border && s.smooth < clear_fat_below) return alone;
    return s.raw > cortical_above ? anatomy::tissue::cortical_bone : anatomy::tissue::cancellous_bone;
  }
  if (action == anatomy::tissue::muscle && is_bone(alone)) return alone;
  return static_cast<anatomy::TissueId>(action);
}

// The shell of a bone is cortical, even if partial volume lowered its HU.
void draw_cortex(anatomy::TissueVolume& tissues) {
  const anatomy::Grid& grid = tissues.grid;
  const auto& size = grid.size;
  const auto row = static_cast<std::ptrdiff_t>(size[0]), slice = row * size[1];
  const std::array<std::ptrdiff_t, 6> neighbours = {-1, 1, -row, row, -slice, slice};
  // Cancellous bone only turns cortical, and both count as bone, so threads may read bytes written by others.
  parallel_for(size[2] - 2, [&](int below) {
    const int k = below + 1;
    for (int j = 1; j < size[1] - 1; ++j) {
      for (int i = 1; i < size[0] - 1; ++i) {
        anatomy::TissueId* voxel = &tissues.at(i, j, k);
        if (*voxel != anatomy::tissue::cancellous_bone) continue;
        for (const std::ptrdiff_t step : neighbours) {
          const anatomy::TissueId other =
              std::atomic_ref<anatomy::TissueId>(voxel[step]).load(std::memory_order_relaxed);
          if (is_bone(other) || other == anatomy::tissue::disc || other == anatomy::tissue::cartilage) continue;
          std::atomic_ref<anatomy::TissueId>(*voxel).store(anatomy::tissue::cortical_bone, std::memory_order_relaxed);
          break;
        }
      }
    }
  });
}

}  // namespace

bool is_bone(anatomy::TissueId id) {
  return id == anatomy::tissue::cortical_bone || id == anatomy::tissue::cancellous_bone ||
         id == anatomy::tissue::metal;
}

anatomy::TissueVolume classify_tissues(const anatomy::CtVolume& ct, const anatomy::LabelVolume& structures,
                                       const std::vector<anatomy::Structure>& table,
                                       const anatomy::TissueLibrary& library, const TissueLattice& lattice,
                                       const BodySurface& body, const Progress& progress) {
  const auto actions = label_actions(table, library);
  const anatomy::CtVolume calm = smoothed(ct);
  anatomy::TissueVolume tissues(lattice.grid);
  const RowSampler raw(ct, lattice.grid), smooth(calm, lattice.grid);
  const RowSampler distance(body.distance, lattice.grid);
  const RowSampler lung(body.lung, lattice.grid);
  const auto& parts = lattice.parts;
  const auto edge = static_cast<float>(body.edge);
  std::atomic<int> done = 0;
  parallel_for(lattice.grid.size[2], [&](int k) {
    thread_local std::vector<float> raws, smooths, distances, lungs, scratch;
    for (int j = 0; j < lattice.grid.size[1]; ++j) {
      distance.read(j, k, distances, scratch);
      if (*std::min_element(distances.begin(), distances.end()) > edge) continue;  // a row of air
      raw.read(j, k, raws, scratch);
      smooth.read(j, k, smooths, scratch);
      lung.read(j, k, lungs, scratch);
      anatomy::TissueId* row = &tissues.at(0, j, k);
      for (std::size_t i = 0; i < raws.size(); ++i) {
        const float d = distances[i];
        // Blocks separate inside from outside, except for one block around the surface, where the skin's HU decide.
        if (d > edge || (d > -edge && raws[i] < skin_surface_hounsfield && body.has_skin)) continue;
        const Sample sample = {raws[i], smooths[i], -d, lungs[i] > 0.5F};
        LabelAction action = by_hounsfield;
        bool border = false;
        if (!structures.empty()) {
          const int x = static_cast<int>(i) / parts[0], y = j / parts[1], z = k / parts[2];
          action = actions[structures.at(x, y, z)];
          border = action == by_bone && sample.smooth < clear_fat_below && at_border(structures, x, y, z);
        }
        row[i] = by_label(action, sample, border);
      }
    }
    const int slices = ++done;
    if (progress && slices % 16 == 0)
      progress("Telling tissues apart", static_cast<double>(slices) / lattice.grid.size[2]);
  });
  draw_cortex(tissues);
  return tissues;
}

void draw_skin(anatomy::TissueVolume& tissues) {
  const anatomy::Grid& grid = tissues.grid;
  const auto& size = grid.size;
  struct Step {
    int i, j, k;
  };
  std::vector<Step> ball;  // body voxels within the skin's thickness of the centre of an air voxel at the surface
  const double reach = skin_thickness + 0.5 * grid.spacing.minCoeff();
  const Vec3 most = (reach / grid.spacing.array()).floor();
  for (int k = -static_cast<int>(most.z()); k <= most.z(); ++k) {
    for (int j = -static_cast<int>(most.y()); j <= most.y(); ++j) {
      for (int i = -static_cast<int>(most.x()); i <= most.x(); ++i) {
        if (grid.spacing.cwiseProduct(Vec3(i, j, k)).norm() <= reach) ball.push_back({i, j, k});
      }
    }
  }
  const auto body_at = [&](int i, int j, int k) {
    return grid.contains(i, j, k) && tissues.at(i, j, k) != anatomy::tissue::air;
  };
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        if (tissues.at(i, j, k) != anatomy::tissue::air) continue;
        if (!body_at(i - 1, j, k) && !body_at(i + 1, j, k) && !body_at(i, j - 1, k) && !body_at(i, j + 1, k) &&
            !body_at(i, j, k - 1) && !body_at(i, j, k + 1)) {
          continue;
        }
        for (const Step& s : ball) {
          if (body_at(i + s.i, j + s.j, k + s.k)) tissues.at(i + s.i, j + s.j, k + s.k) = anatomy::tissue::skin;
        }
      }
    }
  }
}

void thicken_skin(anatomy::TissueVolume& tissues, const BodySurface& body) {
  constexpr double deepest = 6.0, to_fat = 4.0;  // mm
  const anatomy::Grid& grid = tissues.grid;
  const auto depth_at = [&](const Vec3& p) { return -anatomy::linear(body.distance, p, 1e3F); };
  // Whether skin lies outwards and fat inwards of p, with only dense soft tissue in between.
  const auto between_skin_and_fat = [&](const Vec3& p) {
    Vec3 inwards;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = body.edge * Vec3::Unit(axis);
      inwards[axis] = depth_at(p + step) - depth_at(p - step);
    }
    if (!(inwards.norm() > 1e-6)) return false;
    inwards.normalize();
    const auto meets = [&](const Vec3& direction, anatomy::TissueId wanted, double within) {
      for (double way = 0.5; way <= within; way += 0.5) {
        const anatomy::TissueId id = anatomy::nearest(tissues, Vec3(p + way * direction), anatomy::tissue::air);
        if (id == wanted) return true;
        if (id != anatomy::tissue::muscle && id != anatomy::tissue::skin) return false;
      }
      return false;
    };
    return meets(-inwards, anatomy::tissue::skin, deepest) && meets(inwards, anatomy::tissue::fat, to_fat);
  };
  const RowSampler distance(body.distance, grid);
  std::vector<std::vector<std::size_t>> dermis(static_cast<std::size_t>(grid.size[2]));  // offsets, by slice
  parallel_for(grid.size[2], [&](int k) {
    thread_local std::vector<float> distances, scratch;
    for (int j = 0; j < grid.size[1]; ++j) {
      distance.read(j, k, distances, scratch);
      const auto [nearest_edge, deepest_edge] = std::minmax_element(distances.begin(), distances.end());
      if (*deepest_edge < -deepest || *nearest_edge > body.edge) continue;  // a row of depth, or of air
      for (int i = 0; i < grid.size[0]; ++i) {
        const float depth = -distances[static_cast<std::size_t>(i)];
        if (depth >= deepest || depth <= -body.edge || tissues.at(i, j, k) != anatomy::tissue::muscle) continue;
        if (between_skin_and_fat(grid.to_patient(Vec3(i, j, k))))
          dermis[static_cast<std::size_t>(k)].push_back(grid.offset(i, j, k));
      }
    }
  });
  for (const std::vector<std::size_t>& slice : dermis) {
    for (const std::size_t offset : slice) tissues.voxels[offset] = anatomy::tissue::skin;
  }
}

}  // namespace bodkin::patient
