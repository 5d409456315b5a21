#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <limits>

#include "tests/io/images/test_images.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "core/error.h"
#include "core/random.h"
#include "io/image_worker.h"
#include "io/images/image_source.h"

// Damaged and dishonest files of every format: each is refused with one sentence that names the file.

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

using test::sentence_of;
using testing::HasSubstr;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

template <typename Number>
std::string patched(std::string bytes, std::size_t place, Number value) {
  std::memcpy(bytes.data() + place, &value, sizeof value);
  return bytes;
}

struct Damage {
  std::string what;   // of the test
  std::string bytes;  // of the file
  std::string says;   // part of the sentence
};

using Reader = std::function<void(const std::filesystem::path&)>;

void use_built_worker() {
  setenv("BODKIN_IMAGES_WORKER", BODKIN_BUILD "/bin/bodkin-images", 0);
}

void expect_refusals(
    const std::string& file_name, const std::vector<Damage>& damages,
    const Reader& read = [](const auto& file) { read_ct(file); }) {
  const test::ScratchFolder folder;
  for (const Damage& damage : damages) {
    const std::filesystem::path file = folder / file_name;
    test::write_file(file, damage.bytes);
    const std::string sentence = sentence_of([&] { read(file); });
    EXPECT_THAT(sentence, HasSubstr(file.string())) << damage.what;
    EXPECT_THAT(sentence, HasSubstr(damage.says)) << damage.what;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << damage.what;
  }
}

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

TEST(DamagedFiles, the_undamaged_ones_are_read_alike_in_every_format) {
  for (const bool oblique : {false, true}) {
    const CtVolume ct = test::small_ct(oblique);
    const test::ScratchFolder folder;
    const std::vector<std::pair<std::string, std::string>> files = {
        {"a.nii", test::nifti_bytes(ct)},
        {"a.nii.gz", test::gzip_bytes(test::nifti_bytes(ct))},
        {"a.nrrd", test::nrrd_bytes(ct)},
        {"a.mha", test::meta_image_bytes(ct)}};
    for (const auto& [name, bytes] : files) {
      test::write_file(folder / name, bytes);
      const CtVolume read = read_ct(folder / name).ct;
      EXPECT_EQ(read.voxels, ct.voxels) << name;
      EXPECT_TRUE(same_lattice(read.grid, ct.grid, 1e-4)) << name;
    }
  }
}

TEST(DamagedFiles, nifti) {
  const std::string good = test::nifti_bytes(test::small_ct());
  expect_refusals(
      "ct.nii",
      {{"empty", "", "this file is empty"},
       {"header cut", good.substr(0, 200), "ends after 200 of the 348 bytes"},
       {"voxels cut", good.substr(0, good.size() - 40), "too short"},
       {"huge", patched(good, 42, std::array<std::int16_t, 3>{32767, 32767, 32767}), "32767 x 32767 x 32767"},
       {"large", patched(good, 42, std::array<std::int16_t, 3>{700, 700, 700}), "too short"},
       {"no voxels", patched(good, 44, std::int16_t{0}), "0 voxels along axis 2"},
       {"negative size", patched(good, 44, std::int16_t{-6}), "-6 voxels along axis 2"},
       {"dimensions", patched(good, 40, std::int16_t{99}), "dimensions"},
       {"four frames",
        patched(patched(good, 40, std::int16_t{4}), 48, std::int16_t{4}) + std::string(4 * good.size(), '\0'),
        "frames"},
       {"zero spacing", patched(good, 84, 0.0F), "spacing along axis 2 is 0 mm"},
       {"negative spacing", patched(good, 84, -1.25F), "spacing along axis 2 is -1.25 mm"},
       {"NaN spacing", patched(good, 84, not_a_number), "spacing along axis 2 is nan"},
       {"NaN affine", patched(good, 284, not_a_number), "the affine holds nan"},
       {"infinite origin", patched(good, 292, std::numeric_limits<float>::infinity()), "the affine holds inf"},
       {"zero affine", patched(good, 280, std::array<float, 12>{}), "no length"},
       {"sheared", patched(good, 284, 0.4F), "pixdim"},
       {"no orientation", patched(good, 254, std::int16_t{0}), "where it lies in the patient"},
       {"colours", patched(good, 70, std::int16_t{128}), "colours"},
       {"complex", patched(good, 70, std::int16_t{32}), "not plain numbers"},
       {"pair", patched(good, 344, std::array<char, 4>{'n', 'i', '1', '\0'}), ".hdr/.img pair"},
       {"another format", "this is a text that somebody wrote", "not an image that Bodkin reads"}});
}

