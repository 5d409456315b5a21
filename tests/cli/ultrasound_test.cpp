// `bodkin ultrasound`: images, sweeps and refusals. Sound in tissue has separate tests.
#include <cmath>
#include <regex>
#include <sstream>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "imaging/png_file.h"

namespace bodkin_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr const char* scan_roughly =
    " --lines 64 --samples 96 --size 160x120 --slices 1";  // a picture that takes no time

class UltrasoundCommand : public PatientCommand {
 protected:
  static json said(const std::string& arguments) {
    const Outcome outcome = bodkin("-q --json ultrasound " + patient() + scan_roughly + " " + arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return outcome.exit_code == 0 ? json::parse(outcome.output) : json();
  }
  static void expect_refusal(const std::string& arguments, const std::string& words) {
    const auto before = listing();
    const Outcome outcome = bodkin("-q ultrasound " + patient() + " " + arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_EQ(lines_of(outcome.errors), 1) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr(words));
    EXPECT_EQ(listing(), before) << arguments;
  }
  static ::bodkin::imaging::ImageRgb picture(const std::string& file) {
    return ::bodkin::imaging::decode_png(content_of(folder_ / file), file);
  }
  static double brightness(const ::bodkin::imaging::ImageRgb& image) {
    double sum = 0.0;
    for (const ::bodkin::imaging::Rgb& pixel : image.pixels) sum += pixel.red;
    return sum / static_cast<double>(image.pixels.size());
  }
};

TEST_F(UltrasoundCommand, without_options_it_shows_the_planned_target_from_the_skin) {
  const json result = said("-o first.png");
  EXPECT_EQ(result.at("probe"), "C5-2");
  EXPECT_EQ(result.at("no_image"), "");
  EXPECT_GT(result.at("contact").get<double>(), 0.5);
  EXPECT_GT(result.at("press_mm").get<double>(), 0.5);
  const ::bodkin::imaging::ImageRgb image = picture("first.png");
  EXPECT_GT(image.width, 700);
  EXPECT_GT(image.height, 600);
  EXPECT_GT(brightness(image), 5.0);
  // The same again from the printed pose.
  const Outcome text = bodkin("-q ultrasound " + patient() + scan_roughly + " -o text.png");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(text.output, match, std::regex("--pose=(\\S+)"))) << text.output;
  const json again = said("-o again.png --pose=" + match[1].str());
  EXPECT_NEAR(again.at("contact").get<double>(), result.at("contact").get<double>(), 0.1);
}

TEST_F(UltrasoundCommand, plain_writes_the_pixels_and_the_matrix_says_where_they_are) {
  const json result = said("-o plain.png --plain --mark right");
  const ::bodkin::imaging::ImageRgb image = picture("plain.png");
  EXPECT_EQ(image.width, 160);
  EXPECT_EQ(image.height, 120);
  EXPECT_GT(brightness(image), 3.0);
  const json& matrix = result.at("image_to_patient");
  const double pixel = result.at("pixel_mm").get<double>();
  double length = 0.0;
  for (int row = 0; row < 3; ++row) length += std::pow(matrix[row][0].get<double>(), 2);
  EXPECT_NEAR(std::sqrt(length), pixel, 1e-9);
  const json mirrored = said("-o mirrored.png --plain");
  const ::bodkin::imaging::ImageRgb other = picture("mirrored.png");
  for (int column = 0; column < 160; ++column) ASSERT_EQ(image.at(column, 60), other.at(159 - column, 60));
  for (int row = 0; row < 3; ++row) {
    EXPECT_NEAR(mirrored.at("image_to_patient")[row][0].get<double>(), -matrix[row][0].get<double>(), 1e-12);
  }
}

TEST_F(UltrasoundCommand, every_view_and_a_needle_give_a_picture) {
  for (const std::string options :
       {"--view transverse --at L3_L4", "--view sagittal --ct", "--view kidney", "--at L2_L3 --from left",
        "--probe L14-5 --view needle --needle --needle-depth 40 --ct",
        "--tgc=0,1,2,3,4,5,6,-7 --gain 6 --no-gel --press 8"}) {
    SCOPED_TRACE(options);
    const json result = said("-o view.png " + options);
    EXPECT_EQ(result.at("no_image"), "");
    EXPECT_GT(brightness(picture("view.png")), 4.0);
  }
  said("-o drawing.svg --needle");
  for (const char* words : {"C5-2", ">cm<", "22 G", "<image"}) EXPECT_THAT(text_of("drawing.svg"), HasSubstr(words));
}

