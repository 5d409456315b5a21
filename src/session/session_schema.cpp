#include "session/session_schema.h"

#include <bit>

#include <fmt/format.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "core/error.h"

namespace bodkin::session {

void refuse_session(const std::string& file, const std::string& fault) {
  throw InputError(fmt::format("{}: {}; give a session file that 'bodkin run' wrote", file, fault));
}

std::int64_t chunk_checksum(std::uint64_t first_tick, std::uint32_t ticks, std::uint32_t events,
                            std::span<const std::uint8_t> data) {
  // The position is in the seed, so that exchanged chunks are detected.
  const std::uint64_t place = first_tick * 0x9E3779B97F4A7C15ULL + (std::uint64_t{ticks} << 32) + events;
  return std::bit_cast<std::int64_t>(
      static_cast<std::uint64_t>(XXH3_64bits_withSeed(data.data(), data.size(), place)));
}

std::int64_t data_checksum(std::span<const std::uint8_t> data) {
  return std::bit_cast<std::int64_t>(static_cast<std::uint64_t>(XXH3_64bits(data.data(), data.size())));
}

std::string text_checksum(const std::string& text) {
  return fmt::format("{:016x}", static_cast<std::uint64_t>(XXH3_64bits(text.data(), text.size())));
}

}  // namespace bodkin::session
