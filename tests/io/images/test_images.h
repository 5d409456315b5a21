#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <unistd.h>

#include "anatomy/volume.h"
#include "core/error.h"

// Images for tests: where the real ones are, and small ones written byte by byte as the formats prescribe, so that
// the readers are not tested against a writer of the same library.

namespace bodkin::test {

using namespace bodkin::anatomy;

// The folder of real CT data, or an empty path when it is not here.
inline std::filesystem::path data_folder() {
  const char* named = std::getenv("BODKIN_DATA");
  const std::filesystem::path folder = named != nullptr ? named : BODKIN_REPOSITORY "/../shared/data";
  return std::filesystem::exists(folder / "MANIFEST.tsv") ? folder : std::filesystem::path();
}

#define BODKIN_REQUIRE_DATA(variable)                         \
  const std::filesystem::path variable = test::data_folder(); \
  if (variable.empty()) GTEST_SKIP() << "no real CT data: set BODKIN_DATA to its folder"

// The message of `call`'s refusal.
template <typename Call>
std::string sentence_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

// A folder that is removed with everything in it.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "bodkin-test-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) std::abort();
    path_ = pattern;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// A small CT with air, fat and bone and no symmetry, on an oblique grid when asked.
CtVolume small_ct(bool oblique = false);

// Whole files as bytes. NIfTI-1 with an sform; NRRD raw; MetaImage with local raw voxels.
std::string nifti_bytes(const CtVolume& volume);
std::string nrrd_bytes(const CtVolume& volume);
std::string meta_image_bytes(const CtVolume& volume);
std::string gzip_bytes(const std::string& bytes);

// One DICOM CT slice, explicit VR little endian, uncompressed.
struct DicomSliceFile {
  int columns = 4, rows = 3;
  Vec3 position = Vec3::Zero();
  Vec3 row = Vec3::UnitX(), column = Vec3::UnitY();
  double spacing = 1.0;
  std::string series_uid = "1.2.3", instance_uid, modality = "CT";
  int series_number = 1;
  double slope = 1.0, intercept = -1024.0;
  std::vector<std::uint16_t> pixels;  // columns * rows; empty: all stored 1024
  bool deflated = false;              // the whole data set packed
};
std::string dicom_bytes(const DicomSliceFile& slice);

// DICOM of any kind, explicit VR little endian: an element, a sequence of items (each the elements in it), a number
// of 16 bits and a point as values, and a file of elements in ascending order.
std::string dicom_element(unsigned group, unsigned number, const std::string& vr, std::string value);
std::string dicom_sequence(unsigned group, unsigned number, const std::vector<std::string>& items);
std::string dicom_number(unsigned value);
std::string dicom_point(const Vec3& p);
std::string dicom_file(const std::string& sop_class, const std::string& transfer_syntax, const std::string& instance,
                       const std::string& elements);

void write_file(const std::filesystem::path& file, const std::string& bytes);
std::string read_file(const std::filesystem::path& file);

}  // namespace bodkin::test
