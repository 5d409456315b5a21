#include "io/images/dicom_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <new>
#include <span>
#include <stdexcept>

#include <fmt/format.h>
#include <gdcmImage.h>
#include <gdcmImageReader.h>
#include <gdcmSequenceOfFragments.h>

#include "core/error.h"
#include "core/parallel_for.h"
#include "io/images/dicom_extent.h"
#include "io/images/image_file.h"
#include "io/images/memory_budget.h"

namespace bodkin::io {
namespace {

// A uniform image compresses to almost nothing, so the bound on compressed slices is wide; it only prevents a file of
// a few bytes from claiming gigabytes.
constexpr double compressed_limit = 5000.0;

constexpr int workers = 2;  // files decoded at a time
constexpr std::uintmax_t decoding_memory =
    96U << 20U;  // bytes in addition to the slices' own: stacks and heaps of threads

// The slices in one file: one, or the frames of an enhanced image.
using FileSlices = std::vector<std::size_t>;

std::vector<FileSlices> by_file(const DicomSeries& series) {
  std::map<std::filesystem::path, std::size_t> known;
  std::vector<FileSlices> files;
  for (std::size_t n = 0; n < series.slices.size(); ++n) {
    const auto [place, is_new] = known.emplace(series.slices[n].file, files.size());
    if (is_new) files.emplace_back();
    files[place->second].push_back(n);
  }
  return files;
}

void require_plausible_file(const DicomSeries& series, const FileSlices& slices) {
  const std::filesystem::path& file = series.slices[slices.front()].file;
  std::error_code error;
  const auto bytes = static_cast<double>(std::filesystem::file_size(file, error));
  require_plausible_size(
      file.string(),
      {static_cast<std::uintmax_t>(series.columns), static_cast<std::uintmax_t>(series.rows), slices.size()},
      static_cast<std::uintmax_t>(std::max(1, series.bytes_allocated)),
      error ? 0.0 : bytes * (series.compressed ? compressed_limit : 1.0));
}

template <typename Stored>
void rescale(const char* bytes, const DicomSlice& slice, std::span<std::int16_t> pixels, HounsfieldLosses& losses) {
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    Stored stored{};
    std::memcpy(&stored, bytes + i * sizeof(Stored), sizeof(Stored));
    pixels[i] = to_hounsfield(slice.slope * static_cast<double>(stored) + slice.intercept, losses);
  }
}

void rescale(const gdcm::PixelFormat& format, const char* bytes, const DicomSlice& slice,
             std::span<std::int16_t> pixels, HounsfieldLosses& losses) {
  switch (format.GetScalarType()) {
    case gdcm::PixelFormat::UINT8:
      return rescale<std::uint8_t>(bytes, slice, pixels, losses);
    case gdcm::PixelFormat::INT8:
      return rescale<std::int8_t>(bytes, slice, pixels, losses);
    case gdcm::PixelFormat::UINT16:
      return rescale<std::uint16_t>(bytes, slice, pixels, losses);
    case gdcm::PixelFormat::INT16:
      return rescale<std::int16_t>(bytes, slice, pixels, losses);
    case gdcm::PixelFormat::UINT32:
      return rescale<std::uint32_t>(bytes, slice, pixels, losses);
    case gdcm::PixelFormat::INT32:
      return rescale<std::int32_t>(bytes, slice, pixels, losses);
    default:
      break;
  }
  throw InputError(fmt::format("{}: the pixels are stored as {}; expected whole numbers of 8, 16 or 32 bits",
                               slice.file.string(), format.GetScalarTypeAsString()));
}

bool read_pixels_within_budget(gdcm::ImageReader& reader) {
  try {
    return reader.Read();
  } catch (const std::bad_alloc&) {
    return false;
  } catch (const std::length_error&) {
    return false;
  }
}

// The compression loss stated in the first coded piece of the pixels, in HU.
std::optional<CodingError> loss_of(const gdcm::File& file, double slope) {
  const gdcm::Tag pixel_data(0x7fe0, 0x0010);
  if (!file.GetDataSet().FindDataElement(pixel_data)) return std::nullopt;
  const gdcm::SequenceOfFragments* pieces = file.GetDataSet().GetDataElement(pixel_data).GetSequenceOfFragments();
  if (pieces == nullptr || pieces->GetNumberOfFragments() == 0) return std::nullopt;
  const gdcm::ByteValue* coded = pieces->GetFragment(0).GetByteValue();
  if (coded == nullptr || coded->GetPointer() == nullptr) return std::nullopt;
  std::optional<CodingError> error = coding_error({coded->GetPointer(), coded->GetLength()});
  if (error) {
    error->largest *= std::abs(slope);
    error->typical *= std::abs(slope);
  }
  return error;
}

// The accumulators of one thread.
struct Gathered {
  HounsfieldLosses losses;
  std::optional<CodingError> coding;
  std::vector<DamagedSlice> damaged;
};

void keep_larger(std::optional<CodingError>& sum, const std::optional<CodingError>& part) {
  if (part && (!sum || part->largest > sum->largest)) sum = part;
}

void decode_file(const DicomSeries& series, const FileSlices& slices, std::span<std::int16_t> voxels,
                 Gathered& gathered) {
  const DicomSlice& first = series.slices[slices.front()];
  const std::string name = first.file.string();
  require_plausible_file(series, slices);
  gdcm::ImageReader reader;
  reader.SetFileName(first.file.c_str());
  const bool read = !dicom_extent(first.file).pixels_cut && read_pixels_within_budget(reader);
  const gdcm::Image& image = reader.GetImage();
  const gdcm::PixelFormat format = read ? image.GetPixelFormat() : gdcm::PixelFormat();
  if (read && format.GetSamplesPerPixel() != 1) {
    throw InputError(
        fmt::format("{}: a pixel holds {} numbers (colours); expected one", name, format.GetSamplesPerPixel()));
  }
  const bool same_size = read && image.GetNumberOfDimensions() >= 2 &&
                         static_cast<int>(image.GetDimension(0)) == series.columns &&
                         static_cast<int>(image.GetDimension(1)) == series.rows;
  const std::size_t slice_size = static_cast<std::size_t>(series.columns) * static_cast<std::size_t>(series.rows);
  const std::size_t slice_bytes = slice_size * format.GetPixelSize();
  std::vector<char> bytes;
  bool decoded = same_size && image.GetBufferLength() == slice_bytes * slices.size();
  if (decoded) {
    bytes.resize(slice_bytes * slices.size());
    decoded = image.GetBuffer(bytes.data());
  }
  if (!decoded) {
    throw InputError(
        fmt::format("{}: the pixels of this slice cannot be decoded; the file is truncated or damaged, copy "
                    "it again",
                    name));
  }
  for (const std::size_t n : slices) {
    const DicomSlice& slice = series.slices[n];
    rescale(format, bytes.data() + static_cast<std::size_t>(slice.frame) * slice_bytes, slice,
            voxels.subspan(n * slice_size, slice_size), gathered.losses);
  }
  keep_larger(gathered.coding, loss_of(reader.GetFile(), first.slope));
}

void add(HounsfieldLosses& sum, const HounsfieldLosses& part) {
  sum.largest_rounding = std::max(sum.largest_rounding, part.largest_rounding);
  sum.padded += part.padded;
  sum.too_high += part.too_high;
  sum.not_numbers += part.not_numbers;
}

// The error of the first file, unless some file is large enough for its header's claim.
void require_a_plausible_file(const DicomSeries& series, const std::vector<FileSlices>& files) {
  std::string first;
  for (const FileSlices& slices : files) {
    try {
      require_plausible_file(series, slices);
      return;
    } catch (const InputError& error) {
      if (first.empty()) first = error.what();
    }
  }
  throw InputError(first);
}

}  // namespace

