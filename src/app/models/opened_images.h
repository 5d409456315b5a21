#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace bodkin::app {

// Maps images and DICOM folders to their patients, so that opening one again opens the same patient immediately, and
// another image of the same name becomes a separate patient. Stored beside the patients in `opened.json`.
class OpenedImages {
 public:
  // `patients`: the folder of all of them. `is_taken`: names that are not available for patients created here.
  OpenedImages(std::filesystem::path patients, std::function<bool(const std::string&)> is_taken);

  // The folder of an image's patient, existing or not: named after the image, with a number if the name is taken. A
  // modified image counts as another one.
  std::filesystem::path folder_of(const std::filesystem::path& image) const;
  // Records `folder` as the patient of the image in its present version. Throws SystemError.
  void keep(const std::filesystem::path& image, const std::filesystem::path& folder) const;

 private:
  std::filesystem::path patients_;
  std::function<bool(const std::string&)> is_taken_;
};

}  // namespace bodkin::app
