// The images of a teaching station, from files, and its tools in the patient's frame.
#include "tracking/station_footage.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin::tracking {
namespace {

namespace fs = std::filesystem;

Pose any_pose(Random& random) {
  const auto vector = [&](double most) {
    const double x = random.uniform(-most, most), y = random.uniform(-most, most), z = random.uniform(-most, most);
    return Vec3(x, y, z);
  };
  Pose pose = Pose::Identity();
  const Vec3 turn = vector(1.5);
  pose.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  pose.translation() = vector(300.0) + 600.0 * Vec3::UnitZ();
  return pose;
}

// A point of the patient passes through all frames: patient, mannequin, camera, body and back.
TEST(ToolInPatient, has_its_tip_and_axis_where_the_camera_sees_them) {
  Random random(11);
  const MarkerBody body = cube_body("needle", 12, 60.0, 150.0);
  for (int trial = 0; trial < 50; ++trial) {
    const Pose camera_from_mannequin = any_pose(random), camera_from_body = any_pose(random);
    const Pose placed = any_pose(random);
    Similarity mannequin_from_patient;
    mannequin_from_patient.turn = placed.linear();
    mannequin_from_patient.shift = placed.translation();
    mannequin_from_patient.scale = random.uniform(0.8, 1.25);
    const Pose tool = tool_in_patient(body, camera_from_body, camera_from_mannequin, mannequin_from_patient);
    const auto seen = [&](const Vec3& patient) { return camera_from_mannequin * (mannequin_from_patient * patient); };
    EXPECT_LT((seen(tool.translation()) - camera_from_body * body.tip).norm(), 1e-9);
    const Vec3 ahead = tool.translation() + 10.0 * tool.linear().col(2);
    const Vec3 direction = seen(ahead) - seen(tool.translation());
    EXPECT_LT((direction.normalized() - camera_from_body.linear() * body.axis).norm(), 1e-9);
    EXPECT_LT((tool.linear().transpose() * tool.linear() - Mat3::Identity()).norm(), 1e-12);
    EXPECT_NEAR(tool.linear().determinant(), 1.0, 1e-12);
  }
}

TEST(FootageFiles, a_source_without_calibration_is_refused_with_what_to_do) {
  const fs::path folder = fs::temp_directory_path() / ("bodkin-footage-" + std::to_string(getpid()));
  fs::create_directories(folder);
  FootageFiles files;
  files.source = folder.string();
  EXPECT_FALSE(has_calibration(files));
  EXPECT_THROW(open_footage_files(files), InputError);
  std::ofstream(folder / "frame.png") << "no picture";
  try {
    open_footage_files(files);
    ADD_FAILURE() << "opened";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("bodkin camera calibrate"));
  }
  files.camera = folder / "camera.json";
  EXPECT_TRUE(has_calibration(files));
  EXPECT_THROW(open_footage_files(files), InputError) << "there is no such file";
  fs::remove_all(folder);
}

}  // namespace
}  // namespace bodkin::tracking
