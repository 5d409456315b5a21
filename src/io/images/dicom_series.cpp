#include "io/images/dicom_series.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "io/images/dicom_pixels.h"
#include "io/images/image_file.h"
#include "io/images/slice_stack.h"
#include "io/text_encoding.h"

namespace bodkin::io {
namespace {

constexpr double same_place = 0.01;     // mm; slices closer than this are two images of one place
constexpr double steepest_tilt = 45.0;  // degrees; a gantry tilts by 30 at most

// "a.dcm", "a.dcm and 2 more"
std::string named(const std::vector<std::filesystem::path>& files) {
  const std::string more = files.size() == 1 ? "" : fmt::format(" and {} more", files.size() - 1);
  return files.front().filename().string() + more;
}

// The series to read: the requested one, or the only one.
DicomSeries chosen_series(const DicomFolder& folder, const std::string& name, const DicomOptions& options,
                          std::vector<std::string>& notes) {
  if (folder.series.empty()) {
    if (!folder.unreadable.empty()) {
      throw InputError(
          fmt::format("{}: the DICOM header cannot be read (files: {}, {}); it is truncated or damaged, copy it "
                      "again",
                      name, folder.unreadable.size(), named(folder.unreadable)));
    }
    const std::string others =
        folder.other_objects.empty() ? "" : fmt::format(" (other DICOM objects: {})", folder.other_objects.size());
    const char* expected =
        options.any_modality ? "label images, a segmentation or a structure set" : "the slices of a CT series";
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
  if (series.frames > 1 && !series.placed) {
    throw InputError(
        fmt::format("{}: this is an image with {} frames in one file that do not all say where they lie, or are not "
                    "parallel; expected an enhanced CT, or convert it to single-frame DICOM or NIfTI first",
                    name, series.frames));
  }
  if (!series.placed) {
    throw InputError(
        fmt::format("{}: the slices do not say where they lie in the patient; expected Image Position, Image "
                    "Orientation (Patient) and Pixel Spacing",
                    series.slices.front().file.string()));
  }
}

// The coordinate along the patient's axis nearest to the normal.
double along(const Vec3& position, const Vec3& normal) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return position[axis];
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

// Refuses irreparable defects and reports repairs.
void judge_geometry(const SliceStack& stack, const StackGeometry& geometry, const DicomFolder& folder,
                    const DicomOptions& options, std::vector<std::string>& notes) {
  const std::string name = folder.path.string();
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
      const std::string mend = folder.unreadable.empty() ? "find the file"
                                                         : fmt::format("the header of {} is damaged, copy it again",
                                                                       named(folder.unreadable));
      throw InputError(
          fmt::format("{}: a slice is missing {}{}, where the step is {:.4g} mm instead of {:.4g} mm; {}, or say "
                      "--fill-missing to interpolate",
                      name, where, more, geometry.largest_step, geometry.smallest_step, mend));
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

struct Lattice {
  SliceStack stack;
  anatomy::Grid grid;
  bool regular = true;
};

Lattice lattice_of(const DicomSeries& series, const DicomFolder& folder, const DicomOptions& options,
                   std::vector<std::string>& notes) {
  const std::string name = folder.path.string();
  Lattice lattice;
  lattice.stack = stack_of(series);
  const StackGeometry geometry = measure_stack(lattice.stack, series.thickness > 0.0 ? series.thickness : 1.0);
  judge_geometry(lattice.stack, geometry, folder, options, notes);
  lattice.regular = geometry.regular();
  lattice.grid = clean_grid(
      lattice.regular ? regular_grid(lattice.stack, geometry) : resampled_grid(lattice.stack, geometry), name);
  require_plausible_size(
      name,
      {static_cast<std::uintmax_t>(lattice.grid.size[0]), static_cast<std::uintmax_t>(lattice.grid.size[1]),
       static_cast<std::uintmax_t>(lattice.grid.size[2])},
      1, static_cast<double>(most_voxels));
  return lattice;
}

// Omits damaged slices if the rest is still a stack without gaps, as at its ends; with --fill-missing anywhere.
// Otherwise throws InputError with the sentence about the first of them.
void leave_out_damaged(DicomSeries& series, DecodedSlices& decoded, const DicomOptions& options,
                       std::vector<std::string>& notes) {
  if (decoded.damaged.empty()) return;
  const StackGeometry before = measure_stack(stack_of(series), 1.0);
  const std::size_t slice_size = decoded.voxels.size() / series.slices.size();
  std::vector<bool> damaged(series.slices.size(), false);
  std::vector<std::filesystem::path> files;
  for (const DamagedSlice& one : decoded.damaged) {
    damaged[one.slice] = true;
    if (files.empty() || files.back() != series.slices[one.slice].file)
      files.push_back(series.slices[one.slice].file);
  }
  std::vector<DicomSlice> kept;
  for (std::size_t n = 0; n < series.slices.size(); ++n) {
    if (damaged[n]) continue;
    const auto from = decoded.voxels.begin() + static_cast<std::ptrdiff_t>(n * slice_size);
    std::copy_n(from, slice_size, decoded.voxels.begin() + static_cast<std::ptrdiff_t>(kept.size() * slice_size));
    kept.push_back(series.slices[n]);
  }
  decoded.voxels.resize(kept.size() * slice_size);
  series.slices = std::move(kept);
  const StackGeometry after = measure_stack(stack_of(series), 1.0);
  const bool whole = after.gaps.empty() && (!after.uneven || before.uneven);
  if (!whole && !options.fill_missing) {
    throw InputError(
        fmt::format("{}; its neighbours alone are no regular stack, so it cannot be left out, but "
                    "--fill-missing interpolates it",
                    decoded.damaged.front().sentence));
  }
  notes.push_back(fmt::format("Slices whose pixels cannot be decoded (files: {}, {}) were left out.", files.size(),
                              named(files)));
}

// How far JPEG 2000 moved the values of three CTs of other patients at ratios of 4 to 30, HU for each N of N:1, with
// room: 1.3 in root mean square and 7.9 at most were found (docs/importing.md).
constexpr double jpeg_2000_typical = 1.5, jpeg_2000_largest = 10.0;

// The known loss of a series with lossy compression.
void note_loss(const DicomSeries& series, const std::optional<CodingError>& coding, std::vector<std::string>& notes) {
  const std::string ratio = series.lossy_ratio > 1.0 ? fmt::format(", {:.3g}:1", series.lossy_ratio) : "";
  if (coding) {
    notes.push_back(
        fmt::format("The series was compressed with loss{}: values are off by about {:.2g} HU (root mean square), by "
                    "{:.3g} HU at "
                    "most.",
                    ratio, coding->typical, coding->largest));
  } else if (series.lossy && series.jpeg_2000 && series.lossy_ratio > 1.0) {
    notes.push_back(fmt::format(
        "The series was compressed with loss, by JPEG 2000{}, which sets no limit; at this ratio values of other CTs "
        "were off by less than {:.2g} HU (root mean square) and {:.0f} HU at most, the most at edges.",
        ratio, jpeg_2000_typical * series.lossy_ratio, jpeg_2000_largest * series.lossy_ratio));
  } else if (series.lossy) {
    notes.push_back(
        fmt::format("The series was compressed with loss{}; the file does not say how far values are off: edges of "
                    "thin layers may be blurred by about a voxel, and values there may be off by tens of HU.",
                    ratio));
  }
}

// " of 168 x 156 mm, z 10 to 250 mm"
std::string extent_text(const DicomSeries& series) {
  if (!series.placed) return "";
  const Vec3 normal = series.row_direction.cross(series.column_direction);
  const auto [low, high] = std::minmax_element(
      series.slices.begin(), series.slices.end(),
      [&](const DicomSlice& a, const DicomSlice& b) { return a.position.dot(normal) < b.position.dot(normal); });
  return fmt::format(", {:.0f} x {:.0f} mm, {} to {:.2f} mm", series.columns * series.column_spacing,
                     series.rows * series.row_spacing, place_of(low->position, normal),
                     along(high->position, normal));
}

// The folder of a series relative to the scanned one; empty if it is that one.
std::string folder_text(const DicomSeries& series, const std::filesystem::path& scanned) {
  std::error_code error;
  const std::filesystem::path below =
      std::filesystem::relative(series.slices.front().file.parent_path(), scanned, error);
  return error || below.empty() || below == "." ? "" : fmt::format(", in {}", printable(below.string()));
}

}  // namespace

std::string series_listing(const DicomFolder& folder) {
  std::string listing;
  for (std::size_t i = 0; i < folder.series.size(); ++i) {
    const DicomSeries& series = folder.series[i];
    listing += fmt::format("{}  {}: {}{}{}", i == 0 ? "" : "\n", i + 1, series.describe(), extent_text(series),
                           folder_text(series, folder.path));
  }
  return listing;
}

DicomVolume read_dicom(const std::filesystem::path& path, const DicomOptions& options, const Progress& progress) {
  const std::string name = path.string();
  DicomVolume result;
  const DicomFolder folder = scan_dicom(path, progress);
  DicomSeries series = chosen_series(folder, name, options, result.notes);
  if (!folder.unreadable.empty()) {
    result.notes.push_back(fmt::format("Damaged DICOM files (files: {}, {}) were left out.", folder.unreadable.size(),
                                       named(folder.unreadable)));
  }
  require_ct_stack(series, name, options);
  order_slices(series, name, result.notes);

  // Irreparable geometry is refused before any pixel is read.
  std::vector<std::string> mended;
  static_cast<void>(lattice_of(series, folder, options, mended));

  HounsfieldLosses losses;
  DecodedSlices decoded = decode_slices(series, losses, progress);
  leave_out_damaged(series, decoded, options, result.notes);
  const Lattice lattice = lattice_of(series, folder, options, result.notes);
  note_loss(series, decoded.coding, result.notes);
  const std::vector<std::string> lost = losses.notes();
  result.notes.insert(result.notes.end(), lost.begin(), lost.end());
  if (lattice.regular) {
    result.volume.grid = lattice.grid;
    result.volume.voxels = std::move(decoded.voxels);
  } else {
    if (progress) progress("resampling", 0.0);
    result.volume = resample_stack(lattice.stack, lattice.grid, decoded.voxels, anatomy::lowest_hounsfield);
    result.resampled = true;
  }
  return result;
}

}  // namespace bodkin::io
