#include "io/images/image_source.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "io/images/image_file.h"
#include "io/images/image_format.h"
#include "io/images/image_values.h"

namespace bodkin::io {
namespace {

bool holds_dicom(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) return true;
  return detect_image_format(path) == ImageFormat::dicom;
}

// The only segmentation or structure set of a folder or file; nothing if there is none.
std::optional<DicomObject> annotation_of(const std::filesystem::path& path, const Progress& progress) {
  const DicomFolder folder = scan_dicom(path, progress);
  std::vector<DicomObject> found;
  std::copy_if(folder.other_objects.begin(), folder.other_objects.end(), std::back_inserter(found),
               [](const DicomObject& object) { return object.modality == "SEG" || object.modality == "RTSTRUCT"; });
  if (found.empty()) return std::nullopt;
  if (found.size() == 1) return found.front();
  std::string listing;
  for (const DicomObject& object : found)
    listing += fmt::format("\n  {}: {} '{}'", object.file.string(), object.modality, object.description);
  throw InputError(fmt::format("{}: this folder holds {} segmentations; give the file of one of them:{}",
                               path.string(), found.size(), listing));
}

NamedLabels read_any_labels(const std::filesystem::path& path, const anatomy::Grid* ct, const Progress& progress) {
  if (!holds_dicom(path)) {
    if (progress) progress("reading the labels", 0.0);
    return {to_labels(read_image_file(path), path.string()), {}, {}};
  }
  const std::optional<DicomObject> annotation = annotation_of(path, progress);
  if (!annotation) {
    DicomOptions options;
    options.any_modality = true;
    DicomVolume dicom = read_dicom(path, options, progress);
    return {to_labels(std::move(dicom.volume), path.string()), {}, std::move(dicom.notes)};
  }
  if (annotation->modality == "SEG") return read_segmentation(annotation->file);
  if (ct == nullptr) {
    throw InputError(
        fmt::format("{}: a structure set has contours, not voxels; give it as --labels of its CT", path.string()));
  }
  return read_structure_set(annotation->file, *ct);
}

}  // namespace

CtImage read_ct(const std::filesystem::path& path, const DicomOptions& options, const Progress& progress) {
  CtImage result;
  if (holds_dicom(path)) {
    DicomVolume dicom = read_dicom(path, options, progress);
    result = {std::move(dicom.volume), dicom.resampled, std::move(dicom.notes)};
  } else {
    if (options.series) {
      throw InputError(fmt::format("{}: --series picks a series of a DICOM folder; this is one file", path.string()));
    }
    if (progress) progress("reading the CT", 0.0);
    result.ct = to_ct(read_image_file(path), result.notes);
  }
  return result;
}

NamedLabels read_named_labels(const std::filesystem::path& path, const anatomy::Grid& ct, const Progress& progress) {
  return read_any_labels(path, &ct, progress);
}

anatomy::LabelVolume read_labels(const std::filesystem::path& path, const Progress& progress) {
  return read_any_labels(path, nullptr, progress).labels;
}

anatomy::TissueVolume read_tissues(const std::filesystem::path& path) {
  return to_tissues(read_image_file(path), path.string());
}

}  // namespace bodkin::io
