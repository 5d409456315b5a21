#include <cmath>
#include <cstring>
#include <limits>

#include "tests/io/images/test_images.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "io/images/coding_error.h"
#include "io/images/image_source.h"
#include "io/run_program.h"

// Radiology's exports other than a clean stack of slices: damaged slices, packed and lossy ones, several frames in
// one file; and NIfTI with NaN padding.

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

using test::sentence_of;
using testing::Contains;
using testing::HasSubstr;

constexpr const char* enhanced_ct_storage = "1.2.840.10008.5.1.4.1.1.2.1";
constexpr const char* explicit_little_endian = "1.2.840.10008.1.2.1";

test::DicomSliceFile slice_at(int k) {
  test::DicomSliceFile slice;
  slice.columns = 16;
  slice.rows = 12;
  slice.position = Vec3(0, 0, 2.0 * k);
  slice.pixels.assign(16 * 12, static_cast<std::uint16_t>(100 + k));
  return slice;
}

std::string slice_name(int k) {
  return "slice" + std::to_string(k) + ".dcm";
}

// Six slices, of which number `bad` is changed by `damage`.
template <typename Damage>
void write_series(const test::ScratchFolder& folder, int bad, const Damage& damage) {
  for (int k = 0; k < 6; ++k) {
    std::string bytes = test::dicom_bytes(slice_at(k));
    if (k == bad) bytes = damage(bytes);
    test::write_file(folder / slice_name(k), bytes);
  }
}

// HU by which a series changed in a round trip.
struct ValuesLost {
  double largest = 0.0, root_mean_square = 0.0;
};

ValuesLost values_lost(const CtVolume& whole, const CtVolume& lossy) {
  ValuesLost lost;
  double squares = 0.0;
  for (std::size_t n = 0; n < whole.voxels.size(); ++n) {
    const double off = whole.voxels[n] - lossy.voxels[n];
    lost.largest = std::max(lost.largest, std::abs(off));
    squares += off * off;
  }
  lost.root_mean_square = std::sqrt(squares / static_cast<double>(whole.voxels.size()));
  return lost;
}

std::string pixels_cut(const std::string& bytes) {
  return bytes.substr(0, bytes.size() - 100);
}

std::string header_cut(const std::string& bytes) {
  return bytes.substr(0, 320);
}

std::string without_place(const std::string& bytes) {
  std::string changed = bytes;
  const auto place = changed.find(std::string("\x20\0\x32\0DS", 6));
  EXPECT_NE(place, std::string::npos);
  changed.replace(place + 8, 3, "x\\0");
  return changed;
}

TEST(DamagedSlice, at_the_end_of_a_stack_is_named_and_left_out) {
  for (const auto& damage : {pixels_cut, header_cut, without_place}) {
    for (const int bad : {0, 5}) {
      const test::ScratchFolder folder;
      write_series(folder, bad, damage);
      const CtImage image = read_ct(folder.path());
      EXPECT_EQ(image.ct.grid.size, (std::array<int, 3>{16, 12, 5}));
      EXPECT_FALSE(image.resampled);
      const int first = bad == 0 ? 1 : 0;
      EXPECT_EQ(image.ct.grid.origin.z(), 2.0 * first);
      for (int k = 0; k < 5; ++k) EXPECT_EQ(image.ct.at(3, 3, k), 100 + first + k - 1024);
      EXPECT_THAT(image.notes, Contains(HasSubstr(slice_name(bad))));
    }
  }
}

