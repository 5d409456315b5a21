#include "io/images/dicom_series.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "io/images/dicom_pixels.h"
#include "io/images/image_file.h"
#include "io/images/slice_stack.h"

namespace bodkin::io {
namespace {

constexpr double same_place = 0.01;     // mm; slices closer than this are two images of one place
constexpr double steepest_tilt = 45.0;  // degrees; a gantry tilts by 30 at most

// The series to read: the one asked for, or the only one there is.
DicomSeries chosen_series(const DicomFolder& folder, const std::string& name, const DicomOptions& options,
                          std::vector<std::string>& notes) {
  if (folder.series.empty()) {
    if (folder.unreadable > 0) {
      throw InputError(
          fmt::format("{}: the DICOM header cannot be read (files: {}); it is truncated or damaged, copy it "
                      "again",
                      name, folder.unreadable));
    }
    const std::string others =
        folder.other_objects == 0 ? "" : fmt::format(" (other DICOM objects: {})", folder.other_objects);
    const char* expected = options.any_modality ? "label images; save a DICOM segmentation object as NIfTI or NRRD"
                                                : "the slices of a CT series";
    throw InputError(fmt::format("{}: there is no DICOM image here{}; expected {}", name, others, expected));
  }
  if (options.series) {
    const int wanted = *options.series;
    if (wanted < 1 || wanted > static_cast<int>(folder.series.size())) {
      throw InputError(fmt::format("{}: there is no series {}; expected 1 to {}:\n{}", name, wanted,
                                   folder.series.size(), series_listing(folder)));
    }
    return folder.series[static_cast<std::size_t>(wanted) - 1];
  }
  std::vector<const DicomSeries*> candidates;
  for (const DicomSeries& series : folder.series) {
    if (options.any_modality || series.modality == "CT") candidates.push_back(&series);
  }
  if (candidates.size() > 1 || (candidates.empty() && folder.series.size() > 1)) {
    throw InputError(fmt::format("{}: this folder holds {} series; say --series N to pick one:\n{}", name,
                                 folder.series.size(), series_listing(folder)));
  }
  if (candidates.empty()) return folder.series.front();
  if (folder.series.size() > 1) {
    notes.push_back(fmt::format("Read the only CT series of the folder ({}) and left {} other series aside.",
                                candidates.front()->describe(), folder.series.size() - 1));
  }
  return *candidates.front();
}

void require_ct_stack(const DicomSeries& series, const std::string& name, const DicomOptions& options) {
  if (!options.any_modality && series.modality != "CT") {
    throw InputError(fmt::format("{}: this is {} (modality {}), not CT; Bodkin needs HU, so give a CT series", name,
                                 series.describe(), series.modality.empty() ? "missing" : series.modality));
  }
  if (series.frames > 1) {
    throw InputError(
        fmt::format("{}: this is an enhanced image with {} frames in one file; convert it to single-frame "
                    "DICOM or NIfTI first",
                    name, series.frames));
  }
  if (!series.placed) {
    throw InputError(
        fmt::format("{}: the slices do not say where they lie in the patient; expected Image Position, Image "
                    "Orientation (Patient) and Pixel Spacing",
                    series.slices.front().file.string()));
  }
}

std::string place_of(const Vec3& position, const Vec3& normal) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return fmt::format("{} = {:.2f}", "xyz"[axis], position[axis]);
}

// Orders slices along the normal and drops exact repetitions; two different images of one place are refused.
void order_slices(DicomSeries& series, const std::string& name, std::vector<std::string>& notes) {
  const Vec3 normal = series.row_direction.cross(series.column_direction);
  std::vector<DicomSlice> ordered = std::move(series.slices);
  std::stable_sort(ordered.begin(), ordered.end(), [&](const DicomSlice& a, const DicomSlice& b) {
    return a.position.dot(normal) < b.position.dot(normal);
  });
  std::size_t repeated = 0;
  series.slices.clear();
  for (DicomSlice& slice : ordered) {
    if (!series.slices.empty()) {
      const DicomSlice& before = series.slices.back();
      if (std::abs((slice.position - before.position).dot(normal)) < same_place) {
        if (slice.instance_uid != before.instance_uid) {
          throw InputError(
              fmt::format("{}: two different slices lie at {} mm ({} and {}); give a folder with one phase of "
                          "one acquisition",
                          name, place_of(slice.position, normal), before.file.filename().string(),
                          slice.file.filename().string()));
        }
        ++repeated;
        continue;
      }
    }
    series.slices.push_back(std::move(slice));
  }
  if (repeated > 0)
    notes.push_back(fmt::format("Slices that were there more than once (files: {}) were read once.", repeated));
}

SliceStack stack_of(const DicomSeries& series) {
  SliceStack stack;
  stack.columns = series.columns;
  stack.rows = series.rows;
  stack.column_spacing = series.column_spacing;
  stack.row_spacing = series.row_spacing;
  stack.row_direction = series.row_direction;
  stack.column_direction = series.column_direction;
  for (const DicomSlice& slice : series.slices) stack.positions.push_back(slice.position);
  return stack;
}

// Refuses what cannot be repaired and says what will be.
void judge_geometry(const SliceStack& stack, const StackGeometry& geometry, const std::string& name,
                    const DicomOptions& options, std::vector<std::string>& notes) {
  if (geometry.shear_angle > steepest_tilt) {
    throw InputError(
        fmt::format("{}: the slices are shifted against each other by {:.1f} degrees, more than any gantry "
                    "tilts; the positions in the headers are wrong",
                    name, geometry.shear_angle));
  }
  if (!geometry.gaps.empty()) {
    const std::size_t gap = geometry.gaps.front();
    const std::string where = fmt::format("between {} and {} mm", place_of(stack.positions[gap], stack.normal()),
                                          place_of(stack.positions[gap + 1], stack.normal()));
    const std::string more =
        geometry.gaps.size() == 1 ? "" : fmt::format(" (and at {} other places)", geometry.gaps.size() - 1);
    if (!options.fill_missing) {
      throw InputError(
          fmt::format("{}: a slice is missing {}{}, where the step is {:.4g} mm instead of {:.4g} mm; find the "
                      "file, or say --fill-missing to interpolate",
                      name, where, more, geometry.largest_step, geometry.smallest_step));
    }
    notes.push_back(fmt::format("A slice is missing {}{}; it was interpolated from its neighbours.", where, more));
  } else if (geometry.uneven) {
    notes.push_back(
        fmt::format("The slices are unevenly spaced ({:.4g} to {:.4g} mm); the CT was resampled to slices every "
                    "{:.4g} mm.",
                    geometry.smallest_step, geometry.largest_step, geometry.step));
  }
  if (geometry.sheared) {
    notes.push_back(
        fmt::format("The gantry was tilted: the slices are shifted against each other by {:.1f} degrees; the CT "
                    "was resampled to a regular grid.",
                    geometry.shear_angle));
  }
}

}  // namespace

