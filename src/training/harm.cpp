#include "training/harm.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "core/error.h"
#include "io/tissue_library_file.h"
#include "training/surface_voxels.h"

namespace bodkin::training {

namespace {

constexpr double near_miss_step = 0.25;  // mm of travel between two checks
constexpr double organ_wall = 10.0;      // mm of the planned path before the target in which its organ begins

// "inferior_vena_cava" becomes "inferior vena cava".
std::string spoken_name(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

const Forbidden* rule_about(const std::string& structure, const Procedure& procedure) {
  for (const Forbidden& each : procedure.forbidden)
    if (each.structure == structure) return &each;
  return nullptr;
}

std::set<std::uint16_t> guarded_labels(const anatomy::CaseDescription& description, const Procedure& procedure) {
  std::set<std::uint16_t> guarded;
  for (const anatomy::Structure& each : description.structures)
    if (each.critical || rule_about(each.name, procedure) != nullptr) guarded.insert(each.label);
  return guarded;
}

class HarmSearch {
 public:
  HarmSearch(const Attempt& attempt, const Procedure& procedure, const PatientVolumes& volumes)
      : attempt_(attempt),
        procedure_(procedure),
        volumes_(volumes),
        covered_(attempt.size(), 0),
        way_(way_in_body(attempt)) {}

  HarmReport search() {
    structures();
    tissues();
    std::stable_sort(report_.distances.begin(), report_.distances.end(),
                     [](const ForbiddenDistance& a, const ForbiddenDistance& b) {
                       return a.closest.value_or(unbounded) < b.closest.value_or(unbounded);
                     });
    std::stable_sort(report_.harms.begin(), report_.harms.end(), [](const Harm& a, const Harm& b) {
      return a.grade != b.grade ? a.grade > b.grade : a.first_time < b.first_time;
    });
    return std::move(report_);
  }

 private:
  bool forbids_tissue(const std::string& tissue) const {
    return !tissue.empty() && std::any_of(procedure_.forbidden.begin(), procedure_.forbidden.end(),
                                          [&](const Forbidden& each) { return each.tissue == tissue; });
  }

  // Labels of the organ that contains the planned target: from the target back along the path, as long as the label
  // is that of a structure that must not be entered.
  std::set<std::uint16_t> meant(const std::set<std::uint16_t>& guarded) const {
    std::set<std::uint16_t> found;
    const anatomy::NeedlePath& path = attempt_.path();
    const double length = path.length();
    for (double back = 0.0; back <= std::min(length, organ_wall); back += 0.5) {
      const Vec3 point = path.target - (length > 0.0 ? back * path.direction() : Vec3(Vec3::Zero()));
      const auto label = anatomy::nearest<std::uint16_t>(*volumes_.structures, point, 0);
      if (guarded.contains(label)) found.insert(label);
      if (label != 0 && !guarded.contains(label) && !found.empty()) break;
    }
    return found;
  }

  void structures() {
    const std::set<std::uint16_t> guarded = guarded_labels(attempt_.description(), procedure_);
    if (guarded.empty()) return;
    const bool can_look = volumes_.structures != nullptr && !volumes_.structures->empty();
    const std::set<std::uint16_t> aim = can_look ? meant(guarded) : std::set<std::uint16_t>();
    for (const anatomy::Structure& each : attempt_.description().structures) {
      if (!guarded.contains(each.label) || aim.contains(each.label)) continue;
      if (!can_look) {
        if (!forbids_tissue(each.tissue)) report_.unchecked.push_back(spoken_name(each.name));
        continue;
      }
      const Forbidden* rule = rule_about(each.name, procedure_);
      Forbidden forbidden;
      if (rule != nullptr) forbidden = *rule;
      if (forbidden.title.empty()) forbidden.title = "the " + spoken_name(each.name);
      const auto is_in = [&](std::size_t i) {
        return anatomy::nearest<std::uint16_t>(*volumes_.structures, attempt_.tip[i], 0) == each.label;
      };
      const auto distance = [&](const Vec3& tip) {
        return distance_to_value(*volumes_.structures, tip, each.label, forbidden.margin);
      };
      if (volumes_.surfaces == nullptr && !structure_surfaces_)
        structure_surfaces_.emplace(*volumes_.structures, guarded);
      const auto& surfaces = volumes_.surfaces != nullptr ? volumes_.surfaces->structures : *structure_surfaces_;
      look_for(forbidden, true, is_in, distance);
      measure_distance(forbidden, surfaces.nearest_to(each.label, way_));
    }
  }

  void tissues() {
    for (const Forbidden& each : procedure_.forbidden) {
      if (each.tissue.empty()) continue;
      const auto id = attempt_.find_tissue(each.tissue);
      if (!id) {
        require_known_tissue(each.tissue, procedure_);
        continue;  // a session of an older Bodkin that did not record it
      }
      Forbidden forbidden = each;
      if (forbidden.title.empty()) forbidden.title = attempt_.title_of(*id);
      const auto is_in = [&](std::size_t i) { return attempt_.tissue[i] == *id && covered_[i] == 0; };
      const bool can_look = volumes_.tissues != nullptr && !volumes_.tissues->empty();
      const auto distance = [&](const Vec3& tip) {
        return can_look ? distance_to_value(*volumes_.tissues, tip, *id, forbidden.margin) : forbidden.margin;
      };
      look_for(forbidden, false, is_in, distance);
      if (!can_look) continue;
      if (volumes_.surfaces == nullptr && !tissue_surfaces_)
        tissue_surfaces_.emplace(*volumes_.tissues, forbidden_tissues());
      const auto& surfaces = volumes_.surfaces != nullptr ? volumes_.surfaces->tissues : *tissue_surfaces_;
      measure_distance(forbidden, surfaces.nearest_to(*id, way_));
    }
  }

  std::set<std::uint8_t> forbidden_tissues() const {
    std::set<std::uint8_t> ids;
    for (const Forbidden& each : procedure_.forbidden)
      if (const auto id = attempt_.find_tissue(each.tissue); id && !each.tissue.empty()) ids.insert(*id);
    return ids;
  }

  // After look_for(), which knows entries and distances that the points of the way may have missed.
  void measure_distance(const Forbidden& forbidden, const std::optional<NearestVoxel>& nearest) {
    ForbiddenDistance found{.title = forbidden.title, .closest = {}};
    if (nearest) {
      found.closest = nearest->distance;
      found.time = attempt_.time[way_[nearest->point].tick];
      found.depth = attempt_.depth[way_[nearest->point].tick];
    }
    if (last_found_ && (!found.closest || last_found_->closest <= *found.closest)) {
      found.closest = last_found_->closest;
      found.time = last_found_->first_time;
      found.depth = last_found_->first_depth;
    }
    report_.distances.push_back(std::move(found));
  }

  template <typename IsIn, typename Distance>
  void look_for(const Forbidden& forbidden, bool covers, const IsIn& is_in, const Distance& distance) {
    Harm harm{.title = forbidden.title, .consequence = forbidden.consequence, .grade = forbidden.grade};
    double outside = std::numeric_limits<double>::infinity();  // mm travelled since the tip was last in it
    double since_look = std::numeric_limits<double>::infinity();
    harm.closest = forbidden.margin;
    for (std::size_t i = 0; i < attempt_.size(); ++i) {
      const double step = i > 0 ? (attempt_.tip[i] - attempt_.tip[i - 1]).norm() : 0.0;
      since_look += step;
      if (attempt_.inside[i] == 0 || !is_in(i)) {
        outside += step;
        const bool look =
            forbidden.margin > 0.0 && !harm.entered && attempt_.inside[i] != 0 && since_look >= near_miss_step;
        if (!look) continue;
        since_look = 0.0;
        const double here = distance(attempt_.tip[i]);
        if (here < harm.closest) {
          harm.closest = here;
          harm.first_time = attempt_.time[i];
          harm.first_depth = attempt_.depth[i];
        }
        continue;
      }
      if (covers) covered_[i] = 1;
      harm.time_inside += attempt_.dt();
      if (!harm.entered) {
        harm.entered = true;
        harm.first_time = attempt_.time[i];
        harm.first_depth = harm.deepest = attempt_.depth[i];
      }
      if (outside >= attempt_.thresholds().reentry) ++harm.entries;
      outside = 0.0;
      harm.deepest = std::max(harm.deepest, attempt_.depth[i]);
    }
    last_found_.reset();
    if (harm.entered) {
      harm.closest = 0.0;
    } else if (harm.closest < forbidden.margin) {
      harm.grade = Grade::borderline;
    } else {
      return;
    }
    last_found_ = harm;
    report_.harms.push_back(harm);
  }

  const Attempt& attempt_;
  const Procedure& procedure_;
  const PatientVolumes& volumes_;
  std::vector<char> covered_;  // ticks caused by an entry into a structure
  std::vector<WayPoint> way_;  // of the tip in the body
  std::optional<SurfaceVoxels<std::uint16_t>> structure_surfaces_;
  std::optional<SurfaceVoxels<std::uint8_t>> tissue_surfaces_;
  std::optional<Harm> last_found_;  // by look_for()
  HarmReport report_;
};

}  // namespace

void require_known_tissue(const std::string& tissue, const Procedure& procedure) {
  static const anatomy::TissueLibrary library = io::default_tissue_library();
  if (library.find(tissue) != nullptr) return;
  throw InputError(fmt::format(
      "the procedure {} names the tissue '{}', which neither the session's patient nor Bodkin knows; correct "
      "the name",
      procedure.name, tissue));
}

PatientSurfaces surfaces_of(const PatientVolumes& volumes, const anatomy::CaseDescription& description,
                            const anatomy::TissueLibrary& library, const Procedure& procedure) {
  std::set<std::uint8_t> tissues;
  for (const Forbidden& each : procedure.forbidden)
    if (const anatomy::TissueProperties* tissue = library.find(each.tissue)) tissues.insert(tissue->id);
  return {{*volumes.structures, guarded_labels(description, procedure)}, {*volumes.tissues, tissues}};
}

HarmReport find_harm(const Attempt& attempt, const Procedure& procedure, const PatientVolumes& volumes) {
  return HarmSearch(attempt, procedure, volumes).search();
}

template <typename Voxel>
double distance_to_value(const anatomy::Volume<Voxel>& volume, const Vec3& point, Voxel value, double limit) {
  const Vec3 index = volume.grid.to_index(point);
  int low[3], high[3];
  for (int axis = 0; axis < 3; ++axis) {
    const double reach = limit / volume.grid.spacing[axis] + 1.0;
    const double last = volume.grid.size[static_cast<std::size_t>(axis)] - 1;
    if (!(index[axis] + reach >= 0.0 && index[axis] - reach <= last)) return limit;
    low[axis] = static_cast<int>(std::max(0.0, std::floor(index[axis] - reach)));
    high[axis] = static_cast<int>(std::min(last, std::ceil(index[axis] + reach)));
  }
  double nearest = limit * limit;
  for (int k = low[2]; k <= high[2]; ++k) {
    for (int j = low[1]; j <= high[1]; ++j) {
      for (int i = low[0]; i <= high[0]; ++i) {
        if (volume.at(i, j, k) != value) continue;
        const Vec3 beyond = ((Vec3(i, j, k) - index).cwiseAbs().array() - 0.5).max(0.0);
        nearest = std::min(nearest, beyond.cwiseProduct(volume.grid.spacing).squaredNorm());
      }
    }
  }
  return std::sqrt(nearest);
}

template double distance_to_value(const anatomy::LabelVolume&, const Vec3&, std::uint16_t, double);
template double distance_to_value(const anatomy::TissueVolume&, const Vec3&, std::uint8_t, double);

}  // namespace bodkin::training
