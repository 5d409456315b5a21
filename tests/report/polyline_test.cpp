#include "report/polyline.h"

#include <cmath>

#include <gmock/gmock.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::report;
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Polyline, keeps_corners_and_drops_what_is_straight) {
  EXPECT_THAT(corners_of({{0, 0}, {1, 0}, {2, 0}, {3, 4}, {4, 8}, {5, 8}}, 0.01), ElementsAre(0, 2, 4, 5));
  EXPECT_THAT(corners_of({{0, 0}, {1, 0}, {2, 0}}, 0.01), ElementsAre(0, 2));
  EXPECT_THAT(corners_of({{0, 0}, {1, 0}}, 0.01), ElementsAre(0, 1));
  EXPECT_THAT(corners_of({}, 0.01), IsEmpty());
}

TEST(Polyline, a_line_that_runs_back_over_itself_keeps_its_turning_points) {
  EXPECT_THAT(corners_of({{0, 0}, {5, 0}, {10, 0}, {5, 0}, {0, 0}}, 0.01), ElementsAre(0, 2, 4));
}

TEST(Polyline, nothing_left_out_is_further_away_than_the_tolerance) {
  Random random(7);
  std::vector<std::array<double, 2>> line;
  for (int i = 0; i < 2000; ++i) line.push_back({i * 0.3, 30.0 * std::sin(i * 0.01) + 0.4 * random.uniform()});
  const auto kept = corners_of(line, 0.5);
  EXPECT_LT(kept.size(), 200U);
  for (std::size_t k = 1; k < kept.size(); ++k) {
    const auto &a = line[kept[k - 1]], &b = line[kept[k]];
    for (std::size_t i = kept[k - 1]; i <= kept[k]; ++i) {
      const double part = (line[i][0] - a[0]) / (b[0] - a[0]);
      EXPECT_LT(std::abs(a[1] + part * (b[1] - a[1]) - line[i][1]) * std::cos(std::atan2(b[1] - a[1], b[0] - a[0])),
                0.5 + 1e-9);
    }
  }
}

}  // namespace
}  // namespace bodkin
