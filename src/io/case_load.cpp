#include <algorithm>
#include <future>
#include <optional>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "io/case_folder.h"
#include "io/case_soundness.h"
#include "io/digest.h"
#include "io/image_worker.h"
#include "io/nrrd_reader.h"
#include "io/resources.h"

namespace bodkin::io {

namespace fs = std::filesystem;

namespace {

// One volume of the case, which must be the volume that the case was made with. Bodkin's own file is read by a thread
// that starts at once; a file of any other form is read by the image worker, in wait().
template <typename Voxel>
class VolumeLoading {
 public:
  using ForeignReader = anatomy::Volume<Voxel> (*)(const fs::path&, const Progress&);

  VolumeLoading(const fs::path& folder, const char* element, const std::string& file, const std::string& digest,
                ForeignReader read_foreign)
      : digest_(digest), read_foreign_(read_foreign) {
    const std::string what = fmt::format("{}: {} file", (folder / "case.xml").string(), element);
    own_ = std::async(std::launch::async, [this, folder, file, what] {
      path_ = file_inside(folder, file, what);
      std::optional<anatomy::Volume<Voxel>> volume = read_nrrd<Voxel>(path_);
      if (volume) accept(*volume);
      return volume;
    });
  }
  VolumeLoading(const VolumeLoading&) = delete;
  VolumeLoading& operator=(const VolumeLoading&) = delete;

  // Returns the volume; may be called once. Throws InputError.
  anatomy::Volume<Voxel> wait(const Progress& progress) {
    std::optional<anatomy::Volume<Voxel>> own = own_.get();
    if (own) return std::move(*own);
    anatomy::Volume<Voxel> volume = read_foreign_(path_, progress);
    accept(volume);
    return volume;
  }

 private:
  void accept(anatomy::Volume<Voxel>& volume) const {
    if constexpr (std::is_same_v<anatomy::Volume<Voxel>, anatomy::CtVolume>) {
      // Padding outside the scanned field, raised by the image worker too.
      for (Voxel& value : volume.voxels) value = std::max(value, anatomy::lowest_hounsfield);
    }
    if (digest_.empty()) return;
    const std::string found = volume_digest(volume);
    if (found == digest_) return;
    throw InputError(
        fmt::format("{} has changed since the case was made: its digest is {}, expected {}; restore the file or make "
                    "the case again",
                    path_.string(), found, digest_));
  }

  std::string digest_;
  ForeignReader read_foreign_;
  fs::path path_;                                           // written by the thread, read after its end
  std::future<std::optional<anatomy::Volume<Voxel>>> own_;  // the last member: its thread uses the others
};

// The volumes of a case, all read at the same time.
class CaseVolumes {
 public:
  CaseVolumes(const fs::path& folder, const anatomy::CaseDescription& description)
      : ct_(folder, "ct", description.ct_file, description.ct_digest, read_ct_isolated),
        tissues_(folder, "tissues", description.tissues_file, description.tissues_digest, read_tissues_isolated) {
    if (description.structures_file.empty()) return;
    structures_.emplace(folder, "structures", description.structures_file, description.structures_digest,
                        read_labels_isolated);
  }

  anatomy::CtVolume ct(const Progress& progress) { return ct_.wait(progress); }
  anatomy::LabelVolume structures(const Progress& progress) {
    return structures_ ? structures_->wait(progress) : anatomy::LabelVolume();
  }
  anatomy::TissueVolume tissues(const Progress& progress) { return tissues_.wait(progress); }

 private:
  VolumeLoading<std::int16_t> ct_;
  VolumeLoading<std::uint8_t> tissues_;
  std::optional<VolumeLoading<std::uint16_t>> structures_;
};

}  // namespace

anatomy::Case load_case(const fs::path& folder, const Progress& progress) {
  anatomy::Case patient;
  patient.description = read_case_description(folder);
  patient.library = read_case_library(folder, patient.description);
  CaseVolumes volumes(folder, patient.description);
  patient.ct = volumes.ct(progress);
  patient.structures = volumes.structures(progress);
  patient.tissues = volumes.tissues(progress);
  if (const auto problems = lattice_problems(patient); !problems.empty()) {
    throw InputError(fmt::format("{}: {}; make the case again", folder.string(), problems.front()));
  }
  return patient;
}

anatomy::TissueVolume load_case_tissues(const fs::path& folder, const anatomy::CaseDescription& description,
                                        const Progress& progress) {
  return VolumeLoading<std::uint8_t>(folder, "tissues", description.tissues_file, description.tissues_digest,
                                     read_tissues_isolated)
      .wait(progress);
}

anatomy::LabelVolume load_case_structures(const fs::path& folder, const anatomy::CaseDescription& description,
                                          const Progress& progress) {
  if (description.structures_file.empty()) return {};
  return VolumeLoading<std::uint16_t>(folder, "structures", description.structures_file,
                                      description.structures_digest, read_labels_isolated)
      .wait(progress);
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
  anatomy::Case patient;
  anatomy::CaseDescription& description = patient.description;
  if (!attempt([&] { description = read_case_description(folder); })) return problems;
  CaseVolumes volumes(folder, description);
  attempt([&] { patient.library = read_case_library(folder, description); });
  attempt([&] { patient.ct = volumes.ct(progress); });
  attempt([&] { patient.structures = volumes.structures(progress); });
  attempt([&] { patient.tissues = volumes.tissues(progress); });
  for (auto find : {lattice_problems, content_problems}) {
    for (const std::string& problem : find(patient))
      problems.push_back(fmt::format("{}: {}", folder.string(), problem));
  }
  return problems;
}

}  // namespace bodkin::io
