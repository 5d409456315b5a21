#include "scene/surface_cache.h"

#include <filesystem>
#include <fstream>

#include "scene/export_surfaces.h"
#include "tests/scene/test_bodies.h"
#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkXMLPolyDataReader.h>

#include "core/error.h"

namespace bodkin::scene {
namespace {

namespace fs = std::filesystem;

class SurfaceFiles : public testing::Test {
 protected:
  SurfaceFiles() { fs::remove_all(folder_); }
  ~SurfaceFiles() override { fs::remove_all(folder_); }

  fs::path folder_ = fs::path(testing::TempDir()) /
                     (std::string("bodkin_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(SurfaceFiles, come_back_as_they_were_written) {
  const PatientSurfaces& surfaces = ball_surfaces();
  write_surfaces(surfaces, "abc", folder_ / "surfaces.vtp");
  const std::optional<PatientSurfaces> back = read_surfaces(folder_ / "surfaces.vtp", "abc");
  ASSERT_TRUE(back);
  ASSERT_EQ(back->parts.size(), surfaces.parts.size());
  for (std::size_t p = 0; p < surfaces.parts.size(); ++p) {
    const PatientSurface &was = surfaces.parts[p], &is = back->parts[p];
    EXPECT_EQ(is.kind, was.kind);
    EXPECT_EQ(is.name, was.name);
    EXPECT_EQ(is.colour, was.colour);
    EXPECT_EQ(is.mesh.triangles, was.mesh.triangles);
    EXPECT_EQ(is.mesh.points, was.mesh.points);
    EXPECT_EQ(is.mesh.normals, was.mesh.normals);
    EXPECT_EQ(is.mesh.openness, was.mesh.openness);
  }
}

TEST_F(SurfaceFiles, of_other_tissues_damaged_or_absent_are_not_used) {
  const fs::path file = folder_ / "surfaces.vtp";
  EXPECT_FALSE(read_surfaces(file, "abc"));
  write_surfaces(ball_surfaces(), "abc", file);
  EXPECT_FALSE(read_surfaces(file, "other"));
  fs::resize_file(file, fs::file_size(file) / 2);
  EXPECT_FALSE(read_surfaces(file, "abc"));
  std::ofstream(file) << "not a surface";
  EXPECT_FALSE(read_surfaces(file, "abc"));
}

TEST_F(SurfaceFiles, are_kept_beside_the_case_and_made_anew_for_other_tissues) {
  fs::create_directories(folder_);
  const anatomy::TissueVolume tissues = ball_of_tissues(2.0);
  int steps = 0;
  const Progress count = [&steps](std::string_view, double) { ++steps; };
  const PatientSurfaces made = surfaces_of_case(tissues, folder_, count);
  EXPECT_GT(steps, 0);
  steps = 0;
  const PatientSurfaces kept = surfaces_of_case(tissues, folder_, count);
  EXPECT_EQ(steps, 0);
  EXPECT_EQ(kept.skin().points, made.skin().points);
  anatomy::TissueVolume other = tissues;
  other.at(25, 25, 25) = anatomy::tissue::mass;
  EXPECT_NE(surfaces_digest(other), surfaces_digest(tissues));
  surfaces_of_case(other, folder_, count);
  EXPECT_GT(steps, 0);
  EXPECT_NO_THROW(surfaces_of_case(tissues, "/proc/cannot/be/written"));
}

template <typename Reader>
void expect_same(const fs::path& file, const SceneMesh& mesh) {
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), static_cast<vtkIdType>(mesh.triangles.size()));
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), static_cast<vtkIdType>(mesh.points.size()));
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& point : mesh.points) box.extend(point);
  double bounds[6];
  reader->GetOutput()->GetBounds(bounds);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(bounds[2 * axis], static_cast<double>(box.min()[axis]), 1e-4);
    EXPECT_NEAR(bounds[2 * axis + 1], static_cast<double>(box.max()[axis]), 1e-4);
  }
}

TEST_F(SurfaceFiles, are_exported_in_three_formats_that_vtk_reads) {
  const PatientSurfaces& surfaces = ball_surfaces();
  for (const char* name : {"stl", "ply", "vtp"}) {
    const std::optional<SurfaceFormat> format = surface_format_from(name);
    ASSERT_TRUE(format);
    EXPECT_EQ(name_of(*format), name);
    const std::vector<fs::path> files = export_surfaces(surfaces, folder_, *format);
    ASSERT_EQ(files.size(), surfaces.parts.size());
    EXPECT_EQ(files[0], folder_ / (std::string("skin.") + name));
    for (std::size_t p = 0; p < files.size(); ++p) {
      const SceneMesh& mesh = surfaces.parts[p].mesh;
      switch (*format) {
        case SurfaceFormat::stl:
          expect_same<vtkSTLReader>(files[p], mesh);
          break;
        case SurfaceFormat::ply:
          expect_same<vtkPLYReader>(files[p], mesh);
          break;
        case SurfaceFormat::vtp:
          expect_same<vtkXMLPolyDataReader>(files[p], mesh);
          break;
      }
    }
  }
  EXPECT_FALSE(surface_format_from("obj"));
  EXPECT_THROW(export_surfaces(surfaces, "/proc/cannot/be/made", SurfaceFormat::stl), SystemError);
}

}  // namespace
}  // namespace bodkin::scene
