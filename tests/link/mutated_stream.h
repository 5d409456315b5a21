#pragma once

#include <algorithm>
#include <array>

#include "link/contents.h"
#include "link/message.h"

#include "core/random.h"

namespace bodkin::link {

// Data of a broken or hostile client: successive messages, sound, truncated, with altered bytes, of other versions,
// with wrong sizes, and sometimes with a corrected checksum.
inline Bytes mutated_stream(Random& random) {
  const std::array<Message, 5> seeds = {
      {{"STRING", "CMD_1", 0.0, string_content("<Command Name=\"Freeze\" On=\"true\"/>")},
       {"STT_TDATA", "Client", 0.0, Bytes(36, 0)},
       {"GET_STATUS", "", 0.0, {}},
       {"COMMAND", "x", 0.0, Bytes(150, 'a')},
       {"TRANSFORM", "NeedleToReference", 0.0, transform_content(Pose::Identity())}}};
  Bytes stream;
  const std::uint64_t count = 1 + random.next() % 6;
  for (std::uint64_t i = 0; i < count; ++i) {
    Bytes bytes = pack(seeds[random.next() % seeds.size()]);
    const std::uint64_t changes = random.next() % 4;
    for (std::uint64_t change = 0; change < changes; ++change) {
      const std::size_t at = random.next() % bytes.size();
      bytes[at] = static_cast<std::uint8_t>(random.next());
    }
    switch (random.next() % 6) {
      case 0:
        bytes.resize(random.next() % bytes.size());
        break;
      case 1:
        bytes.insert(bytes.end(), random.next() % 200, static_cast<std::uint8_t>(random.next()));
        break;
      case 2: {  // a body of other bytes whose check sum is right
        const std::uint64_t crc = crc64(std::span<const std::uint8_t>(bytes).subspan(header_size));
        for (std::size_t byte = 0; byte < 8; ++byte)
          bytes[50 + byte] = static_cast<std::uint8_t>(crc >> (56U - 8U * byte));
        break;
      }
      case 3:
        bytes[1] = 2;  // with an extended header that is none
        break;
      default:
        break;
    }
    stream.insert(stream.end(), bytes.begin(), bytes.end());
    if (stream.empty()) stream.push_back(0);
  }
  return stream;
}

}  // namespace bodkin::link
