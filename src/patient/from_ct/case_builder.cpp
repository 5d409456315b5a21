#include "patient/from_ct/case_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <utility>

#include "patient/from_ct/label_names.h"
#include "patient/from_ct/label_plausibility.h"
#include "patient/from_ct/patient_builder.h"
#include "patient/planning/needle_choice.h"
#include "patient/planning/path_search.h"
#include "patient/synthetic/calcification.h"
#include <fmt/format.h>

#include "anatomy/generic_device.h"
#include "core/error.h"
#include "core/files.h"
#include "io/case_folder.h"
#include "io/digest.h"
#include "io/images/image_source.h"
#include "io/images/image_values.h"
#include "io/images/label_placement.h"
#include "io/label_scheme.h"
#include "io/nrrd_writer.h"
#include "io/partial_folder.h"
#include "io/tissue_library_file.h"

namespace bodkin::patient {
namespace {

constexpr const char* maker = "bodkin";

// Progress of one stretch of a longer piece of work.
Progress stretch(const Progress& progress, double from, double to) {
  if (!progress) return {};
  return [=](std::string_view stage, double fraction) { progress(stage, from + (to - from) * fraction); };
}

anatomy::Needle needle_of(int gauge) {
  const std::optional<anatomy::GaugeSize> size = anatomy::gauge_size(gauge);
  if (!size) {
    throw InputError(fmt::format("--needle-gauge is {}; expected {} to {}", gauge,
                                 anatomy::gauge_sizes().front().gauge, anatomy::gauge_sizes().back().gauge));
  }
  anatomy::Needle needle;
  needle.gauge = gauge;
  needle.outer_diameter = size->outer_diameter;
  needle.inner_diameter = size->inner_diameter;
  return needle;
}

void require_path(const std::optional<anatomy::NeedlePath>& path) {
  if (path && path->length() < 1.0) {
    throw InputError(fmt::format("--entry and --target are {:.2g} mm apart; expected at least 1 mm", path->length()));
  }
}

// A path that leaves the image cannot be performed.
void require_inside(const anatomy::NeedlePath& path, const anatomy::Grid& image) {
  for (const auto& [option, point] : {std::pair("--target", path.target), std::pair("--entry", path.entry)}) {
    const Vec3 index = image.to_index(point);
    const Vec3 last(image.size[0] - 0.5, image.size[1] - 0.5, image.size[2] - 0.5);
    if ((index.array() >= -0.5).all() && (index.array() <= last.array()).all()) continue;
    throw InputError(
        fmt::format("{} is ({:.1f}, {:.1f}, {:.1f}), which lies outside the CT; give a point inside it, LPS mm",
                    option, point.x(), point.y(), point.z()));
  }
}

std::string case_name(const NewCase& wanted) {
  if (!wanted.name.empty()) return wanted.name;
  const std::filesystem::path normal = std::filesystem::absolute(wanted.folder).lexically_normal();
  return (normal.has_filename() ? normal : normal.parent_path()).filename().string();
}

std::vector<TissueAmount> amounts_of(const anatomy::TissueVolume& tissues, const anatomy::TissueLibrary& library) {
  std::array<std::size_t, 256> counts{};
  for (const anatomy::TissueId id : tissues.voxels) ++counts[id];
  const double voxel = tissues.grid.spacing.prod() / 1000.0;
  std::vector<TissueAmount> amounts;
  for (std::size_t id = 1; id < counts.size(); ++id) {
    if (counts[id] == 0) continue;
    amounts.push_back({library.title(static_cast<anatomy::TissueId>(id)), static_cast<double>(counts[id]) * voxel});
  }
  std::stable_sort(amounts.begin(), amounts.end(),
                   [](const TissueAmount& a, const TissueAmount& b) { return a.millilitres > b.millilitres; });
  return amounts;
}

// Writes a volume and returns its digest; runs on a separate thread, because compression is slow.
template <typename Voxel>
std::future<std::string> write_beside(const anatomy::Volume<Voxel>& volume, const std::filesystem::path& file) {
  return std::async(std::launch::async, [&volume, file] {
    io::write_nrrd(volume, file);
    return io::volume_digest(volume);
  });
}

struct Volumes {
  const anatomy::CtVolume& ct;
  const anatomy::LabelVolume& structures;  // may be empty
  const anatomy::TissueVolume& tissues;
};

// Writes everything into `folder` and completes `description` with file names and digests.
void write_case(const std::filesystem::path& folder, const Volumes& volumes, anatomy::CaseDescription& description) {
  description.ct_file = "ct.nrrd";
  description.tissues_file = "tissues.nrrd";
  std::future<std::string> ct = write_beside(volumes.ct, folder / description.ct_file);
  std::future<std::string> tissues = write_beside(volumes.tissues, folder / description.tissues_file);
  if (!volumes.structures.empty()) {
    description.structures_file = "structures.nrrd";
    io::write_nrrd(volumes.structures, folder / description.structures_file);
    description.structures_digest = io::volume_digest(volumes.structures);
  }
  description.ct_digest = ct.get();
  description.tissues_digest = tissues.get();
  io::write_case_description(description, folder);
}

constexpr const char* epidural = "epidural_fat";

// Whether a path through an interspace is suitable: a biopsy or an injection needs a separate target.
bool is_spinal(const NewCase& wanted) {
  return wanted.procedure.empty() || wanted.target_tissue == epidural ||
         wanted.target_tissue == "cerebrospinal_fluid";
}

// The requested procedure, or else a lumbar puncture if there is a lumbar spine and a plain insertion if not.
anatomy::Procedure procedure_for(const NewCase& wanted, const std::optional<anatomy::NeedlePath>& path, bool lumbar) {
  anatomy::Procedure procedure;
  procedure.path = path;
  if (!wanted.procedure.empty()) {
    procedure.name = wanted.procedure;
    procedure.target_tissue = wanted.target_tissue;
    return procedure;
  }
  procedure.name = lumbar ? "lumbar_puncture" : "needle_insertion";
  if (lumbar) procedure.target_tissue = "cerebrospinal_fluid";
  return procedure;
}

bool has_target(const NewCase& wanted) {
  return wanted.target || !wanted.target_structure.empty();
}

// The best path to the user's target; if there is none, nothing and a note with the reason. Throws InputError for a
// missing structure.
std::optional<anatomy::NeedlePath> path_to_target(const NewCase& wanted, const anatomy::Needle& needle,
                                                  const PatientView& patient, std::vector<std::string>& notes) {
  const Vec3 target = wanted.target ? *wanted.target : target_in_structure(patient, wanted.target_structure);
  const std::string named = wanted.target_structure.empty() ? "the target" : spoken(wanted.target_structure);
  if (const auto problem = level_problem(patient, wanted.rules, target)) {
    notes.push_back(fmt::format("No path was planned to {}, because {}.", named, *problem));
    return std::nullopt;
  }
  const Obstacles obstacles = find_obstacles(patient, wanted.rules, target);
  const PathSearch search = search_paths(patient, obstacles, target, criteria_for(needle, wanted.rules));
  if (search.proposals.empty()) {
    notes.push_back(fmt::format("No path was planned to {} at ({:.1f}, {:.1f}, {:.1f}). {}", named, target.x(),
                                target.y(), target.z(), search.why_not));
    return std::nullopt;
  }
  const PathReport& best = search.proposals.front();
  notes.push_back(fmt::format(
      "The path to {} was planned, {:.0f} mm long, {:.0f} degrees {} and {:.0f} to the {}; nearest: {}. 'bodkin case "
      "plan' lists others.",
      named, best.path.length(), std::abs(best.cranial), best.cranial < 0.0 ? "caudal" : "cranial",
      std::abs(best.lateral), best.lateral < 0.0 ? "right" : "left", nearest_text(obstacles, best, 3)));
  return best.path;
}

// Only the structures that occur; a scheme lists many more.
std::vector<anatomy::Structure> present_structures(std::vector<anatomy::Structure> table,
                                                   const anatomy::LabelVolume& labels,
                                                   std::vector<std::string>& notes) {
  std::vector<bool> present(65536, false);
  for (const std::uint16_t label : labels.voxels) present[label] = true;
  present[0] = false;
  std::erase_if(table, [&](const anatomy::Structure& structure) { return !present[structure.label]; });
  for (const anatomy::Structure& structure : table) present[structure.label] = false;
  const auto unknown = std::count(present.begin(), present.end(), true);
  if (unknown > 0) {
    const auto first = std::find(present.begin(), present.end(), true) - present.begin();
    notes.push_back(fmt::format("{} label{} (first {}) are not in the scheme; their voxels were decided by HU alone.",
                                unknown, unknown == 1 ? "" : "s", first));
    for (std::size_t label = 1; label < present.size(); ++label) {
      if (present[label]) {
        table.push_back({static_cast<std::uint16_t>(label), fmt::format("label_{}", label), "", false});
      }
    }
  }
  return table;
}

// The meaning of the labels without a scheme: by the names in their file, else the numbers are TotalSegmentator's.
std::vector<anatomy::Structure> table_for(const std::vector<io::LabelName>& names,
                                          const anatomy::TissueLibrary& library, std::vector<std::string>& notes) {
  if (names.empty()) return io::read_label_scheme("totalsegmentator", library);
  NamedStructures named = structures_named(names);
  notes.insert(notes.end(), named.notes.begin(), named.notes.end());
  return std::move(named.table);
}

// The library of the new case. A patient may contain any of Bodkin's own tissues, so none may be missing.
anatomy::TissueLibrary library_for(const std::filesystem::path& file) {
  anatomy::TissueLibrary own = io::default_tissue_library();
  if (file.empty()) return own;
  anatomy::TissueLibrary library = io::read_tissue_library(file);
  for (int id = 0; id < anatomy::tissue::count; ++id) {
    if (library.find(static_cast<anatomy::TissueId>(id)) != nullptr) continue;
    throw InputError(fmt::format(
        "{}: there is no tissue with id {} ({}), expected all of Bodkin's own, 0 to {}; begin with a copy "
        "of share/bodkin/tissues.xml",
        file.string(), id, own.title(static_cast<anatomy::TissueId>(id)), anatomy::tissue::count - 1));
  }
  return library;
}

// The end of the patient's cord, as stated by the user or by age.
SpinePlace conus_of(const ImportOptions& options) {
  if (options.conus.empty()) return options.age ? conus_at_age(*options.age) : adult_conus;
  const auto place = place_named(options.conus);
  if (!place || *place < 0.0 || *place > 5.0) {
    throw InputError(fmt::format("--conus is '{}'; expected a vertebra, T12 to L4, or an interspace, T12_L1 to L4_L5",
                                 options.conus));
  }
  return *place;
}

void require_level(const std::string& level) {
  if (!level.empty() && !interspace_named(level)) {
    throw InputError(fmt::format("--level is '{}'; expected an interspace, T12_L1 to L5_S1", level));
  }
}

void copy_in(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code failed;
  std::filesystem::copy_file(from, to, failed);
  if (failed)
    throw SystemError(fmt::format("{} cannot be copied to {}: {}", from.string(), to.string(), failed.message()));
}

void append(std::vector<std::string>& notes, const std::vector<std::string>& more) {
  notes.insert(notes.end(), more.begin(), more.end());
}

}  // namespace

CaseSummary build_imported_case(const NewCase& wanted, const ImportOptions& options, const Progress& progress) {
  anatomy::CaseDescription description;
  description.needle = wanted.needle.empty() ? needle_of(wanted.needle_gauge) : parse_needle(wanted.needle);
  description.haptics.mechanics = wanted.mechanics;
  description.device = anatomy::generic_device(description.needle, wanted.mechanics);
  description.haptics.parts = wanted.parts;
  description.haptics.force_in_organs = wanted.force_in_organs;
  require_path(wanted.path);
  require_level(options.level);
  if (!options.lowest_vertebra.empty()) require_vertebra(options.lowest_vertebra);
  const SpinePlace conus = conus_of(options);
  const anatomy::TissueLibrary library = library_for(options.tissues);
  std::vector<anatomy::Structure> table;
  if (!options.labels.empty() && !options.scheme.empty()) table = io::read_label_scheme(options.scheme, library);
  io::PartialFolder folder(wanted.folder, wanted.overwrite);
  if (!options.tissues.empty()) {
    description.tissue_library_file = "tissues.xml";
    copy_in(options.tissues, folder.path() / description.tissue_library_file);
  }

  io::CtImage image =
      io::read_ct(options.ct, {options.series, options.fill_missing, false}, stretch(progress, 0.0, 0.3));
  if (!options.assume_hounsfield) io::require_hounsfield(image.ct, options.ct.string());
  append(description.notes, image.notes);
  if (wanted.path) require_inside(*wanted.path, image.ct.grid);
  if (wanted.target) require_inside({*wanted.target, *wanted.target}, image.ct.grid);
  io::LabelPlacement placed;
  if (!options.labels.empty()) {
    io::NamedLabels read = io::read_named_labels(options.labels, image.ct.grid, stretch(progress, 0.3, 0.4));
    append(description.notes, read.notes);
    placed = io::place_labels(std::move(read.labels), image.ct.grid, options.resample_labels || image.resampled,
                              options.labels.string());
    append(description.notes, placed.notes);
    if (options.scheme.empty()) table = table_for(read.names, library, description.notes);
    table = present_structures(std::move(table), placed.labels, description.notes);
    append(description.notes, check_labels(image.ct, placed.labels, table));
  }

  PatientOptions patient_options;
  patient_options.path = wanted.path;
  patient_options.library = library;
  patient_options.plan = is_spinal(wanted) && !has_target(wanted);
  patient_options.level = options.level;
  patient_options.levels = wanted.rules.levels;
  patient_options.lowest_vertebra = options.lowest_vertebra;
  patient_options.conus = conus;
  BuiltPatient patient = build_patient(image.ct, placed.labels, table, patient_options, stretch(progress, 0.4, 0.85));
  append(description.notes, patient.notes);
  if (has_target(wanted)) {
    patient.path =
        path_to_target(wanted, description.needle,
                       {patient.tissues, placed.labels, table, patient.landmarks, library}, description.notes);
  } else if (!is_spinal(wanted) && !patient.path) {
    description.notes.push_back(
        fmt::format("No path was planned, because {} has a target of its own; give --target.", wanted.procedure));
  }
  if (patient.path && !wanted.path && !has_target(wanted) && wanted.target_tissue == epidural)
    patient.path = ended_in_epidural_space(*patient.path, patient.tissues);

  description.name = case_name(wanted);
  description.description = fmt::format("Made from {}", options.ct.filename().string());
  description.created_by = maker;
  description.structures = std::move(table);
  description.landmarks = std::move(patient.landmarks);
  description.procedure = procedure_for(wanted, patient.path, !description.landmarks.empty());
  if (progress) progress("writing the case", 0.9);
  write_case(folder.path(), {image.ct, placed.labels, patient.tissues}, description);
  folder.finish();
  return {description, image.ct.grid, patient.tissues.grid, amounts_of(patient.tissues, library)};
}

CaseSummary build_synthetic_case(const NewCase& wanted, const LumbarParameters& parameters,
                                 const Progress& progress) {
  anatomy::CaseDescription description;
  description.needle = wanted.needle.empty() ? needle_of(wanted.needle_gauge) : parse_needle(wanted.needle);
  description.haptics.mechanics = wanted.mechanics;
  description.device = anatomy::generic_device(description.needle, wanted.mechanics);
  description.haptics.parts = wanted.parts;
  description.haptics.force_in_organs = wanted.force_in_organs;
  require_path(wanted.path);
  const bool is_calcified = parameters.calcification > 0.0;
  const anatomy::TissueLibrary library =
      is_calcified ? with_calcified_ligament(io::default_tissue_library()) : io::default_tissue_library();
  io::PartialFolder folder(wanted.folder, wanted.overwrite);
  if (is_calcified) {
    description.tissue_library_file = "tissues.xml";
    write_file(folder.path() / description.tissue_library_file, io::tissue_library_xml(library));
  }
  SyntheticPatient patient = synthesize_lumbar(parameters, library, stretch(progress, 0.0, 0.85));

  description.name = case_name(wanted);
  description.description = fmt::format(
      "Synthetic lumbar torso: seed {}, {:g} years, {:g} m, {:g} kg, flexion {:g}, voxels of {:g} mm",
      parameters.seed, parameters.age, parameters.height, parameters.weight, parameters.flexion, parameters.spacing);
  if (parameters.scoliosis != 0.0) {
    description.description +=
        fmt::format(", scoliosis of {:g} degrees, convex to the {}", std::abs(parameters.scoliosis),
                    parameters.scoliosis > 0.0 ? "left" : "right");
  }
  if (parameters.lesion > 0.0) description.description += fmt::format(", a lesion of {:g} mm", parameters.lesion);
  if (is_calcified) description.description += fmt::format(", ligaments calcified by {:g}", parameters.calcification);
  description.created_by = maker;
  description.structures = std::move(patient.structure_table);
  description.landmarks = std::move(patient.landmarks);
  std::optional<anatomy::NeedlePath> path = wanted.path;
  if (has_target(wanted)) {
    path =
        path_to_target(wanted, description.needle,
                       {patient.tissues, patient.structures, description.structures, description.landmarks, library},
                       description.notes);
  } else if (!path) {
    path = wanted.target_tissue == epidural ? ended_in_epidural_space(patient.path, patient.tissues) : patient.path;
  }
  description.procedure = procedure_for(wanted, path, true);
  if (progress) progress("writing the case", 0.9);
  write_case(folder.path(), {patient.ct, patient.structures, patient.tissues}, description);
  folder.finish();
  return {description, patient.ct.grid, patient.tissues.grid, amounts_of(patient.tissues, library)};
}

}  // namespace bodkin::patient
