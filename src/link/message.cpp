#include "link/message.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::link {

namespace {

constexpr std::size_t type_size = 12, device_size = 20;
constexpr std::uint64_t crc_polynomial = 0x42F0E1EBA9EA3693ULL;
constexpr double fraction = 4294967296.0;  // of a second, in a time stamp; also the seconds that one can hold
constexpr std::uint16_t newest_version = 255;

constexpr std::array<std::uint64_t, 256> crc_table = [] {
  std::array<std::uint64_t, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    std::uint64_t value = static_cast<std::uint64_t>(i) << 56U;
    for (int bit = 0; bit < 8; ++bit) value = (value << 1U) ^ ((value >> 63U) != 0 ? crc_polynomial : 0);
    table[i] = value;
  }
  return table;
}();

void check_name(const std::string& name, std::size_t size, const char* what) {
  if (name.size() <= size) return;
  throw InputError(
      fmt::format("the {} of a message is '{}', {} bytes; expected at most {}", what, name, name.size(), size));
}

// Seconds since 1970 as in the header, in 2^-32 s. A time out of range becomes the nearest representable one: a stamp
// read from a header may, as a double, lie just beyond the last.
std::uint64_t time_stamp(double seconds) {
  const double last = std::nextafter(fraction, 0.0);
  if (!(seconds > 0)) return 0;
  return static_cast<std::uint64_t>(std::min(seconds, last) * fraction);
}

// Whether the type name is one of the protocol's; a line of text is not.
bool is_type(const std::string& text) {
  return text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") == std::string::npos;
}

bool is_printable(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

}  // namespace

std::uint64_t crc64(std::span<const std::uint8_t> bytes, std::uint64_t before) noexcept {
  std::uint64_t crc = before;
  for (const std::uint8_t byte : bytes) crc = crc_table[(crc >> 56U) ^ byte] ^ (crc << 8U);
  return crc;
}

Bytes pack_header(const MessageHeader& header) {
  check_name(header.type, type_size, "type");
  check_name(header.device, device_size, "device name");
  if (header.type.empty()) throw InputError("a message has no type, expected one such as TRANSFORM");
  ByteWriter writer;
  writer.u16(1);
  writer.field(header.type, type_size);
  writer.field(header.device, device_size);
  writer.u64(time_stamp(header.time));
  writer.u64(header.body_size);
  writer.u64(header.crc);
  return writer.take();
}

Bytes pack(const Message& message) {
  const std::uint64_t crc = crc64(message.content);
  Bytes bytes = pack_header({1, message.type, message.device, message.time, message.content.size(), crc});
  bytes.insert(bytes.end(), message.content.begin(), message.content.end());
  return bytes;
}

MessageHeader read_header(std::span<const std::uint8_t> bytes) {
  ByteReader reader(bytes.first(std::min(bytes.size(), header_size)));
  MessageHeader header;
  header.version = reader.u16();
  header.type = reader.field(type_size);
  header.device = reader.field(device_size);
  const std::uint32_t seconds = reader.u32(), parts = reader.u32();
  header.time = static_cast<double>(seconds) + static_cast<double>(parts) / fraction;
  header.body_size = reader.u64();
  header.crc = reader.u64();
  const bool is_known_version = header.version != 0 && header.version <= newest_version;
  if (header.type.empty() || !is_printable(header.type) || !is_printable(header.device) ||
      (!is_known_version && !is_type(header.type)))
    throw InputError("this is not a header of OpenIGTLink; the other side speaks another protocol");
  if (!is_known_version) {
    throw InputError(fmt::format(
        "the header of a message has version {}, expected 1 or 2; let the other side speak OpenIGTLink 1 to 3",
        header.version));
  }
  return header;
}

Message unpack(const MessageHeader& header, std::span<const std::uint8_t> body) {
  if (const std::uint64_t found = crc64(body); found != header.crc) {
    throw InputError(fmt::format("a message {} of '{}' arrived damaged: its check sum is {:016x}, expected {:016x}",
                                 header.type, header.device, found, header.crc));
  }
  if (header.version >= 2) {
    ByteReader extended(body);
    const std::size_t size = extended.u16(), metadata_header = extended.u16(), metadata = extended.u32();
    const std::size_t around = size + metadata_header + metadata;
    if (size < 12 || around > body.size()) {
      throw InputError(fmt::format("the extended header of a message {} names {} bytes in a body of {}", header.type,
                                   around, body.size()));
    }
    body = body.subspan(size, body.size() - around);
  }
  return {header.type, header.device, header.time, Bytes(body.begin(), body.end())};
}

double time_now() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace bodkin::link
