#include "fem/solid/contact_sites.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

// Layers along z in voxels of 1 mm; the skin begins at z = 0.
Case layered_patient(const std::vector<std::pair<double, TissueId>>& layers) {
  Case patient;
  std::vector<TissueProperties> tissues(5);
  tissues[0].name = "air";
  const std::vector<std::pair<TissueId, double>> forces = {
      {tissue::skin, 1.5}, {tissue::muscle, 0.9}, {tissue::ligamentum_flavum, 4.7}, {tissue::cortical_bone, 100.0}};
  for (std::size_t i = 0; i < forces.size(); ++i) {
    TissueProperties& each = tissues[i + 1];
    each.id = forces[i].first;
    each.name = each.title = "tissue " + std::to_string(i);
    each.deformable.puncture_force = forces[i].second;
  }
  tissues[4].layered.kind = LayeredKind::rigid;
  patient.library = TissueLibrary(tissues);
  Grid grid;
  grid.size = {60, 60, 80};
  grid.origin = Vec3(-29.5, -29.5, -19.5);
  patient.tissues = TissueVolume(grid, tissue::air);
  for (int k = 0; k < 80; ++k) {
    for (const auto& [from, id] : layers) {
      if (k - 19.5 < from) continue;
      for (int j = 0; j < 60; ++j)
        for (int i = 0; i < 60; ++i) patient.tissues.at(i, j, k) = id;
    }
  }
  return patient;
}

NeedlePath down(double length, const Vec3& sideways = Vec3::Zero()) {
  return {Vec3::Zero(), length * (Vec3::UnitZ() + sideways).normalized()};
}

TEST(ContactSites, lie_at_every_border_and_at_equal_distances_behind_it) {
  const Case patient =
      layered_patient({{0.0, tissue::skin}, {2.0, tissue::muscle}, {6.0, tissue::ligamentum_flavum}});
  const std::vector<ContactSite> sites = contact_sites_along(down(10.0), 10.0, 1.0, patient);
  ASSERT_GE(sites.size(), 10U);
  std::vector<double> borders;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    EXPECT_LT((sites[i].place - sites[i].depth * Vec3::UnitZ()).norm(), 1e-12);
    if (sites[i].border) borders.push_back(sites[i].depth);
    if (i > 0) {
      EXPECT_LE(sites[i].depth - sites[i - 1].depth, 1.5 + 1e-9);
    }
    if (i > 0) {
      EXPECT_GE(sites[i].depth - sites[i - 1].depth, 0.4);
    }
  }
  ASSERT_EQ(borders.size(), 3U);
  EXPECT_NEAR(borders[0], 0.0, 0.051);
  EXPECT_NEAR(borders[1], 2.0, 0.051);
  EXPECT_NEAR(borders[2], 6.0, 0.051);
  EXPECT_TRUE(sites[0].resists);  // skin
  for (const ContactSite& site : sites)
    EXPECT_EQ(site.resists, site.border && site.tissue != tissue::muscle) << site.depth;
}

// Inside the body: no border where the needle continues in its tissue.
TEST(ContactSites, ahead_of_a_needle_that_has_turned_begin_in_the_tissue_behind_it) {
  const Case patient =
      layered_patient({{0.0, tissue::skin}, {2.0, tissue::muscle}, {6.0, tissue::ligamentum_flavum}});
  const Vec3 place(0.0, 0.0, 3.0), along = Vec3(1.0, 0.0, 1.0).normalized();
  const std::vector<ContactSite> sites = contact_sites_ahead(place, along, 10.0, 1.0, tissue::muscle, patient);
  ASSERT_GE(sites.size(), 8U);
  EXPECT_FALSE(sites.front().border);
  EXPECT_NEAR(sites.front().depth, 1.0, 1e-9);
  int borders = 0;
  for (const ContactSite& site : sites) {
    EXPECT_LT((site.place - place - site.depth * along).norm(), 1e-9);
    if (!site.border) continue;
    ++borders;
    EXPECT_NEAR(site.depth, 3.0 * std::sqrt(2.0), 0.06);
    EXPECT_EQ(site.tissue, tissue::ligamentum_flavum);
    EXPECT_TRUE(site.resists);
  }
  EXPECT_EQ(borders, 1);
  // The needle has not punctured the voxels' tissue there: it lies before the tip.
  const std::vector<ContactSite> before = contact_sites_ahead(place, along, 10.0, 1.0, tissue::skin, patient);
  EXPECT_TRUE(before.front().border);
  EXPECT_FALSE(before.front().resists) << "skin takes more force than muscle";
  EXPECT_NEAR(before.front().depth, 0.0, 1e-9);
}

