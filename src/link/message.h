#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "link/bytes.h"

namespace bodkin::link {

inline constexpr std::size_t header_size = 58;  // bytes, of every version

// One message of OpenIGTLink: what kind, of which device, when, and the content that the kind defines.
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
  std::uint64_t body_size = 0;  // bytes that follow
  std::uint64_t crc = 0;        // of the body
};

// CRC-64 of ECMA-182, as the protocol uses it: highest bit first, from 0, nothing inverted. `before`: that of the
// bytes that come before these.
std::uint64_t crc64(std::span<const std::uint8_t> bytes, std::uint64_t before = 0) noexcept;

// Header of version 1 and body. Throws InputError when the type or the device's name is too long for its field or
// empty (the type).
Bytes pack(const Message& message);
// The header alone, of version 1. Throws the same.
Bytes pack_header(const MessageHeader& header);

// Throws InputError for fewer than 58 bytes, a version of 0 or above 255, and a type or name that is not printable
// ASCII, which is how a stream that speaks another protocol looks.
MessageHeader read_header(std::span<const std::uint8_t> bytes);

// The message of a header and its body. Of version 2 and above the extended header and the metadata are left out.
// Throws InputError when the check sum is another one or the body is shorter than what it says of itself.
Message unpack(const MessageHeader& header, std::span<const std::uint8_t> body);

// s since 1970, as time stamps have it.
double time_now();

}  // namespace bodkin::link
