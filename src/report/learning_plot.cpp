#include "report/learning_plot.h"

#include <array>

#include "report/plot.h"
#include <fmt/format.h>

namespace bodkin::report {

imaging::Canvas draw_learning_curve(const std::vector<training::AttemptSummary>& attempts,
                                    const training::CusumSettings& settings) {
  constexpr std::uint32_t curve_colour = 0x12385C, limit_colour = 0x8A8F98, score_colour = 0x1D7F5F;
  constexpr double low_plot = 150.0;  // px
  const training::Cusum cusum(settings);
  const std::vector<training::Cusum::Point> points = training::learning_curve(attempts, settings);
  Plot sum{.title = fmt::format("{}: {}", attempts.front().trainee, attempts.front().procedure),
           .x_label = "",
           .y_label = "CUSUM of failures"};
  PlotSeries curve{.name = "failures against what is acceptable", .x = {0.0}, .y = {0.0}, .colour = curve_colour};
  // The limits restart wherever one was crossed.
  PlotSeries mastery{
      .name = "mastery below", .x = {}, .y = {}, .colour = score_colour, .width = 1.2, .dash = {5.0, 4.0}},
      absence{
          .name = "not acceptable above", .x = {}, .y = {}, .colour = limit_colour, .width = 1.2, .dash = {2.0, 3.0}};
  double level = 0.0;
  const auto put_limits = [&](double x) {
    mastery.x.push_back(x);
    mastery.y.push_back(level - cusum.lower());
    absence.x.push_back(x);
    absence.y.push_back(level + cusum.upper());
  };
  put_limits(0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double number = static_cast<double>(i + 1);
    curve.x.push_back(number);
    curve.y.push_back(points[i].value);
    put_limits(number);
    if (!points[i].mastery && !points[i].failing) continue;
    sum.marks.push_back(
        {number, points[i].value,
         fmt::format("attempt {}: {}", i + 1, points[i].mastery ? "mastery shown" : "too many failures")});
    level = points[i].value;
    if (i + 1 < points.size()) put_limits(number);
  }
  sum.series = {absence, mastery, curve};
  Plot scores{.title = "", .x_label = "attempt", .y_label = "score", .height = low_plot};
  PlotSeries score{.name = "", .x = {}, .y = {}, .colour = score_colour};
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    score.x.push_back(static_cast<double>(i + 1));
    score.y.push_back(attempts[i].score);
  }
  scores.series = {score};
  const std::array<Plot, 2> both = {sum, scores};
  return draw_plots(both);
}

}  // namespace bodkin::report
