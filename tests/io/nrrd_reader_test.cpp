// Bodkin's own volumes are read back to the bit, without an imaging library; other files are left to the image worker
// or refused with a sentence.
#include "io/nrrd_reader.h"

#include <bit>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "io/nrrd_header.h"
#include "io/nrrd_writer.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

using ::testing::HasSubstr;

template <typename Voxel>
Volume<Voxel> noise_volume(const Grid& grid) {
  Volume<Voxel> volume(grid);
  Random random(7);
  for (Voxel& voxel : volume.voxels) voxel = static_cast<Voxel>(random.next());
  return volume;
}

Grid upright_grid() {
  Grid grid;
  grid.size = {9, 8, 7};
  grid.spacing = Vec3(0.1, 1.0 / 3.0, 2.5);
  grid.origin = Vec3(-12.3, 1e-7, 1e5);
  return grid;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::stringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

template <typename Voxel>
void expect_round_trip_in_memory(const Grid& grid) {
  const Volume<Voxel> written = noise_volume<Voxel>(grid);
  const std::vector<std::uint8_t> bytes = nrrd_bytes(written);
  const auto read = parse_nrrd<Voxel>(bytes, "it");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->voxels, written.voxels);
  EXPECT_EQ(read->grid.spacing, grid.spacing);
  EXPECT_EQ(read->grid.direction, grid.direction);
  EXPECT_EQ(read->grid.origin, grid.origin);
  // The same bytes are a file that other programs read.
  const ScratchFolder folder;
  std::ofstream(folder.path() / "volume.nrrd", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  EXPECT_EQ(read_nrrd<Voxel>(folder.path() / "volume.nrrd")->voxels, written.voxels);
}

template <typename Voxel>
void expect_round_trip(const Grid& grid) {
  const ScratchFolder folder;
  const Volume<Voxel> written = noise_volume<Voxel>(grid);
  write_nrrd(written, folder.path() / "volume.nrrd");
  const auto read = read_nrrd<Voxel>(folder.path() / "volume.nrrd");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->voxels, written.voxels);
  EXPECT_EQ(read->grid.size, grid.size);
  EXPECT_EQ(read->grid.spacing, grid.spacing);
  EXPECT_EQ(read->grid.direction, grid.direction);
  EXPECT_EQ(read->grid.origin, grid.origin);
}

TEST(NrrdReader, reads_in_memory_what_was_packed_in_memory) {
  expect_round_trip_in_memory<std::uint8_t>(upright_grid());
  expect_round_trip_in_memory<std::uint16_t>(upright_grid());
}

TEST(NrrdReader, voxels_and_an_upright_grid_come_back_to_the_bit) {
  expect_round_trip<std::int16_t>(upright_grid());
  expect_round_trip<std::uint16_t>(upright_grid());
  expect_round_trip<std::uint8_t>(upright_grid());
}

TEST(NrrdReader, axes_in_any_order_and_direction_come_back_to_the_bit) {
  Grid grid = upright_grid();
  grid.direction << 0, 0, -1, 1, 0, 0, 0, -1, 0;
  expect_round_trip<std::int16_t>(grid);
}

