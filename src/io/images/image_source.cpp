#include "io/images/image_source.h"

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

anatomy::LabelVolume read_labels(const std::filesystem::path& path, const Progress& progress) {
  if (holds_dicom(path)) {
    DicomOptions options;
    options.any_modality = true;
    DicomVolume dicom = read_dicom(path, options, progress);
    return to_labels(std::move(dicom.volume), path.string());
  }
  if (progress) progress("reading the labels", 0.0);
  return to_labels(read_image_file(path), path.string());
}

anatomy::TissueVolume read_tissues(const std::filesystem::path& path) {
  return to_tissues(read_image_file(path), path.string());
}

}  // namespace bodkin::io
