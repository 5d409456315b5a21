// Untrusted camera images: any bytes are refused with a sentence, or give an image of the stated size, in grey and in
// colours.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "tracking/jpeg_file.h"

#include "core/error.h"

namespace {

template <typename Decode>
auto decoded(const Decode& decode) -> std::optional<decltype(decode())> {
  try {
    return decode();
  } catch (const bodkin::InputError&) {
    return std::nullopt;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto grey = decoded([&] { return bodkin::tracking::decode_jpeg_grey(bytes, "fuzz"); });
  const auto colours = decoded([&] { return bodkin::tracking::decode_jpeg(bytes, "fuzz"); });
  if (grey && grey->pixels.size() != static_cast<std::size_t>(grey->width) * static_cast<std::size_t>(grey->height))
    std::abort();
  if (grey && colours && (grey->width != colours->width || grey->height != colours->height)) std::abort();
  return 0;
}