std::string series_listing(const DicomFolder& folder) {
  std::string listing;
  for (std::size_t i = 0; i < folder.series.size(); ++i) {
    listing += fmt::format("{}  {}: {}", i == 0 ? "" : "\n", i + 1, folder.series[i].describe());
  }
  return listing;
}

DicomVolume read_dicom(const std::filesystem::path& path, const DicomOptions& options, const Progress& progress) {
  const std::string name = path.string();
  DicomVolume result;
  const DicomFolder folder = scan_dicom(path, progress);
  DicomSeries series = chosen_series(folder, name, options, result.notes);
  if (folder.unreadable > 0) {
    result.notes.push_back(fmt::format("Damaged DICOM files (files: {}) were left out.", folder.unreadable));
  }
  require_ct_stack(series, name, options);
  order_slices(series, name, result.notes);

  const SliceStack stack = stack_of(series);
  const double thickness = series.thickness > 0.0 ? series.thickness : 1.0;
  const StackGeometry geometry = measure_stack(stack, thickness);
  judge_geometry(stack, geometry, name, options, result.notes);
  const anatomy::Grid grid =
      clean_grid(geometry.regular() ? regular_grid(stack, geometry) : resampled_grid(stack, geometry), name);
  require_plausible_size(name,
                         {static_cast<std::uintmax_t>(grid.size[0]), static_cast<std::uintmax_t>(grid.size[1]),
                          static_cast<std::uintmax_t>(grid.size[2])},
                         1, static_cast<double>(most_voxels));

  HounsfieldLosses losses;
  std::vector<std::int16_t> voxels = decode_slices(series, losses, progress);
  const std::vector<std::string> lost = losses.notes();
  result.notes.insert(result.notes.end(), lost.begin(), lost.end());
  if (geometry.regular()) {
    result.volume.grid = grid;
    result.volume.voxels = std::move(voxels);
  } else {
    if (progress) progress("resampling", 0.0);
    result.volume = resample_stack(stack, grid, voxels, anatomy::lowest_hounsfield);
    result.resampled = true;
  }
  return result;
}

}  // namespace bodkin::io
