#include "scene/view_software.h"

#include <cmath>
#include <memory>

#include "scene/camera_moves.h"
#include "tests/scene/test_bodies.h"
#include <gtest/gtest.h>

namespace bodkin::scene {
namespace {

const anatomy::NeedlePath ball_path{ball_middle + Vec3(0.0, ball_radius, 0.0), ball_middle + Vec3(0.0, 16.0, 0.0)};

SoftwareView view_of_ball(Preset preset = Preset::cut_away) {
  SoftwareView view(std::make_shared<PatientSurfaces>(ball_surfaces()));
  view.set_size(320, 240);
  ViewSubject subject;
  subject.middle = ball_middle;
  subject.height = 110.0;
  view.set_camera(standard_view(StandardView::operator_side, subject));
  view.set_opening({ball_path.entry, 20.0, 20.0});
  view.set_preset(preset);
  view.set_entry(ball_path.entry, ball_path.direction());
  return view;
}

std::vector<NeedleLook> needle_at(double depth) {
  NeedleLook needle;
  needle.pose = needle_pose(ball_path.entry + depth * ball_path.direction(), ball_path.direction());
  return {needle};
}

int different_pixels(const Picture& a, const Picture& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) count += a.pixels[i] == b.pixels[i] ? 0 : 1;
  return count;
}

TEST(SoftwareView, kept_layers_give_the_picture_of_a_full_drawing_to_the_pixel) {
  for (const Preset preset : presets) {
    SoftwareView kept = view_of_ball(preset);
    SceneMarks marks;
    marks.path = ball_path;
    marks.insert_here = 0.3;
    for (int step = 0; step < 12; ++step) {
      const double depth = 2.0 * step - 6.0;
      const SkinDent dent{ball_path.entry, ball_path.direction(), step < 3 ? 0.0 : (step < 8 ? depth : -1.5)};
      if (step == 6) marks.insert_here.reset();
      kept.set_needles(needle_at(depth));
      kept.set_marks(marks);
      kept.set_dent(dent);
      kept.draw();
      SoftwareView full = view_of_ball(preset);
      full.set_needles(needle_at(depth));
      full.set_marks(marks);
      full.set_dent(dent);
      full.draw();
      EXPECT_EQ(different_pixels(kept.picture(), full.picture()), 0) << name_of(preset) << ", step " << step;
    }
  }
}

TEST(SoftwareView, every_pixel_that_changes_is_within_the_box_that_draw_returns) {
  SoftwareView view = view_of_ball();
  view.draw();
  Picture before = view.picture();
  for (int step = 0; step < 10; ++step) {
    view.set_needles(needle_at(step));
    view.set_dent(SkinDent{ball_path.entry, ball_path.direction(), 0.5 * step});
    const PixelBox box = view.draw();
    for (int y = 0; y < 240; ++y) {
      for (int x = 0; x < 320; ++x) {
        if (view.picture().row(y)[x] == before.row(y)[x]) continue;
        EXPECT_TRUE(x >= box.left && x < box.right && y >= box.top && y < box.bottom) << x << ' ' << y;
      }
    }
    before = view.picture();
  }
  EXPECT_TRUE(view.draw().empty()) << "nothing has changed";
  view.set_needles(needle_at(9.0));
  view.set_marks({});
  view.set_dent(SkinDent{ball_path.entry, ball_path.direction(), 4.5});
  EXPECT_TRUE(view.draw().empty()) << "all is as it was";
}

TEST(SoftwareView, the_needle_is_drawn_on_the_projected_line_in_its_true_gauge) {
  SoftwareView view = view_of_ball();
  view.draw();
  const Picture without = view.picture();
  NeedleLook needle = needle_at(-5.0).front();
  needle.shape.outer_diameter = 2.4;
  view.set_needles({needle});
  view.draw();
  const Projection projection = view.projection();
  const Vec3 tip = needle.pose.translation(), axis = needle_axis(needle.pose);
  const Eigen::Vector2d from = projection.place(tip)->pixel();
  const Vec3 hub = tip - needle.shape.length * axis;
  const Eigen::Vector2d to = projection.place(hub)->pixel(), along = (to - from).normalized();
  const double end = projection.place(hub_end(needle))->pixel().x();
  int on_line = 0;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      if (view.picture().row(y)[x] == without.row(y)[x]) continue;
      const Eigen::Vector2d at = Eigen::Vector2d(x + 0.5, y + 0.5) - from;
      const double p = at.dot(along), q = std::abs(at.x() * along.y() - at.y() * along.x());
      EXPECT_GT(p, -1.0);
      if (p > (to - from).norm() - 1.0) continue;  // the hub is wider
      const double t = p / (to - from).norm();
      const double nearness = (1.0 - t) * projection.place(tip)->nearness + t * projection.place(hub)->nearness;
      EXPECT_LE(q, 1.2 * projection.focal_length() * nearness + 0.5 + 1e-6) << x << ' ' << y;
      ++on_line;
    }
  }
  // 2.4 mm wide along the visible part of its length.
  const double visible = std::min(320.0, std::max(end, to.x())) - from.x();
  EXPECT_GT(on_line, visible * 2.0 * projection.pixels_per_mm(tip));
}

