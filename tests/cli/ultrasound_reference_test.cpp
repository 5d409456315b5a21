// `bodkin ultrasound --beside`: a real image beside the simulated one, and their grey statistics.
#include <cmath>
#include <numbers>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "core/random.h"
#include "imaging/png_file.h"

namespace bodkin_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class UltrasoundReference : public PatientCommand {
 protected:
  static Outcome scanned(const std::string& arguments, const std::string& size = "--size 160x120") {
    return bodkin("-q --json ultrasound " + patient() + " --lines 96 --samples 128 --slices 1 " + size + " " +
                  arguments);
  }
  static json beside(const std::string& arguments, const std::string& size = "--size 160x120") {
    const Outcome outcome = scanned(arguments, size);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return outcome.exit_code == 0 ? json::parse(outcome.output) : json();
  }
  static void expect_refused(const std::string& arguments, const std::string& words) {
    const auto before = listing();
    const Outcome outcome = scanned(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_EQ(lines_of(outcome.errors), 1) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr(words));
    EXPECT_EQ(listing(), before) << arguments;
  }
  // White noise averaged over so many pixels across and down: its autocorrelation is a triangle that wide.
  static ::bodkin::imaging::ImageRgb averaged_noise(int width, int height, int across, int down) {
    ::bodkin::Random random(17);
    std::vector<double> noise(static_cast<std::size_t>((width + across) * (height + down)));
    for (double& value : noise) value = random.normal();
    ::bodkin::imaging::ImageRgb image(width, height);
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        double sum = 0.0;
        for (int j = 0; j < down; ++j) {
          for (int i = 0; i < across; ++i)
            sum += noise[static_cast<std::size_t>((row + j) * (width + across) + column + i)];
        }
        const double grey = 120.0 + 25.0 * sum / std::sqrt(across * down);
        const auto byte = static_cast<std::uint8_t>(std::min(255.0, std::max(0.0, std::round(grey))));
        image.at(column, row) = {byte, byte, byte};
      }
    }
    return image;
  }
  // A user's MetaImage of one or more frames.
  static void write_meta_image(const std::string& name, const std::string& size, const std::string& fields,
                               const std::string& type, const std::string& pixels) {
    write(name,
          "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
          "CompressedData = False\nDimSize = " +
              size + "\nElementType = " + type + "\n" + fields + "ElementDataFile = LOCAL\n" + pixels);
  }
};

TEST_F(UltrasoundReference, noise_of_known_width_has_it_in_millimetres) {
  write("noise.png", ::bodkin::imaging::encode_png(averaged_noise(600, 500, 10, 6)));
  const json result = beside("--beside noise.png --beside-pixel 0.1 --beside-window 5,20,40,40 -o noise-beside.svg");
  const json& real = result.at("beside").at("real");
  EXPECT_NEAR(real.at("half_width_across_mm").get<double>(), 0.5, 0.04);  // half of 10 pixels
  EXPECT_NEAR(real.at("half_width_along_mm").get<double>(), 0.3, 0.03);
  const std::array<double, 5> normal = {-1.6449, -0.6745, 0.0, 0.6745, 1.6449};
  for (std::size_t i = 0; i < normal.size(); ++i)
    EXPECT_NEAR(real.at("grey_percentiles")[i].get<double>(), 120.0 + 25.0 * normal[i], 5.0);
  EXPECT_EQ(real.at("window_mm"), json::array({5.0, 20.0, 40.0, 40.0}));
  // The file does not state depth and probe: the depth is the image's, as deep as the curved face permits.
  EXPECT_GT(result.at("depth_mm").get<double>(), 30.0);
  EXPECT_LT(result.at("depth_mm").get<double>(), 50.0);
  for (const char* words : {"noise.png", "grey 5, 25, 50, 75, 95 %: ", "half-width across ", "stroke-dasharray"})
    EXPECT_THAT(text_of("noise-beside.svg"), HasSubstr(words));
}

TEST_F(UltrasoundReference, one_grey_has_no_width) {
  ::bodkin::imaging::ImageRgb image(200, 200);
  for (::bodkin::imaging::Rgb& pixel : image.pixels) pixel = {90, 90, 90};
  write("grey.png", ::bodkin::imaging::encode_png(image));
  const json real = beside("--beside grey.png --beside-pixel 0.3 -o grey-beside.png").at("beside").at("real");
  EXPECT_EQ(real.at("grey_percentiles"), json::array({90, 90, 90, 90, 90}));
  EXPECT_TRUE(real.at("half_width_across_mm").is_null());
  EXPECT_TRUE(real.at("half_width_along_mm").is_null());
}