TEST(ContactSites, end_at_what_is_rigid_and_begin_behind_air) {
  const Case patient = layered_patient({{0.0, tissue::skin}, {5.0, tissue::cortical_bone}});
  const std::vector<ContactSite> sites = contact_sites_along(down(20.0), 20.0, 1.0, patient);
  ASSERT_FALSE(sites.empty());
  EXPECT_NEAR(sites.front().depth, 0.0, 0.051);
  EXPECT_LT(sites.back().depth, 5.0);
  EXPECT_TRUE(contact_sites_along({Vec3(0.0, 0.0, -15.0), Vec3(0.0, 0.0, -5.0)}, 10.0, 1.0, patient).empty());
}

TEST(ContactSites, go_on_behind_a_corner_of_bone_thinner_than_a_layer) {
  Case patient = layered_patient({{0.0, tissue::muscle}});
  patient.tissues.at(30, 30, 30) = tissue::cortical_bone;  // x and y from 0 to 1 mm, z from 10 to 11
  // At 45 degrees through the voxel's edge at x = 1 mm, z = 10 mm, `inside` mm from it.
  const auto deepest = [&](double inside) {
    const Vec3 entry(-9.0 - inside, 0.5, 0.0), along = Vec3(1.0, 0.0, 1.0).normalized();
    return contact_sites_along({entry, entry + 30.0 * along}, 30.0, 1.0, patient).back().depth;
  };
  EXPECT_GT(deepest(0.1), 28.0);  // 0.14 mm of bone
  EXPECT_LT(deepest(0.4), 15.0);  // 0.57 mm
}

TEST(ContactSites, a_layer_of_one_voxel_is_met_from_every_side_and_once) {
  const Case patient = layered_patient(
      {{0.0, tissue::skin}, {2.0, tissue::muscle}, {10.0, tissue::ligamentum_flavum}, {11.0, tissue::muscle}});
  Random random(7);
  for (int way = 0; way < 200; ++way) {
    const Vec3 sideways(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 0.0);
    int ligaments = 0;
    for (const ContactSite& site : contact_sites_along(down(20.0, sideways), 20.0, 1.0, patient)) {
      if (site.tissue == tissue::ligamentum_flavum && site.border) ++ligaments;
    }
    EXPECT_EQ(ligaments, 1) << sideways.transpose();
  }
}

// A plane at an angle, in voxels a staircase: the line meets its corners.
TEST(ContactSites, the_staircase_of_an_oblique_border_is_one_border) {
  Case patient = layered_patient({{0.0, tissue::muscle}});
  const Vec3 normal = Vec3(0.35, 0.2, 1.0).normalized();
  for (int k = 20; k < 80; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 60; ++i) {
        const double behind = normal.dot(patient.tissues.grid.to_patient(Vec3(i, j, k)) - Vec3(0.0, 0.0, 12.0));
        if (behind > 0.0 && behind < 3.0) patient.tissues.at(i, j, k) = tissue::ligamentum_flavum;
      }
  Random random(8);
  for (int way = 0; way < 500; ++way) {
    const Vec3 sideways(random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7), 0.0);
    int ligaments = 0;
    for (const ContactSite& site : contact_sites_along(down(30.0, sideways), 30.0, 1.0, patient)) {
      if (site.tissue == tissue::ligamentum_flavum && site.border) ++ligaments;
    }
    EXPECT_EQ(ligaments, 1) << sideways.transpose();
  }
}

}  // namespace
}  // namespace bodkin
