// Volumes of a case from anybody: any bytes are left to the image worker, refused with a sentence, or a volume of the
// size that its header declares.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "core/error.h"
#include "io/nrrd_header.h"
#include "io/nrrd_reader.h"

namespace {

// Shared memory is a file that costs no disk. Removed when the fuzzer ends.
class ScratchVolume {
 public:
  ScratchVolume()
      : path_(std::string(std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp") +
              ("/bodkin_nrrd_fuzz_" + std::to_string(getpid()) + ".nrrd")) {}
  ~ScratchVolume() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  ScratchVolume(const ScratchVolume&) = delete;
  ScratchVolume& operator=(const ScratchVolume&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

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
  static const ScratchVolume scratch;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  // What was understood is written as what is understood to be the same.
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