TEST_F(UltrasoundReference, its_own_sequence_is_what_it_simulates) {
  const std::string machine = "--probe L14-5 --depth 60 --gain 3 ";
  ASSERT_EQ(scanned(machine + "--tilt=0,15 --frames 3 -o own.igs.mha").exit_code, 0);
  for (const std::string mark : {"left", "right"}) {
    const json result = beside("--probe L14-5 --gain 3 --mark " + mark + " --beside own.igs.mha:0 -o own-beside.png");
    EXPECT_NEAR(result.at("depth_mm").get<double>(), 60.0, 0.1);
    EXPECT_EQ(result.at("beside").at("picture"), "own.igs.mha, frame 0");
    const double pixel = result.at("beside").at("pixel_mm").get<double>();
    EXPECT_NEAR(pixel, 60.0 / 119.0, 1e-3);
    EXPECT_NEAR(result.at("pixel_mm").get<double>(), pixel, 1e-3);
    json simulated = result.at("beside").at("simulated"), real = result.at("beside").at("real");
    for (const char* width : {"half_width_across_mm", "half_width_along_mm"})
      EXPECT_NEAR(simulated.at(width).get<double>(), real.at(width).get<double>(), 0.02) << width;
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_NEAR(simulated.at("grey_percentiles")[i].get<int>(), real.at("grey_percentiles")[i].get<int>(), 2);
    }
  }
  const json matched = beside("--probe L14-5 --beside own.igs.mha:0 -o own-beside.png", "");
  EXPECT_NEAR(matched.at("pixel_mm").get<double>(), 60.0 / 119.0, 0.01) << "nobody said a size";
  EXPECT_EQ(matched.at("size")[1], 120);
  // A window beside the middle contains the same tissue in both: neither is the mirror image of the other.
  const json aside =
      beside("--probe L14-5 --gain 3 --beside own.igs.mha:0 --window=-6,48,8,10 -o own-beside.png").at("beside");
  const json mirrored =
      beside("--probe L14-5 --gain 3 --beside own.igs.mha:0 --window=-6,48,8,10 --beside-window 6,48,8,10 -o o.png")
          .at("beside");
  const auto apart = [](const json& pair) {
    int sum = 0;
    for (std::size_t i = 0; i < 5; ++i) {
      sum += std::abs(pair.at("simulated").at("grey_percentiles")[i].get<int>() -
                      pair.at("real").at("grey_percentiles")[i].get<int>());
    }
    return sum;
  };
  EXPECT_LE(apart(aside), 8);
  EXPECT_GT(apart(mirrored), 40) << "bone and its shadow are on one side only";
  EXPECT_NE(beside("--probe L14-5 --beside own.igs.mha:2 -o o.png").at("beside").at("real"), aside.at("real"));
}

TEST_F(UltrasoundReference, a_crop_is_all_that_is_looked_at) {
  ::bodkin::imaging::ImageRgb screen(300, 260);
  for (int row = 40; row < 240; ++row) {
    for (int column = 100; column < 250; ++column) screen.at(column, row) = {200, 200, 200};
  }
  write("screen.png", ::bodkin::imaging::encode_png(screen));
  const json result =
      beside("--probe L14-5 --beside screen.png --beside-pixel 0.2 --beside-crop 100,40,150,200 -o c.png", "");
  EXPECT_EQ(result.at("size")[1], 200);
  EXPECT_NEAR(result.at("depth_mm").get<double>(), 40.0, 0.3);
  EXPECT_EQ(result.at("beside").at("real").at("grey_percentiles"), json::array({200, 200, 200, 200, 200}));
  // Only the picture that is written has both.
  const ::bodkin::imaging::ImageRgb both = ::bodkin::imaging::decode_png(content_of(folder_ / "c.png"), "c.png");
  std::ptrdiff_t grey = 0;
  for (const ::bodkin::imaging::Rgb& pixel : both.pixels)
    grey += pixel == ::bodkin::imaging::Rgb{200, 200, 200} ? 1 : 0;
  EXPECT_GT(grey, 3 * 150 * 200) << "it is drawn at the scale of the simulated one, 600 px high";
}

