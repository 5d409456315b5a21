#include "patient/from_ct/patient_builder.h"

#include <algorithm>
#include <numeric>

#include "patient/from_ct/body_surface.h"
#include "patient/from_ct/hounsfield_classes.h"
#include "patient/from_ct/lumbar_construction.h"
#include "patient/from_ct/lumbar_landmarks.h"
#include "patient/from_ct/marrow.h"
#include "patient/from_ct/midline_search.h"
#include "patient/from_ct/path_planner.h"
#include "patient/from_ct/spinal_canal.h"
#include "patient/from_ct/spine_view.h"
#include "patient/from_ct/tissue_lattice.h"
#include <fmt/format.h>

namespace bodkin::patient {
namespace {

constexpr double least_labelled_laminae = 15.0;  // mm of laminae that labels of vertebrae must show to be a spine
constexpr double below_lung = 60.0;  // mm, two vertebrae: how far below lung an interspace counts as lumbar
constexpr double least_side = 6.0;   // mm of image on either side of the midline, about half a canal

// The middle of the labelled vertebrae, slice by slice; labels of the sides balance.
std::vector<double> midline_of_labels(const SpineView& view) {
  const auto& size = view.grid().size;
  std::vector<double> x;
  double last = 0.5 * (view.x_of(0) + view.x_of(size[0] - 1));
  for (int k = 0; k < size[2]; ++k) {
    double sum = 0.0;
    int count = 0;
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        if (view.role.at(i, j, k) != spine_role::none) sum += view.x_of(i), ++count;
      }
    }
    if (count > 100) last = sum / count;
    x.push_back(last);
  }
  return moving_average(x, 25);
}

struct FoundSpine {
  SpineView view;
  LumbarSpine spine;
  std::string source;  // how it was found, for people
};

FoundSpine found_in(SpineView view, SpinalCanal canal, const char* source) {
  LumbarSpine spine = find_interspaces(view, std::move(canal));
  return {std::move(view), std::move(spine), source};
}

// LPS z of the lowest lung in the image; far above the image when it shows none.
double lung_base(const BodySurface& body) {
  double base = 1e9;
  const anatomy::Grid& grid = body.lung.grid;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        if (body.lung.at(i, j, k) == 1) base = std::min(base, grid.to_patient(Vec3(i, j, k)).z());
      }
    }
  }
  return base;
}

// Why a spine that only bone shows is no lumbar spine that a needle could be planned into, as the end of a sentence;
// empty when it may be one.
std::string why_not_lumbar(const LumbarSpine& spine, const anatomy::CtVolume& ct, const BodySurface& body) {
  const PatientBox image = box_of_image(ct.grid);
  const auto& sections = spine.canal.sections;
  const auto cut = std::count_if(sections.begin(), sections.end(), [&](const CanalSection& section) {
    return std::min(section.x - image.low.x(), image.high.x() - section.x) < least_side;
  });
  if (cut > static_cast<std::ptrdiff_t>(sections.size() / 2)) return "the image border cuts it lengthwise";
  if (spine.interspaces.back().middle() > lung_base(body) - below_lung) {
    return fmt::format("it lies at the level of the lungs or less than {:.0f} mm below, where vertebrae are thoracic",
                       below_lung);
  }
  return "";
}

