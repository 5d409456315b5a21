#include "report/expert_plot.h"

#include <gtest/gtest.h>

#include "training/metric.h"

namespace bodkin::report {
namespace {

training::MetricResult result(const char* metric, double value, double low, double high, bool has_rule = true) {
  training::MetricResult made;
  made.metric = training::find_metric(metric);
  made.value = value;
  if (has_rule) made.grade = training::Grade::pass;
  made.experts = training::ExpertSet::Place{.low = low, .high = high};
  return made;
}

TEST(ExpertBand, has_the_measures_that_rules_are_about_and_those_outside_it_first) {
  training::Score score;
  score.metrics = {result("insertions", 1.0, 1.0, 1.0), result("loss_overshoot_mm", 6.0, 1.0, 3.0),
                   result("tremor_mm", 9.0, 0.0, 1.0, false)};
  score.metrics.push_back({training::find_metric("bone_contacts"), 1.0, training::Grade::pass, {}});
  const std::vector<ExpertRow> rows = expert_rows(score);
  ASSERT_EQ(rows.size(), 2U) << "one has no rule, one no experts";
  EXPECT_EQ(rows[0].title, "overshoot after the loss of resistance");
  EXPECT_EQ(rows[0].high_text, "3.0 mm");
  EXPECT_FALSE(rows[0].is_within());
  EXPECT_DOUBLE_EQ(rows[0].share(), 2.5);
  EXPECT_TRUE(rows[1].is_within());
  EXPECT_DOUBLE_EQ(rows[1].share(), 0.5) << "all experts had one insertion";
}

// The columns of green pixels tell where the dot is.
TEST(ExpertBand, the_dot_stands_in_the_bar_at_its_share) {
  const auto middle_of = [](double value) {
    const ExpertRow row{"measure", value, 10.0, 20.0, "", "", ""};
    const imaging::ImageRgb picture = draw_expert_band({row}).pixels(1.0);
    double sum = 0.0, count = 0.0;
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const imaging::Rgb& pixel =
            picture.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                           static_cast<std::size_t>(x)];
        const bool is_green = pixel.green > 100 && pixel.red < 60 && pixel.blue < 110;
        sum += is_green ? x + 0.5 : 0.0;
        count += is_green ? 1.0 : 0.0;
      }
    }
    return sum / count;
  };
  EXPECT_NEAR(middle_of(15.0) - middle_of(10.0), 100.0, 0.5);
  EXPECT_NEAR(middle_of(20.0) - middle_of(15.0), 100.0, 0.5);
}

TEST(ExpertBand, a_value_far_outside_stands_at_the_edge) {
  const ExpertRow low{"measure", -1e6, 10.0, 20.0, "far", "10", "20"}, same{"measure", 3.0, 1.0, 1.0, "3", "1", "1"};
  EXPECT_NO_THROW(draw_expert_band({low, same}).pixels(1.0));
  EXPECT_GT(same.share(), 1.0);
}

}  // namespace
}  // namespace bodkin::report
