#include "imaging/canvas.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/error.h"
#include "io/run_program.h"

namespace bodkin {

using namespace bodkin::imaging;
using namespace bodkin::io;
namespace {

using Place = Eigen::Vector2d;

// Every kind of shape once.
Canvas all_shapes() {
  Canvas canvas(100.0, 80.0);
  canvas.fill_all(0xFFFFFF);
  canvas.fill(Path::rectangle(10.0, 10.0, 20.0, 10.0), {0x0000FF, 0.5});
  canvas.stroke(Path::circle({70.0, 20.0}, 10.0), {0x00FF00, 4.0});
  canvas.stroke(Path::segment({0.0, 40.0}, {100.0, 40.0}), {0xFF0000, 2.0, {10.0, 10.0}});
  canvas.text({50.0, 60.0}, "a < b & c", {.size = 10.0, .anchor = TextAnchor::middle, .bold = true, .angle = 10.0});
  ImageRgb image(2, 1);
  image.at(1, 0) = {255, 255, 255};
  canvas.image(image, 80.0, 60.0, 20.0, 10.0);
  Canvas inner(10.0, 10.0);
  inner.fill(Path::rectangle(-50.0, -50.0, 100.0, 100.0), 0xFF00FF);
  canvas.place(std::move(inner), 0.0, 70.0);
  return canvas;
}

TEST(Canvas, shapes_are_where_they_were_put) {
  for (const int zoom : {1, 3}) {
    const ImageRgb image = all_shapes().pixels(zoom);
    ASSERT_EQ(image.width, 100 * zoom);
    ASSERT_EQ(image.height, 80 * zoom);
    const auto at = [&](int x, int y) { return image.at(x * zoom, y * zoom); };
    EXPECT_NEAR(at(20, 15).red, 127, 1);  // half covered by blue
    EXPECT_EQ(at(20, 15).blue, 255);
    EXPECT_EQ(at(20, 25), rgb(0xFFFFFF));
    EXPECT_EQ(at(70, 20), rgb(0xFFFFFF)) << "a circle that is stroked is empty";
    EXPECT_EQ(at(79, 20), rgb(0x00FF00));
    EXPECT_EQ(at(5, 40), rgb(0xFF0000));
    EXPECT_EQ(at(15, 40), rgb(0xFFFFFF)) << "a gap between dashes";
    EXPECT_EQ(at(25, 40), rgb(0xFF0000));
    EXPECT_LT(at(82, 65).red, 40) << "the left pixel of the image";
    EXPECT_GT(at(98, 65).red, 215) << "and the right one";
    EXPECT_EQ(at(5, 75), rgb(0xFF00FF));
    EXPECT_EQ(at(15, 75), rgb(0xFFFFFF)) << "the inner canvas is cut off where it ends";
  }
}

TEST(Canvas, text_stands_where_its_anchor_says_and_is_as_wide_as_measured) {
  const double width = text_width("millimetres", 20.0);
  EXPECT_NEAR(text_width("millimetres", 40.0), 2.0 * width, 0.05);
  EXPECT_GT(text_width("millimetres", 20.0, true), width);
  for (const auto& [anchor, share] :
       {std::pair{TextAnchor::start, 0.0}, std::pair{TextAnchor::middle, 0.5}, std::pair{TextAnchor::end, 1.0}}) {
    Canvas canvas(400.0, 60.0);
    canvas.text({200.0, 40.0}, "millimetres", {.size = 20.0, .ink = 0xFFFFFF, .anchor = anchor});
    const ImageRgb image = canvas.pixels(1.0);
    int first = image.width, last = 0, lowest = 0;
    for (int row = 0; row < image.height; ++row) {
      for (int column = 0; column < image.width; ++column) {
        if (image.at(column, row).red < 100) continue;
        first = std::min(first, column);
        last = std::max(last, column);
        lowest = std::max(lowest, row);
      }
    }
    EXPECT_NEAR(first, 200.0 - share * width, 3.0);
    EXPECT_NEAR(last, 200.0 + (1.0 - share) * width, 3.0);
    EXPECT_NEAR(lowest, 39, 1) << "letters without descenders stand on the base line";
  }
}

TEST(Canvas, its_svg_is_well_formed_always_the_same_and_keeps_text_as_text) {
  const std::string svg = all_shapes().svg();
  EXPECT_EQ(svg, all_shapes().svg());
  const ProgramResult checked = run_program({"xmllint", "--noout", "-"}, svg, "libxml2-utils");
  EXPECT_EQ(checked.exit_code, 0) << checked.errors;
  EXPECT_NE(svg.find(">a &lt; b &amp; c</text>"), std::string::npos);
  EXPECT_EQ(all_shapes().png(2.0), all_shapes().png(2.0));
}

TEST(Canvas, what_is_drawn_over_an_image_leaves_the_rest_of_it) {
  ImageRgb image(20, 10);
  for (Rgb& pixel : image.pixels) pixel = {1, 2, 3};
  Canvas canvas(20.0, 10.0);
  canvas.fill(Path::rectangle(5.0, 5.0, 5.0, 5.0), 0xFFFFFF);
  canvas.draw_over(image);
  EXPECT_EQ(image.at(4, 5), (Rgb{1, 2, 3}));
  EXPECT_EQ(image.at(5, 5), (Rgb{255, 255, 255}));
}

TEST(Canvas, broken_numbers_and_bytes_harm_nothing_else) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Canvas canvas(20.0, 10.0);
  canvas.stroke(Path::segment({nan, 0.0}, {5.0, 5.0}), {0xFFFFFF});
  canvas.fill(Path::circle({5.0, 5.0}, nan), 0xFFFFFF);
  canvas.text({nan, nan}, "nowhere", {});
  canvas.text({1.0, 1.0}, "\xff\xc3", {});
  canvas.image({}, 0.0, 0.0, 1.0, 1.0);
  canvas.place(Canvas(5.0, 5.0), nan, 0.0);
  canvas.stroke(Path::segment({0.0, 8.5}, {20.0, 8.5}), {0xFFFFFF});
  EXPECT_EQ(canvas.svg().find("nan"), std::string::npos);
  EXPECT_EQ(canvas.pixels(1.0).at(10, 8), rgb(0xFFFFFF));
}

TEST(Canvas, a_picture_too_large_for_pixels_is_refused) {
  EXPECT_THROW(Canvas(40000.0, 10.0).pixels(1.0), SystemError);
}

}  // namespace
}  // namespace bodkin
