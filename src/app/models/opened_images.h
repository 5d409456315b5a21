#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace bodkin::app {

// Which patient was made from which image or DICOM folder, so that opening it again opens him at once, and another
// image of the same name becomes a patient of its own. Kept beside the patients in `opened.json`.
class OpenedImages {
 public:
  // `patients`: the folder of all of them. `is_taken`: names that no patient made here may have.
  OpenedImages(std::filesystem::path patients, std::function<bool(const std::string&)> is_taken);

  // Where the patient of an image is, or will be made: named after it, with a number where another has that name. An
  // image that was written since then is another one.
  std::filesystem::path folder_of(const std::filesystem::path& image) const;
  // From now on `folder` is the patient of the image as it is. Throws SystemError.
  void keep(const std::filesystem::path& image, const std::filesystem::path& folder) const;

 private:
  std::filesystem::path patients_;
  std::function<bool(const std::string&)> is_taken_;
};

}  // namespace bodkin::app
