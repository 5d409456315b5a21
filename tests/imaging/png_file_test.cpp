#include "imaging/png_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::imaging;
namespace {

ImageRgb noise(int width, int height) {
  ImageRgb image(width, height);
  Random random(7);
  for (Rgb& pixel : image.pixels) pixel = rgb(static_cast<std::uint32_t>(random.next() & 0xFFFFFF));
  return image;
}

TEST(PngFile, a_picture_reads_back_pixel_for_pixel) {
  const ImageRgb image = noise(37, 23);
  const ImageRgb again = decode_png(encode_png(image), "memory");
  EXPECT_EQ(again.width, 37);
  EXPECT_EQ(again.height, 23);
  EXPECT_EQ(again.pixels, image.pixels);
}

TEST(PngFile, a_written_file_holds_the_picture_and_nothing_lies_beside_it) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "png_file_test";
  std::filesystem::remove_all(folder);
  write_png(noise(8, 5), folder / "new" / "a.png");
  std::ifstream stream(folder / "new" / "a.png", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  EXPECT_EQ(decode_png(bytes, "a.png").pixels, noise(8, 5).pixels);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "new"), {}), 1);
}

TEST(PngFile, bytes_that_are_no_picture_are_refused_by_name) {
  const std::string bytes = encode_png(noise(16, 16));
  for (const std::string& broken : {std::string(), std::string("not a picture"), bytes.substr(0, bytes.size() / 2)}) {
    try {
      decode_png(broken, "the-file.png");
      FAIL() << "accepted " << broken.size() << " bytes";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("the-file.png"), std::string::npos);
    }
  }
}

TEST(PngFile, a_folder_that_cannot_be_written_is_a_system_error) {
  EXPECT_THROW(write_png(noise(2, 2), "/proc/nowhere/a.png"), SystemError);
}

}  // namespace
}  // namespace bodkin
