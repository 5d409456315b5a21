#include <fmt/format.h>

#include "core/error.h"
#include "io/case_folder.h"
#include "io/case_soundness.h"
#include "io/digest.h"
#include "io/image_worker.h"
#include "io/resources.h"

namespace bodkin {

namespace fs = std::filesystem;

namespace {

// One volume of the case, which must be the one that the case was made with.
template <typename Voxel>
Volume<Voxel> load_volume(const fs::path& folder, const char* element, const std::string& file,
                          const std::string& digest, Volume<Voxel> (*read)(const fs::path&, const Progress&),
                          const Progress& progress) {
  const std::string what = fmt::format("{}: {} file", (folder / "case.xml").string(), element);
  const fs::path path = file_inside(folder, file, what);
  Volume<Voxel> volume = read(path, progress);
  const std::string found = digest.empty() ? digest : volume_digest(volume);
  if (found != digest) {
    throw InputError(
        fmt::format("{} has changed since the case was made: its digest is {}, expected {}; restore the file or make "
                    "the case again",
                    path.string(), found, digest));
  }
  return volume;
}

CtVolume load_ct(const fs::path& folder, const CaseDescription& description, const Progress& progress) {
  return load_volume(folder, "ct", description.ct_file, description.ct_digest, read_ct_isolated, progress);
}

LabelVolume load_structures(const fs::path& folder, const CaseDescription& description, const Progress& progress) {
  if (description.structures_file.empty()) return {};
  return load_volume(folder, "structures", description.structures_file, description.structures_digest,
                     read_labels_isolated, progress);
}

TissueVolume load_tissues(const fs::path& folder, const CaseDescription& description, const Progress& progress) {
  return load_volume(folder, "tissues", description.tissues_file, description.tissues_digest, read_tissues_isolated,
                     progress);
}

}  // namespace

Case load_case(const fs::path& folder, const Progress& progress) {
  Case patient;
  patient.description = read_case_description(folder);
  patient.library = read_case_library(folder, patient.description);
  patient.ct = load_ct(folder, patient.description, progress);
  patient.structures = load_structures(folder, patient.description, progress);
  patient.tissues = load_tissues(folder, patient.description, progress);
  if (const auto problems = lattice_problems(patient); !problems.empty()) {
    throw InputError(fmt::format("{}: {}; make the case again", folder.string(), problems.front()));
  }
  return patient;
}

TissueVolume load_case_tissues(const fs::path& folder, const CaseDescription& description, const Progress& progress) {
  return load_tissues(folder, description, progress);
}

std::vector<std::string> check_case(const fs::path& folder, const Progress& progress) {
  std::vector<std::string> problems;
  const auto attempt = [&problems](const auto& work) {
    try {
      work();
      return true;
    } catch (const InputError& error) {
      problems.emplace_back(error.what());
      return false;
    }
  };
  Case patient;
  CaseDescription& description = patient.description;
  if (!attempt([&] { description = read_case_description(folder); })) return problems;
  attempt([&] { patient.library = read_case_library(folder, description); });
  attempt([&] { patient.ct = load_ct(folder, description, progress); });
  attempt([&] { patient.structures = load_structures(folder, description, progress); });
  attempt([&] { patient.tissues = load_tissues(folder, description, progress); });
  for (auto find : {lattice_problems, content_problems}) {
    for (const std::string& problem : find(patient))
      problems.push_back(fmt::format("{}: {}", folder.string(), problem));
  }
  return problems;
}

}  // namespace bodkin
