#include "haptics/latency_histogram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

TEST(LatencyHistogram, is_empty_at_first) {
  const LatencyHistogram histogram;
  EXPECT_EQ(histogram.count(), 0u);
  EXPECT_EQ(histogram.maximum(), 0.0);
  EXPECT_EQ(histogram.mean(), 0.0);
  EXPECT_EQ(histogram.percentile(0.5), 0.0);
}

TEST(LatencyHistogram, one_value_is_its_own_every_percentile) {
  for (const double value : {0.0, 1e-9, 15e-9, 16e-9, 17e-9, 1e-6, 3.7e-4, 0.0999}) {
    LatencyHistogram histogram;
    histogram.record(value);
    EXPECT_EQ(histogram.maximum(), value);
    for (const double share : {0.0, 0.5, 1.0}) EXPECT_NEAR(histogram.percentile(share), value, 0.51e-9) << value;
  }
}

TEST(LatencyHistogram, percentiles_are_at_most_a_sixteenth_above_those_of_the_sorted_values) {
  LatencyHistogram histogram;
  Random random(5);
  std::vector<double> values;
  for (int i = 0; i < 20000; ++i) {
    values.push_back(std::pow(10.0, random.uniform(-8.9, -1.01)));
    histogram.record(values.back());
  }
  std::sort(values.begin(), values.end());
  for (const double share : {0.01, 0.1, 0.5, 0.9, 0.99, 0.999, 1.0}) {
    const auto rank = static_cast<std::size_t>(std::ceil(share * 20000.0)) - 1;
    EXPECT_GE(histogram.percentile(share), values[rank] - 1e-9) << share;
    EXPECT_LE(histogram.percentile(share), values[rank] * (1.0 + 1.0 / 16.0) + 1e-9) << share;
  }
  EXPECT_EQ(histogram.maximum(), values.back());
  EXPECT_EQ(histogram.beyond(), 0u);
}

TEST(LatencyHistogram, what_takes_longer_than_100_ms_is_counted_and_kept_as_the_maximum) {
  LatencyHistogram histogram;
  histogram.record(0.001);
  histogram.record(0.1);
  EXPECT_EQ(histogram.beyond(), 0u);
  histogram.record(2.5);
  EXPECT_EQ(histogram.beyond(), 1u);
  EXPECT_EQ(histogram.maximum(), 2.5);
  EXPECT_EQ(histogram.percentile(1.0), 2.5);
  EXPECT_LT(histogram.percentile(0.3), 0.0011);
}

TEST(LatencyHistogram, takes_anything) {
  LatencyHistogram histogram;
  histogram.record(std::numeric_limits<double>::quiet_NaN());
  histogram.record(std::numeric_limits<double>::infinity());
  histogram.record(-1.0);
  EXPECT_EQ(histogram.count(), 3u);
  EXPECT_EQ(histogram.beyond(), 2u);
  EXPECT_EQ(histogram.mean(), 0.0);  // no time runs backwards
  EXPECT_EQ(histogram.maximum(), 0.0);
  histogram.reset();
  EXPECT_EQ(histogram.count(), 0u);
  EXPECT_EQ(histogram.beyond(), 0u);
}

}  // namespace
}  // namespace bodkin
