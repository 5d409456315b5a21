#include "link/bytes.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::link {

void ByteWriter::number(std::uint64_t value, int size) {
  for (int i = size - 1; i >= 0; --i) bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

void ByteWriter::f32(float value) {
  u32(std::bit_cast<std::uint32_t>(value));
}

void ByteWriter::f64(double value) {
  u64(std::bit_cast<std::uint64_t>(value));
}

void ByteWriter::field(std::string_view text, std::size_t size) {
  const std::size_t kept = std::min(text.size(), size);
  bytes_.insert(bytes_.end(), text.begin(), text.begin() + static_cast<std::ptrdiff_t>(kept));
  bytes_.insert(bytes_.end(), size - kept, 0);
}

std::span<const std::uint8_t> ByteReader::raw(std::size_t size) {
  if (size > left())
    throw InputError(fmt::format("the message ends {} bytes too early, {} were expected", size - left(), size));
  const std::span<const std::uint8_t> found = bytes_.subspan(at_, size);
  at_ += size;
  return found;
}

std::uint64_t ByteReader::number(std::size_t size) {
  std::uint64_t value = 0;
  for (const std::uint8_t byte : raw(size)) value = (value << 8U) | byte;
  return value;
}

float ByteReader::f32() {
  return std::bit_cast<float>(u32());
}

double ByteReader::f64() {
  return std::bit_cast<double>(u64());
}

std::string ByteReader::field(std::size_t size) {
  const std::span<const std::uint8_t> found = raw(size);
  return {found.begin(), std::find(found.begin(), found.end(), std::uint8_t{0})};
}

}  // namespace bodkin::link
