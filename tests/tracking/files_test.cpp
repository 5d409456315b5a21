// Cameras, bodies, images and sheets as files.
#include "core/files.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include "tracking/camera_model.h"
#include "tracking/jpeg_file.h"
#include "tracking/marker_body.h"
#include "tracking/marker_sheet.h"
#include "tracking/registration_file.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/error.h"

namespace bodkin::tracking {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class TrackingFiles : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path written(const std::string& name, const std::string& text) const {
    write_file(folder_ / name, text);
    return folder_ / name;
  }
  static std::string refusal(const std::function<void()>& work) {
    try {
      work();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_ = fs::temp_directory_path() / ("bodkin_tracking_" + std::to_string(getpid()));
};

TEST_F(TrackingFiles, a_camera_comes_back_as_it_was_and_sees_what_it_projects) {
  CameraModel camera = footage_camera(1280, 720);
  camera.tone = {1.7, 0.2};
  camera.blur = 0.9;
  EXPECT_EQ(read_camera(written("camera.json", camera_json(camera))), camera);
  for (const Vec3& point : {Vec3(0, 0, 500), Vec3(-210, 120, 600), Vec3(250, -130, 520)}) {
    const Vec3 ray = camera.ray(camera.project(point));
    EXPECT_LT((ray * point.z() - point).norm(), 1e-6);
  }
}

TEST_F(TrackingFiles, tone_curves_are_their_own_inverse) {
  for (const ToneCurve& tone : {ToneCurve{}, ToneCurve{1.0, 0.0}, ToneCurve{1.8, 0.3}}) {
    for (const double light : {0.0, 0.01, 0.2, 0.5, 0.93, 1.0})
      EXPECT_NEAR(tone.light(tone.level(light)), light, 1e-8);
  }
  EXPECT_NEAR(ToneCurve{}.level(0.5), 0.735357, 1e-6);  // IEC 61966-2-1
}

TEST_F(TrackingFiles, bodies_come_back_and_a_marker_may_be_there_once) {
  const std::vector<MarkerBody> bodies = station_bodies();
  const std::vector<MarkerBody> read = read_bodies(written("bodies.json", bodies_json(bodies)));
  ASSERT_EQ(read.size(), bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    EXPECT_EQ(read[b].name, bodies[b].name);
    ASSERT_EQ(read[b].faces.size(), bodies[b].faces.size());
    for (std::size_t f = 0; f < bodies[b].faces.size(); ++f)
      EXPECT_TRUE(read[b].faces[f].place.isApprox(bodies[b].faces[f].place, 1e-9));
  }
  const std::vector<MarkerBody> twice = {cube_body("one", 3, 60.0, 150.0), cube_body("two", 7, 60.0, 150.0)};
  EXPECT_THAT(refusal([&] { read_bodies(written("twice.json", bodies_json(twice))); }), HasSubstr("marker 7"));
}

TEST_F(TrackingFiles, what_is_wrong_with_a_file_is_said_by_field) {
  EXPECT_THAT(refusal([&] { read_camera(written("a.json", "{\"width\": 5}")); }), HasSubstr("\"width\""));
  EXPECT_THAT(refusal([&] { read_camera(written("b.json", "{\"focus\": 5}")); }), HasSubstr("\"focus\" is unknown"));
  EXPECT_THAT(refusal([&] { read_camera(written("c.json", "nothing")); }), HasSubstr("not a JSON object"));
  EXPECT_THAT(refusal([&] { read_points(written("p.csv", "name,x,y,z\na,1,2,3\nb,1,2\n")); }), HasSubstr("line 3"));
  EXPECT_THAT(refusal([&] { decode_jpeg_grey("no picture", "x.jpg"); }), HasSubstr("x.jpg: not a valid JPEG"));
}

TEST_F(TrackingFiles, a_jpeg_keeps_its_grey_levels_and_a_cut_one_is_refused) {
  GreyImage picture(64, 48);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) picture.at(x, y) = static_cast<std::uint8_t>(2 * x + y);
  }
  const std::string bytes = encode_jpeg(picture, 95);
  const GreyImage back = decode_jpeg_grey(bytes, "x.jpg");
  ASSERT_EQ(back.width, 64);
  for (std::size_t i = 0; i < back.pixels.size(); ++i) EXPECT_NEAR(back.pixels[i], picture.pixels[i], 4);
  EXPECT_THROW(decode_jpeg_grey(std::string_view(bytes).substr(0, bytes.size() / 2), "x.jpg"), InputError);
}

TEST_F(TrackingFiles, sheets_are_a_pdf_and_a_body_too_large_for_the_page_is_named) {
  EXPECT_EQ(marker_sheets_pdf(station_bodies()).substr(0, 5), "%PDF-");
  EXPECT_THAT(refusal([] { marker_sheets_pdf({cube_body("large", 0, 120.0, 150.0)}); }), HasSubstr("\"large\""));
}

TEST(MarkerBody, the_faces_of_a_cube_look_outwards_and_are_turned_rightly) {
  for (const MarkerFace& face : cube_body("needle", 0, 60.0, 150.0).faces) {
    EXPECT_NEAR(face.place.linear().determinant(), 1.0, 1e-12);
    EXPECT_LT(face.place.linear().col(2).dot(face.place.translation()), 0.0);
    EXPECT_NEAR(face.place.translation().norm(), 30.0, 1e-12);
  }
}

}  // namespace
}  // namespace bodkin::tracking