// `why_not` becomes what speaks against a spine that bone shows, when it was not taken.
std::optional<FoundSpine> find_spine(const anatomy::CtVolume& ct, const anatomy::LabelVolume& structures,
                                     const std::vector<std::uint8_t>& roles, anatomy::TissueVolume& tissues,
                                     const BodySurface& body, std::string& why_not) {
  constexpr double spacing = 1.0;
  const auto bones = box_of_roles(structures, roles, 1, spine_role::vertebra);
  const auto canal_box = box_of_roles(structures, roles, spine_role::canal, spine_role::canal);
  std::optional<SpinalCanal> canal;
  if (canal_box) {
    PatientBox box = *canal_box;
    const double middle = 0.5 * (box.low.x() + box.high.x()),
                 half = std::max(35.0, 0.5 * (box.high.x() - box.low.x()) + 20.0);
    box.low.x() = middle - half, box.high.x() = middle + half;
    box.low.y() -= 10.0;
    box.high.y() = std::max(box.high.y() + 70.0, bones ? bones->high.y() + 10.0 : box.high.y());
    SpineView view = view_spine(ct, structures, roles, tissues, box, spacing);
    canal = canal_from_label(view);
    if (canal) return found_in(std::move(view), std::move(*canal), "the labels of the spinal canal");
  }
  if (bones) {
    PatientBox box = *bones;
    box.low -= Vec3(2.0, 2.0, 2.0), box.high += Vec3(2.0, 15.0, 2.0);
    SpineView view = view_spine(ct, structures, roles, tissues, box, spacing);
    canal = canal_from_bone(view, midline_of_labels(view), least_labelled_laminae);
    if (canal) return found_in(std::move(view), std::move(*canal), "the labels of the vertebrae");
  }
  if (const auto midline = find_midline(ct, tissues, body)) {
    SpineView view = view_spine(ct, structures, roles, tissues, midline->box, spacing);
    std::vector<double> x;
    for (int k = 0; k < view.grid().size[2]; ++k) x.push_back(midline->x_at(view.z_of(k)));
    canal = canal_from_bone(view, x, 2 * least_labelled_laminae);
    // The spinous processes show the midline finer than the search did.
    for (int pass = 0; pass < 2 && canal; ++pass) {
      const LumbarSpine spine = find_interspaces(view, *canal);
      for (std::size_t k = 0; k < x.size(); ++k) {
        const double n = std::clamp(view.z_of(static_cast<int>(k)) - canal->lowest, 0.0, spine.tip_x.size() - 1.0);
        x[k] = spine.tip_x[static_cast<std::size_t>(n)];
      }
      canal = canal_from_bone(view, x, 2 * least_labelled_laminae);
    }
    if (!canal) return std::nullopt;
    const LumbarSpine bare = find_interspaces(view, *canal);
    if (bare.interspaces.empty()) return std::nullopt;  // without them bone alone proves no spine
    why_not = why_not_lumbar(bare, ct, body);
    if (!why_not.empty()) return std::nullopt;
    fill_marrow(view, tissues, *canal);
    FoundSpine found = found_in(std::move(view), std::move(*canal), "bone and midline of the CT");
    if (!found.spine.interspaces.empty()) return found;
  }
  return std::nullopt;
}

std::string list_of(const std::vector<Interspace>& spaces) {
  std::string text;
  for (const Interspace& gap : spaces) text += (text.empty() ? "" : ", ") + gap.name;
  return text;
}

void add_landmarks(BuiltPatient& patient, const LumbarSpine& spine, const std::vector<PlannedPath>& paths) {
  for (const Interspace& gap : spine.interspaces) {
    const CanalSection canal = spine.canal.at(gap.middle());
    const Vec3 centre(canal.x, 0.5 * (canal.front + canal.back), gap.middle());
    patient.landmarks.push_back({gap.name, centre});
    const auto path =
        std::find_if(paths.begin(), paths.end(), [&](const PlannedPath& p) { return p.interspace == gap.name; });
    if (path != paths.end()) {
      if (path->from_skin) patient.landmarks.push_back({gap.name + "_skin", path->path.entry});
    } else if (const SkinPoint skin = skin_along(patient.tissues, centre, Vec3::UnitY()); skin.skin) {
      patient.landmarks.push_back({gap.name + "_skin", skin.point});
    }
  }
}

void build_lumbar(BuiltPatient& patient, const FoundSpine& found, bool plan) {
  const LumbarSpine& spine = found.spine;
  draw_lumbar(patient.tissues, spine);
  muscle_behind(patient.tissues, spine.canal);
  if (spine.interspaces.empty()) {
    patient.notes.push_back(
        fmt::format("A spinal canal was found from {}, but no lumbar interspace: its contents are "
                    "constructed, ligaments are not.",
                    found.source));
    return;
  }
  patient.notes.push_back(fmt::format(
      "Ligaments, epidural space and dura are constructed from {} with textbook thicknesses; interspaces found: {}.",
      found.source, list_of(spine.interspaces)));
  if (spine.counted_from_sacrum) {
    patient.notes.emplace_back("Levels are counted up from the sacrum, assuming five lumbar vertebrae.");
  } else if (!spine.levels_known) {
    patient.notes.emplace_back("The levels of the vertebrae are not known, so interspaces are numbered from below.");
  }
  const auto paths = plan_paths(patient.tissues, found.view, spine);
  add_landmarks(patient, spine, paths);
  if (!plan) return;
  if (const auto best = best_path(paths)) {
    patient.path = best->path;
    std::string passed;
    for (const PlannedPath& narrow : passed_over(paths, *best)) {
      passed += fmt::format("{} {} {:.1f} mm", passed.empty() ? ";" : ",", narrow.interspace, narrow.clearance);
    }
    if (!passed.empty()) passed += passed.find(',') == std::string::npos ? " is narrower" : " are narrower";
    patient.notes.push_back(
        fmt::format("The path was planned through {}, {:.0f} degrees cephalad, {:.0f} mm long, with {:.1f} mm to the "
                    "nearest bone{}{}.",
                    best->interspace, best->cephalad, best->path.length(), best->clearance, passed,
                    best->from_skin ? "" : "; it starts where the image ends, because there is no skin"));
  } else {
    patient.notes.emplace_back("No straight path through an interspace stays clear of bone; give one yourself.");
  }
}