TEST(SoftwareView, rings_stand_at_each_10_mm_and_the_fiftieth_is_orange) {
  SoftwareView view = view_of_ball();
  NeedleLook needle = needle_at(0.0).front();
  needle.shape.outer_diameter = 2.4;
  view.set_needles({needle});
  ViewSubject subject;
  subject.middle = needle.pose.translation() - 45.0 * needle_axis(needle.pose);
  subject.height = 80.0;
  view.set_camera(standard_view(StandardView::left, subject));
  view.draw();
  for (int mm = 5; mm < 70; mm += 5) {
    const Place place = view.projection().place(needle.pose.translation() - mm * needle_axis(needle.pose)).value();
    const int x = static_cast<int>(place.x), y = static_cast<int>(place.y);
    if (x < 0 || x >= 320) continue;
    const std::uint32_t colour = view.picture().row(y)[x];
    const std::uint32_t red = (colour >> 16U) & 0xFFU, blue = colour & 0xFFU;
    if (mm == 50) {
      EXPECT_GT(red, blue + 100u);
    } else if (mm % 10 == 0) {
      EXPECT_LT(red, 90u) << mm;
    } else {
      EXPECT_GT(red, 150u) << mm;
    }
  }
}

TEST(SoftwareView, the_dent_in_the_picture_is_as_deep_as_the_model_says) {
  SoftwareView view = view_of_ball(Preset::skin);
  ViewSubject subject;
  subject.middle = ball_path.entry;
  subject.height = 40.0;
  view.set_camera(standard_view(StandardView::posterior, subject));  // straight down the needle
  for (const double depth : {0.0, 2.0, 5.0, -3.0}) {
    view.set_dent(SkinDent{ball_path.entry, ball_path.direction(), depth});
    view.draw();
    const Vec3 bottom = ball_path.entry + depth * ball_path.direction();
    const Place place = view.projection().place(bottom).value();
    const float seen = view.layers().nearness_at(static_cast<int>(place.x), static_cast<int>(place.y));
    ASSERT_GT(seen, 0.0F);
    const Vec3 point = view.projection().point({place.x, place.y, static_cast<double>(seen)});
    // Within a tenth of the dent's slope over a pixel, and 0.6 mm of the drawn skin at rest.
    EXPECT_NEAR((point - ball_path.entry).dot(ball_path.direction()), depth, depth == 0.0 ? 0.6 : 0.25);
  }
}

TEST(SoftwareView, what_is_behind_bone_or_skin_is_hidden_as_the_preset_says) {
  // A needle on the far side of the ball from the viewer.
  NeedleLook behind;
  behind.pose = needle_pose(ball_middle + Vec3(0.0, -20.0, 0.0), Vec3::UnitX());
  ViewSubject subject;
  subject.middle = ball_middle;
  subject.height = 110.0;
  const auto changed = [&](Preset preset) {
    SoftwareView view = view_of_ball(preset);
    view.set_camera(standard_view(StandardView::posterior, subject));
    view.draw();
    const Picture without = view.picture();
    view.set_needles({behind});
    view.draw();
    const Place place = view.projection().place(ball_middle + Vec3(-4.0, -20.0, 0.0)).value();
    const std::size_t pixel = static_cast<std::size_t>(place.y) * 320 + static_cast<std::size_t>(place.x);
    const std::uint32_t a = without.pixels[pixel], b = view.picture().pixels[pixel];
    return std::abs(static_cast<int>((a >> 8U) & 0xFFU) - static_cast<int>((b >> 8U) & 0xFFU));
  };
  EXPECT_EQ(changed(Preset::skin), 0);
  EXPECT_GT(changed(Preset::bones), 5) << "shows through bone";
  EXPECT_LT(changed(Preset::bones), 100) << "faintly";
}

TEST(SoftwareView, a_pixel_of_the_skin_is_picked_where_it_is_seen) {
  SoftwareView view = view_of_ball(Preset::skin);
  view.draw();
  const Place entry = view.projection().place(ball_path.entry).value();
  const auto picked = view.skin_at(entry.x, entry.y);
  ASSERT_TRUE(picked);
  EXPECT_LT((picked->point - ball_path.entry).norm(), 0.8);
  EXPECT_GT(picked->normal.dot(Vec3::UnitY()), 0.98);
  EXPECT_FALSE(view.skin_at(1.0, 1.0));
}

TEST(SoftwareView, extreme_sizes_cameras_and_needles_do_no_harm) {
  SoftwareView view = view_of_ball();
  view.set_size(1, 1);
  view.draw();
  view.set_size(333, 1);
  view.draw();
  view.set_size(64, 48);
  Camera inside;
  inside.eye = ball_middle;
  inside.focus = ball_middle + Vec3(1.0, 0.0, 0.0);
  view.set_camera(inside);
  view.set_needles({NeedleLook{.pose = needle_pose(ball_middle, Vec3::UnitX())}});
  SceneMarks marks;
  marks.path = anatomy::NeedlePath{ball_middle, ball_middle};
  marks.insert_here = 1.0;
  view.set_marks(marks);
  view.set_dent(SkinDent{ball_path.entry, ball_path.direction(), 30.0});
  for (int detail = 1; detail <= 3; ++detail) {
    view.set_detail(detail);
    view.draw();
  }
  EXPECT_EQ(view.picture().pixels.size(), 64u * 48u);
}

}  // namespace
}  // namespace bodkin::scene