TEST(DamagedFiles, packed_nifti) {
  const std::string plain = test::nifti_bytes(test::small_ct());
  const std::string good = test::gzip_bytes(plain);
  expect_refusals(
      "ct.nii.gz",
      {{"stream cut", good.substr(0, good.size() / 2), "ct.nii.gz"},
       {"head cut", good.substr(0, 30), "ct.nii.gz"},
       {"huge", test::gzip_bytes(patched(plain, 42, std::array<std::int16_t, 3>{700, 700, 700})), "too short"},
       {"short inside", test::gzip_bytes(plain.substr(0, plain.size() - 100)), "too short"},
       {"not nifti", test::gzip_bytes(std::string(500, 'x')), "without a NIfTI image"},
       {"zero spacing", test::gzip_bytes(patched(plain, 80, 0.0F)), "spacing along axis 1 is 0 mm"}});
}

TEST(DamagedFiles, nrrd) {
  const std::string good = test::nrrd_bytes(test::small_ct());
  const std::string origin = "space origin: (-12.5,30.25,101)";
  expect_refusals(
      "ct.nrrd",
      {{"voxels cut", good.substr(0, good.size() - 40), "too short"},
       {"header cut", good.substr(0, 30), "no 'sizes'"},
       {"huge", replaced(good, "sizes: 7 6 5", "sizes: 70000 60000 50000"), "70000 x 60000 x 50000"},
       {"large", replaced(good, "sizes: 7 6 5", "sizes: 700 600 500"), "too short"},
       {"no voxels", replaced(good, "sizes: 7 6 5", "sizes: 7 0 5"), "expected 1 to 1000000 voxels"},
       {"negative", replaced(good, "sizes: 7 6 5", "sizes: 7 -6 5"), "expected 1 to 1000000 voxels"},
       {"zero spacing", replaced(good, "(0,1.25,0)", "(0,0,0)"), "ct.nrrd"},
       {"NaN affine", replaced(good, "(0,1.25,0)", "(0,nan,0)"), "expected finite numbers"},
       {"NaN origin", replaced(good, origin, "space origin: (nan,30.25,101)"), "expected finite numbers"},
       {"sheared", replaced(good, "(0,1.25,0)", "(0.5,1.25,0)"), "not orthogonal"},
       {"no frame", replaced(good, "space: left-posterior-superior\n", ""), "where the image lies"},
       {"wrong type", replaced(good, "type: short", "type: block"), "ct.nrrd"},
       {"unknown type", replaced(good, "type: short", "type: banana"), "ct.nrrd"},
       {"encoding", replaced(good, "encoding: raw", "encoding: bzip2"), "the encoding is 'bzip2'"},
       {"elsewhere", replaced(good, "encoding: raw", "encoding: raw\ndata file: /etc/passwd"), "same folder"},
       {"upwards", replaced(good, "encoding: raw", "encoding: raw\ndata file: ../secret.raw"), "same folder"},
       {"not there", replaced(good, "encoding: raw", "encoding: raw\ndata file: lost.raw"), "not there"},
       {"packed rubbish", replaced(good, "encoding: raw", "encoding: gzip"), "ct.nrrd"}});
}

