#include "views/force_chart.h"

#include <QTest>
#include <cmath>

#include "tests/views/made_up.h"
#include "views/theme.h"
#include <gtest/gtest.h>

namespace bodkin::views {
namespace {

using bodkin_test::frame_at;

// A chart of a needle that moves to a depth in steps of 0.05 mm and 2 ms, with force = depth / 10.
struct ShownChart {
  ForceChart chart;
  double time = 0.0;

  ShownChart() {
    chart.resize(500, 164);
    chart.set_case(bodkin_test::layered_patient());
  }
  void go(double from, double to, const std::vector<session::SessionEvent>& events = {}) {
    std::vector<station::HandSample> samples;
    const double step = to > from ? 0.05 : -0.05;
    const auto segments = bodkin_test::layered_patient();
    for (double depth = from; step * (to - depth) > 0.0; depth += step) {
      const Frame there = frame_at(depth);
      samples.push_back({time += 0.002, depth, 0.1 * std::max(0.0, depth), 0.1 * depth, 0.0, there.tissue});
    }
    Frame frame = frame_at(to);
    frame.samples = samples;
    frame.events = events;
    frame.time = time;
    chart.show_frame(frame, Changes::all());
  }
  // Continues without events and without the reset of a new attempt.
  void go_on(double from, double to) {
    std::vector<station::HandSample> samples;
    const double step = to > from ? 0.05 : -0.05;
    for (double depth = from; step * (to - depth) > 0.0; depth += step) {
      samples.push_back({time += 0.002, depth, 0.1 * depth, 0.1 * depth, 0.0, frame_at(depth).tissue});
    }
    Frame frame = frame_at(to);
    frame.samples = samples;
    Changes changes;
    changes.force = changes.needle = true;
    chart.show_frame(frame, changes);
  }
};

bool looks_like(const QColor& a, const QColor& b) {
  return std::abs(a.red() - b.red()) < 40 && std::abs(a.green() - b.green()) < 40 &&
         std::abs(a.blue() - b.blue()) < 40;
}

TEST(ForceChart, the_curve_runs_through_the_forces_that_were_measured) {
  ShownChart shown;
  shown.go(-1.0, 38.0);
  const QImage picture = shown.chart.grab().toImage();
  for (const double depth : {5.0, 11.0, 20.0, 25.0, 33.0}) {
    const QPointF at = shown.chart.place(depth, 0.1 * depth);
    bool found = false;
    for (int dy = -2; dy <= 2; ++dy) {
      found = found || looks_like(picture.pixelColor(static_cast<int>(at.x()), static_cast<int>(at.y()) + dy),
                                  Theme::now().accent);
    }
    EXPECT_TRUE(found) << depth << " mm";
  }
}

TEST(ForceChart, shows_no_tissue_that_the_needle_has_not_met) {
  ShownChart shown;
  shown.go(-1.0, 20.0);
  const QImage picture = shown.chart.grab().toImage();
  const auto strip_at = [&](double depth) {
    const QPointF at = shown.chart.place(depth, 0.0);
    return picture.pixelColor(static_cast<int>(at.x()), static_cast<int>(at.y()) - 2);
  };
  const auto colour_of = [](anatomy::TissueId id) {
    return tissue_colour(id, bodkin_test::layered_patient()->patient.library);
  };
  EXPECT_TRUE(looks_like(strip_at(7.0), colour_of(anatomy::tissue::fat)));
  EXPECT_TRUE(looks_like(strip_at(16.0), colour_of(anatomy::tissue::muscle)));
  EXPECT_TRUE(looks_like(strip_at(25.0), Theme::now().panel)) << "not there yet";
  EXPECT_TRUE(looks_like(strip_at(32.0), Theme::now().panel)) << "ligamentum flavum lies ahead";
}

TEST(ForceChart, the_way_out_does_not_widen_the_way_in) {
  ShownChart shown;
  shown.go(-1.0, 30.0);
  const double top = shown.chart.place(20.0, 2.0).y();
  shown.go_on(30.0, 5.0);
  EXPECT_EQ(shown.chart.place(20.0, 2.0).y(), top);
  EXPECT_FALSE(shown.chart.grab().isNull());
}

TEST(ForceChart, a_drag_zooms_and_a_double_click_shows_all) {
  ShownChart shown;
  shown.go(-1.0, 38.0);
  EXPECT_EQ(shown.chart.from(), 0.0);
  EXPECT_EQ(shown.chart.to(), 60.0);
  const QPoint begin = shown.chart.place(10.0, 1.0).toPoint(), end = shown.chart.place(30.0, 1.0).toPoint();
  QTest::mousePress(&shown.chart, Qt::LeftButton, {}, begin);
  QTest::mouseRelease(&shown.chart, Qt::LeftButton, {}, end);
  EXPECT_NEAR(shown.chart.from(), 10.0, 0.2);
  EXPECT_NEAR(shown.chart.to(), 30.0, 0.2);
  QTest::mouseDClick(&shown.chart, Qt::LeftButton, {}, begin);
  EXPECT_EQ(shown.chart.to(), 60.0);
}

TEST(ForceChart, against_time_its_cost_does_not_grow) {
  ShownChart shown;
  shown.chart.set_axis(ForceChart::Axis::time);
  for (int i = 0; i < 20; ++i) {
    if (i == 0) {
      shown.go(-1.0, 20.0);
    } else {
      shown.go_on(i % 2 == 1 ? 20.0 : 5.0, i % 2 == 1 ? 5.0 : 20.0);
    }
  }
  EXPECT_GE(shown.chart.to(), shown.time);
  EXPECT_FALSE(shown.chart.grab().isNull());
}

TEST(CrossedTissues, run_together_and_know_no_deeper) {
  CrossedTissues met;
  for (double depth = 0.02; depth < 5.0; depth += 0.07) {
    met.add(depth, depth < 2.0 ? anatomy::tissue::skin : anatomy::tissue::fat);
  }
  met.add(-1.0, anatomy::tissue::muscle);
  met.add(3.0, anatomy::tissue::air);
  const auto bands = met.bands();
  ASSERT_EQ(bands.size(), 2U);
  EXPECT_EQ(bands[0].tissue, anatomy::tissue::skin);
  EXPECT_NEAR(bands[0].to, 2.0, 0.11);
  EXPECT_NEAR(bands[1].from, 2.0, 0.11);
  EXPECT_NEAR(bands[1].to, 5.0, 0.11);
}

}  // namespace
}  // namespace bodkin::views
