#include <array>
#include <cmath>
#include <fstream>
#include <map>

#include "tests/io/images/test_images.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "anatomy/case.h"
#include "io/images/image_source.h"
#include "io/images/label_placement.h"

// The fourteen trajectories of the real data were sampled by an independent program: trilinear HU and the nearest
// label at each millimetre. Reading, geometry and interpolation together must give the same numbers.

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

struct Images {
  CtVolume ct;
  LabelVolume labels;
};

constexpr double hounsfield_rounding = 0.11;  // the list has one decimal

TEST(Trajectories, hounsfield_and_label_are_as_listed_at_every_millimetre) {
  BODKIN_REQUIRE_DATA(data);
  const nlohmann::json trajectories = nlohmann::json::parse(std::ifstream(data / "trajectories.json"));
  ASSERT_EQ(trajectories.size(), 14U);
  std::map<std::string, Images> cache;
  double worst = 0.0;
  int samples = 0, labels_at_a_border = 0;
  for (const nlohmann::json& trajectory : trajectories) {
    const std::string ct_file = trajectory.at("ct"), label_file = trajectory.at("labels");
    auto& images = cache[ct_file + label_file];
    if (images.ct.empty()) {
      images.ct = read_ct(data / ct_file).ct;
      images.labels = place_labels(read_labels(data / label_file), images.ct.grid, false, label_file).labels;
    }
    const auto entry = trajectory.at("entry").get<std::array<double, 3>>();
    const auto target = trajectory.at("target").get<std::array<double, 3>>();
    const NeedlePath path{Vec3(entry[0], entry[1], entry[2]), Vec3(target[0], target[1], target[2])};
    for (const nlohmann::json& sample : trajectory.at("samples")) {
      const double depth = sample.at("depth_mm");
      const Vec3 place = path.entry + depth * path.direction();
      const double hounsfield = linear(images.ct, place, -9999.0);
      worst = std::max(worst, std::abs(hounsfield - sample.at("hu").get<double>()));
      const int label = nearest(images.labels, place, std::uint16_t{0});
      if (label != sample.at("label").get<int>()) {
        // Allowed only where the point lies on the face between two voxels, which rounding decides.
        const Vec3 index = images.labels.grid.to_index(place);
        const Vec3 from_face = (index.array() - index.array().floor() - 0.5).abs();
        EXPECT_LT(from_face.minCoeff(), 1e-4) << trajectory.at("name") << " at " << depth << " mm";
        ++labels_at_a_border;
      }
      ++samples;
    }
  }
  EXPECT_LT(worst, hounsfield_rounding);
  EXPECT_EQ(samples, 1221);
  EXPECT_LT(labels_at_a_border, 12);
}

TEST(Trajectories, in_the_dicom_series_they_meet_the_same_hounsfield_as_in_its_nifti) {
  BODKIN_REQUIRE_DATA(data);
  const CtVolume ct = read_ct(data / "dicom_ct_lumbosacral/series").ct;
  const nlohmann::json trajectories = nlohmann::json::parse(std::ifstream(data / "trajectories.json"));
  int samples = 0;
  for (const nlohmann::json& trajectory : trajectories) {
    if (trajectory.at("set") != "dicom_ct_lumbosacral") continue;
    const auto entry = trajectory.at("entry").get<std::array<double, 3>>();
    const auto target = trajectory.at("target").get<std::array<double, 3>>();
    const NeedlePath path{Vec3(entry[0], entry[1], entry[2]), Vec3(target[0], target[1], target[2])};
    for (const nlohmann::json& sample : trajectory.at("samples")) {
      const Vec3 place = path.entry + sample.at("depth_mm").get<double>() * path.direction();
      EXPECT_NEAR(linear(ct, place, -9999.0), sample.at("hu").get<double>(), hounsfield_rounding);
      ++samples;
    }
  }
  EXPECT_GT(samples, 250);
}

}  // namespace
}  // namespace bodkin
