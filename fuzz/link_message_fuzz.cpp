// Untrusted OpenIGTLink: any bytes are refused with a sentence or parsed, and parsed contents are written unchanged.
// The checksum is corrected first, so that the fuzzer gets past it.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "link/command.h"
#include "link/contents.h"
#include "link/message.h"
#include "link/needle_state.h"
#include "link/tracked_tool.h"

#include "core/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace bodkin::link;
  const std::span<const std::uint8_t> bytes(data, size);
  Message message;
  try {
    MessageHeader header = read_header(bytes.first(std::min(size, header_size)));
    const std::span<const std::uint8_t> body = bytes.subspan(header_size);
    header.crc = crc64(body);
    message = unpack(header, body);
  } catch (const bodkin::InputError&) {
    return 0;
  }
  const Bytes written = pack(message);
  const Message again =
      unpack(read_header(std::span(written).first(header_size)), std::span(written).subspan(header_size));
  if (again.content != message.content || again.device != message.device || again.type != message.type) std::abort();
  try {
    if (const auto command = command_of(message)) reply_to(message, true, command->name, 0.0);
  } catch (const bodkin::InputError& error) {
    reply_to(message, false, error.what(), 0.0);
  }
  for (int kind = 0; kind < 8; ++kind) {
    try {
      if (kind == 0) read_transform(message.content);
      if (kind == 1) read_array(message.content);
      if (kind == 2) read_string(message.content);
      if (kind == 4) read_image(message.content);
      if (kind == 5) read_needle_state(message.content);
      if (kind == 7) read_status(message.content);
      if (kind == 6) read_surface_points(message.content);
      if (kind == 3) pose_of_tool(message, message.device);
    } catch (const bodkin::InputError&) {
      continue;
    }
  }
  return 0;
}
