#include "app/models/stored_measures.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

namespace bodkin::app {
namespace {

namespace fs = std::filesystem;
using views::Measure;

TEST(KeptMeasures, come_back_as_they_were_and_go_when_they_are_deleted) {
  const fs::path folder = fs::temp_directory_path() / ("bodkin-measures-" + std::to_string(getpid()));
  fs::create_directories(folder);
  EXPECT_TRUE(stored_measures(folder).empty());
  Measure distance;
  distance.places = {Vec3(0.1, 2.0, -3.0), Vec3(30.1, 42.0, -3.0)};
  Measure angle;
  angle.kind = Measure::Kind::angle;
  angle.places = {Vec3(10.0, 0.0, 0.0), Vec3::Zero(), Vec3(0.0, 7.0, 0.0)};
  store_measures({distance, angle}, folder);
  const std::vector<Measure> kept = stored_measures(folder);
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(views::text_of(kept[0]), "50.0 mm");
  EXPECT_EQ(kept[0].places[0], distance.places[0]);
  EXPECT_EQ(views::text_of(kept[1]), "90.0°");
  store_measures({}, folder);
  EXPECT_TRUE(fs::is_empty(folder));
  std::ofstream(folder / "measures.json") << "[[[1, 2";
  EXPECT_TRUE(stored_measures(folder).empty());
  fs::remove_all(folder);
}

}  // namespace
}  // namespace bodkin::app
