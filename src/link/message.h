#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "link/bytes.h"

namespace bodkin::link {

inline constexpr std::size_t header_size = 58;  // bytes, of every version

// One message of OpenIGTLink: kind, device, time, and the content defined by the kind.
struct Message {
  std::string type;    // at most 12 bytes: "TRANSFORM"
  std::string device;  // at most 20 bytes: "NeedleTipToReference"
  double time = 0.0;   // s since 1970
  Bytes content;
};

// The first 58 bytes.
struct MessageHeader {
  std::uint16_t version = 1;  // of the header: 1, or 2 and above with an extended header in the body
  std::string type, device;
  double time = 0.0;
  std::uint64_t body_size = 0;  // bytes that follow the header
  std::uint64_t crc = 0;        // of the body
};

// CRC-64 of ECMA-182, in the protocol's variant: highest bit first, starting at 0, nothing inverted. `before`: that
// of the preceding bytes.
std::uint64_t crc64(std::span<const std::uint8_t> bytes, std::uint64_t before = 0) noexcept;

// Header of version 1 and body. Throws InputError when the type or the device's name is too long for its field or
// empty (the type).
Bytes pack(const Message& message);
// Only the header, of version 1. Throws as pack() does.
Bytes pack_header(const MessageHeader& header);

// Throws InputError for fewer than 58 bytes, a version of 0 or above 255, and a type or name that is not printable
// ASCII, the signs of a stream of another protocol.
MessageHeader read_header(std::span<const std::uint8_t> bytes);

// The message of a header and its body. For version 2 and above the extended header and the metadata are skipped.
// Throws InputError when the checksum is wrong or the body is shorter than it states.
Message unpack(const MessageHeader& header, std::span<const std::uint8_t> body);

// s since 1970, for time stamps.
double time_now();

}  // namespace bodkin::link
