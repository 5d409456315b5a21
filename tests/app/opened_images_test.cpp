// An image opens its own patient, whatever its file name.
#include "app/models/opened_images.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

namespace bodkin::app {
namespace {

namespace fs = std::filesystem;

class OpenedImagesTest : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::temp_directory_path() / ("bodkin-opened-" + std::to_string(getpid()));
    fs::remove_all(root_);
    for (const char* folder : {"one/series", "two/series", "patients"}) fs::create_directories(root_ / folder);
  }
  void TearDown() override { fs::remove_all(root_); }

  static void write(const fs::path& file) { std::ofstream(file) << "x"; }
  // As in an import.
  fs::path open(const fs::path& image) const {
    const fs::path folder = images_.folder_of(image);
    fs::create_directories(folder);
    write(folder / "case.xml");
    images_.keep(image, folder);
    return folder.filename();
  }

  fs::path root_ = fs::temp_directory_path() / ("bodkin-opened-" + std::to_string(getpid()));
  OpenedImages images_{root_ / "patients", [](const std::string& name) { return name == "lumbar"; }};
};

TEST_F(OpenedImagesTest, two_series_of_one_name_are_two_patients_and_each_opens_again) {
  EXPECT_EQ(open(root_ / "one/series"), "series");
  EXPECT_EQ(open(root_ / "two/series"), "series 2");
  EXPECT_EQ(images_.folder_of(root_ / "one/series").filename(), "series");
  EXPECT_EQ(images_.folder_of(root_ / "two" / ".." / "two" / "series").filename(), "series 2");
  fs::remove_all(root_ / "patients" / "series");
  EXPECT_EQ(images_.folder_of(root_ / "one/series").filename(), "series") << "made anew where it was";
}

TEST_F(OpenedImagesTest, an_image_that_was_written_again_is_another_patient) {
  const fs::path image = root_ / "spine.nii.gz";
  write(image);
  EXPECT_EQ(open(image), "spine");
  EXPECT_EQ(images_.folder_of(image).filename(), "spine");
  fs::last_write_time(image, fs::last_write_time(image) + std::chrono::hours(1));
  EXPECT_EQ(images_.folder_of(image).filename(), "spine 2");
}

TEST_F(OpenedImagesTest, takes_no_name_of_a_practice_patient_and_none_of_a_folder_it_did_not_make) {
  write(root_ / "lumbar.mha");
  EXPECT_EQ(images_.folder_of(root_ / "lumbar.mha").filename(), "lumbar 2");
  fs::create_directories(root_ / "patients" / "spine");
  write(root_ / "spine.mha");
  EXPECT_EQ(images_.folder_of(root_ / "spine.mha").filename(), "spine 2");
}

TEST_F(OpenedImagesTest, a_damaged_list_costs_a_second_import_and_nothing_else) {
  EXPECT_EQ(open(root_ / "one/series"), "series");
  std::ofstream(root_ / "patients" / "opened.json") << "{\"series\": ";
  EXPECT_EQ(open(root_ / "one/series"), "series 2");
  EXPECT_EQ(images_.folder_of(root_ / "one/series").filename(), "series 2");
}

}  // namespace
}  // namespace bodkin::app
