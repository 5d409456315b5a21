#include <chrono>
#include <cstdlib>
#include <iostream>

#include "patient/synthetic/lumbar.h"
#include "tests/io/images/test_images.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "io/image_worker.h"
#include "io/nrrd_writer.h"
#include "io/tissue_library_file.h"

// The size of a clinical CT: 512 x 512 x 300 slices of DICOM with labels, imported as `bodkin case new` does it.

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::patient;
namespace {

constexpr int columns = 512, rows = 512, slices = 300;

// A synthetic torso, stretched over the lattice of a scanner.
SyntheticPatient torso() {
  LumbarParameters parameters;
  parameters.spacing = 2.0;
  return synthesize_lumbar(parameters, default_tissue_library());
}

Vec3 place_in(const Grid& grid, int i, int j, int k) {
  return Vec3(i * (grid.size[0] - 1.0) / (columns - 1), j * (grid.size[1] - 1.0) / (rows - 1),
              k * (grid.size[2] - 1.0) / (slices - 1));
}

void write_series(const SyntheticPatient& patient, const test::ScratchFolder& folder) {
  const Grid& grid = patient.ct.grid;
  std::filesystem::create_directory(folder / "series");
  test::DicomSliceFile slice;
  slice.columns = columns;
  slice.rows = rows;
  slice.spacing = 0.7;
  slice.pixels.resize(static_cast<std::size_t>(columns) * rows);
  LabelVolume labels;
  labels.grid.size = {columns, rows, slices};
  labels.grid.spacing = Vec3(0.7, 0.7, 1.0);
  labels.voxels.reserve(labels.grid.voxel_count());
  for (int k = 0; k < slices; ++k) {
    slice.position = Vec3(0, 0, k);
    std::size_t pixel = 0;
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        const Vec3 index = place_in(grid, i, j, k);
        const double hounsfield = nearest_at_index(patient.ct, index, std::int16_t{-1000});
        slice.pixels[pixel++] = static_cast<std::uint16_t>(std::max(0.0, hounsfield + 1024.0));
        labels.voxels.push_back(nearest_at_index(patient.structures, index, std::uint16_t{0}));
      }
    }
    test::write_file(folder / ("series/" + std::to_string(k)), test::dicom_bytes(slice));
  }
  write_nrrd(labels, folder / "labels.nrrd");
}

TEST(LargeImport, a_clinical_series_with_labels_takes_seconds_and_less_than_two_and_a_half_gigabytes) {
#if defined(BODKIN_ADDRESS_SANITIZER) || defined(BODKIN_THREAD_SANITIZER)
  GTEST_SKIP() << "time and memory mean nothing under a sanitizer";
#endif
  setenv("BODKIN_IMAGES_WORKER", BODKIN_BUILD "/bin/bodkin-images", 0);
  const test::ScratchFolder folder;
  write_series(torso(), folder);
  const nlohmann::json request = {{"folder", (folder / "case").string()},
                                  {"ct", (folder / "series").string()},
                                  {"labels", (folder / "labels.nrrd").string()}};
  rusage before{}, after{};
  getrusage(RUSAGE_CHILDREN, &before);
  const auto start = std::chrono::steady_clock::now();
  const WorkerReport report = run_image_worker("case-new", request.dump(), "series", {});
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  getrusage(RUSAGE_CHILDREN, &after);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  const double processor =
      seconds(after.ru_utime) + seconds(after.ru_stime) - seconds(before.ru_utime) - seconds(before.ru_stime);
  const double gigabytes = static_cast<double>(after.ru_maxrss) / (1024.0 * 1024.0);  // KiB
  std::cout << "import of " << columns << " x " << rows << " x " << slices << ": " << wall.count() << " s, "
            << processor << " s of processor time, " << gigabytes << " GiB\n";
  EXPECT_EQ(nlohmann::json::parse(report.result).at("size"), (std::array<int, 3>{columns, rows, slices}));
  EXPECT_LT(gigabytes, 2.5);
  EXPECT_LT(processor, 60.0);  // 15 s on a quiet machine; a shared one is slower
}

}  // namespace
}  // namespace bodkin
