#include "patient/from_ct/relabel.h"

#include <algorithm>
#include <optional>
#include <set>

#include "patient/from_ct/patient_builder.h"
#include "patient/planning/path_search.h"
#include <fmt/format.h>

#include "core/error.h"
#include "io/case_folder.h"
#include "io/case_soundness.h"
#include "io/digest.h"
#include "io/images/image_source.h"
#include "io/nrrd_writer.h"
#include "io/partial_folder.h"

namespace bodkin::patient {
namespace {

constexpr const char* structures_name = "structures.nrrd";
constexpr const char* relabelled_tissues_name = "tissues.nrrd";

Progress part_of(const Progress& progress, double from, double to) {
  if (!progress) return {};
  return [=](std::string_view stage, double fraction) { progress(stage, from + (to - from) * fraction); };
}

// Applies to the tissues of `patient` the differences of `after` from `before`. Returns the number of changed voxels.
std::size_t take_differences(anatomy::TissueVolume& tissues, const anatomy::TissueVolume& before,
                             const anatomy::TissueVolume& after) {
  std::size_t changed = 0;
  const bool is_same = anatomy::same_lattice(tissues.grid, before.grid) && tissues.grid.size == before.grid.size;
  std::size_t offset = 0;
  for (int k = 0; k < tissues.grid.size[2]; ++k) {
    for (int j = 0; j < tissues.grid.size[1]; ++j) {
      for (int i = 0; i < tissues.grid.size[0]; ++i, ++offset) {
        std::uint8_t was = 0, is = 0;
        if (is_same) {
          was = before.voxels[offset];
          is = after.voxels[offset];
        } else {
          const Vec3 point = tissues.grid.to_patient(Vec3(i, j, k));
          was = anatomy::nearest(before, point, anatomy::tissue::air);
          is = anatomy::nearest(after, point, anatomy::tissue::air);
        }
        if (was == is || tissues.voxels[offset] == is) continue;
        tissues.voxels[offset] = is;
        ++changed;
      }
    }
  }
  return changed;
}

// The defect of a path of this patient, by its validity and by the rules; empty: none.
std::string trouble_with_path(const anatomy::Case& patient, const PlanningRules& rules,
                              const anatomy::NeedlePath& path) {
  const std::vector<std::string> problems = io::path_problems(patient, path);
  if (!problems.empty()) return problems.front();
  const PatientView view = view_of(patient);
  const Obstacles obstacles = find_obstacles(view, rules, path.target);
  const PathReport report = report_on(view, obstacles, path);
  if (report.room.spare >= 0.0 && !report.room.blocked) return {};
  return fmt::format("it is too close to what it must keep away from (nearest: {})",
                     nearest_text(obstacles, report, 2));
}

void mend_path(const anatomy::Case& before, anatomy::Case& patient, const PlanningRules& rules,
               std::vector<std::string>& notes) {
  std::optional<anatomy::NeedlePath>& path = patient.description.procedure.path;
  if (!path) return;
  const std::string trouble = trouble_with_path(patient, rules, *path);
  const bool was_as_bad = !trouble.empty() && io::path_problems(patient, *path).empty() &&
                          !trouble_with_path(before, rules, *path).empty();
  if (trouble.empty() || was_as_bad) return;
  const PatientView view = view_of(patient);
  const Obstacles obstacles = find_obstacles(view, rules, path->target);
  const PathSearch search =
      search_paths(view, obstacles, path->target, criteria_for(patient.description.needle, rules));
  if (search.proposals.empty()) {
    notes.push_back(fmt::format("The planned path was taken out, because {}. {}", trouble, search.why_not));
    path.reset();
    return;
  }
  const PathReport& best = search.proposals.front();
  path = best.path;
  notes.push_back(
      fmt::format("The planned path was replaced, because {}. The new one is {:.0f} mm long; nearest: {}.", trouble,
                  best.path.length(), nearest_text(obstacles, best, 3)));
}

void keep_other_files(const std::filesystem::path& from, const std::filesystem::path& to,
                      const std::set<std::string>& written, std::vector<std::string>& notes) {
  for (const auto& entry : std::filesystem::directory_iterator(from)) {
    const std::string name = entry.path().filename().string();
    if (written.contains(name)) continue;
    if (name.starts_with("mesh.")) {
      if (name == "mesh.vtu")
        notes.push_back(
            "The mesh of this case was made from the previous tissues and is left out; 'bodkin case mesh' makes a "
            "new one.");
      continue;
    }
    std::filesystem::copy(entry.path(), to / name, std::filesystem::copy_options::recursive);
  }
}

std::vector<anatomy::Structure> of_present_labels(std::vector<anatomy::Structure> table,
                                                  const anatomy::LabelVolume& labels) {
  std::vector<bool> present(65536, false);
  for (const std::uint16_t label : labels.voxels) present[label] = true;
  std::erase_if(table, [&](const anatomy::Structure& each) { return each.label == 0 || !present[each.label]; });
  present[0] = false;
  for (const anatomy::Structure& each : table) present[each.label] = false;
  const auto unknown = std::find(present.begin(), present.end(), true);
  if (unknown != present.end()) {
    throw InputError(fmt::format("label {} has voxels but no name; give it one in the list of structures",
                                 unknown - present.begin()));
  }
  return table;
}

}  // namespace

RelabelledCase relabel_case(const Relabelling& wanted, const Progress& progress) {
  RelabelledCase result;
  anatomy::Case patient = io::load_case(wanted.folder, part_of(progress, 0.0, 0.1));
  if (patient.ct.empty()) throw InputError("this case has no CT, so its structures cannot be corrected");
  anatomy::LabelVolume labels = io::read_labels(wanted.labels);
  if (labels.grid.size != patient.ct.grid.size || !anatomy::same_lattice(labels.grid, patient.ct.grid))
    throw InputError(fmt::format("{}: the labels do not lie on the lattice of the CT", wanted.labels.string()));
  std::vector<anatomy::Structure> table = of_present_labels(wanted.table, labels);

  io::PartialFolder folder(wanted.folder, true);
  PatientOptions options;
  options.library = patient.library;
  options.plan = false;
  const BuiltPatient before = build_patient(patient.ct, patient.structures, patient.description.structures, options,
                                            part_of(progress, 0.1, 0.45));
  const BuiltPatient after = build_patient(patient.ct, labels, table, options, part_of(progress, 0.45, 0.8));
  const anatomy::Case as_it_was = patient;
  result.changed_tissue_voxels = take_differences(patient.tissues, before.tissues, after.tissues);
  patient.structures = std::move(labels);
  anatomy::CaseDescription& description = patient.description;
  description.structures = std::move(table);
  // Found in the labels; a synthetic patient has his own.
  const auto same_places = [](const anatomy::Landmark& a, const anatomy::Landmark& b) {
    return a.name == b.name && a.position == b.position;
  };
  if (!std::equal(before.landmarks.begin(), before.landmarks.end(), after.landmarks.begin(), after.landmarks.end(),
                  same_places))
    description.landmarks = after.landmarks;
  if (progress) progress("looking at the planned path", 0.8);
  mend_path(as_it_was, patient, wanted.rules, result.notes);

  if (progress) progress("writing the case", 0.9);
  const bool has_structures = std::any_of(patient.structures.voxels.begin(), patient.structures.voxels.end(),
                                          [](auto label) { return label != 0; });
  std::set<std::string> written = {"case.xml", description.structures_file, description.tissues_file, structures_name,
                                   relabelled_tissues_name};
  keep_other_files(wanted.folder, folder.path(), written, result.notes);
  description.structures_file = has_structures ? structures_name : "";
  description.structures_digest = has_structures ? io::volume_digest(patient.structures) : "";
  description.tissues_file = relabelled_tissues_name;
  description.tissues_digest = io::volume_digest(patient.tissues);
  if (has_structures) io::write_nrrd(patient.structures, folder.path() / structures_name);
  io::write_nrrd(patient.tissues, folder.path() / relabelled_tissues_name);
  io::write_case_description(description, folder.path());
  folder.finish();
  return result;
}

}  // namespace bodkin::patient
