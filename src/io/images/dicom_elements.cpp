#include "io/images/dicom_elements.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>
#include <stdexcept>

#include <gdcmDataSet.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmTag.h>

#include "io/images/memory_budget.h"

namespace bodkin::io {

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

std::vector<double> numbers_of(const gdcm::DataSet& data, const gdcm::Tag& tag, std::size_t count) {
  if (!data.FindDataElement(tag)) return {};
  const gdcm::ByteValue* bytes = data.GetDataElement(tag).GetByteValue();
  if (bytes == nullptr || bytes->GetPointer() == nullptr) return {};
  std::string text(bytes->GetPointer(), bytes->GetLength());
  text.erase(std::find(text.begin(), text.end(), '\0'), text.end());
  std::vector<double> numbers;
  for (const char* place = text.c_str();;) {
    char* rest = nullptr;
    const double value = std::strtod(place, &rest);
    if (rest == place || !std::isfinite(value)) return {};
    numbers.push_back(value);
    while (*rest == ' ') ++rest;
    if (*rest != '\\') break;
    place = rest + 1;
  }
  if (count > 0 && numbers.size() != count) return {};
  return numbers;
}

double number_of(const gdcm::DataSet& data, const gdcm::Tag& tag, double otherwise) {
  const std::vector<double> numbers = numbers_of(data, tag, 1);
  return numbers.empty() ? otherwise : numbers.front();
}

int whole_number_of(const gdcm::DataSet& data, const gdcm::Tag& tag, int otherwise) {
  return static_cast<int>(std::clamp(number_of(data, tag, otherwise), -1e9, 1e9));
}

int unsigned_short_of(const gdcm::DataSet& data, const gdcm::Tag& tag, int otherwise) {
  if (!data.FindDataElement(tag)) return otherwise;
  const gdcm::ByteValue* bytes = data.GetDataElement(tag).GetByteValue();
  if (bytes == nullptr || bytes->GetPointer() == nullptr || bytes->GetLength() < 2) return otherwise;
  // GDCM keeps values in the byte order of little endian files on this kind of processor.
  const auto* raw = reinterpret_cast<const unsigned char*>(bytes->GetPointer());
  return raw[0] + 256 * raw[1];
}

std::vector<gdcm::DataSet> items_of(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  std::vector<gdcm::DataSet> items;
  if (!data.FindDataElement(tag)) return items;
  const gdcm::SmartPointer<gdcm::SequenceOfItems> sequence = data.GetDataElement(tag).GetValueAsSQ();
  if (!sequence) return items;
  for (gdcm::SequenceOfItems::SizeType n = 1; n <= sequence->GetNumberOfItems(); ++n)
    items.push_back(sequence->GetItem(n).GetNestedDataSet());
  return items;
}

std::optional<gdcm::DataSet> first_item_of(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  if (!data.FindDataElement(tag)) return std::nullopt;
  const gdcm::SmartPointer<gdcm::SequenceOfItems> sequence = data.GetDataElement(tag).GetValueAsSQ();
  if (!sequence || sequence->GetNumberOfItems() == 0) return std::nullopt;
  return sequence->GetItem(1).GetNestedDataSet();
}

bool read_within_budget(const std::filesystem::path& file, std::uintmax_t memory, const std::function<bool()>& read) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  const MemoryBudget budget(memory + 4 * (error ? 0 : size));
  try {
    return read();
  } catch (const std::bad_alloc&) {
    return false;
  } catch (const std::length_error&) {
    return false;
  }
}

}  // namespace bodkin::io
