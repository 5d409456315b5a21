#include "app/models/opened_images.h"

#include <fstream>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "io/image_worker.h"

namespace bodkin::app {

namespace fs = std::filesystem;

namespace {

// Path and time of the last change: identifies an image without reading it.
nlohmann::json mark_of(const fs::path& image) {
  std::error_code ignored;
  const auto written = fs::last_write_time(image, ignored).time_since_epoch().count();
  return {{"image", io::path_text(fs::weakly_canonical(image, ignored))}, {"written", written}};
}

// By the name of the patient's folder. A damaged or missing file has none, which costs a second import.
nlohmann::json read(const fs::path& file) {
  std::ifstream stream(file);
  nlohmann::json known = nlohmann::json::parse(stream, nullptr, false);
  return known.is_object() ? known : nlohmann::json::object();
}

std::string name_of(const fs::path& image) {
  std::error_code ignored;
  std::string name = fs::is_directory(image, ignored) ? image.filename().string() : image.stem().string();
  if (name.ends_with(".nii")) name.resize(name.size() - 4);
  return name;
}

}  // namespace

OpenedImages::OpenedImages(fs::path patients, std::function<bool(const std::string&)> is_taken)
    : patients_(std::move(patients)), is_taken_(std::move(is_taken)) {}

fs::path OpenedImages::folder_of(const fs::path& image) const {
  const nlohmann::json known = read(patients_ / "opened.json");
  const nlohmann::json mark = mark_of(image);
  for (const auto& [name, from] : known.items()) {
    if (from == mark && fs::exists(patients_ / name / "case.xml")) return patients_ / name;
  }
  const std::string name = name_of(image);
  for (int number = 1;; ++number) {
    const std::string tried = number == 1 ? name : name + " " + std::to_string(number);
    if (!is_taken_(tried) && !fs::exists(patients_ / tried)) return patients_ / tried;
  }
}

void OpenedImages::keep(const fs::path& image, const fs::path& folder) const {
  nlohmann::json known = read(patients_ / "opened.json");
  known[folder.filename().string()] = mark_of(image);
  write_file(patients_ / "opened.json", known.dump(1) + "\n");
}

}  // namespace bodkin::app
