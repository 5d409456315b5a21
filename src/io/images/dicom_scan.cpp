#include "io/images/dicom_scan.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <new>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>
#include <gdcmAttribute.h>
#include <gdcmReader.h>
#include <gdcmTrace.h>

#include "core/error.h"
#include "io/images/image_format.h"
#include "io/images/memory_budget.h"
#include "io/text_encoding.h"

namespace bodkin::io {
namespace {

constexpr std::size_t most_files = 20000;
constexpr int deepest_folder = 8;
constexpr std::uintmax_t header_memory =
    32U << 20U;  // bytes that reading a header may take in addition to the file's own

std::string text_of(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  if (!data.FindDataElement(tag)) return {};
  const gdcm::ByteValue* bytes = data.GetDataElement(tag).GetByteValue();
  if (bytes == nullptr || bytes->GetPointer() == nullptr) return {};
  std::string text(bytes->GetPointer(), std::min<std::size_t>(bytes->GetLength(), 1024));
  text.erase(std::find(text.begin(), text.end(), '\0'), text.end());
  const auto last = text.find_last_not_of(' ');
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

// The numbers of a decimal string, "1\0\0"; empty when any of them is not a finite number or `count` does not fit.
std::vector<double> numbers_of(const gdcm::DataSet& data, const gdcm::Tag& tag, std::size_t count) {
  const std::string text = text_of(data, tag);
  std::vector<double> numbers;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find('\\', start), text.size());
    const std::string word = text.substr(start, end - start);
    char* rest = nullptr;
    const double value = std::strtod(word.c_str(), &rest);
    if (rest == word.c_str() || !std::isfinite(value)) return {};
    numbers.push_back(value);
    start = end + 1;
  }
  return numbers.size() == count ? numbers : std::vector<double>{};
}

double number_of(const gdcm::DataSet& data, const gdcm::Tag& tag, double otherwise) {
  const std::vector<double> numbers = numbers_of(data, tag, 1);
  return numbers.empty() ? otherwise : numbers.front();
}

int whole_number_of(const gdcm::DataSet& data, const gdcm::Tag& tag, int otherwise) {
  return static_cast<int>(std::clamp(number_of(data, tag, otherwise), -1e9, 1e9));
}

template <std::uint16_t Group, std::uint16_t Element>
int unsigned_short_of(const gdcm::DataSet& data) {
  const gdcm::Tag tag(Group, Element);
  if (!data.FindDataElement(tag)) return 0;
  const gdcm::ByteValue* bytes = data.GetDataElement(tag).GetByteValue();
  if (bytes == nullptr || bytes->GetLength() < 2) return 0;
  gdcm::Attribute<Group, Element> attribute;
  attribute.SetFromDataElement(data.GetDataElement(tag));
  return attribute.GetValue();
}

// Position, orientation and spacing; false when one is missing or makes no sense.
bool read_placement(const gdcm::DataSet& data, DicomSeries& series, DicomSlice& slice) {
  const std::vector<double> position = numbers_of(data, {0x0020, 0x0032}, 3);
  const std::vector<double> cosines = numbers_of(data, {0x0020, 0x0037}, 6);
  const std::vector<double> spacing = numbers_of(data, {0x0028, 0x0030}, 2);
  if (position.empty() || cosines.empty() || spacing.empty()) return false;
  slice.position = Vec3(position[0], position[1], position[2]);
  series.row_spacing = spacing[0];  // DICOM gives the spacing between rows first
  series.column_spacing = spacing[1];
  const Vec3 row(cosines[0], cosines[1], cosines[2]);
  const Vec3 column(cosines[3], cosines[4], cosines[5]);
  if (std::abs(row.norm() - 1.0) > 1e-2 || std::abs(column.norm() - 1.0) > 1e-2) return false;
  if (std::abs(row.dot(column)) > 1e-2) return false;
  series.row_direction = row.normalized();
  series.column_direction = (column - column.dot(series.row_direction) * series.row_direction).normalized();
  return std::min(spacing[0], spacing[1]) > 0.0;
}

// Whether the first bytes are those of a DICOM file; spares GDCM (and its patience) everything else.
bool is_dicom(const std::filesystem::path& file) {
  try {
    return detect_image_format(file) == ImageFormat::dicom;
  } catch (const InputError&) {
    return false;
  }
}

// One file's header: a series of a single slice. Nothing when it is damaged.
std::optional<DicomSeries> read_header(const std::filesystem::path& file) {
  static const std::set<gdcm::Tag> wanted = {{0x0008, 0x0016}, {0x0008, 0x0018}, {0x0008, 0x0060}, {0x0008, 0x103e},
                                             {0x0018, 0x0050}, {0x0020, 0x000e}, {0x0020, 0x0011}, {0x0020, 0x0032},
                                             {0x0020, 0x0037}, {0x0028, 0x0008}, {0x0028, 0x0010}, {0x0028, 0x0011},
                                             {0x0028, 0x0030}, {0x0028, 0x0100}, {0x0028, 0x1052}, {0x0028, 0x1053}};
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  if (!reader.ReadSelectedTags(wanted)) return std::nullopt;
  const gdcm::DataSet& data = reader.GetFile().GetDataSet();

  DicomSeries series;
  series.uid = text_of(data, {0x0020, 0x000e});
  series.description = printable(text_of(data, {0x0008, 0x103e}));
  series.modality = printable(text_of(data, {0x0008, 0x0060}));
  series.number = whole_number_of(data, {0x0020, 0x0011}, 0);
  series.rows = unsigned_short_of<0x0028, 0x0010>(data);
  series.columns = unsigned_short_of<0x0028, 0x0011>(data);
  series.frames = whole_number_of(data, {0x0028, 0x0008}, 1);
  series.bytes_allocated = (unsigned_short_of<0x0028, 0x0100>(data) + 7) / 8;
  series.compressed = reader.GetFile().GetHeader().GetDataSetTransferSyntax().IsEncapsulated();
  series.thickness = number_of(data, {0x0018, 0x0050}, 0.0);
  DicomSlice slice;
  slice.file = file;
  slice.instance_uid = text_of(data, {0x0008, 0x0018});
  slice.slope = number_of(data, {0x0028, 0x1053}, 1.0);
  slice.intercept = number_of(data, {0x0028, 0x1052}, 0.0);
  series.placed = read_placement(data, series, slice);
  series.slices.push_back(slice);
  return series;
}

// GDCM takes the memory for an element before it knows whether the file holds it.
std::optional<DicomSeries> read_header_within_budget(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  const MemoryBudget budget(header_memory + 4 * (error ? 0 : size));
  try {
    return read_header(file);
  } catch (const std::bad_alloc&) {
    return std::nullopt;
  } catch (const std::length_error&) {
    return std::nullopt;
  }
}

bool is_image(const DicomSeries& series) {
  const bool annotation = series.modality == "SEG" || series.modality.starts_with("RT");
  return series.rows > 0 && series.columns > 0 && !annotation;
}

bool belong_together(const DicomSeries& a, const DicomSeries& b) {
  return a.uid == b.uid && a.modality == b.modality && a.columns == b.columns && a.rows == b.rows &&
         a.frames == b.frames && a.placed == b.placed && std::abs(a.column_spacing - b.column_spacing) < 1e-4 &&
         std::abs(a.row_spacing - b.row_spacing) < 1e-4 && (a.row_direction - b.row_direction).norm() < 1e-3 &&
         (a.column_direction - b.column_direction).norm() < 1e-3;
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
  return fmt::format("series {}{}, {}, {} slice{} of {} x {}", number, title, modality, slices.size(),
                     slices.size() == 1 ? "" : "s", columns, rows);
}

DicomFolder scan_dicom(const std::filesystem::path& path, const Progress& progress) {
  gdcm::Trace::SetDebug(false);
  gdcm::Trace::SetWarning(false);
  gdcm::Trace::SetError(false);
  if (!std::filesystem::exists(path)) throw InputError(fmt::format("{}: there is no such folder", path.string()));

  DicomFolder folder;
  const std::vector<std::filesystem::path> files = files_of(path);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (progress && i % 16 == 0)
      progress("looking for slices", static_cast<double>(i) / static_cast<double>(files.size()));
    if (!is_dicom(files[i])) continue;
    const std::optional<DicomSeries> found = read_header_within_budget(files[i]);
    if (!found) {
      ++folder.unreadable;
      continue;
    }
    if (!is_image(*found)) {
      ++folder.other_objects;
      continue;
    }
    const auto known = std::find_if(folder.series.begin(), folder.series.end(),
                                    [&](const DicomSeries& series) { return belong_together(series, *found); });
    if (known == folder.series.end()) {
      folder.series.push_back(*found);
    } else {
      known->slices.push_back(found->slices.front());
      known->compressed = known->compressed || found->compressed;
      known->bytes_allocated = std::max(known->bytes_allocated, found->bytes_allocated);
    }
  }
  std::stable_sort(folder.series.begin(), folder.series.end(),
                   [](const DicomSeries& a, const DicomSeries& b) { return a.number < b.number; });
  return folder;
}

}  // namespace bodkin::io