TEST_F(UltrasoundCommand, a_probe_in_the_air_is_a_black_picture_that_says_why) {
  const json result = said("-o air.svg --press=-40");
  EXPECT_NE(result.at("no_image"), "");
  EXPECT_THAT(text_of("air.svg"), HasSubstr("skin"));
  EXPECT_NE(said("-o far.png --face 900,900,900 --look 0,-1,0").at("no_image"), "");
}

TEST_F(UltrasoundCommand, a_sweep_becomes_a_tracked_sequence) {
  const json result = said("--tilt=-10,10 --frames 5 --rate 10 --needle -o fan.igs.mha");
  EXPECT_EQ(result.at("frames"), 5);
  EXPECT_EQ(result.at("frames_without_image"), 0);
  const std::string text = text_of("fan.igs.mha");
  for (const char* field : {"DimSize = 160 120 5\n", "UltrasoundImageOrientation = MF\n",
                            "Seq_Frame0004_ProbeToReferenceTransform = ", "Seq_Frame0004_Timestamp = 0.400000\n",
                            "Seq_Frame0000_NeedleTipToReferenceTransform = ", "ElementDataFile = LOCAL\n"}) {
    EXPECT_THAT(text, HasSubstr(field));
  }
}

TEST_F(UltrasoundCommand, poses_from_a_file_become_a_folder_of_pictures) {
  const Outcome text = bodkin("-q ultrasound " + patient() + scan_roughly + " -o text.png");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(text.output, match, std::regex("--pose=(\\S+)")));
  const std::string pose = match[1].str();
  write("poses.csv", "t_s,a,b,c,d,e,f,g,h,i,j,k,l\n0," + pose + "\n# a remark\n0.1," + pose + "\n");
  const json result = said("--sweep poses.csv -o frames --plain");
  ASSERT_EQ(result.at("files").size(), 2U);
  EXPECT_EQ(content_of(folder_ / "frames/frame-0000.png"), content_of(folder_ / "frames/frame-0001.png"));
  EXPECT_EQ(picture("frames/frame-0001.png").width, 160);
  said("--sweep poses.csv -o here-%02d.png");
  EXPECT_GT(picture("here-01.png").width, 700);
  write("bad.csv", "0," + pose + "\n-1," + pose + "\n");
  expect_refusal("--sweep bad.csv", "bad.csv:2: the time -1 s is before the row above");
  write("bad.csv", "0,1,2,3\n");
  expect_refusal("--sweep bad.csv", "bad.csv:1: the row has 4 fields, expected 13");
  write("bad.csv", "0,2,0,0,0,0,2,0,0,0,0,2,0\n");
  expect_refusal("--sweep bad.csv", "bad.csv:1 is not a rigid placement");
  write("bad.csv", "# nothing\n");
  expect_refusal("--sweep bad.csv", "the file contains no pose");
}

TEST_F(UltrasoundCommand, a_sweep_with_the_ct_is_pictures_of_one_size_with_the_plane_of_each) {
  const std::string turning = "--rotate 0,90 --frames 3 --needle ";
  const json alone = said(turning + "-o alone"), both = said(turning + "--ct -o both-%02d.png");
  ASSERT_EQ(both.at("files").size(), 3U);
  const ::bodkin::imaging::ImageRgb first = picture("both-00.png"), narrow = picture("alone/frame-0000.png");
  EXPECT_GT(first.width, narrow.width + 500) << "the CT is as wide as the ultrasound";
  for (int number = 0; number < 3; ++number) {
    const ::bodkin::imaging::ImageRgb image = picture("both-0" + std::to_string(number) + ".png");
    EXPECT_EQ(image.width, first.width);
    EXPECT_EQ(image.height, first.height);
    // The left side is the image without the CT.
    const ::bodkin::imaging::ImageRgb left = picture("alone/frame-000" + std::to_string(number) + ".png");
    std::ptrdiff_t differing = 0;
    for (int row = 0; row < left.height; ++row) {
      for (int column = 0; column < left.width; ++column) {
        differing += image.at(column, row) == left.at(column, row) ? 0 : 1;
      }
    }
    EXPECT_EQ(differing, 0) << number;
    // The right side is that of a single image of the same pose, whose legend names fewer tissues.
    if (number > 0) continue;
    said("--needle --ct -o single.png");
    const ::bodkin::imaging::ImageRgb single = picture("single.png");
    ASSERT_EQ(single.width, image.width);
    differing = 0;
    for (int row = 90; row < 500; ++row) {
      for (int column = narrow.width + 40; column < image.width - 40; ++column) {
        differing += image.at(column, row) == single.at(column, row) ? 0 : 1;
      }
    }
    EXPECT_EQ(differing, 0);
  }
  const ::bodkin::imaging::ImageRgb last = picture("both-02.png");
  std::ptrdiff_t moved = 0;
  for (int column = narrow.width + 40; column < first.width - 40; ++column)
    moved += first.at(column, 300) == last.at(column, 300) ? 0 : 1;
  EXPECT_GT(moved, 100) << "the plane turns, and the CT with it";
}