TEST(DamagedSlice, inside_a_stack_is_refused_by_name_or_interpolated_when_asked) {
  for (const auto& damage : {pixels_cut, header_cut, without_place}) {
    const test::ScratchFolder folder;
    write_series(folder, 2, damage);
    const std::string sentence = sentence_of([&] { read_ct(folder.path()); });
    EXPECT_THAT(sentence, HasSubstr(slice_name(2)));
    EXPECT_THAT(sentence, HasSubstr("--fill-missing"));
    EXPECT_EQ(sentence.find('\n'), std::string::npos);
    DicomOptions options;
    options.fill_missing = true;
    const CtImage image = read_ct(folder.path(), options);
    EXPECT_EQ(image.ct.grid.size, (std::array<int, 3>{16, 12, 6}));
    EXPECT_EQ(image.ct.at(3, 3, 2), 102 - 1024);
    EXPECT_THAT(image.notes, Contains(HasSubstr("interpolated")));
  }
}

TEST(DamagedSlice, that_is_all_there_is_is_refused) {
  const test::ScratchFolder folder;
  test::write_file(folder / "a.dcm", pixels_cut(test::dicom_bytes(slice_at(0))));
  EXPECT_THAT(sentence_of([&] { read_ct(folder.path()); }), HasSubstr("a.dcm"));
}

TEST(DicomSeries, deflated_files_read_as_the_others_do) {
  const test::ScratchFolder folder;
  for (int k = 0; k < 3; ++k) {
    test::DicomSliceFile slice = slice_at(k);
    slice.columns = 64, slice.rows = 64;
    slice.pixels.assign(64 * 64, static_cast<std::uint16_t>(100 + k));
    slice.deflated = true;
    test::write_file(folder / slice_name(k), test::dicom_bytes(slice));
  }
  const CtImage image = read_ct(folder.path());
  EXPECT_EQ(image.ct.grid.size, (std::array<int, 3>{64, 64, 3}));
  for (int k = 0; k < 3; ++k) EXPECT_EQ(image.ct.at(5, 9, k), 100 + k - 1024);
}

TEST(DicomSeries, the_list_says_what_how_many_how_large_and_where) {
  const test::ScratchFolder folder;
  for (int series = 1; series <= 2; ++series) {
    std::filesystem::create_directories(folder / ("scan" + std::to_string(series)) / "axial");
    for (int k = 0; k < 2; ++k) {
      test::DicomSliceFile slice = slice_at(k);
      slice.series_uid = "1.2." + std::to_string(series);
      slice.series_number = series;
      test::write_file(folder / ("scan" + std::to_string(series)) / "axial" / slice_name(k),
                       test::dicom_bytes(slice));
    }
  }
  EXPECT_THAT(sentence_of([&] { read_ct(folder.path()); }),
              HasSubstr("2: series 2 'made for a test', CT, 2 slices of 16 x 12, 16 x 12 mm, z = 0.00 to 2.00 mm, in "
                        "scan2/axial"));
}

