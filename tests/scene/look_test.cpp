// The user's changes to the patient's looks: visibility, opacity and colour of parts; and looks in a case.
#include "scene/look.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>

#include "scene/camera_moves.h"
#include "scene/look_file.h"
#include "scene/sections.h"
#include "scene/view_software.h"
#include "tests/scene/test_bodies.h"
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin::scene {
namespace {

namespace fs = std::filesystem;

// The ball of bone, its half of lower x labelled 1 and the other one 2.
PatientSurfaces halved_ball() {
  PatientSurfaces surfaces = ball_surfaces();
  const anatomy::TissueVolume tissues = ball_of_tissues();
  anatomy::LabelVolume labels(tissues.grid);
  for (int k = 0; k < tissues.grid.size[2]; ++k) {
    for (int j = 0; j < tissues.grid.size[1]; ++j) {
      for (int i = 0; i < tissues.grid.size[0]; ++i) {
        const Vec3 point = tissues.grid.to_patient(Vec3(i, j, k));
        if ((point - ball_middle).norm() >= bone_radius) continue;
        labels.at(i, j, k) = point.x() < ball_middle.x() ? 1 : 2;
      }
    }
  }
  const std::vector<anatomy::Structure> structures = {
      {1, "right_half", "bone", false}, {2, "left_half", "bone", false}, {3, "nowhere", "bone", false}};
  find_sections(labels, structures, surfaces);
  return surfaces;
}

const PatientSurface& bone_of(const PatientSurfaces& surfaces) {
  return *std::find_if(surfaces.parts.begin(), surfaces.parts.end(),
                       [](const PatientSurface& part) { return part.name == "bone"; });
}

SoftwareView look_at(const PatientSurfaces& surfaces, const Look& look) {
  SoftwareView view(std::make_shared<PatientSurfaces>(surfaces));
  view.set_size(160, 120);
  ViewSubject subject;
  subject.middle = ball_middle;
  subject.height = 110.0;
  view.set_camera(standard_view(StandardView::posterior, subject));
  view.set_look(look);
  view.draw();
  return view;
}

std::array<int, 3> channels(std::uint32_t pixel) {
  return {static_cast<int>(pixel >> 16U) & 0xFF, static_cast<int>(pixel >> 8U) & 0xFF,
          static_cast<int>(pixel) & 0xFF};
}

int farthest_channel(std::uint32_t a, std::uint32_t b) {
  int most = 0;
  for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(channels(a)[c] - channels(b)[c]));
  return most;
}

std::uint32_t middle_pixel(const SoftwareView& view, int right = 0) {
  return view.picture().row(60)[80 + right];
}

Look bones_with(std::vector<PartLook> parts) {
  return {Preset::bones, std::move(parts)};
}

TEST(Look, a_section_follows_its_surface_until_it_is_named_itself) {
  const PatientSurfaces surfaces = halved_ball();
  const PatientSurface& bone = bone_of(surfaces);
  Look look;
  EXPECT_EQ(appearance(look, bone, "left_half").colour, bone.colour);
  look = changed(look, bone, {"left_half", {}, {}, 0x112233});
  look = changed(look, bone, {"bone", {}, 0.4, {}});
  EXPECT_EQ(appearance(look, bone, "left_half").colour, 0x112233u);
  EXPECT_FLOAT_EQ(appearance(look, bone, "left_half").opacity, 0.4F);
  EXPECT_EQ(appearance(look, bone, "right_half").colour, bone.colour);
  look = changed(look, bone, {"bone", {}, {}, 0x445566});
  EXPECT_EQ(appearance(look, bone, "left_half").colour, 0x445566u) << "the whole surface was given a colour";
  look = changed(look, bone, {"left_half", false, {}, {}});
  EXPECT_FALSE(appearance(look, bone, "left_half").drawn());
  EXPECT_TRUE(appearance(look, bone, "right_half").drawn());
}

TEST(Look, another_preset_brings_its_own_visibility_and_keeps_colours) {
  const PatientSurface& bone = bone_of(ball_surfaces());
  const Look look = changed(Look{}, bone, {"bone", false, 0.2, 0x112233});
  const Look next = with_preset(look, Preset::bones);
  EXPECT_TRUE(appearance(next, bone).shown);
  EXPECT_FLOAT_EQ(appearance(next, bone).opacity, 1.0F);
  EXPECT_EQ(appearance(next, bone).colour, 0x112233u);
}

TEST(Sections, every_triangle_belongs_to_the_structure_under_it) {
  const PatientSurfaces surfaces = halved_ball();
  const PatientSurface &bone = bone_of(surfaces), &whole = bone_of(ball_surfaces());
  std::size_t sum = 0, wrong = 0;
  for (const SurfaceSection& section : bone.sections) {
    EXPECT_EQ(section.first, sum);
    sum += section.count;
    for (std::size_t t = section.first; t < section.first + section.count; ++t) {
      double x = 0.0;
      for (const std::int32_t corner_index : bone.mesh.triangles[t])
        x += static_cast<double>(bone.mesh.points[static_cast<std::size_t>(corner_index)].x()) / 3.0;
      const double from_border = x - ball_middle.x();
      if (std::abs(from_border) > 2.0) wrong += (from_border < 0.0) == (section.name == "right_half") ? 0 : 1;
    }
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_EQ(sum, whole.mesh.triangles.size());
  ASSERT_EQ(bone.sections.size(), 2u) << "a structure that is nowhere has no section";
  auto before = whole.mesh.triangles, after = bone.mesh.triangles;
  std::sort(before.begin(), before.end());
  std::sort(after.begin(), after.end());
  EXPECT_EQ(before, after) << "the surface itself stays as it was";
  EXPECT_TRUE(surfaces.skin().triangles.size() == ball_surfaces().skin().triangles.size() &&
              surfaces.parts.front().sections.empty());
}

TEST(Look, a_translucent_bone_is_mixed_with_what_is_behind_it_in_proportion) {
  const std::uint32_t solid = middle_pixel(look_at(ball_surfaces(), bones_with({})));
  const std::uint32_t sky = middle_pixel(look_at(ball_surfaces(), bones_with({{"bone", false, {}, {}}})));
  ASSERT_GT(farthest_channel(solid, sky), 60);
  for (const double opacity : {0.25, 0.5, 0.9}) {
    const std::uint32_t mixed = middle_pixel(look_at(ball_surfaces(), bones_with({{"bone", {}, opacity, {}}})));
    for (std::size_t c = 0; c < 3; ++c) {
      const double expected = opacity * channels(solid)[c] + (1.0 - opacity) * channels(sky)[c];
      EXPECT_NEAR(channels(mixed)[c], expected, 3.0) << "opacity " << opacity;
    }
  }
}

TEST(Look, a_structure_has_its_own_colour_and_can_be_hidden_alone) {
  const PatientSurfaces surfaces = halved_ball();
  // From behind, the patient's right is on the right.
  const std::uint32_t plain = middle_pixel(look_at(surfaces, bones_with({})), 8);
  const SoftwareView coloured = look_at(surfaces, bones_with({{"right_half", {}, {}, 0x0000FF}}));
  const bool right_is_right = farthest_channel(middle_pixel(coloured, 8), plain) > 60;
  const int side = right_is_right ? 8 : -8;
  const auto blue = channels(middle_pixel(coloured, side));
  EXPECT_GT(blue[2], blue[0] + 80);
  const std::uint32_t same = middle_pixel(look_at(surfaces, bones_with({})), -side);
  EXPECT_EQ(middle_pixel(coloured, -side), same) << "the other half stays as it was";
  const SoftwareView hidden = look_at(surfaces, bones_with({{"right_half", false, {}, {}}}));
  EXPECT_EQ(middle_pixel(hidden, -side), same);
  const std::uint32_t sky = middle_pixel(look_at(surfaces, bones_with({{"bone", false, {}, {}}})), side);
  EXPECT_EQ(middle_pixel(hidden, side), sky);
}

TEST(Look, the_nearer_of_two_translucent_surfaces_lies_over_the_other) {
  // Skin of half opacity over bone of half opacity, against the sum by hand.
  const auto pixel = [](double skin, double bone) {
    std::vector<PartLook> parts = {{"skin", skin > 0.0, skin, {}}, {"bone", bone > 0.0, bone, {}}};
    return middle_pixel(look_at(ball_surfaces(), {Preset::see_through, std::move(parts)}));
  };
  const std::uint32_t sky = pixel(0.0, 0.0), bone = pixel(0.0, 1.0), skin = pixel(1.0, 0.0), both = pixel(0.5, 0.5);
  for (std::size_t c = 0; c < 3; ++c) {
    const double inside = 0.5 * channels(bone)[c] + 0.5 * channels(sky)[c];
    EXPECT_NEAR(channels(both)[c], 0.5 * channels(skin)[c] + 0.5 * inside, 3.0);
  }
}

TEST(Look, a_needle_behind_a_translucent_bone_is_seen_through_it) {
  const auto with_needle = [](double depth, const Look& look) {
    SoftwareView view = look_at(ball_surfaces(), look);
    const Vec3 direction = Vec3(0.6, 0.0, 0.8);  // across the line of sight, through the middle of the picture
    NeedleLook needle;
    needle.shape.outer_diameter = 4.0;  // covers whole pixels
    needle.pose = needle_pose(ball_middle + Vec3(0.0, -depth, 0.0) + 40.0 * direction, direction);
    view.set_needles({needle});
    view.draw();
    return view;
  };
  const auto contrast = [&](double depth, double opacity) {
    const Look look = bones_with({{"bone", opacity > 0.0, opacity, {}}});
    const SoftwareView view = with_needle(depth, look), plain = look_at(ball_surfaces(), look);
    int most = 0;
    for (int x = 60; x < 100; ++x)
      most = std::max(most, farthest_channel(view.picture().row(60)[x], plain.picture().row(60)[x]));
    return most;
  };
  const int behind = contrast(30.0, 0.5), bare = contrast(30.0, 0.0);
  EXPECT_NEAR(behind, 0.5 * bare, 0.08 * bare) << "half of it comes through";
  // In a pixel covered by a needle, nothing behind it counts.
  const auto row = [&](double opacity, bool needle) {
    const Look look = bones_with({{"bone", opacity > 0.0, opacity, {}}});
    const SoftwareView view = needle ? with_needle(-30.0, look) : look_at(ball_surfaces(), look);
    return std::vector<std::uint32_t>(view.picture().row(60), view.picture().row(60) + 160);
  };
  const auto sky = row(0.0, false), bone = row(0.5, false), on_sky = row(0.0, true), on_bone = row(0.5, true);
  std::size_t covered = 60;
  for (std::size_t x = 60; x < 100; ++x) {
    if (farthest_channel(on_sky[x], sky[x]) > farthest_channel(on_sky[covered], sky[covered])) covered = x;
  }
  ASSERT_GT(farthest_channel(bone[covered], sky[covered]), 40);
  EXPECT_LT(farthest_channel(on_bone[covered], on_sky[covered]),
            0.25 * farthest_channel(bone[covered], sky[covered]));
}

class LookFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / "bodkin_looks";
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string fault(const std::string& text) {
    std::ofstream(folder_ / "looks.xml") << text;
    try {
      read_looks(folder_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  fs::path folder_;
};

TEST_F(LookFile, brings_back_what_was_saved) {
  EXPECT_TRUE(read_looks(folder_).looks.empty());
  CaseLooks looks;
  looks.opens_with = "Nieren & Gefäße";
  looks.looks.push_back({"Nieren & Gefäße",
                         {Preset::bones, {{"kidney_left", true, 0.35, 0x8A5878}, {"bone", {}, 0.1, {}}}},
                         Camera{Vec3(1.0, 620.5, -3.0), Vec3(0.1, 0.2, 0.3), Vec3(0.0, 0.1, 1.0), 28.0 * degree}});
  looks.looks.push_back({"plain", {}, {}});
  write_looks(looks, folder_);
  const CaseLooks back = read_looks(folder_);
  EXPECT_EQ(back.opens_with, looks.opens_with);
  ASSERT_EQ(back.looks.size(), 2u);
  EXPECT_EQ(back.looks[0].look, looks.looks[0].look);
  EXPECT_EQ(back.looks[0].name, looks.looks[0].name);
  ASSERT_TRUE(back.looks[0].camera.has_value());
  EXPECT_EQ(back.looks[0].camera->eye, looks.looks[0].camera->eye);
  EXPECT_NEAR(back.looks[0].camera->angle, 28.0 * degree, 1e-12);
  EXPECT_FALSE(back.looks[1].camera.has_value());
}

TEST_F(LookFile, refuses_what_is_wrong_with_the_line_and_what_was_expected) {
  const std::string camera =
      R"(<camera eye_x_mm="0" eye_y_mm="1" eye_z_mm="0" focus_x_mm="0" focus_y_mm="1" focus_z_mm="0")"
      R"( up_x="0" up_y="0" up_z="1"/>)";
  const std::string head = "<looks version=\"1\">\n<look name=\"a\">\n", tail = "\n</look></looks>";
  EXPECT_NE(fault(head + "<part name=\"bone\" opacity=\"2\"/>" + tail).find("line 3: part opacity is '2'"),
            std::string::npos);
  EXPECT_NE(fault(head + "<part name=\"bone\" colour=\"red\"/>" + tail).find("#8a5878"), std::string::npos);
  EXPECT_NE(fault(head + camera + tail).find("line 3: camera: eye and focus"), std::string::npos);
  EXPECT_NE(fault(head + "<part name=\"b\"/><part name=\"b\"/>" + tail).find("appears twice"), std::string::npos);
  EXPECT_NE(fault("<looks version=\"1\"><look name=\"a\"/><look name=\"a\"/></looks>").find("two looks called 'a'"),
            std::string::npos);
  EXPECT_NE(fault("<looks version=\"1\" opens_with=\"b\"><look name=\"a\"/></looks>").find("opens_with is 'b'"),
            std::string::npos);
}

}  // namespace
}  // namespace bodkin::scene