TEST(DamagedFiles, meta_image) {
  const std::string good = test::meta_image_bytes(test::small_ct());
  expect_refusals(
      "ct.mha",
      {{"voxels cut", good.substr(0, good.size() - 40), "too short"},
       {"header cut", good.substr(0, 100), "no 'ElementDataFile'"},
       {"huge", replaced(good, "DimSize = 7 6 5", "DimSize = 70000 60000 50000"), "70000 x 60000 x 50000"},
       {"large", replaced(good, "DimSize = 7 6 5", "DimSize = 700 600 500"), "too short"},
       {"no voxels", replaced(good, "DimSize = 7 6 5", "DimSize = 7 0 5"), "expected 1 to 1000000 voxels"},
       {"zero spacing", replaced(good, "ElementSpacing = 0.75 1.25 2.5", "ElementSpacing = 0.75 0 2.5"),
        "above zero"},
       {"negative spacing", replaced(good, "ElementSpacing = 0.75 1.25 2.5", "ElementSpacing = 0.75 -1.25 2.5"),
        "above zero"},
       {"NaN affine", replaced(good, "TransformMatrix = 1 0 0", "TransformMatrix = nan 0 0"),
        "expected finite numbers"},
       {"sheared", replaced(good, "TransformMatrix = 1 0 0 0 1", "TransformMatrix = 1 0.4 0 0 1"), "not orthogonal"},
       {"singular", replaced(good, "TransformMatrix = 1 0 0 0 1", "TransformMatrix = 0 0 0 0 1"), "ct.mha"},
       {"infinite origin", replaced(good, "Offset = -12.5", "Offset = inf"), "expected finite numbers"},
       {"colours", replaced(good, "ElementType = MET_SHORT", "ElementNumberOfChannels = 3\nElementType = MET_SHORT"),
        "ct.mha"},
       {"wrong type", replaced(good, "ElementType = MET_SHORT", "ElementType = MET_STRING"), "ct.mha"},
       {"no spacing", replaced(good, "ElementSpacing", "ElementNothing"), "how large a voxel is"},
       {"elsewhere", replaced(good, "ElementDataFile = LOCAL", "ElementDataFile = /etc/passwd"), "same folder"},
       {"list", replaced(good, "ElementDataFile = LOCAL", "ElementDataFile = LIST"), "same folder"},
       {"pattern", replaced(good, "ElementDataFile = LOCAL", "ElementDataFile = s%03d.raw 1 5 1"), "same folder"}});
}

TEST(DamagedFiles, dicom) {
  use_built_worker();
  test::DicomSliceFile slice;
  slice.columns = 64;
  slice.rows = 48;
  const std::string good = test::dicom_bytes(slice);
  const std::size_t rows = good.find(std::string("\x28\0\x10\0US", 6)) + 8;
  const std::string position = "0\\0\\0 ";
  ASSERT_LT(rows, good.size());
  expect_refusals(
      "slice.dcm",
      {{"pixels cut", good.substr(0, good.size() - 2000), "truncated or damaged"},
       {"header cut", good.substr(0, 300), "slice.dcm"},
       {"huge", patched(patched(good, rows, std::uint16_t{65535}), rows + 10, std::uint16_t{65535}), "65535 x 65535"},
       {"no rows", patched(good, rows, std::uint16_t{0}), "no DICOM image"},
       {"zero spacing", replaced(good, "1\\1 ", "0\\0 "), "where they lie in the patient"},
       {"NaN position", replaced(good, position, "nan\\0 "), "where they lie in the patient"},
       {"wrong orientation", replaced(good, "1\\0\\0\\0\\1\\0", "1\\0\\0\\1\\0\\0"), "where they lie"},
       {"not CT", replaced(good, std::string("CS\2\0CT", 6), std::string("CS\2\0MR", 6)), "not CT"}},
      [](const auto& file) { read_ct_isolated(file); });  // GDCM asserts, and so aborts, on some of them
}

