#include "imaging/slice_picture.h"

#include <cmath>
#include <functional>

#include "patient/synthetic/lumbar.h"
#include <gtest/gtest.h>

#include "imaging/png_file.h"
#include "imaging/svg.h"
#include "imaging/tool.h"
#include "io/tissue_library_file.h"

namespace bodkin {
namespace {

void expect_well_formed(const std::string& svg) {
  const ToolResult result = run_tool({"xmllint", "--huge", "--noout", "-"}, svg, "libxml2-utils");
  EXPECT_EQ(result.exit_code, 0) << result.errors.substr(0, 500);
}

// The middle of the pixels that a test picks.
Eigen::Vector2d centroid(const ImageRgb& image, const std::function<bool(const Rgb&)>& chosen) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double count = 0.0;
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      if (!chosen(image.at(column, row))) continue;
      sum += Eigen::Vector2d(column, row);
      ++count;
    }
  }
  return sum / count;
}

SlicePanel empty_panel(double millimetres) {
  SlicePanel panel;
  panel.slice.plane = view_plane(View::axial, Vec3::Zero(), millimetres, millimetres, 0.5);
  const std::size_t count =
      static_cast<std::size_t>(panel.slice.plane.width) * static_cast<std::size_t>(panel.slice.plane.height);
  panel.slice.hounsfield.assign(count, -1000.0F);
  panel.slice.tissues.assign(count, tissue::air);
  return panel;
}

TEST(SlicePicture, the_path_is_drawn_where_it_lies) {
  SlicePanel panel = empty_panel(100.0);
  panel.path = NeedlePath{Vec3(20, 30, 0), Vec3(-15, -25, 0)};
  const std::string svg = slice_picture({panel}, default_tissue_library(), "", 400.0);  // 4 px a mm
  expect_well_formed(svg);
  EXPECT_NE(svg.find("<circle cx=\"280.00\" cy=\"320.00\""), std::string::npos);  // (50 + 20) * 4, (50 + 30) * 4
  const ImageRgb image = decode_png(svg_to_png(svg, 1.0), "picture");
  // The target's cross is the only red in the picture: its middle relative to the frame's corner at (14, 28).
  const Eigen::Vector2d target =
      centroid(image, [](const Rgb& p) { return p.red > 200 && p.green < 110 && p.blue < 150 && p.blue > 80; });
  EXPECT_NEAR(target.x(), 14 + (50 - 15) * 4 - 0.5, 1.0);
  EXPECT_NEAR(target.y(), 28 + (50 - 25) * 4 - 0.5, 1.0);
  // A point of the path between two ticks is yellow.
  const Vec3 between = panel.path->entry + 0.5 * (Vec3(-35, -55, 0).normalized() * 70.0 + Vec3::Zero());
  const Rgb pixel = image.at(static_cast<int>(std::lround(14 + (50 + between.x()) * 4)),
                             static_cast<int>(std::lround(28 + (50 + between.y()) * 4)));
  EXPECT_GT(pixel.red, 180);
  EXPECT_GT(pixel.green, 150);
  EXPECT_LT(pixel.blue, 130);
}

TEST(SlicePicture, parts_of_a_path_away_from_the_slice_are_dashed) {
  SlicePanel panel = empty_panel(100.0);
  panel.path = NeedlePath{Vec3(0, 40, 0), Vec3(0, -40, 1.5)};
  EXPECT_EQ(slice_picture({panel}, default_tissue_library(), "", 300.0).find("dasharray"), std::string::npos);
  panel.path = NeedlePath{Vec3(0, 40, 0), Vec3(0, -40, 8)};
  const std::string svg = slice_picture({panel}, default_tissue_library(), "", 300.0);
  // The line leaves the 2 mm around the slice after a quarter of its way: one solid piece, one dashed.
  EXPECT_NE(svg.find("dasharray"), std::string::npos);
  EXPECT_NE(svg.find("L150.00 210.00\" stroke=\"#ffd84d\""), std::string::npos);
}

TEST(SlicePicture, names_from_files_cannot_break_the_picture) {
  SlicePanel panel = empty_panel(40.0);
  panel.title = "<script>alert('x')</script> & \"quotes\" \x01";
  const std::string svg = slice_picture({panel}, default_tissue_library(), "a < b & c", 200.0);
  expect_well_formed(svg);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
}

TEST(SlicePicture, the_bar_is_as_long_as_it_says) {
  const std::string svg = slice_picture({empty_panel(100.0)}, default_tissue_library(), "", 400.0);
  EXPECT_NE(svg.find(">20 mm</text>"), std::string::npos);
  EXPECT_NE(svg.find("h80.00M"), std::string::npos);  // 20 mm at 4 px a mm
}

TEST(SlicePicture, a_synthetic_patient_shows_its_three_slices_path_and_tissues) {
  LumbarParameters parameters;
  parameters.spacing = 2.0;
  const TissueLibrary library = default_tissue_library();
  const SyntheticPatient made = synthesize_lumbar(parameters, library);
  Case patient;
  patient.library = library;
  patient.ct = made.ct;
  patient.tissues = made.tissues;
  patient.description.name = "synthetic";
  patient.description.procedure.path = made.path;
  const std::string svg = case_picture(patient);
  expect_well_formed(svg);
  for (const char* text :
       {"sagittal", "axial", "coronal", "planned path", "cortical bone", "ligamentum flavum", "skin"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  }
  const ImageRgb image = decode_png(svg_to_png(svg, 0.5), "picture");
  EXPECT_GT(image.width, 400);
}

TEST(Svg, base64_agrees_with_the_examples_of_rfc_4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Tool, input_and_arguments_reach_the_program_as_they_are) {
  const std::string large(3'000'000, 'x');
  EXPECT_EQ(run_tool({"cat"}, large, "coreutils").output, large);
  EXPECT_EQ(run_tool({"printf", "%s", "$(id) `id` ; 'a b'"}, "", "coreutils").output, "$(id) `id` ; 'a b'");
  EXPECT_EQ(run_tool({"sh", "-c", "echo oh >&2; exit 3"}, "", "dash").exit_code, 3);
  EXPECT_EQ(run_tool({"sh", "-c", "echo oh >&2; exit 3"}, "", "dash").errors, "oh\n");
}

TEST(Tool, a_missing_program_is_a_system_error_that_names_the_package) {
  try {
    run_tool({"no-such-program-of-bodkin"}, "", "the-package");
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("apt-get install the-package"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace bodkin
