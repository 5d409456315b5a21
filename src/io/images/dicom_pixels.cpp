#include "io/images/dicom_pixels.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <span>
#include <stdexcept>

#include <fmt/format.h>
#include <gdcmImage.h>
#include <gdcmImageReader.h>

#include "core/error.h"
#include "core/parallel_for.h"
#include "io/images/image_file.h"
#include "io/images/memory_budget.h"

namespace bodkin::io {
namespace {

// An image of one value packs into almost nothing, so the bound on compressed slices is wide; it only has to keep a
// file of a few bytes from asking for gigabytes.
constexpr double compressed_limit = 5000.0;

constexpr int workers = 2;  // slices decoded at a time
constexpr std::uintmax_t decoding_memory =
    96U << 20U;  // bytes in addition to the slices' own: stacks and heaps of threads

void require_plausible_slice(const DicomSeries& series, const DicomSlice& slice) {
  std::error_code error;
  const auto bytes = static_cast<double>(std::filesystem::file_size(slice.file, error));
  require_plausible_size(slice.file.string(),
                         {static_cast<std::uintmax_t>(series.columns), static_cast<std::uintmax_t>(series.rows)},
                         static_cast<std::uintmax_t>(std::max(1, series.bytes_allocated)),
                         error ? 0.0 : bytes * (series.compressed ? compressed_limit : 1.0));
}

template <typename Stored>
void rescale(const std::vector<char>& bytes, const DicomSlice& slice, std::span<std::int16_t> pixels,
             HounsfieldLosses& losses) {
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    Stored stored{};
    std::memcpy(&stored, bytes.data() + i * sizeof(Stored), sizeof(Stored));
    pixels[i] = to_hounsfield(slice.slope * static_cast<double>(stored) + slice.intercept, losses);
  }
}

bool read_within_budget(gdcm::ImageReader& reader) {
  try {
    return reader.Read();
  } catch (const std::bad_alloc&) {
    return false;
  } catch (const std::length_error&) {
    return false;
  }
}

void decode_slice(const DicomSeries& series, const DicomSlice& slice, std::span<std::int16_t> pixels,
                  HounsfieldLosses& losses) {
  const std::string name = slice.file.string();
  require_plausible_slice(series, slice);
  gdcm::ImageReader reader;
  reader.SetFileName(slice.file.c_str());
  const bool read = read_within_budget(reader);
  const gdcm::Image& image = reader.GetImage();
  const gdcm::PixelFormat format = read ? image.GetPixelFormat() : gdcm::PixelFormat();
  if (read && format.GetSamplesPerPixel() != 1) {
    throw InputError(
        fmt::format("{}: a pixel holds {} numbers (colours); expected one", name, format.GetSamplesPerPixel()));
  }
  const bool same_size = read && image.GetNumberOfDimensions() >= 2 &&
                         static_cast<int>(image.GetDimension(0)) == series.columns &&
                         static_cast<int>(image.GetDimension(1)) == series.rows;
  const std::size_t needed = pixels.size() * format.GetPixelSize();
  std::vector<char> bytes;
  bool decoded = same_size && image.GetBufferLength() == needed;
  if (decoded) {
    bytes.resize(needed);
    decoded = image.GetBuffer(bytes.data());
  }
  if (!decoded) {
    throw InputError(
        fmt::format("{}: the pixels of this slice cannot be decoded; the file is truncated or damaged, copy "
                    "it again",
                    name));
  }
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
  throw InputError(fmt::format("{}: the pixels are stored as {}; expected whole numbers of 8, 16 or 32 bits", name,
                               format.GetScalarTypeAsString()));
}

void add(HounsfieldLosses& sum, const HounsfieldLosses& part) {
  sum.largest_rounding = std::max(sum.largest_rounding, part.largest_rounding);
  sum.padded += part.padded;
  sum.too_high += part.too_high;
  sum.not_numbers += part.not_numbers;
}

}  // namespace

std::vector<std::int16_t> decode_slices(const DicomSeries& series, HounsfieldLosses& losses,
                                        const Progress& progress) {
  const std::size_t slices = series.slices.size();
  require_plausible_slice(series, series.slices.front());
  const std::size_t slice_size = static_cast<std::size_t>(series.columns) * static_cast<std::size_t>(series.rows);
  std::vector<std::int16_t> voxels(slices * slice_size);

  // GDCM takes the memory for an element before it knows whether the file holds it. A codec needs a few copies of a
  // slice.
  std::uintmax_t largest_file = 0;
  for (const DicomSlice& slice : series.slices) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(slice.file, error);
    largest_file = std::max(largest_file, error ? 0 : size);
  }
  const MemoryBudget budget(decoding_memory + workers * (4 * largest_file + 32 * slice_size));

  std::array<HounsfieldLosses, workers> lost;
  parallel_for(
      slices, "decoding slices", progress,
      [&](std::size_t slice, int thread) {
        decode_slice(series, series.slices[slice], std::span(voxels).subspan(slice * slice_size, slice_size),
                     lost[static_cast<std::size_t>(thread)]);
      },
      workers);
  for (const HounsfieldLosses& part : lost) add(losses, part);
  return voxels;
}

}  // namespace bodkin::io
