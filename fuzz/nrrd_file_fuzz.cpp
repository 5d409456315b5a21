// Untrusted volumes of a case: any bytes are left to the image worker, refused with a sentence, or give a volume of
// the declared size.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "fuzz/scratch_file.h"

#include "core/error.h"
#include "io/nrrd_header.h"
#include "io/nrrd_reader.h"

namespace {

template <typename Voxel>
void read(const std::string& file) {
  try {
    const auto volume = bodkin::io::read_nrrd<Voxel>(file);
    if (volume && volume->voxels.size() != volume->grid.voxel_count()) std::abort();
  } catch (const bodkin::InputError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchFile scratch("volume.nrrd");
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  // A parsed message is written so that it parses to the same.
  if (const auto parsed = bodkin::io::parse_nrrd_header(bytes)) {
    const auto again = bodkin::io::parse_nrrd_header(bodkin::io::nrrd_header_text(parsed->header));
    if (!again || again->header.steps != parsed->header.steps || again->header.size != parsed->header.size)
      std::abort();
  }
  std::ofstream(scratch.path(), std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(size));
  read<std::int16_t>(scratch.path());
  read<std::uint16_t>(scratch.path());
  read<std::uint8_t>(scratch.path());
  return 0;
}