TEST_F(UltrasoundReference, what_cannot_be_is_one_sentence) {
  write("grey.png", ::bodkin::imaging::encode_png(::bodkin::imaging::ImageRgb(200, 150)));
  const std::string frames(2 * 64 * 48, '\x30');
  write_meta_image("unscaled.mha", "64 48 2", "ElementSpacing = 1 1 1\n", "MET_UCHAR", frames);
  write_meta_image("oblong.mha", "64 48 2", "ElementSpacing = 0.5 0.8 1\n", "MET_UCHAR", frames);
  write_meta_image("scaled.mha", "64 48 2", "ElementSpacing = 1.5 1.5 1\n", "MET_UCHAR", frames);
  write_meta_image("small.mha", "64 48 2", "ElementSpacing = 0.1 0.1 1\n", "MET_UCHAR", frames);
  write_meta_image("wide.mha", "64 48 1", "ElementSpacing = 1.5 1.5 1\n", "MET_USHORT", frames);
  write("torn.mha", "ObjectType = Image\nNDims = 3\nDimSize = 64 48 2\nElementType = MET_UCHAR\n");
  write("text.png", "this is no picture");
  expect_refused("--beside grey.png", "does not say how large its pixels are; say it with --beside-pixel");
  expect_refused("--beside unscaled.mha", "does not say how large its pixels are; say it with --beside-pixel");
  expect_refused("--beside oblong.mha", "its pixels are 0.5 x 0.8 mm, expected square ones");
  expect_refused("--beside scaled.mha:2", "asks for frame 2 of scaled.mha, which has 2; expected 0 to 1");
  expect_refused("--beside scaled.mha:x", "'scaled.mha:x', which is not a file; expected");
  expect_refused("--beside scaled.mha:-1", "which is not a file");
  expect_refused("--beside scaled.mha:99999999999999999999", "which is not a file");
  expect_refused("--beside grey.png:1 --beside-pixel 0.3", "asks for frame 1 of grey.png, which is one picture");
  expect_refused("--beside wide.mha", "has the value 12336, expected grey levels from 0 to 255");
  expect_refused("--beside torn.mha", "torn.mha");
  expect_refused("--beside text.png --beside-pixel 0.3", "text.png is not a usable PNG");
  expect_refused("--beside .", "which is a folder; expected a picture");
  expect_refused("--beside nothing.mha", "nothing.mha");
  expect_refused("--beside nothing.png", "nothing.png");
  expect_refused("--beside small.mha", "mm deep, expected 10 or more");
  expect_refused("--beside grey.png --beside-pixel 5", "are 1000 mm, expected at most 400");
  expect_refused("--beside grey.png --beside-pixel 0.3 --beside-crop 0,0,300,100",
                 "inside the picture, which has 200");
  expect_refused("--beside grey.png --beside-pixel 0.3 --beside-crop=-1,0,30,30", "expected left,top,width,height");
  expect_refused("--beside grey.png --beside-pixel 0.3 --beside-crop 0,0,30.5,30", "whole pixels");
  expect_refused("--beside grey.png --beside-pixel 0.3 --beside-crop 0,0,8,30",
                 "8 x 30 pixels, expected at least 16");
  expect_refused("--beside grey.png --beside-pixel 0.3 --beside-crop 1,2", "--beside-crop is '1,2'");
  expect_refused("--beside grey.png --beside-pixel 0.3 --window 1,2,3", "--window is '1,2,3'");
  expect_refused("--beside grey.png --beside-pixel 0.3 --window 0,20,0,5", "a width and a height above 0");
  expect_refused("--beside grey.png --beside-pixel 0.3 --window 0,20,300,5", "does not lie in the simulated picture");
  expect_refused("--beside grey.png --beside-pixel 0.3 --beside-window 0,20,300,5",
                 "does not lie in the real picture");
  expect_refused("--window 0,20,5,5", "add --beside FILE");
  expect_refused("--beside-crop 0,0,20,20", "add --beside FILE");
  expect_refused("--beside grey.png --plain", "--beside is for a single picture");
  expect_refused("--beside grey.png --tilt=-5,5", "--beside is for a single picture");
  expect_refused("--beside grey.png --live", "--beside is for a single picture");
}

TEST_F(UltrasoundReference, a_real_scan_of_bone) {
  const char* named = std::getenv("BODKIN_DATA");
  const std::filesystem::path data = named != nullptr ? named : BODKIN_REPOSITORY "/../shared/data";
  const std::filesystem::path bone = data / "reference_ultrasound/bone_linear_l14.igs.mha";
  if (!std::filesystem::exists(bone)) GTEST_SKIP() << "no real ultrasound: set BODKIN_DATA to its folder";
  const std::string file = "--probe L14-5 --beside '" + bone.string() + ":10' -o bone.png ";
  expect_refused(file, "say it with --beside-pixel");
  // The L14-5's face, 39 mm, is 467 of the file's pixels wide.
  const json result = beside(file + "--beside-pixel 0.0835 --beside-crop 176,0,467,616 --window 0,11,16,6", "");
  EXPECT_NEAR(result.at("depth_mm").get<double>(), 51.4, 0.1);
  const json& greys = result.at("beside").at("real").at("grey_percentiles");
  EXPECT_LT(greys[0].get<int>(), 15) << "muscle is dark with bright fascicles";
  EXPECT_GT(greys[4].get<int>(), 35);
  const json& real = result.at("beside").at("real");
  EXPECT_GT(real.at("half_width_across_mm").get<double>(), 2.0 * real.at("half_width_along_mm").get<double>());
}

}  // namespace
}  // namespace bodkin_test
