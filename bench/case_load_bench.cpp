// The cost of opening a case, the first step of every command: the synthetic lumbar torso of 1 mm as `bodkin case
// synthesize` writes it, with warm disk caches.
#include <filesystem>
#include <string>

#include "patient/synthetic/lumbar.h"
#include <benchmark/benchmark.h>
#include <unistd.h>

#include "io/case_folder.h"
#include "io/digest.h"
#include "io/nrrd_reader.h"
#include "io/nrrd_writer.h"
#include "io/tissue_library_file.h"

namespace {

using namespace bodkin;
using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::patient;

// A case on disk, removed at the end of the program.
class CaseOnDisk {
 public:
  CaseOnDisk() : folder_(std::filesystem::temp_directory_path() / ("bodkin_case_load_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
    const SyntheticPatient patient = synthesize_lumbar({}, default_tissue_library());
    CaseDescription description;
    description.name = "torso";
    description.structures = patient.structure_table;
    description.ct_file = add("ct.nrrd", patient.ct, description.ct_digest);
    description.structures_file = add("structures.nrrd", patient.structures, description.structures_digest);
    description.tissues_file = add("tissues.nrrd", patient.tissues, description.tissues_digest);
    write_case_description(description, folder_);
  }
  ~CaseOnDisk() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  CaseOnDisk(const CaseOnDisk&) = delete;
  CaseOnDisk& operator=(const CaseOnDisk&) = delete;
  const std::filesystem::path& folder() const { return folder_; }

 private:
  template <typename Voxel>
  std::string add(const char* file, const Volume<Voxel>& volume, std::string& digest) const {
    write_nrrd(volume, folder_ / file);
    digest = volume_digest(volume);
    return file;
  }

  std::filesystem::path folder_;
};

const std::filesystem::path& torso() {
  static const CaseOnDisk made;
  return made.folder();
}

void whole_case(benchmark::State& state) {
  const std::filesystem::path& folder = torso();
  for (auto _ : state) benchmark::DoNotOptimize(load_case(folder).ct.voxels.data());
}
BENCHMARK(whole_case)->Unit(benchmark::kMillisecond)->UseRealTime();

void description_alone(benchmark::State& state) {
  const std::filesystem::path& folder = torso();
  for (auto _ : state) benchmark::DoNotOptimize(read_case_description(folder).name.data());
}
BENCHMARK(description_alone)->Unit(benchmark::kMillisecond);

template <typename Voxel>
void read_volume(benchmark::State& state, const char* file) {
  const std::filesystem::path path = torso() / file;
  std::size_t bytes = 0;
  for (auto _ : state) {
    const auto volume = read_nrrd<Voxel>(path);
    bytes += volume->voxels.size() * sizeof(Voxel);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
}
void ct_alone(benchmark::State& state) {
  read_volume<std::int16_t>(state, "ct.nrrd");
}
BENCHMARK(ct_alone)->Unit(benchmark::kMillisecond);
void structures_alone(benchmark::State& state) {
  read_volume<std::uint16_t>(state, "structures.nrrd");
}
BENCHMARK(structures_alone)->Unit(benchmark::kMillisecond);
void tissues_alone(benchmark::State& state) {
  read_volume<std::uint8_t>(state, "tissues.nrrd");
}
BENCHMARK(tissues_alone)->Unit(benchmark::kMillisecond);

void digest_of_the_ct(benchmark::State& state) {
  const auto ct = read_nrrd<std::int16_t>(torso() / "ct.nrrd");
  for (auto _ : state) benchmark::DoNotOptimize(volume_digest(*ct).data());
}
BENCHMARK(digest_of_the_ct)->Unit(benchmark::kMillisecond);

}  // namespace