// An enhanced CT of three frames, stored from head to foot.
std::string enhanced_ct(bool placed) {
  using namespace test;
  const auto groups = [](int frame) {
    return dicom_sequence(0x20, 0x9113,
                          {dicom_element(0x20, 0x32, "DS", dicom_point(Vec3(-5.0, 7.0, 40.0 - 2.5 * frame)))}) +
           dicom_sequence(0x28, 0x9145,
                          {dicom_element(0x28, 0x1052, "DS", std::to_string(-1000 - frame)) +
                           dicom_element(0x28, 0x1053, "DS", "2")});
  };
  const std::string shared =
      dicom_sequence(0x20, 0x9116, {dicom_element(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0")}) +
      dicom_sequence(0x28, 0x9110,
                     {dicom_element(0x18, 0x50, "DS", "2.5") + dicom_element(0x28, 0x30, "DS", "0.5\\0.75")});
  std::string pixels(4 * 3 * 3 * 2, '\0');
  for (std::size_t n = 0; n < 36; ++n) pixels[2 * n] = static_cast<char>(n);
  return dicom_file(
      enhanced_ct_storage, explicit_little_endian, "1.2.3.4",
      dicom_element(8, 0x16, "UI", enhanced_ct_storage) + dicom_element(8, 0x18, "UI", "1.2.3.4") +
          dicom_element(8, 0x60, "CS", "CT") + dicom_element(0x20, 0x0e, "UI", "1.2.3") +
          dicom_element(0x28, 2, "US", dicom_number(1)) + dicom_element(0x28, 4, "CS", "MONOCHROME2") +
          dicom_element(0x28, 8, "IS", "3") + dicom_element(0x28, 0x10, "US", dicom_number(3)) +
          dicom_element(0x28, 0x11, "US", dicom_number(4)) + dicom_element(0x28, 0x100, "US", dicom_number(16)) +
          dicom_element(0x28, 0x101, "US", dicom_number(16)) + dicom_element(0x28, 0x102, "US", dicom_number(15)) +
          dicom_element(0x28, 0x103, "US", dicom_number(0)) +
          (placed ? dicom_sequence(0x5200, 0x9229, {shared}) : std::string()) +
          dicom_sequence(0x5200, 0x9230, {groups(0), groups(1), groups(2)}) +
          dicom_element(0x7fe0, 0x10, "OW", pixels));
}

TEST(DicomSeries, the_frames_of_an_enhanced_ct_are_its_slices) {
  const test::ScratchFolder folder;
  test::write_file(folder / "enhanced.dcm", enhanced_ct(true));
  for (const auto& path : {folder.path(), folder / "enhanced.dcm"}) {
    const CtImage image = read_ct(path);
    EXPECT_EQ(image.ct.grid.size, (std::array<int, 3>{4, 3, 3}));
    EXPECT_EQ(image.ct.grid.spacing, Vec3(0.75, 0.5, 2.5));
    EXPECT_EQ(image.ct.grid.origin, Vec3(-5.0, 7.0, 35.0));
    for (int k = 0; k < 3; ++k) {
      const int frame = 2 - k;
      for (int n = 0; n < 12; ++n)
        EXPECT_EQ(image.ct.at(n % 4, n / 4, k), 2 * (12 * frame + n) - 1000 - frame) << k << " " << n;
    }
  }
  test::write_file(folder / "enhanced.dcm", enhanced_ct(false));
  EXPECT_THAT(sentence_of([&] { read_ct(folder.path()); }), HasSubstr("3 frames in one file that do not all say"));
}

// A NIfTI file of float32 with the values of `ct`.
std::string float_nifti(const CtVolume& ct, const std::vector<float>& values, bool big_endian) {
  std::string bytes = test::nifti_bytes(ct).substr(0, 352);
  const auto patch = [&](std::size_t place, auto value) { std::memcpy(bytes.data() + place, &value, sizeof value); };
  patch(70, std::int16_t{16});
  patch(72, std::int16_t{32});
  patch(112, 2.0F);    // slope
  patch(116, -50.0F);  // intercept
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
  if (!big_endian) return bytes;
  const auto turn = [&](std::size_t from, std::size_t to, std::size_t width) {
    for (; from < to; from += width)
      std::reverse(bytes.begin() + static_cast<long>(from), bytes.begin() + static_cast<long>(from + width));
  };
  turn(0, 4, 4), turn(40, 56, 2), turn(68, 76, 2), turn(76, 120, 4), turn(252, 256, 2), turn(256, 328, 4);
  turn(352, bytes.size(), 4);
  return bytes;
}

TEST(Nifti, what_is_not_a_number_is_padding_and_not_water) {
  const CtVolume ct = test::small_ct();
  std::vector<float> stored;
  for (const std::int16_t value : ct.voxels) stored.push_back(0.5F * (static_cast<float>(value) + 50.0F));
  stored[3] = std::numeric_limits<float>::quiet_NaN();
  stored[100] = std::numeric_limits<float>::infinity();
  const test::ScratchFolder folder;
  for (const bool big_endian : {false, true}) {
    const std::string bytes = float_nifti(ct, stored, big_endian);
    test::write_file(folder / "ct.nii", bytes);
    test::write_file(folder / "ct.nii.gz", test::gzip_bytes(bytes));
    for (const char* name : {"ct.nii", "ct.nii.gz"}) {
      const CtImage image = read_ct(folder / name);
      std::vector<std::int16_t> expected = ct.voxels;
      expected[3] = expected[100] = -1024;
      EXPECT_EQ(image.ct.voxels, expected) << name << big_endian;
      EXPECT_THAT(image.notes, testing::ElementsAre(HasSubstr("not a number (NaN, voxels: 2) are padding")));
    }
  }
}

TEST(Nifti, labels_that_are_not_a_number_are_none) {
  CtVolume ct = test::small_ct();
  std::vector<float> stored(ct.voxels.size(), 0.5F * (4.0F + 50.0F));  // label 4
  stored[7] = std::numeric_limits<float>::quiet_NaN();
  const test::ScratchFolder folder;
  test::write_file(folder / "labels.nii", float_nifti(ct, stored, false));
  const LabelVolume labels = read_labels(folder / "labels.nii");
  EXPECT_EQ(labels.voxels[6], 4);
  EXPECT_EQ(labels.voxels[7], 0);
}

TEST(CodingError, near_lossless_jpeg_ls_states_its_largest_error) {
  const std::string start("\xFF\xD8\xFF\xF7\0\x0B\x0C\0\x0C\0\x10\1\1\x11\0", 15);
  const auto scan = [&](char near) {
    return start + std::string("\xFF\xDA\0\x08\1\1\0", 7) + near + std::string("\0\0", 2);
  };
  const auto error = coding_error(scan(3));
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->largest, 3.0);
  EXPECT_NEAR(error->typical, 2.0, 1e-12);  // -3 to 3 alike
  EXPECT_FALSE(coding_error(scan(0)).has_value()) << "lossless";
  EXPECT_FALSE(coding_error("").has_value());
  EXPECT_FALSE(coding_error(start).has_value());
  EXPECT_FALSE(coding_error(std::string(50, '\xFF')).has_value());
}

// A slice of noise that JPEG really compresses: no value is off by more than the tables allow, and the root mean
// square is what the steps say.
TEST(CodingError, of_a_lossy_jpeg_bounds_the_values_that_come_back) {
  test::DicomSliceFile slice = slice_at(0);
  slice.columns = slice.rows = 64;
  slice.intercept = -1024.0;
  slice.pixels.resize(64 * 64);
  Random random(11);
  for (std::uint16_t& pixel : slice.pixels) pixel = static_cast<std::uint16_t>(1000.0 + 900.0 * random.uniform());
  std::string bytes = test::dicom_bytes(slice);
  // JPEG's lossy code holds 12 bits.
  const auto stored = bytes.find(std::string("\x28\0\x01\1US\2\0\x10\0", 10));
  ASSERT_NE(stored, std::string::npos);
  bytes[stored + 8] = 12;
  bytes[bytes.find(std::string("\x28\0\x02\1US\2\0\x0F\0", 10)) + 8] = 11;
  const test::ScratchFolder folder;
  test::write_file(folder / "whole.dcm", bytes);
  const auto packed = run_program(
      {"gdcmconv", "-J", "-Y", "-q", "60", (folder / "whole.dcm").string(), (folder / "lossy.dcm").string()}, "",
      "libgdcm-tools");
  ASSERT_EQ(packed.exit_code, 0);
  const CtImage whole = read_ct(folder / "whole.dcm"), lossy = read_ct(folder / "lossy.dcm");
  const ValuesLost lost = values_lost(whole.ct, lossy.ct);
  ASSERT_GT(lost.largest, 1.0) << "nothing was lost";
  const auto note = std::find_if(lossy.notes.begin(), lossy.notes.end(),
                                 [](const std::string& text) { return text.find("with loss") != std::string::npos; });
  ASSERT_NE(note, lossy.notes.end());
  const double typical = std::stod(note->substr(note->find("about ") + 6));
  const double most = std::stod(note->substr(note->find("by ", note->find("square")) + 3));
  EXPECT_LE(lost.largest, most) << *note;
  EXPECT_NEAR(lost.root_mean_square, typical, 0.25 * typical) << *note;
  EXPECT_TRUE(whole.notes.empty());
}

TEST(DicomSeries, a_loss_that_the_code_does_not_state_is_noted_without_a_number) {
  std::string bytes = test::dicom_bytes(slice_at(0));
  const auto pixels = bytes.find(std::string("\xE0\x7F\x10\0OW", 6));
  bytes.insert(pixels,
               test::dicom_element(0x28, 0x2110, "CS", "01") + test::dicom_element(0x28, 0x2112, "DS", "12.5"));
  const test::ScratchFolder folder;
  test::write_file(folder / "a.dcm", bytes);
  EXPECT_THAT(read_ct(folder.path()).notes,
              Contains(HasSubstr("compressed with loss, 12.5:1; the file does not say")));
}

TEST(DicomSeries, a_loss_by_jpeg_2000_is_noted_with_what_its_ratio_did_to_other_cts) {
  std::string bytes = test::dicom_bytes(slice_at(0));
  const auto pixels = bytes.find(std::string("\xE0\x7F\x10\0OW", 6));
  bytes.insert(pixels, test::dicom_element(0x28, 0x2110, "CS", "01") +
                           test::dicom_element(0x28, 0x2112, "DS", "12.0") +
                           test::dicom_element(0x28, 0x2114, "CS", "ISO_15444_1 "));
  const test::ScratchFolder folder;
  test::write_file(folder / "a.dcm", bytes);
  EXPECT_THAT(read_ct(folder.path()).notes,
              Contains(HasSubstr("JPEG 2000, 12:1, which sets no limit; at this ratio values of other CTs were off "
                                 "by less than 18 HU (root mean square) and 120 HU at most")));
}

// Edges and noise as a CT has them: the decoded values are within the note's limits.
TEST(DicomSeries, jpeg_2000_moves_values_no_further_than_its_note_says) {
  test::DicomSliceFile slice = slice_at(0);
  slice.columns = slice.rows = 128;
  slice.intercept = -1024.0;
  slice.pixels.resize(128 * 128);
  Random random(3);
  for (std::size_t n = 0; n < slice.pixels.size(); ++n) {
    const double x = static_cast<double>(n % 128) - 64.0, y = static_cast<double>(n / 128) - 64.0;
    const double radius = std::hypot(x, y);
    const double value = radius < 8.0 ? 700.0 : radius < 35.0 ? 40.0 : radius < 52.0 ? -100.0 : -1000.0;
    slice.pixels[n] = static_cast<std::uint16_t>(1024.0 + value + 24.0 * random.uniform());
  }
  const test::ScratchFolder folder;
  test::write_file(folder / "whole.dcm", test::dicom_bytes(slice));
  const auto packed = run_program({"gdcmconv", "-K", "-Y", "-r", "10", "--irreversible",
                                   (folder / "whole.dcm").string(), (folder / "lossy.dcm").string()},
                                  "", "libgdcm-tools");
  ASSERT_EQ(packed.exit_code, 0);
  const CtImage whole = read_ct(folder / "whole.dcm"), lossy = read_ct(folder / "lossy.dcm");
  const ValuesLost lost = values_lost(whole.ct, lossy.ct);
  ASSERT_GT(lost.largest, 1.0) << "nothing was lost";
  const auto note = std::find_if(lossy.notes.begin(), lossy.notes.end(),
                                 [](const std::string& text) { return text.find("JPEG 2000") != std::string::npos; });
  ASSERT_NE(note, lossy.notes.end());
  EXPECT_LE(lost.largest, std::stod(note->substr(note->find("square) and ") + 12))) << *note;
  EXPECT_LE(lost.root_mean_square, std::stod(note->substr(note->find("less than ") + 10))) << *note;
}

}  // namespace
}  // namespace bodkin
