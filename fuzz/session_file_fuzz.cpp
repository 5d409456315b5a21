// Untrusted session files: any bytes are either refused with a sentence, or give a session.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

#include "fuzz/scratch_file.h"
#include "session/session_file.h"
#include "session/tick_codec.h"

#include "core/error.h"

namespace {

// The contents behind the checksums, which random bytes do not pass.
void decode(std::span<const std::uint8_t> bytes) {
  bodkin::simulation::TickRecord record;
  const std::size_t size = bodkin::session::encoded_tick_size();
  if (bytes.size() >= size && bodkin::session::decode_tick(bytes.first(size), record)) {
    std::vector<std::uint8_t> again;
    bodkin::session::encode_tick(record, again);
    if (!std::equal(again.begin(), again.end(), bytes.begin())) std::abort();
  }
  try {
    bodkin::session::tissues_of({.structures = {}, .tissues = {bytes.begin(), bytes.end()}}, "the input");
  } catch (const bodkin::InputError&) {
  }
  bodkin::forces::Event event;
  std::uint32_t tick = 0;
  if (bytes.size() >= bodkin::session::encoded_event_size) {
    const auto first = bytes.first(bodkin::session::encoded_event_size);
    std::vector<std::uint8_t> again;
    if (bodkin::session::decode_event(first, tick, event)) bodkin::session::encode_event(tick, event, again);
    if (!again.empty() && !std::equal(again.begin(), again.end(), first.begin())) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchFile scratch("session.bodkin");
  decode({data, size});
  std::ofstream(scratch.path(), std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    bodkin::session::read_session(scratch.path());
  } catch (const bodkin::InputError&) {
  }
  return 0;
}