// Sides on which the image border cuts the body, for people.
void note_cut_faces(BuiltPatient& patient) {
  const anatomy::Grid& grid = patient.tissues.grid;
  static constexpr std::array<const char*, 6> sides = {"right", "left", "front", "back", "foot", "head"};
  std::string cut;
  for (int lps = 0; lps < 3; ++lps) {
    for (const int high : {0, 1}) {
      Eigen::Index axis = 0;
      grid.direction.row(lps).cwiseAbs().maxCoeff(&axis);
      const bool far = (grid.direction(lps, axis) > 0.0) == (high == 1);
      std::array<int, 3> low = {0, 0, 0}, top = {grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1};
      low[static_cast<std::size_t>(axis)] = top[static_cast<std::size_t>(axis)] =
          far ? grid.size[static_cast<std::size_t>(axis)] - 1 : 0;
      long body = 0, count = 0;
      for (int k = low[2]; k <= top[2]; k += 2) {
        for (int j = low[1]; j <= top[1]; j += 2) {
          for (int i = low[0]; i <= top[0]; i += 2, ++count)
            body += patient.tissues.at(i, j, k) != anatomy::tissue::air ? 1 : 0;
        }
      }
      if (body > count / 50) {
        const int side = 2 * lps + high;
        cut += (cut.empty() ? "" : ", ") + std::string(sides[static_cast<std::size_t>(side)]);
      }
    }
  }
  if (!cut.empty())
    patient.notes.push_back(fmt::format("The image border cuts the body ({}); cut faces have no skin.", cut));
}

void note_metal(BuiltPatient& patient) {
  const auto& voxels = patient.tissues.voxels;
  const auto metal = static_cast<double>(std::count(voxels.begin(), voxels.end(), anatomy::tissue::metal));
  if (metal == 0.0) return;
  patient.notes.push_back(fmt::format("Metal in the body ({:.1f} mL above 2500 HU) stops the needle as bone does.",
                                      metal * patient.tissues.grid.spacing.prod() / 1e3));
}

}  // namespace

BuiltPatient build_patient(const anatomy::CtVolume& ct, const anatomy::LabelVolume& structures,
                           const std::vector<anatomy::Structure>& table, const PatientOptions& options,
                           const Progress& progress) {
  const auto report = [&](const char* stage, double fraction) {
    if (progress) progress(stage, fraction);
  };
  BuiltPatient patient;
  patient.path = options.path;
  report("Finding the body", 0.0);
  const BodySurface body = find_body(ct, structures, table);
  patient.notes = body.notes;
  const TissueLattice lattice = divide_lattice(ct.grid, options.tissue_spacing);
  report("Telling tissues apart", 0.0);
  patient.tissues = classify_tissues(ct, structures, table, options.library, lattice, body, progress);
  report("Drawing the skin", 0.0);
  draw_skin(patient.tissues);
  if (body.has_skin) note_cut_faces(patient);
  note_metal(patient);
  if (options.construct_lumbar) {
    report("Building the spine", 0.0);
    const auto roles = spine_roles(table);
    std::string why_not;
    if (const auto found = find_spine(ct, structures, roles, patient.tissues, body, why_not)) {
      build_lumbar(patient, *found, !options.path.has_value());
    } else {
      patient.notes.push_back(fmt::format(
          "No {} was constructed, because {}.",
          options.path ? "ligament and no dura" : "path was planned, and no ligament and no dura",
          why_not.empty() ? "no lumbar spine was found" : "the spine that was found is not lumbar: " + why_not));
    }
  }
  report("Building the spine", 1.0);
  return patient;
}

}  // namespace bodkin::patient
