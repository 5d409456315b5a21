#include "scene/raster.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin::scene {
namespace {

using Corners = std::array<std::int32_t, 3>;

double side(const ScreenPoint& a, const ScreenPoint& b, double x, double y) {
  return (static_cast<double>(b.x) - static_cast<double>(a.x)) * (y - static_cast<double>(a.y)) -
         (static_cast<double>(b.y) - static_cast<double>(a.y)) * (x - static_cast<double>(a.x));
}

TEST(Raster, a_pixel_belongs_to_a_triangle_when_its_centre_lies_inside) {
  Random random(7);
  Layer layer({0, 0, 61, 47});
  for (int round = 0; round < 300; ++round) {
    std::array<ScreenPoint, 3> points{};
    for (ScreenPoint& point : points) {
      point = {static_cast<float>(random.uniform() * 90.0 - 15.0),
               static_cast<float>(random.uniform() * 70.0 - 12.0),
               0.5F,
               10.0F,
               20.0F,
               30.0F};
    }
    layer.clear();
    const Corners corners = {0, 1, 2};
    draw_triangles(points, std::span(&corners, 1), false, layer);
    const double turn =
        side(points[0], points[1], static_cast<double>(points[2].x), static_cast<double>(points[2].y));
    for (int y = 0; y < 47; ++y) {
      for (int x = 0; x < 61; ++x) {
        double least = 1e9;
        for (std::size_t c = 0; c < 3; ++c) {
          least = std::min(least, (turn > 0.0 ? 1.0 : -1.0) * side(points[c], points[(c + 1) % 3], x + 0.5, y + 0.5));
        }
        if (std::abs(least) < 1e-2) continue;  // on an edge to within rounding
        EXPECT_EQ(layer.nearness(y)[x] > 0.0F, least > 0.0) << x << ' ' << y << " in round " << round;
        if (least > 0.0) {
          EXPECT_EQ(layer.colours(y)[x], 0x0A141Eu);
        }
      }
    }
  }
}

TEST(Raster, the_nearer_triangle_wins_in_any_order_and_depth_is_linear) {
  const std::vector<ScreenPoint> points = {{0, 0, 0.1F, 255, 0, 0},  {0, 40, 0.1F, 255, 0, 0},
                                           {40, 0, 0.5F, 255, 0, 0}, {0, 0, 0.3F, 0, 0, 255},
                                           {0, 40, 0.3F, 0, 0, 255}, {40, 0, 0.3F, 0, 0, 255}};
  for (const bool swapped : {false, true}) {
    std::vector<Corners> triangles = {{0, 1, 2}, {3, 4, 5}};
    if (swapped) std::swap(triangles[0], triangles[1]);
    Layer layer({0, 0, 40, 40});
    layer.clear();
    draw_triangles(points, triangles, false, layer);
    for (int x = 0; x < 39; ++x) {
      const double slanted = 0.1 + 0.4 * (x + 0.5) / 40.0;
      if (std::abs(slanted - 0.3) < 0.01) continue;
      EXPECT_EQ(layer.colours(0)[x], slanted > 0.3 ? 0xFF0000u : 0x0000FFu) << x;
      EXPECT_NEAR(static_cast<double>(layer.nearness(0)[x]), std::max(0.3, slanted), 1e-5);
    }
  }
}

TEST(Raster, triangles_that_share_an_edge_leave_no_gap) {
  // A fan about a point, whose edges meet at all angles.
  std::vector<ScreenPoint> points = {{50.3F, 49.7F, 0.5F, 9, 9, 9}};
  std::vector<Corners> triangles;
  constexpr int spokes = 37;
  for (int i = 0; i < spokes; ++i) {
    const double turn = 6.283185307 * i / spokes;
    points.push_back({static_cast<float>(50.3 + 45.0 * std::cos(turn)),
                      static_cast<float>(49.7 + 45.0 * std::sin(turn)), 0.5F, 9, 9, 9});
    triangles.push_back({0, 1 + i, 1 + (i + 1) % spokes});
  }
  Layer layer({0, 0, 100, 100});
  layer.clear();
  draw_triangles(points, triangles, false, layer);
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      if (std::hypot(x + 0.5 - 50.3, y + 0.5 - 49.7) < 44.0) {
        EXPECT_GT(layer.nearness(y)[x], 0.0F) << x << ' ' << y;
      }
    }
  }
}

TEST(Raster, backs_are_left_out_on_request_and_a_part_of_the_picture_is_drawn_as_in_the_whole) {
  const std::vector<ScreenPoint> points = {
      {10, 10, 0.5F, 200, 100, 50}, {12, 90, 0.4F, 0, 0, 0}, {95, 15, 0.3F, 9, 99, 9}};
  const std::vector<Corners> front = {{0, 1, 2}}, back = {{0, 2, 1}};
  Layer whole({0, 0, 100, 100}), none({0, 0, 100, 100}), part({23, 17, 60, 41});
  for (Layer* layer : {&whole, &none, &part}) layer->clear();
  draw_triangles(points, front, true, whole);
  draw_triangles(points, back, true, none);
  draw_triangles(points, front, true, part);
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      EXPECT_EQ(none.nearness(y)[x], 0.0F);
      if (x < 23 || x >= 60 || y < 17 || y >= 41) continue;
      EXPECT_NEAR(part.nearness(y)[x], whole.nearness(y)[x], 1e-5F);
    }
  }
  EXPECT_GT(whole.nearness(20)[20], 0.0F);
  EXPECT_EQ(whole.nearness_at(-1, 0), 0.0F);
  EXPECT_EQ(whole.nearness_at(0, 100), 0.0F);
}

TEST(Raster, points_that_are_not_numbers_or_far_outside_draw_nothing) {
  Layer layer({0, 0, 20, 20});
  layer.clear();
  const float nan = std::nanf("");
  const std::vector<ScreenPoint> points = {{nan, 1, 0.5F, 9, 9, 9},   {1, 15, 0.5F, 9, 9, 9},
                                           {15, 1, 0.5F, 9, 9, 9},    {1, 1, 0.0F, 9, 9, 9},
                                           {1e30F, 1, 0.5F, 9, 9, 9}, {1, -1e30F, 0.5F, 9, 9, 9}};
  draw_triangles(points, std::vector<Corners>{{0, 1, 2}, {3, 1, 2}, {4, 1, 2}, {5, 1, 2}}, false, layer);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) EXPECT_EQ(layer.nearness(y)[x], 0.0F);
  }
}

TEST(PixelBox, boxes_meet_join_and_scale) {
  const PixelBox a{0, 0, 10, 10}, b{5, -3, 12, 4};
  EXPECT_EQ(a.meet(b).width(), 5);
  EXPECT_EQ(a.meet(b).height(), 4);
  EXPECT_EQ(a.join(b).top, -3);
  EXPECT_EQ(PixelBox{}.join(b).left, 5);
  EXPECT_EQ((PixelBox{3, -3, 5, 7}).over(2).left, 1);
  EXPECT_EQ((PixelBox{3, -3, 5, 7}).over(2).top, -2);
  EXPECT_EQ((PixelBox{3, -3, 5, 7}).over(2).right, 3);
  EXPECT_EQ((PixelBox{3, -3, 5, 7}).over(2).bottom, 4);
}

}  // namespace
}  // namespace bodkin::scene
