#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bodkin::link {

using Bytes = std::vector<std::uint8_t>;

// Appends numbers in network byte order, as OpenIGTLink requires.
class ByteWriter {
 public:
  void u8(std::uint8_t value) { bytes_.push_back(value); }
  void u16(std::uint16_t value) { number(value, 2); }
  void u32(std::uint32_t value) { number(value, 4); }
  void u64(std::uint64_t value) { number(value, 8); }
  void f32(float value);
  void f64(double value);
  // Exactly `size` bytes: longer text is truncated, shorter text is padded with zeros.
  void field(std::string_view text, std::size_t size);
  void raw(std::span<const std::uint8_t> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

  Bytes take() { return std::move(bytes_); }

 private:
  void number(std::uint64_t value, int size);

  Bytes bytes_;
};

// Reads what ByteWriter wrote. Throws InputError, which says how many bytes are missing, at a premature end.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint8_t u8() { return static_cast<std::uint8_t>(number(1)); }
  std::uint16_t u16() { return static_cast<std::uint16_t>(number(2)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(number(4)); }
  std::uint64_t u64() { return number(8); }
  float f32();
  double f64();
  // The text in a field of `size` bytes, up to its first zero.
  std::string field(std::size_t size);
  std::span<const std::uint8_t> raw(std::size_t size);
  std::size_t left() const noexcept { return bytes_.size() - at_; }

 private:
  std::uint64_t number(std::size_t size);

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

}  // namespace bodkin::link
