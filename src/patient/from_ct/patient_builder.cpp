#include "patient/from_ct/patient_builder.h"

#include <algorithm>
#include <numeric>

#include "patient/from_ct/body_surface.h"
#include "patient/from_ct/contrast_search.h"
#include "patient/from_ct/dense_pieces.h"
#include "patient/from_ct/hounsfield_classes.h"
#include "patient/from_ct/lumbar_construction.h"
#include "patient/from_ct/path_planner.h"
#include "patient/from_ct/spine_search.h"
#include "patient/from_ct/spine_view.h"
#include "patient/from_ct/tissue_lattice.h"
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::patient {
namespace {

std::string list_of(const std::vector<Interspace>& spaces) {
  std::string text;
  for (const Interspace& gap : spaces) text += (text.empty() ? "" : ", ") + gap.name;
  return text;
}

void add_landmarks(BuiltPatient& patient, const LumbarSpine& spine, const std::vector<PlannedPath>& paths) {
  if (spine.conus && spine.canal.covers(*spine.conus)) {
    const CanalSection canal = spine.canal.at(*spine.conus);
    patient.landmarks.push_back({"conus", Vec3(canal.x, 0.5 * (canal.front + canal.back), *spine.conus)});
  }
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

// The evidence for the levels, and the end of the cord.
void note_levels(BuiltPatient& patient, const LumbarSpine& spine) {
  const VertebralLevels& levels = spine.levels;
  if (!levels.known()) {
    patient.notes.push_back(fmt::format(
        "The levels of the vertebrae are not known, so interspaces are numbered from below and the whole canal "
        "counts as holding cord: {}.",
        levels.evidence));
    return;
  }
  patient.notes.push_back(fmt::format("{} Confidence: {}.", levels.evidence, to_string(levels.confidence)));
  const std::string conus = fmt::format("{}{}", describe_place(spine.conus_place),
                                        spine.conus_place == adult_conus ? ", the mean of adults" : "");
  if (!spine.conus || spine.canal.covers(*spine.conus)) {
    patient.notes.push_back(fmt::format("The spinal cord is drawn down to the {}.", conus));
  } else if (*spine.conus > spine.canal.highest()) {
    patient.notes.push_back(fmt::format("The spinal cord ends above the canal seen here, at the {}.", conus));
  } else {
    patient.notes.push_back(
        fmt::format("The spinal cord runs through the whole canal seen here and ends below it, at the {}.", conus));
  }
}

// Layers of each interspace seen in the CT, and those from textbooks.
void note_layers(BuiltPatient& patient, const LumbarSpine& spine) {
  std::string text;
  for (const Interspace& gap : spine.interspaces) {
    const auto& [wall, fat] = gap.seen;
    text +=
        fmt::format("{}{} {}, {}", text.empty() ? "" : "; ", gap.name,
                    wall ? fmt::format("flavum seen to +-{:.1f} mm", wall->uncertainty)
                         : std::string("flavum textbook to +-3 mm"),
                    fat ? fmt::format("epidural fat {:.1f} mm deep seen to +-{:.1f} mm", fat->value, fat->uncertainty)
                        : std::string("epidural fat textbook to +-2 mm"));
  }
  patient.notes.push_back(fmt::format("Layers, front edge of the flavum and depth of the epidural fat: {}.", text));
}

std::string path_note(const PathChoice& choice) {
  const PlannedPath& best = *choice.path;
  std::string passed;
  for (const PlannedPath& narrow : choice.passed_over) {
    passed += fmt::format("{} {} {:.1f} mm", passed.empty() ? ";" : ",", narrow.interspace, narrow.clearance);
  }
  if (!passed.empty()) passed += choice.passed_over.size() == 1 ? " is narrower" : " are narrower";
  return fmt::format(
      "The path was planned through {}, {:.0f} degrees cephalad, {:.0f} mm long, with {:.1f} mm to the nearest "
      "bone{}{}.",
      best.interspace, best.cephalad, best.path.length(), best.clearance, passed,
      best.from_skin ? "" : "; it starts where the image ends, because there is no skin");
}

void build_lumbar(BuiltPatient& patient, const FoundSpine& found, const PatientOptions& options) {
  const LumbarSpine& spine = found.spine;
  draw_lumbar(patient.tissues, spine);
  muscle_behind(patient.tissues, spine.canal);
  if (spine.interspaces.empty()) {
    patient.notes.push_back(
        fmt::format("A spinal canal was found from {}, but no lumbar interspace: its contents are constructed, "
                    "ligaments are not.",
                    found.source));
    return;
  }
  patient.notes.push_back(
      fmt::format("Ligaments, epidural space and dura are constructed from {} with textbook thicknesses where the CT "
                  "shows none; interspaces found: {}.",
                  found.source, list_of(spine.interspaces)));
  note_layers(patient, spine);
  note_levels(patient, spine);
  const auto paths = plan_paths(patient.tissues, found.view, spine);
  add_landmarks(patient, spine, paths);
  if (options.path || (!options.plan && options.level.empty())) return;
  const PathChoice choice = choose_path(paths, spine, options.level, options.levels);
  if (choice.path) patient.path = choice.path->path;
  patient.notes.push_back(choice.path ? path_note(choice)
                                      : fmt::format("No path was planned, because {}.", choice.why_not));
  const bool allowed = options.level.empty() || options.levels.empty() ||
                       std::find(options.levels.begin(), options.levels.end(), options.level) != options.levels.end();
  if (!allowed) {
    patient.notes.push_back(fmt::format(
        "The procedure is not meant to be done at {}; its score will count that as the wrong level.", options.level));
  }
}

// The user's path must not enter the cord, nor may a level be requested if no spine was found.
void check_options(const BuiltPatient& patient, const PatientOptions& options, bool levels_known) {
  if (!options.level.empty() && !patient.path) {
    throw InputError(fmt::format("--level is {}, but no lumbar interspace was found in this CT", options.level));
  }
  if (!options.path) return;
  const auto depth = depth_of_cord(patient.tissues, *options.path, 0.0);
  if (!depth) return;
  throw InputError(fmt::format(
      "the path from --entry to --target goes into the spinal cord {:.1f} mm from its entry; {}", *depth,
      levels_known ? "choose a target below the conus, or say with --conus where the cord of this patient ends"
                   : "the levels of this spine are not known: if it is the cauda equina, say with "
                     "--lowest-vertebra which vertebra lies above the lowest interspace"));
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
  for (std::string& note : remove_dense_pieces(patient.tissues, ct, structures, lattice, body))
    patient.notes.push_back(std::move(note));
  const double contrast = take_out_contrast_on_bone(patient.tissues, ct, structures, lattice, body);
  if (contrast > 0.0) {
    patient.notes.push_back(fmt::format(
        "Contrast that touches bone, long, even in HU and without a shell as bone has ({:.0f} mL), was taken for "
        "vessels.",
        contrast));
  }
  report("Drawing the skin", 0.0);
  draw_skin(patient.tissues);
  if (body.has_skin) thicken_skin(patient.tissues, body);
  if (body.has_skin) note_cut_faces(patient);
  note_metal(patient);
  if (options.construct_lumbar) {
    report("Building the spine", 0.0);
    const auto roles = spine_roles(table);
    std::string why_not;
    bool levels_known = false;
    if (const auto found = find_spine({ct, structures, roles, patient.tissues, body, options}, why_not)) {
      build_lumbar(patient, *found, options);
      levels_known = found->spine.levels.known();
    } else {
      patient.notes.push_back(fmt::format(
          "No {} was constructed, because {}.",
          options.path ? "ligament and no dura" : "path was planned, and no ligament and no dura",
          why_not.empty() ? "no lumbar spine was found"
                          : fmt::format("the spine that was found is not taken for lumbar: {}; if it is, say with "
                                        "--lowest-vertebra which vertebra lies above its lowest interspace",
                                        why_not)));
    }
    check_options(patient, options, levels_known);
  }
  report("Building the spine", 1.0);
  return patient;
}

}  // namespace bodkin::patient
