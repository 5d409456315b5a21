#include "imaging/slice_picture.h"

#include <cmath>
#include <functional>

#include "patient/synthetic/lumbar.h"
#include <gtest/gtest.h>

#include "imaging/markup.h"
#include "imaging/png_file.h"
#include "io/run_program.h"
#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
using namespace bodkin::io;
using namespace bodkin::patient;
namespace {

void expect_well_formed(const std::string& svg) {
  const ProgramResult result = run_program({"xmllint", "--huge", "--noout", "-"}, svg, "libxml2-utils");
  EXPECT_EQ(result.exit_code, 0) << result.errors.substr(0, 500);
}

// The middle of the pixels selected by a predicate.
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
  const Canvas picture = slice_picture({panel}, default_tissue_library(), "", 400.0);  // 4 px a mm
  expect_well_formed(picture.svg());
  const ImageRgb image = picture.pixels(1.0);
  EXPECT_EQ(image.at(14 + (50 + 20) * 4, 28 + (50 + 30) * 4), rgb(0xFFD84D)) << "the entry's dot";
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
  // Pixels along the path, 3 px a mm, whose yellow is interrupted by the dark line below it.
  const auto gaps = [&panel](double from, double to) {  // mm of y
    const ImageRgb image = slice_picture({panel}, default_tissue_library(), "", 300.0).pixels(1.0);
    int count = 0;
    for (int row = 28 + static_cast<int>(3.0 * (50.0 + from)); row < 28 + static_cast<int>(3.0 * (50.0 + to)); ++row)
      count += image.at(14 + 150, row).red < 128 ? 1 : 0;
    return count;
  };
  EXPECT_EQ(gaps(-32.0, 38.0), 0);
  panel.path = NeedlePath{Vec3(0, 40, 0), Vec3(0, -40, 8)};
  // The line leaves the 2 mm around the slice after a quarter of its way, at y = 20.
  EXPECT_EQ(gaps(22.0, 38.0), 0);
  EXPECT_GT(gaps(-32.0, 18.0), 30);
}

TEST(SlicePicture, names_from_files_cannot_break_the_picture) {
  SlicePanel panel = empty_panel(40.0);
  panel.title = "<script>alert('x')</script> & \"quotes\" \x01";
  const std::string svg = slice_picture({panel}, default_tissue_library(), "a < b & c", 200.0).svg();
  expect_well_formed(svg);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
}

TEST(SlicePicture, the_bar_is_as_long_as_it_says) {
  const Canvas picture = slice_picture({empty_panel(100.0)}, default_tissue_library(), "", 400.0);
  EXPECT_NE(picture.svg().find(">20 mm</text>"), std::string::npos);
  // White along its row, 20 mm at 4 px a mm, and half its own thickness at the ends.
  const ImageRgb image = picture.pixels(1.0);
  int white = 0;
  for (int column = 14; column < 200; ++column) white += image.at(column, 28 + 400 - 11).red > 200 ? 1 : 0;
  EXPECT_NEAR(white, 80, 2);
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
  const Canvas picture = case_picture(patient);
  const std::string svg = picture.svg();
  expect_well_formed(svg);
  for (const char* text :
       {"sagittal", "axial", "coronal", "planned path", "cortical bone", "ligamentum flavum", "skin"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(svg, case_picture(patient).svg()) << "the same picture has the same bytes";
  EXPECT_GT(picture.pixels(0.5).width, 400);
}

TEST(SlicePicture, levels_of_the_spine_and_the_end_of_the_cord_are_lettered) {
  SlicePanel panel = empty_panel(100.0);
  const SlicePlane& plane = panel.slice.plane;
  const Vec3 conus = plane.point(0.5 * plane.width, 0.25 * plane.height);
  const Vec3 interspace = plane.point(0.5 * plane.width, 0.75 * plane.height);
  panel.levels = {{conus, "conus", true},
                  {interspace, "L3/L4", false},
                  {interspace + 30.0 * plane.normal(), "far off", false},
                  {plane.point(-20.0, 0.0), "outside", false}};
  const Canvas picture = slice_picture({panel}, default_tissue_library(), "", 400.0);
  const std::string svg = picture.svg();
  EXPECT_NE(svg.find(">conus</text>"), std::string::npos);
  EXPECT_NE(svg.find(">L3/L4</text>"), std::string::npos);
  EXPECT_NE(svg.find("conus, where the spinal cord ends"), std::string::npos);
  EXPECT_EQ(svg.find("far off"), std::string::npos);
  EXPECT_EQ(svg.find("outside"), std::string::npos);
  // The line lies at the height of the conus: 100 px below the top of the slice, which begins at 28 px.
  const ImageRgb image = picture.pixels(1.0);
  EXPECT_GT(image.at(14 + 200, 28 + 100).red, 200);
  EXPECT_LT(image.at(14 + 200, 28 + 92).red, 100);
}

TEST(SlicePicture, the_name_of_the_planned_level_stands_clear_of_the_paths_depths) {
  SlicePanel panel = empty_panel(100.0);
  const SlicePlane& plane = panel.slice.plane;
  const Vec3 target = plane.point(0.1 * plane.width, 0.5 * plane.height);  // no room for a name on its left
  panel.levels = {{target, "L3/L4", false}};
  const auto height_of_name = [&panel] {
    const std::string svg = slice_picture({panel}, default_tissue_library(), "", 400.0).svg();
    const std::size_t end = svg.find(">L3/L4</text>"), from = svg.rfind(" y=\"", end);
    return std::stod(svg.substr(from + 4));
  };
  const double without = height_of_name();
  panel.path = NeedlePath{plane.point(0.9 * plane.width, 0.5 * plane.height), target};
  EXPECT_LT(height_of_name(), without - 20.0);
  panel.path->target = plane.point(0.5 * plane.width, 0.1 * plane.height);
  EXPECT_EQ(height_of_name(), without);
}

TEST(SlicePicture, of_a_case_shows_its_landmarks_as_levels) {
  LumbarParameters parameters;
  parameters.spacing = 3.0;
  const SyntheticPatient made = synthesize_lumbar(parameters, default_tissue_library());
  Case patient;
  patient.library = default_tissue_library();
  patient.ct = made.ct;
  patient.tissues = made.tissues;
  patient.description.landmarks = made.landmarks;
  patient.description.landmarks.push_back({"interspace_1", made.landmarks.front().position});
  const std::string svg = case_picture(patient).svg();
  for (const char* name : {">conus</text>", ">L1/L2</text>", ">L4/L5</text>", ">interspace 1</text>"})
    EXPECT_NE(svg.find(name), std::string::npos) << name;
  EXPECT_EQ(svg.find("skin</text>"), svg.rfind("skin</text>")) << "only the tissue's name in the legend";
}

}  // namespace
}  // namespace bodkin
