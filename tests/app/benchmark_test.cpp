#include "app/benchmark.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "app/main_window.h"
#include "app/models/data_folder.h"
#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

// This machine's speed is not tested: only that everything is measured, and the needle and the camera really move.
TEST(Benchmark, measures_every_row_of_the_real_window) {
  MainWindow window(data_folder());
  window.resize(1280, 720);
  window.show();
  const std::vector<BenchmarkRow> rows = measure_window(window, 0.5);
  ASSERT_EQ(rows.size(), 16u);
  std::set<std::string> names;
  for (const BenchmarkRow& row : rows) {
    EXPECT_TRUE(std::isfinite(row.value)) << row.name;
    EXPECT_GE(row.value, 0.0) << row.name;
    EXPECT_TRUE(names.insert(row.name + row.unit).second) << row.name;
    if (row.unit == "frames/s") {
      EXPECT_GT(row.value, 0.0) << row.name;
    }
  }
  EXPECT_GT(window.practice().frame().depth, 5.0) << "the needle is in the tissue";
  const std::string table = benchmark_table(rows, window);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 17);
  EXPECT_NE(table.find("window 1280x720"), std::string::npos);
}

}  // namespace
}  // namespace bodkin::app