TEST(DamagedFiles, a_file_never_brings_in_its_neighbour) {
  // niftilib would read a.nii for the voxels of a.nii.gz.
  const test::ScratchFolder folder;
  CtVolume ct = test::small_ct();
  test::write_file(folder / "a.nii.gz", test::gzip_bytes(test::nifti_bytes(ct)));
  CtVolume other = ct;
  other.voxels.assign(other.voxels.size(), 77);
  test::write_file(folder / "a.nii", test::nifti_bytes(other));
  EXPECT_EQ(read_ct(folder / "a.nii.gz").ct.voxels, ct.voxels);
  EXPECT_EQ(read_ct(folder / "a.nii").ct.voxels, other.voxels);
}

TEST(DamagedFiles, the_content_decides_not_the_name) {
  const test::ScratchFolder folder;
  const CtVolume ct = test::small_ct();
  test::write_file(folder / "is_nrrd.nii.gz", test::nrrd_bytes(ct));
  test::write_file(folder / "is_nifti.mha", test::gzip_bytes(test::nifti_bytes(ct)));
  test::write_file(folder / "is_meta_image", test::meta_image_bytes(ct));
  for (const char* name : {"is_nrrd.nii.gz", "is_nifti.mha", "is_meta_image"}) {
    EXPECT_EQ(read_ct(folder / name).ct.voxels, ct.voxels) << name;
  }
}

TEST(DamagedFiles, labels_must_be_whole_numbers) {
  const test::ScratchFolder folder;
  test::write_file(folder / "labels.nrrd", test::nrrd_bytes(test::small_ct()));
  EXPECT_THAT(sentence_of([&] { read_labels(folder / "labels.nrrd"); }),
              HasSubstr("a voxel holds -1000; expected labels"));
}

// Flips a few bytes, or cuts or doubles a piece.
std::string mangled(std::string bytes, Random& random) {
  const int changes = 1 + static_cast<int>(random.uniform() * 8.0);
  for (int i = 0; i < changes; ++i) {
    const auto place = static_cast<std::size_t>(random.uniform() * static_cast<double>(bytes.size()));
    // Half of the changes go to the header, where they hurt most.
    const std::size_t target = random.uniform() < 0.5 ? place % std::min<std::size_t>(bytes.size(), 600) : place;
    bytes[target] = static_cast<char>(random.next() & 0xFFU);
  }
  if (random.uniform() < 0.1)
    bytes.resize(static_cast<std::size_t>(random.uniform() * static_cast<double>(bytes.size())));
  return bytes;
}

TEST(DamagedFiles, no_mangled_file_gets_past_the_isolated_reader) {
  const CtVolume ct = test::small_ct(true);
  test::DicomSliceFile slice;
  const std::vector<std::pair<std::string, std::string>> originals = {
      {"f.nii", test::nifti_bytes(ct)},
      {"f.nii.gz", test::gzip_bytes(test::nifti_bytes(ct))},
      {"f.nrrd", test::nrrd_bytes(ct)},
      {"f.mha", test::meta_image_bytes(ct)},
      {"f.dcm", test::dicom_bytes(slice)}};
  use_built_worker();
  const test::ScratchFolder folder;
  rusage before{}, after{};
  getrusage(RUSAGE_CHILDREN, &before);
  Random random(20240607);
  int refused = 0, read = 0;
  for (int seed = 0; seed < 60; ++seed) {
    for (const auto& [name, bytes] : originals) {
      test::write_file(folder / name, mangled(bytes, random));
      try {
        const CtVolume volume = read_ct_isolated(folder / name);
        EXPECT_EQ(volume.voxels.size(), volume.grid.voxel_count());
        EXPECT_LE(volume.voxels.size() * sizeof(std::int16_t), 1100 * bytes.size() * 4);
        ++read;
      } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(name));
        ++refused;
      }
    }
  }
  getrusage(RUSAGE_CHILDREN, &after);
#ifndef BODKIN_ADDRESS_SANITIZER                                         // which keeps what is freed
  EXPECT_LE(after.ru_maxrss, std::max(before.ru_maxrss, 256L * 1024L));  // KiB; files of a few hundred bytes
#endif
  EXPECT_GT(refused, 50);
  EXPECT_GT(read, 50);
}

}  // namespace
}  // namespace bodkin
