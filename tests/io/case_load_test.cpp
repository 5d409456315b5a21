// The volumes of a case: Bodkin's own are read in this process, others by the image worker.
#include <cstdlib>
#include <fstream>

#include "tests/io/case_documents.h"
#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/case_folder.h"
#include "io/digest.h"
#include "io/nrrd_writer.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A case of two voxels of air and six of skin, in a place without an image worker.
class CaseLoad : public ::testing::Test {
 protected:
  CaseLoad() {
    if (const char* named = std::getenv(worker)) before_ = named;
    setenv(worker, "/nonexistent/bodkin-images", 1);
    Grid grid;
    grid.size = {2, 2, 2};
    grid.spacing = Vec3(1.0, 2.0, 3.0);
    ct_ = CtVolume(grid, 40);
    ct_.voxels[0] = ct_.voxels[1] = -1000;
    labels_ = LabelVolume(grid, 7);
    tissues_ = TissueVolume(grid, tissue::skin);
    tissues_.voxels[0] = tissues_.voxels[1] = tissue::air;
    description_ = parse(smallest);
    description_.ct_digest = volume_digest(ct_);
    description_.structures_file = "structures.nrrd";
    description_.structures_digest = volume_digest(labels_);
    description_.structures = {{7, "seven", "", false}};
    description_.tissues_digest = volume_digest(tissues_);
    write_nrrd(labels_, folder_.path() / "structures.nrrd");
    write_nrrd(tissues_, folder_.path() / "tissues.nrrd");
    write_ct(ct_);
  }
  ~CaseLoad() override {
    if (before_)
      setenv(worker, before_->c_str(), 1);
    else
      unsetenv(worker);
  }
  CaseLoad(const CaseLoad&) = delete;
  CaseLoad& operator=(const CaseLoad&) = delete;

  void write_ct(const CtVolume& ct) {
    write_nrrd(ct, folder_.path() / "ct.nrrd");
    write_case_description(description_, folder_.path());
  }

  static constexpr const char* worker = "BODKIN_IMAGES_WORKER";
  std::optional<std::string> before_;
  ScratchFolder folder_;
  CtVolume ct_;
  LabelVolume labels_;
  TissueVolume tissues_;
  CaseDescription description_;
};

TEST_F(CaseLoad, needs_no_image_worker_for_files_that_bodkin_wrote) {
  const Case patient = load_case(folder_.path());
  EXPECT_EQ(patient.ct.voxels, ct_.voxels);
  EXPECT_EQ(patient.structures.voxels, labels_.voxels);
  EXPECT_EQ(patient.tissues.voxels, tissues_.voxels);
  EXPECT_EQ(load_case_tissues(folder_.path(), description_).voxels, tissues_.voxels);
  EXPECT_THAT(check_case(folder_.path()), ElementsAre());
}

TEST_F(CaseLoad, leaves_any_other_file_to_the_image_worker) {
  std::ofstream(folder_.path() / "tissues.nrrd") << "NRRD0004\n# written by another program\n\n";
  EXPECT_THROW(load_case(folder_.path()), SystemError);  // there is none here
}

TEST_F(CaseLoad, finds_each_volume_that_has_changed) {
  ct_.voxels[3] += 1;
  write_ct(ct_);
  labels_.voxels[0] = 0;
  write_nrrd(labels_, folder_.path() / "structures.nrrd");
  EXPECT_THAT(refusal([&] { load_case(folder_.path()); }), HasSubstr("ct.nrrd has changed since the case was made"));
  EXPECT_THAT(check_case(folder_.path()),
              ElementsAre(HasSubstr("ct.nrrd has changed"), HasSubstr("structures.nrrd has changed")));
}

TEST_F(CaseLoad, raises_padding_to_the_lowest_value_of_the_ct_scale) {
  ct_.voxels[0] = -3024;
  description_.ct_digest.clear();
  write_ct(ct_);
  EXPECT_EQ(load_case(folder_.path()).ct.voxels[0], -1024);
}

}  // namespace
}  // namespace bodkin
