#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

// Values of DICOM elements as plain C++.

namespace gdcm {
class DataSet;
class Tag;
}  // namespace gdcm

namespace bodkin::io {

// A text without padding, at most 1024 bytes; empty when the element is missing.
std::string text_of(const gdcm::DataSet& data, const gdcm::Tag& tag);

// The numbers of a decimal string, "1\0\0"; empty when any of them is not a finite number, or, with `count`, when
// their number differs.
std::vector<double> numbers_of(const gdcm::DataSet& data, const gdcm::Tag& tag, std::size_t count = 0);

double number_of(const gdcm::DataSet& data, const gdcm::Tag& tag, double otherwise);
int whole_number_of(const gdcm::DataSet& data, const gdcm::Tag& tag, int otherwise);

// An unsigned short (US); `otherwise` when the element is missing.
int unsigned_short_of(const gdcm::DataSet& data, const gdcm::Tag& tag, int otherwise = 0);

// The items of a sequence, in order; they share their values with `data`. Empty when it is missing.
std::vector<gdcm::DataSet> items_of(const gdcm::DataSet& data, const gdcm::Tag& tag);

// The first item of a sequence, if there is one.
std::optional<gdcm::DataSet> first_item_of(const gdcm::DataSet& data, const gdcm::Tag& tag);

// Calls `read`, which reads the file with GDCM, allowing it `memory` bytes and four times the file's size: GDCM
// allocates the memory for an element before it knows whether the file contains it. False when it needed more, or
// returned false.
bool read_within_budget(const std::filesystem::path& file, std::uintmax_t memory, const std::function<bool()>& read);

}  // namespace bodkin::io
