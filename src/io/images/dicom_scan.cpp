#include "io/images/dicom_scan.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <gdcmDataSet.h>
#include <gdcmReader.h>
#include <gdcmTag.h>
#include <gdcmTrace.h>

#include "core/error.h"
#include "io/images/dicom_elements.h"
#include "io/images/dicom_extent.h"
#include "io/images/dicom_frames.h"
#include "io/images/image_format.h"
#include "io/text_encoding.h"

namespace bodkin::io {
namespace {

constexpr std::size_t most_files = 20000;
constexpr int deepest_folder = 8;
constexpr std::uintmax_t whole_memory = 512U << 20U;  // bytes allowed for a deflated file with its pixels
constexpr std::uintmax_t header_memory = 32U
                                         << 20U;  // bytes allowed for reading a header, in addition to the file's own

// Whether the first bytes are those of a DICOM file; spares GDCM all other files.
bool is_dicom(const std::filesystem::path& file) {
  try {
    return detect_image_format(file) == ImageFormat::dicom;
  } catch (const InputError&) {
    return false;
  }
}

// Reads the requested tags, and perhaps others. If a file ends before the last of them, or is deflated, GDCM fails
// unless it reads everything.
bool read_tags(gdcm::Reader& reader, const std::filesystem::path& file, const std::set<gdcm::Tag>& wanted) {
  const bool ends_early = dicom_extent(file).last_tag <= wanted.rbegin()->GetElementTag();
  return ends_early ? reader.Read() : reader.ReadSelectedTags(wanted);
}

void place(DicomSeries& series, const ImagePlacement& placement) {
  series.placed = true;
  series.column_spacing = placement.column_spacing;
  series.row_spacing = placement.row_spacing;
  series.row_direction = placement.row_direction;
  series.column_direction = placement.column_direction;
}

bool parallel(const ImagePlacement& a, const ImagePlacement& b) {
  return std::abs(a.column_spacing - b.column_spacing) < 1e-4 && std::abs(a.row_spacing - b.row_spacing) < 1e-4 &&
         (a.row_direction - b.row_direction).norm() < 1e-3 && (a.column_direction - b.column_direction).norm() < 1e-3;
}

// Makes each frame of an enhanced image a slice, if all state their positions and are parallel.
void add_frames(DicomSeries& series) {
  static const std::set<gdcm::Tag> wanted = {{0x5200, 0x9229}, {0x5200, 0x9230}};
  const DicomSlice file = series.slices.front();
  gdcm::Reader reader;
  reader.SetFileName(file.file.c_str());
  if (!read_tags(reader, file.file, wanted)) return;
  const std::vector<FrameInfo> frames = read_frames(reader.GetFile().GetDataSet());
  if (frames.size() != static_cast<std::size_t>(series.frames)) return;
  const ImagePlacement& first = frames.front().placement;
  if (!std::all_of(frames.begin(), frames.end(),
                   [&](const FrameInfo& frame) { return parallel(frame.placement, first); })) {
    return;
  }
  place(series, first);
  series.thickness = frames.front().thickness;
  series.slices.clear();
  for (std::size_t n = 0; n < frames.size(); ++n) {
    DicomSlice slice = file;
    slice.frame = static_cast<int>(n);
    slice.instance_uid += fmt::format("#{}", n + 1);
    slice.position = frames[n].placement.position;
    slice.slope = frames[n].slope;
    slice.intercept = frames[n].intercept;
    series.slices.push_back(slice);
  }
}

// One file's header: a series of a single slice. Nothing if it is damaged.
std::optional<DicomSeries> read_header(const std::filesystem::path& file) {
  static const std::set<gdcm::Tag> wanted = {{0x0008, 0x0016}, {0x0008, 0x0018}, {0x0008, 0x0060}, {0x0008, 0x103e},
                                             {0x0018, 0x0050}, {0x0020, 0x000e}, {0x0020, 0x0011}, {0x0020, 0x0032},
                                             {0x0020, 0x0037}, {0x0028, 0x0008}, {0x0028, 0x0010}, {0x0028, 0x0011},
                                             {0x0028, 0x0030}, {0x0028, 0x0100}, {0x0028, 0x1052}, {0x0028, 0x1053},
                                             {0x0028, 0x2110}, {0x0028, 0x2112}, {0x0028, 0x2114}};
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  if (!read_tags(reader, file, wanted)) return std::nullopt;
  const gdcm::DataSet& data = reader.GetFile().GetDataSet();

  DicomSeries series;
  series.uid = text_of(data, {0x0020, 0x000e});
  series.description = printable(text_of(data, {0x0008, 0x103e}));
  series.modality = printable(text_of(data, {0x0008, 0x0060}));
  series.number = whole_number_of(data, {0x0020, 0x0011}, 0);
  series.rows = unsigned_short_of(data, {0x0028, 0x0010});
  series.columns = unsigned_short_of(data, {0x0028, 0x0011});
  series.frames = whole_number_of(data, {0x0028, 0x0008}, 1);
  series.bytes_allocated = (unsigned_short_of(data, {0x0028, 0x0100}) + 7) / 8;
  const gdcm::TransferSyntax syntax = reader.GetFile().GetHeader().GetDataSetTransferSyntax();
  series.compressed = syntax.IsEncapsulated() || syntax == gdcm::TransferSyntax::DeflatedExplicitVRLittleEndian;
  series.lossy = text_of(data, {0x0028, 0x2110}) == "01";
  series.lossy_ratio = number_of(data, {0x0028, 0x2112}, 0.0);
  series.jpeg_2000 = syntax == gdcm::TransferSyntax::JPEG2000 || text_of(data, {0x0028, 0x2114}) == "ISO_15444_1";
  series.thickness = number_of(data, {0x0018, 0x0050}, 0.0);
  DicomSlice slice;
  slice.file = file;
  slice.instance_uid = text_of(data, {0x0008, 0x0018});
  slice.slope = number_of(data, {0x0028, 0x1053}, 1.0);
  slice.intercept = number_of(data, {0x0028, 0x1052}, 0.0);
  const std::optional<ImagePlacement> placement = read_placement(data);
  if (placement) place(series, *placement);
  slice.position = placement ? placement->position : Vec3::Zero();
  series.slices.push_back(slice);
  if (series.frames > 1) add_frames(series);
  return series;
}

std::optional<DicomSeries> read_header_within_budget(const std::filesystem::path& file) {
  std::optional<DicomSeries> series;
  const DicomExtent extent = dicom_extent(file);
  if (extent.header_cut) return std::nullopt;
  const std::uintmax_t memory = extent.last_tag == 0 ? whole_memory : header_memory;
  const bool read = read_within_budget(file, memory, [&] { return (series = read_header(file)).has_value(); });
  return read ? series : std::nullopt;
}

// Segmentations, structure sets, plans and doses.
bool is_annotation(const DicomSeries& series) {
  return series.modality == "SEG" || series.modality.starts_with("RT");
}

bool belong_together(const DicomSeries& a, const DicomSeries& b) {
  return a.uid == b.uid && a.modality == b.modality && a.columns == b.columns && a.rows == b.rows &&
         (a.frames > 1) == (b.frames > 1) && a.placed == b.placed &&
         std::abs(a.column_spacing - b.column_spacing) < 1e-4 && std::abs(a.row_spacing - b.row_spacing) < 1e-4 &&
         (a.row_direction - b.row_direction).norm() < 1e-3 && (a.column_direction - b.column_direction).norm() < 1e-3;
}

// Single files without a position, in a series whose files mostly have one, are damaged.
void set_strays_aside(DicomFolder& folder) {
  const auto stray = [&](const DicomSeries& one) {
    return !one.placed && std::any_of(folder.series.begin(), folder.series.end(), [&](const DicomSeries& other) {
      return other.placed && other.uid == one.uid && other.modality == one.modality &&
             other.slices.size() > one.slices.size();
    });
  };
  std::vector<DicomSeries> kept;
  for (const DicomSeries& series : folder.series) {
    if (!stray(series)) {
      kept.push_back(series);
      continue;
    }
    for (const DicomSlice& slice : series.slices) folder.unreadable.push_back(slice.file);
  }
  folder.series = std::move(kept);
}

std::vector<std::filesystem::path> files_of(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  if (!fs::is_directory(path)) return {path};
  std::vector<fs::path> files;
  std::error_code error;
  fs::recursive_directory_iterator entry(path, fs::directory_options::skip_permission_denied, error);
  if (error) throw InputError(fmt::format("{}: this folder cannot be read: {}", path.string(), error.message()));
  for (; entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (error) break;
    if (entry.depth() >= deepest_folder) entry.disable_recursion_pending();
    if (entry->is_regular_file(error)) files.push_back(entry->path());
    if (files.size() > most_files) {
      throw InputError(fmt::format("{}: this folder holds more than {} files; give the folder of one series",
                                   path.string(), most_files));
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::string DicomSeries::describe() const {
  const std::string title = description.empty() ? "" : fmt::format(" '{}'", description);
  const std::size_t count = placed ? slices.size() : slices.size() * static_cast<std::size_t>(std::max(1, frames));
  return fmt::format("series {}{}, {}, {} slice{} of {} x {}", number, title, modality, count, count == 1 ? "" : "s",
                     columns, rows);
}

DicomFolder scan_dicom(const std::filesystem::path& path, const Progress& progress) {
  gdcm::Trace::SetDebug(false);
  gdcm::Trace::SetWarning(false);
  gdcm::Trace::SetError(false);
  if (!std::filesystem::exists(path)) throw InputError(fmt::format("{}: there is no such folder", path.string()));

  DicomFolder folder;
  folder.path = path;
  const std::vector<std::filesystem::path> files = files_of(path);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (progress && i % 16 == 0)
      progress("looking for slices", static_cast<double>(i) / static_cast<double>(files.size()));
    if (!is_dicom(files[i])) continue;
    const std::optional<DicomSeries> found = read_header_within_budget(files[i]);
    if (!found) {
      folder.unreadable.push_back(files[i]);
      continue;
    }
    if (is_annotation(*found) || found->rows <= 0 || found->columns <= 0) {
      folder.other_objects.push_back({files[i], found->modality, found->description});
      continue;
    }
    const auto known = std::find_if(folder.series.begin(), folder.series.end(),
                                    [&](const DicomSeries& series) { return belong_together(series, *found); });
    if (known == folder.series.end()) {
      folder.series.push_back(*found);
    } else {
      known->slices.insert(known->slices.end(), found->slices.begin(), found->slices.end());
      known->compressed = known->compressed || found->compressed;
      known->lossy = known->lossy || found->lossy;
      known->jpeg_2000 = known->jpeg_2000 || found->jpeg_2000;
      known->lossy_ratio = std::max(known->lossy_ratio, found->lossy_ratio);
      known->bytes_allocated = std::max(known->bytes_allocated, found->bytes_allocated);
    }
  }
  set_strays_aside(folder);
  std::stable_sort(folder.series.begin(), folder.series.end(),
                   [](const DicomSeries& a, const DicomSeries& b) { return a.number < b.number; });
  return folder;
}

}  // namespace bodkin::io
