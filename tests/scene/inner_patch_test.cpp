#include "scene/inner_patch.h"

#include "scene/view_software.h"
#include "tests/scene/test_bodies.h"
#include <gtest/gtest.h>

namespace bodkin::scene {
namespace {

const Vec3 straight_in = -Vec3::UnitY();
const Vec3 ball_top = ball_middle - ball_radius * straight_in;
constexpr double sheet_depth = 20.0;  // mm below the skin

// The ball with a sheet of ligament across it, 80 mm wide, of squares of 4 mm in two sections, left and right.
std::shared_ptr<const PatientSurfaces> ball_with_sheet() {
  PatientSurfaces surfaces;
  surfaces.parts.push_back(ball_surfaces().parts.front());
  PatientSurface sheet;
  sheet.kind = SurfaceKind::tissue;
  sheet.name = "ligamentum_flavum";
  sheet.colour = 0xE0C060;
  constexpr int across = 21;
  const Vec3 middle = ball_top + sheet_depth * straight_in;
  for (int j = 0; j < across; ++j) {
    for (int i = 0; i < across; ++i) {
      sheet.mesh.points.push_back((middle + Vec3(4.0 * (i - 10), 0.0, 4.0 * (j - 10))).cast<float>());
      sheet.mesh.normals.push_back(Eigen::Vector3f::UnitY());
      sheet.mesh.openness.push_back(1.0F);
    }
  }
  for (const bool left : {true, false}) {
    const std::size_t first = sheet.mesh.triangles.size();
    for (int j = 0; j + 1 < across; ++j) {
      for (int i = left ? 0 : 10; i < (left ? 10 : 20); ++i) {
        const int a = j * across + i, b = a + 1, c = a + across, d = c + 1;
        sheet.mesh.triangles.push_back({a, c, b});
        sheet.mesh.triangles.push_back({b, c, d});
      }
    }
    sheet.sections.push_back({left ? "left" : "right", first, sheet.mesh.triangles.size() - first});
  }
  surfaces.parts.push_back(std::move(sheet));
  return std::make_shared<const PatientSurfaces>(std::move(surfaces));
}

TEST(InnerPatch, takes_the_triangles_near_the_needle_and_leaves_the_others) {
  const auto surfaces = ball_with_sheet();
  const InnerPatch patch(*surfaces, ball_top, straight_in);
  ASSERT_EQ(patch.parts().size(), 1U) << "not the skin";
  const InnerPatch::Part& part = patch.parts().front();
  EXPECT_EQ(patch.part_of(1), &part);
  EXPECT_EQ(patch.part_of(0), nullptr);
  EXPECT_EQ(part.mesh.triangles.size() + part.still_triangles.size(), surfaces->parts[1].mesh.triangles.size());
  ASSERT_EQ(part.sections.size(), 2U);
  for (std::size_t s = 0; s < 2; ++s)
    EXPECT_EQ(part.sections[s].count + part.around[s].count, surfaces->parts[1].sections[s].count);
  for (const auto& corners : part.still_triangles) {
    for (const std::int32_t corner : corners) {
      const Vec3 from = surfaces->parts[1].mesh.points[static_cast<std::size_t>(corner)].cast<double>() - ball_top;
      EXPECT_GE(Vec3(from - from.dot(straight_in) * straight_in).norm(), InnerPatch::radius);
    }
  }
}

TEST(InnerPatch, follows_the_body_near_the_needle_and_joins_what_stands_still) {
  InnerPatch patch(*ball_with_sheet(), ball_top, straight_in);
  std::vector<float> displacements;
  for (std::size_t i = 0; i < patch.rest().size(); ++i)
    displacements.insert(displacements.end(), {0.5F, -3.0F, 1.0F});
  patch.deform(displacements);
  const InnerPatch::Part& part = patch.parts().front();
  int whole = 0, none = 0;
  for (std::size_t i = 0; i < patch.rest().size(); ++i) {
    const Vec3 moved = part.mesh.points[i].cast<double>() - patch.rest()[i], from = patch.rest()[i] - ball_top;
    const double beside = Vec3(from - from.dot(straight_in) * straight_in).norm();
    if (beside < 15.0) {
      EXPECT_LT((moved - Vec3(0.5, -3.0, 1.0)).norm(), 1e-4);
      ++whole;
    } else if (beside >= InnerPatch::radius) {
      EXPECT_LT(moved.norm(), 1e-4) << "where it meets triangles that stand still";
      ++none;
    }
    EXPECT_NEAR(part.mesh.normals[i].norm(), 1.0F, 1e-4F);
  }
  EXPECT_GT(whole, 20);
  EXPECT_GT(none, 10);
  patch.deform({});
  for (std::size_t i = 0; i < patch.rest().size(); ++i) {
    EXPECT_LT((part.mesh.points[i].cast<double>() - patch.rest()[i]).norm(), 1e-5);
    EXPECT_LT((part.mesh.normals[i] - Eigen::Vector3f::UnitY()).norm(), 1e-5F);
  }
}

TEST(SoftwareView, a_surface_inside_is_seen_where_the_body_has_moved_it) {
  const auto surfaces = ball_with_sheet();
  ViewSubject subject;
  subject.middle = ball_top;
  subject.height = 60.0;
  const auto view_of = [&] {
    SoftwareView view(surfaces);
    view.set_size(200, 160);
    view.set_preset(Preset::bones);
    view.set_camera(standard_view(StandardView::posterior, subject));
    view.set_entry(ball_top, straight_in);
    return view;
  };
  SoftwareView kept = view_of();
  kept.draw();
  const Picture at_rest = kept.picture();
  for (const double pushed : {2.0, 6.0, 0.0}) {
    std::vector<float> displacements(3 * kept.deformable_points().size(), 0.0F);
    for (std::size_t i = kept.patch().rest().size(); i < kept.deformable_points().size(); ++i)
      displacements[3 * i + 1] = static_cast<float>(-pushed);
    kept.set_dent({}, displacements);
    kept.draw();
    const Vec3 middle = ball_top + (sheet_depth + pushed) * straight_in;
    const Place place = kept.projection().place(middle).value();
    const Vec3 seen = kept.projection().point(
        {place.x, place.y,
         static_cast<double>(kept.layers().nearness_at(static_cast<int>(place.x), static_cast<int>(place.y)))});
    EXPECT_NEAR((seen - ball_top).dot(straight_in), sheet_depth + pushed, 0.1);
    SoftwareView fresh = view_of();
    fresh.set_dent({}, displacements);
    fresh.draw();
    EXPECT_EQ(kept.picture().pixels, fresh.picture().pixels) << pushed;
  }
  EXPECT_EQ(kept.picture().pixels, at_rest.pixels);
}

}  // namespace
}  // namespace bodkin::scene
