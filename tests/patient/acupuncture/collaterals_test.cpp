// The fifteen collaterals against their rules.
#include "patient/acupuncture/collaterals.h"

#include <map>
#include <set>
#include <string>

#include "patient/acupuncture/point_table.h"
#include <gtest/gtest.h>

namespace bodkin::patient {
namespace {

TEST(Collaterals, are_fifteen_at_points_that_there_are) {
  const PointTable table = read_point_table();
  std::set<std::string> points;
  for (const Collateral& each : collaterals()) {
    EXPECT_NE(table.find(each.luo), nullptr) << each.luo;
    points.emplace(each.luo);
    EXPECT_EQ(collateral_at(each.luo), &each);
    EXPECT_EQ(each.partner.empty(), each.source.empty()) << each.luo;
    EXPECT_NE(each.partner.empty(), each.goes_to.empty()) << each.luo;
  }
  EXPECT_EQ(points.size(), 15U);
  EXPECT_EQ(collateral_at("ST36"), nullptr);
}

TEST(Collaterals, go_to_the_partner_and_back) {
  const PointTable table = read_point_table();
  std::map<std::string, std::string> partner_of;
  for (const Collateral& each : collaterals()) {
    if (each.partner.empty()) continue;
    partner_of[std::string(meridian_code(each.luo))] = each.partner;
    ASSERT_NE(table.find(each.source), nullptr) << each.source;
    EXPECT_EQ(meridian_code(each.source), each.partner) << "the source point is one of the partner's";
  }
  EXPECT_EQ(partner_of.size(), 12U) << "each of the twelve meridians has one";
  for (const auto& [meridian, partner] : partner_of) EXPECT_EQ(partner_of[partner], meridian);
}

// The twelve source (yuan) points, by meridian.
TEST(Collaterals, end_at_the_source_points) {
  const std::map<std::string, std::string> sources = {{"LU", "LU9"}, {"LI", "LI4"}, {"ST", "ST42"}, {"SP", "SP3"},
                                                      {"HT", "HT7"}, {"SI", "SI4"}, {"BL", "BL64"}, {"KI", "KI3"},
                                                      {"PC", "PC7"}, {"TE", "TE4"}, {"GB", "GB40"}, {"LR", "LR3"}};
  for (const Collateral& each : collaterals()) {
    if (each.partner.empty()) continue;
    EXPECT_EQ(each.source, sources.at(std::string(each.partner)));
  }
}

}  // namespace
}  // namespace bodkin::patient