TEST_F(UltrasoundCommand, a_video_needs_ffmpeg_and_says_so) {
  const Outcome without =
      run_bodkin(folder_, "--version > /dev/null; PATH=/nowhere '" BODKIN_BUILD "/bin/bodkin' -q ultrasound " +
                              patient() + scan_roughly + " --tilt=-9,9 --frames 3 -o sweep.mp4");
  EXPECT_EQ(without.exit_code, 1);
  EXPECT_EQ(lines_of(without.errors), 1) << without.errors;
  EXPECT_THAT(without.errors, HasSubstr("apt-get install ffmpeg"));
  if (std::system("command -v ffmpeg > /dev/null") != 0) GTEST_SKIP() << "ffmpeg is not installed";
  for (const std::string ending : {".mp4", ".webm", ".avi", ".gif"}) {
    said("--tilt=-9,9 --frames 3 -o sweep" + ending);
    EXPECT_GT(std::filesystem::file_size(folder_ / ("sweep" + ending)), 1000U) << ending;
    EXPECT_FALSE(std::filesystem::exists(folder_ / (".part-sweep" + ending)));
  }
  said("--tilt=-9,9 --frames 3 --ct -o with-ct.mp4");
  EXPECT_GT(std::filesystem::file_size(folder_ / "with-ct.mp4"), std::filesystem::file_size(folder_ / "sweep.mp4"));
}

TEST_F(UltrasoundCommand, what_cannot_be_is_one_sentence) {
  expect_refusal("--probe Z99-1", "Z99-1");
  expect_refusal("--probes nothing.xml", "nothing.xml");
  expect_refusal("--view upside_down", "--view is 'upside_down'; expected paramedian, ");
  expect_refusal("--at elbow", "--at is 'elbow', which is not a landmark or structure");
  expect_refusal("--at 900,900,900", "not in the body");
  expect_refusal("--from above", "--from is 'above'; expected back, ");
  expect_refusal("--pose 1,2,3", "--pose is '1,2,3'; expected 12 or 16 numbers");
  expect_refusal("--pose 2,0,0,0,0,1,0,0,0,0,1,0", "not a rigid placement");
  expect_refusal("--pose=-1,0,0,0,0,1,0,0,0,0,1,0", "not a rigid placement");
  expect_refusal("--pose 1,0,0,0,0,1,0,0,0,0,1,0 --view sagittal", "leave out");
  expect_refusal("--face 0,90,0", "--look");
  expect_refusal("--look 0,-1,0", "--face");
  expect_refusal("--face 0,90,0 --look 0,-1,0 --marked 0,1,0", "parallel");
  expect_refusal("--face 0,90,0 --look 0,0,0", "zero");
  expect_refusal("--tgc 1,2,3", "--tgc is '1,2,3'; expected 8");
  expect_refusal("--tgc=0,0,0,0,0,0,0,99", "slider 8");
  expect_refusal("--size 8x8", "--size is '8x8'; expected WIDTHxHEIGHT");
  expect_refusal("--slices 4", "--slices is '4'; expected 1, 3, 5 or 7");
  expect_refusal("--mark above", "--mark is 'above'; expected left or right");
  expect_refusal("--frequency 25", "band");
  expect_refusal("--needle-depth 20", "--needle");
  expect_refusal("--plain --ct", "--plain");
  expect_refusal("--tilt 1,2 --ct",
                 "sweep.igs.mha is a sequence with the ultrasound alone; give -o NAME.mp4 or a folder");
  expect_refusal("--live --ct", "--live");
  expect_refusal("-o picture.jpg", "expected a picture, .png or .svg");
  expect_refusal("--plain -o picture.svg", "expected a picture, .png");
  expect_refusal("--frames 20", "--frames");
  expect_refusal("--on-skin --tilt 1,2", "--sweep-to");
  expect_refusal("--tilt 5", "--tilt is '5'; expected 2 finite numbers");
  expect_refusal("--tilt 1,2 -o sweep.png", "frame-%04d.png");
  expect_refusal("--tilt 1,2 -o sweep.mov", "a sweep becomes");
  expect_refusal("--sweep a.csv --tilt 1,2", "leave out");
  expect_refusal("--sweep a.csv", "a.csv");
  expect_refusal("--live --plain", "--live");
  expect_refusal("--deformed", "add --needle");
  expect_refusal("--needle --deformed --press 2", "leave out --press");
  expect_refusal("--needle --deformed --tilt 1,2", "--deformed is for a single picture");
  expect_refusal("--needle --deformed", "make one with: bodkin case mesh");
}

}  // namespace
}  // namespace bodkin_test