TEST(NrrdReader, an_oblique_grid_comes_back_to_a_trillionth) {
  const ScratchFolder folder;
  Grid grid = upright_grid();
  grid.direction = Eigen::AngleAxisd(0.3, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  write_nrrd(noise_volume<std::uint8_t>(grid), folder.path() / "volume.nrrd");
  const auto read = read_nrrd<std::uint8_t>(folder.path() / "volume.nrrd");
  ASSERT_TRUE(read.has_value());
  EXPECT_LT((read->grid.direction - grid.direction).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((read->grid.spacing - grid.spacing).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(NrrdReader, a_volume_longer_than_one_gzip_block_and_one_that_packs_a_thousandfold) {
  Grid grid = upright_grid();
  grid.size = {200, 150, 90};
  expect_round_trip<std::int16_t>(grid);  // noise: the packed voxels are longer than the voxels

  const ScratchFolder folder;
  const TissueVolume air(grid);
  write_nrrd(air, folder.path() / "air.nrrd");
  const auto read = read_nrrd<std::uint8_t>(folder.path() / "air.nrrd");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->voxels, air.voxels);
}

// The form is fixed: cases on disk have it, and the reader accepts no other.
TEST(NrrdHeader, is_this_text) {
  NrrdHeader header{"short", {2, 3, 4}, Mat3::Identity(), Vec3(0.1, -0.0, 1e-9)};
  header.steps(2, 1) = 0.5;
  const std::string text = nrrd_header_text(header);
  EXPECT_EQ(text,
            "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 3 4\n"
            "space directions: (1,0,0) (0,1,0.5) (0,0,1)\nkinds: domain domain domain\nendian: little\n"
            "encoding: gzip\nspace origin: (0.10000000000000001,-0,1.0000000000000001e-09)\n\n");
  const auto parsed = parse_nrrd_header(text + "voxels");
  ASSERT_TRUE(parsed.has_value());
  EXPECT_EQ(parsed->bytes, text.size());
  EXPECT_EQ(parsed->header.steps, header.steps);
  EXPECT_EQ(parsed->header.origin, header.origin);
}

TEST(NrrdHeader, the_longest_fits_the_limit) {
  constexpr double widest = -std::numeric_limits<double>::denorm_min();
  const int largest = std::numeric_limits<int>::max();
  const NrrdHeader header{
      "unsigned short", {largest, largest, largest}, Mat3::Constant(widest), Vec3::Constant(widest)};
  EXPECT_LE(nrrd_header_text(header).size(), longest_nrrd_header);
  EXPECT_TRUE(parse_nrrd_header(nrrd_header_text(header)).has_value());
}

class NrrdFile : public ::testing::Test {
 protected:
  NrrdFile() {
    write_nrrd(noise_volume<std::int16_t>(upright_grid()), file_);
    good_ = bytes_of(file_);
  }
  std::optional<CtVolume> read(const std::string& bytes) {
    std::ofstream(file_, std::ios::binary) << bytes;
    return read_nrrd<std::int16_t>(file_);
  }
  std::string sentence_for(const std::string& bytes) {
    const std::string sentence = refusal([&] { read(bytes); });
    EXPECT_THAT(sentence, HasSubstr(file_.string()));
    EXPECT_EQ(sentence.find('\n'), std::string::npos);
    return sentence;
  }

  ScratchFolder folder_;
  std::filesystem::path file_ = folder_.path() / "ct.nrrd";
  std::string good_;
};

TEST_F(NrrdFile, every_other_form_is_left_to_the_image_worker) {
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"NRRD0004", "NRRD0005"},
                                                        {"type: short", "type: int16"},
                                                        {"type: short", "type: unsigned short"},
                                                        {"dimension: 3", "dimension: 4"},
                                                        {"left-posterior-superior", "right-anterior-superior"},
                                                        {"sizes: 9 8 7", "sizes: 9 8"},
                                                        {"sizes: 9 8 7", "sizes: 9 8 0"},
                                                        {"sizes: 9 8 7", "sizes: 9 8 -7"},
                                                        {"sizes: 9 8 7", "sizes: 9 8 99999999999"},
                                                        {"(0.10000000000000001,", "(nan,"},
                                                        {"(0.10000000000000001,", "(inf,"},
                                                        {"(0.10000000000000001,", "(1e999,"},
                                                        {"endian: little", "endian: big"},
                                                        {"encoding: gzip", "encoding: raw"},
                                                        {"space origin", "data file: other.raw\nspace origin"},
                                                        {"\n\n", "\n# a comment\n\n"}}) {
    EXPECT_FALSE(read(replaced(good_, from, to)).has_value()) << to;
  }
  EXPECT_FALSE(read("").has_value());
  EXPECT_FALSE(read(good_.substr(0, 100)).has_value());
  EXPECT_FALSE(read_nrrd<std::int16_t>(folder_.path() / "absent.nrrd").has_value());
}

TEST_F(NrrdFile, damage_is_refused_with_a_sentence) {
  const std::size_t start = good_.find("\n\n") + 2;
  EXPECT_THAT(sentence_for(good_.substr(0, start)), HasSubstr("truncated"));
  EXPECT_THAT(sentence_for(good_.substr(0, start + 30)), HasSubstr("truncated"));
  EXPECT_THAT(sentence_for(good_.substr(0, good_.size() - 1)), HasSubstr("truncated"));
  EXPECT_THAT(sentence_for(good_ + "more"), HasSubstr("packed voxels"));
  EXPECT_THAT(sentence_for(good_ + good_.substr(start)), HasSubstr("followed by other bytes"));
  EXPECT_THAT(sentence_for(good_ + std::string(100'000, 'x')), HasSubstr("followed by other bytes"));
  EXPECT_THAT(sentence_for(replaced(good_, "sizes: 9 8 7", "sizes: 9 8 6")), HasSubstr("as many as the header"));
  EXPECT_THAT(sentence_for(replaced(good_, "sizes: 9 8 7", "sizes: 9 8 8")), HasSubstr("as many as the header"));
  EXPECT_THAT(sentence_for(replaced(good_, "0.10000000000000001,", "0,")), HasSubstr("voxel spacing is 0"));
}

TEST_F(NrrdFile, a_header_that_lies_about_its_size_takes_no_memory) {
  EXPECT_THAT(sentence_for(replaced(good_, "sizes: 9 8 7", "sizes: 800 800 800")), HasSubstr("too short"));
  EXPECT_THAT(sentence_for(replaced(good_, "sizes: 9 8 7", "sizes: 2147483647 2147483647 2147483647")),
              HasSubstr("at most 512 million"));
}

TEST_F(NrrdFile, a_length_that_lies_with_the_header_is_found_by_unpacking) {
  std::string bytes = replaced(good_, "sizes: 9 8 7", "sizes: 9 8 8");
  const std::uint32_t length = 9 * 8 * 8 * 2;
  std::memcpy(bytes.data() + bytes.size() - sizeof length, &length, sizeof length);
  EXPECT_THAT(sentence_for(bytes), HasSubstr("packed voxels"));
}

TEST_F(NrrdFile, no_changed_byte_of_the_packed_voxels_changes_a_voxel) {
  const std::size_t start = good_.find("\n\n") + 2;
  const CtVolume written = noise_volume<std::int16_t>(upright_grid());
  std::size_t refused = 0;
  for (std::size_t place = start; place < good_.size(); ++place) {
    std::string bytes = good_;
    bytes[place] = static_cast<char>(bytes[place] ^ 0x10);
    try {
      // The head of a gzip stream contains a time and a system, and bits between blocks are ignored.
      EXPECT_EQ(read(bytes).value().voxels, written.voxels) << place;
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused + 20, good_.size() - start);
}

}  // namespace
}  // namespace bodkin
