#include "io/images/inflated_size.h"

#include <fstream>
#include <vector>

#include <zlib.h>

namespace bodkin::io {
namespace {

constexpr int any_header = 15 + 32;  // zlib's code for a gzip or a zlib header
constexpr std::size_t buffer_size = 1U << 18U;

struct Inflater {
  z_stream stream{};
  bool ready = inflateInit2(&stream, any_header) == Z_OK;
  Inflater() = default;
  ~Inflater() {
    if (ready) inflateEnd(&stream);
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
};

}  // namespace

std::optional<std::uintmax_t> inflated_size(const std::filesystem::path& file, std::uintmax_t offset,
                                            std::uintmax_t enough) {
  std::ifstream source(file, std::ios::binary);
  source.seekg(static_cast<std::streamoff>(offset));
  Inflater inflater;
  if (!source || !inflater.ready) return std::nullopt;
  std::vector<char> packed(buffer_size);
  std::vector<Bytef> unpacked(buffer_size);
  z_stream& stream = inflater.stream;
  std::uintmax_t total = 0;
  while (total <= enough) {
    if (stream.avail_in == 0) {
      source.read(packed.data(), static_cast<std::streamsize>(packed.size()));
      stream.avail_in = static_cast<uInt>(source.gcount());
      stream.next_in = reinterpret_cast<Bytef*>(packed.data());
      if (stream.avail_in == 0) return std::nullopt;  // the stream is cut off
    }
    stream.next_out = unpacked.data();
    stream.avail_out = static_cast<uInt>(unpacked.size());
    const int state = inflate(&stream, Z_NO_FLUSH);
    total += unpacked.size() - stream.avail_out;
    if (state == Z_STREAM_END) return total;
    if (state != Z_OK) return std::nullopt;
  }
  return total;
}

}  // namespace bodkin::io