DecodedSlices decode_slices(const DicomSeries& series, HounsfieldLosses& losses, const Progress& progress) {
  const std::vector<FileSlices> files = by_file(series);
  require_a_plausible_file(series, files);
  const std::size_t slice_size = static_cast<std::size_t>(series.columns) * static_cast<std::size_t>(series.rows);
  DecodedSlices result;
  result.voxels.assign(series.slices.size() * slice_size, anatomy::lowest_hounsfield);

  // GDCM allocates the memory for an element before checking that the file contains it. A codec needs a few copies of
  // a slice.
  std::uintmax_t largest_file = 0, most_frames = 1;
  for (const FileSlices& slices : files) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(series.slices[slices.front()].file, error);
    largest_file = std::max(largest_file, error ? 0 : size);
    most_frames = std::max<std::uintmax_t>(most_frames, slices.size());
  }
  const MemoryBudget budget(decoding_memory +
                            workers * (4 * largest_file + (32 + 8 * (most_frames - 1)) * slice_size));

  std::array<Gathered, workers> parts;
  parallel_for(
      files.size(), "decoding slices", progress,
      [&](std::size_t file, int thread) {
        Gathered& gathered = parts[static_cast<std::size_t>(thread)];
        try {
          decode_file(series, files[file], result.voxels, gathered);
        } catch (const InputError& error) {
          for (const std::size_t slice : files[file]) gathered.damaged.push_back({slice, error.what()});
        }
      },
      workers);
  for (const Gathered& part : parts) {
    add(losses, part.losses);
    keep_larger(result.coding, part.coding);
    result.damaged.insert(result.damaged.end(), part.damaged.begin(), part.damaged.end());
  }
  std::sort(result.damaged.begin(), result.damaged.end(),
            [](const DamagedSlice& a, const DamagedSlice& b) { return a.slice < b.slice; });
  if (result.damaged.size() == series.slices.size()) throw InputError(result.damaged.front().sentence);
  return result;
}

}  // namespace bodkin::io
