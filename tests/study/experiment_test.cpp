#include "study/experiment.h"

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "report/experiment_page.h"
#include "report/experiment_plot.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::report;
using namespace bodkin::study;
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// Every shipped experiment, computed once for all tests.
const std::vector<Figure>& figures() {
  static const std::vector<Figure> all = [] {
    std::vector<Figure> played;
    for (const fs::path& file : shipped_experiments()) {
      Experiment experiment = read_experiment(file);
      ExperimentRun run = play(experiment);
      played.push_back({std::move(experiment), std::move(run)});
    }
    return played;
  }();
  return all;
}

const Figure& figure(const std::string& name) {
  for (const Figure& one : figures()) {
    if (one.experiment.name == name) return one;
  }
  throw InputError("there is no experiment " + name);
}

// The resistance at a time, s.
double force_at(const Figure& played, double time) {
  return played.run.ticks.at(static_cast<std::size_t>(std::lround(time / played.run.dt))).resistance;
}

// Lowest and highest of a quantity between two times.
std::pair<double, double> range(const Figure& played, Quantity quantity, double from, double to) {
  double low = 1e300, high = -1e300;
  for (const ExperimentTick& tick : played.run.ticks) {
    if (tick.time < from || tick.time > to) continue;
    const double value = value_of(quantity, tick, played.experiment);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return {low, high};
}

TEST(Experiment, every_number_that_a_shipped_experiment_expects_comes_out) {
  for (const Figure& played : figures()) {
    for (const PublishedComparison& comparison : played.run.comparisons) {
      EXPECT_TRUE(comparison.agrees) << played.experiment.name << ": " << comparison.published.what << ": expected "
                                     << comparison.published.value << ", found " << comparison.found;
    }
  }
}

TEST(Experiment, alamilla_reaches_1_newton_within_2_millimetres_and_keeps_it_for_12) {
  const Figure& played = figure("alamilla_2018_fig_5");
  double deepest = 0.0;
  for (const ExperimentTick& tick : played.run.ticks) {
    deepest = std::max(deepest, tick.depth);
    EXPECT_NEAR(tick.resistance, std::min(1.0, 0.5 * tick.depth), 1e-9) << tick.depth;
    if (tick.depth > 2.0) {
      EXPECT_NEAR(value_of(Quantity::wall, tick, played.experiment), tick.depth - 2.0, 1e-9);
    }
  }
  EXPECT_NEAR(deepest, 11.99, 0.02);
  EXPECT_NEAR(force_at(played, 0.7), 1.0, 1e-6);
  EXPECT_NEAR(force_at(played, 1.299), 1.0, 1e-6);
}

TEST(Experiment, alamilla_loses_the_force_in_a_stop_of_800_milliseconds) {
  const Figure& played = figure("alamilla_2018_fig_6");
  EXPECT_NEAR(force_at(played, 2.8), 1.0, 0.01);
  EXPECT_NEAR(force_at(played, 4.5), 1.0, 1e-6);
  EXPECT_NEAR(force_at(played, 4.528), 1.0 - 0.028 / 0.5, 0.005) << "the wall starts with the stop";
  EXPECT_NEAR(force_at(played, 4.75), 0.5, 0.005);
  EXPECT_GT(force_at(played, 4.7), 0.5);
  EXPECT_LT(force_at(played, 4.9), 0.5);
  EXPECT_EQ(force_at(played, 5.29), 0.0);
  EXPECT_NEAR(force_at(played, 5.4), 0.5, 0.01);
  EXPECT_NEAR(force_at(played, 5.6), 1.0, 1e-6);
}

TEST(Experiment, alamilla_finds_the_cut_channel_free_to_its_old_depth) {
  const Figure& played = figure("alamilla_2018_fig_7");
  EXPECT_NEAR(force_at(played, 4.9), 1.0, 1e-3);
  const auto [low, high] = range(played, Quantity::resistance, 5.1, 7.49);
  EXPECT_EQ(low, 0.0);
  EXPECT_EQ(high, 0.0);
  EXPECT_NEAR(force_at(played, 7.525), 0.5, 0.02);
}

TEST(Experiment, alamilla_feels_nine_layers_whose_components_share_one_threshold) {
  const Figure& played = figure("alamilla_2018_fig_9");
  const double forces[] = {1.5, 1.0, 1.8, 2.0, 3.0, 3.5, 2.5, 4.0, 4.5};
  std::map<int, double> found;
  for (const ExperimentTick& tick : played.run.ticks) {
    EXPECT_NEAR(tick.requested.force.norm(), tick.resistance, 1e-6);
    const double layer = tick.depth / (150.0 / 9.0);
    if (tick.velocity > 0.0 && layer - std::floor(layer) > 0.75 && layer - std::floor(layer) < 0.9)
      found[static_cast<int>(layer)] = tick.resistance;
  }
  ASSERT_EQ(found.size(), 9U);
  for (int i = 0; i < 9; ++i) EXPECT_NEAR(found[i], forces[i], 1e-6) << i;
  EXPECT_EQ(range(played, Quantity::resistance, 3.1, 4.9).second, 0.0);
}

TEST(Experiment, heng_follows_equation_2_before_the_skin_gives_way) {
  for (const ExperimentTick& tick : figure("heng_2004_fig_6").run.ticks) {
    const double a = tick.depth;
    if (a <= 0.1 || a > 2.0) continue;  // deeper, the next tissues contribute
    EXPECT_NEAR(tick.resistance, 0.05 * a * (a + 1.0) * (a + 2.0) / 6.0 + 0.001 * a * tick.velocity, 1e-9) << a;
  }
}

TEST(Experiment, kwon_bounds_both_forces_and_lets_go_on_withdrawal) {
  EXPECT_EQ(range(figure("kwon_2001_fig_8"), Quantity::resistance, 0.0, 100.0).second, 6.0);
  const Figure& tilted = figure("kwon_2001_fig_9");
  EXPECT_NEAR(range(tilted, Quantity::constraint, 0.0, 100.0).second, 2.0, 1e-9);
  // Out of the bone 0.4 s into the withdrawal, which begins at 6.9 s.
  EXPECT_EQ(range(figure("kwon_2001_fig_10"), Quantity::resistance, 7.33, 100.0).second, 0.0);
  EXPECT_GT(range(figure("kwon_2001_fig_10"), Quantity::resistance, 0.0, 6.9).second, 3.9);
}

TEST(Experiment, faerbers_torque_grows_with_depth) {
  const Figure& played = figure("faerber_torque");
  for (const ExperimentTick& tick : played.run.ticks) {
    if (tick.time < 1.76) continue;
    EXPECT_NEAR(tick.requested.torque.norm(), 1000.0 * std::min(tick.depth / 40.0, 1.0) * tick.tilt, 1e-6);
  }
}

TEST(Experiment, sutherlands_means_come_out) {
  const Figure& played = figure("sutherland_2013_fig_10");
  double skin = 0.0, flavum = 0.0;
  for (const ExperimentTick& tick : played.run.ticks) {
    if (tick.depth < 6.0) skin = std::max(skin, tick.resistance);
    flavum = std::max(flavum, tick.resistance);
  }
  EXPECT_NEAR(skin, 1.5, 0.05);
  EXPECT_NEAR(flavum, 4.7, 0.05);
  EXPECT_LT(played.run.ticks.back().resistance, 2.5);  // the loss of resistance
}

TEST(Experiment, sutherlands_finite_elements_go_up_and_down_in_soft_tissue_and_lose_resistance_behind_the_ligament) {
  const Figure& played = figure("sutherland_2013_fig_10_elements");
  int nodes = 0;  // falls of more than half a newton between skin and ligament
  double highest = 0.0, before = 0.0;
  for (const ExperimentTick& tick : played.run.ticks) {
    if (tick.depth > 6.0 && tick.depth < 42.0 && before - tick.resistance > 0.5) ++nodes;
    before = tick.resistance;
    highest = std::max(highest, tick.resistance);
  }
  EXPECT_GE(nodes, 6);
  EXPECT_LE(nodes, 10);
  EXPECT_NEAR(highest, 4.7, 0.05);
  EXPECT_LT(played.run.ticks.back().resistance, 1.0);
}

// The layers are punctured in order, each at its own force plus at most 0.1 N/mm of friction, with each model's own
// coupling to the body: nodes or points.
TEST(Experiment, both_deformable_models_are_played_on_layers) {
  for (const char* model : {"closest_node", "embedded_needle"}) {
    const std::string text = std::string(R"(<experiment version="1" name="stack" title="a stack">
  <caption><reproduces>a stack</reproduces></caption>
  <body><stack mesh_mm="4" width_mm="40"><tissue_layer tissue="skin" thickness_mm="4"/>
    <tissue_layer tissue="fat" thickness_mm="16"/><tissue_layer tissue="ligamentum_flavum" thickness_mm="4"/>
    <tissue_layer tissue="epidural_fat" thickness_mm="16"/></stack></body>
  <haptics><resistance><)") + model +
                             R"(/></resistance></haptics>
  <motion from_mm="-5"><move depth_mm="36" speed_mm_per_s="20"/></motion>
  <plot><panel><curve quantity="resistance_N"/></panel></plot>
</experiment>)";
    const ExperimentRun run = play(parse_experiment(text, "stack.xml"));
    double skin = 0.0, flavum = 0.0;
    for (const ExperimentTick& tick : run.ticks) {
      if (tick.depth < 15.0) skin = std::max(skin, tick.resistance);
      flavum = std::max(flavum, tick.resistance);
    }
    EXPECT_GT(skin, 1.4) << model;
    EXPECT_LT(skin, 1.5 + 0.1 * 15.0) << model;
    EXPECT_GT(flavum, 4.6) << model;
    EXPECT_LT(flavum, 4.7 + 0.1 * 30.0) << model;
    EXPECT_LT(run.ticks.back().resistance, flavum - 2.0) << model;
  }
}

// The needle, 8 mm from the line and tilted in the fat, meets the layers there too.
TEST(Experiment, a_needle_in_a_deformable_body_is_felt_beside_the_line_of_the_motion) {
  const std::string text = R"(<experiment version="1" name="stack" title="a stack">
  <caption><reproduces>a stack</reproduces></caption>
  <body><stack mesh_mm="4" width_mm="40"><tissue_layer tissue="skin" thickness_mm="4"/>
    <tissue_layer tissue="fat" thickness_mm="16"/><tissue_layer tissue="ligamentum_flavum" thickness_mm="4"/>
    <tissue_layer tissue="epidural_fat" thickness_mm="16"/></stack></body>
  <haptics><resistance><embedded_needle/></resistance></haptics>
  <motion from_mm="-5"><move aside_mm="8" speed_mm_per_s="20"/><move depth_mm="10" speed_mm_per_s="20"/>
    <move tilt_deg="8" time_s="0.4"/><move depth_mm="36" speed_mm_per_s="20"/></motion>
  <plot><panel><curve quantity="resistance_N"/></panel></plot>
</experiment>)";
  const ExperimentRun run = play(parse_experiment(text, "stack.xml"));
  double skin = 0.0, flavum = 0.0;
  for (const ExperimentTick& tick : run.ticks) {
    if (tick.depth < 10.0) skin = std::max(skin, tick.resistance);
    flavum = std::max(flavum, tick.resistance);
  }
  EXPECT_GT(skin, 1.4);
  EXPECT_LT(skin, 1.5 + 0.1 * 10.0);
  EXPECT_GT(flavum, 4.6);
  EXPECT_LT(flavum, 4.7 + 0.1 * 40.0);
  EXPECT_LT(run.ticks.back().resistance, flavum - 2.0);
}

TEST(Experiment, a_deformable_model_needs_layers_that_are_plane) {
  std::string text = R"(<experiment version="1" name="ball" title="a ball">
  <caption><reproduces>a ball</reproduces></caption>
  <body><hemisphere radius_mm="20" voxel_mm="1"><tissue_layer tissue="skin" thickness_mm="4"/></hemisphere></body>
  <haptics><resistance><closest_node/></resistance></haptics>
  <motion from_mm="-5"><move depth_mm="10" speed_mm_per_s="50"/></motion>
  <plot><panel><curve quantity="resistance_N"/></panel></plot>
</experiment>)";
  try {
    play(parse_experiment(text, "ball.xml"));
    FAIL() << "a half ball was played";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("not a half ball"));
  }
}

constexpr const char* ball = R"(<experiment version="1" name="ball" title="a ball">
  <caption><reproduces>a ball</reproduces></caption>
  <body><hemisphere radius_mm="20" voxel_mm="1"><tissue_layer tissue="skin" thickness_mm="4"/>
    <tissue_layer tissue="muscle" thickness_mm="6"/></hemisphere></body>
  <haptics><resistance><tracking_wall/></resistance></haptics>
  <motion from_mm="-5"><move depth_mm="19" speed_mm_per_s="50"/></motion>
  <plot><panel x="depth_mm" tissues="true"><curve quantity="resistance_N"/></panel></plot>
  <published><value what="never" source="nowhere" quantity="resistance_N" is="1" tolerance="1" depth_from_mm="500"/></published>
</experiment>)";

TEST(Experiment, a_half_ball_has_its_pole_at_the_origin_and_shells_inwards) {
  const Case patient = experiment_case(parse_experiment(ball, "ball.xml"));
  const auto at = [&](double x, double y, double z) {
    return nearest<TissueId>(patient.tissues, Vec3(x, y, z), tissue::air);
  };
  EXPECT_EQ(at(0, 0, -0.5), tissue::air);
  EXPECT_EQ(at(0, 0, 1), tissue::skin);
  EXPECT_EQ(at(0, 0, 6), tissue::muscle);
  EXPECT_EQ(at(0, 0, 18), tissue::muscle);  // the last layer fills the centre
  EXPECT_EQ(at(17.5, 0, 19.5), tissue::skin);
  EXPECT_EQ(at(-12.5, 0, 19.5), tissue::muscle);
  EXPECT_EQ(at(15, 15, 4), tissue::air);
  EXPECT_TRUE(patient.ct.empty());
}

TEST(Experiment, refuses_a_window_that_is_never_reached_and_a_body_that_is_too_large) {
  const auto said = [](const std::string& text) -> std::string {
    try {
      play(parse_experiment(text, "ball.xml"));
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  };
  EXPECT_THAT(said(ball), HasSubstr("never reaches"));
  std::string huge = ball;
  huge.replace(huge.find("radius_mm=\"20\""), 14, "radius_mm=\"500\"");
  EXPECT_THAT(said(huge), HasSubstr("million voxels"));
}

TEST(ExperimentPlot, a_wall_that_is_slack_is_a_gap_and_expectations_are_dashed) {
  const Figure& played = figure("alamilla_2018_fig_7");
  const std::vector<Plot> plots = plots_of(played.experiment, played.run);
  ASSERT_EQ(plots.size(), 3U);
  const auto walls = std::count_if(plots[0].series.begin(), plots[0].series.end(), [&](const PlotSeries& series) {
    return series.colour == plots[0].series[1].colour;
  });
  EXPECT_GE(walls, 2);
  for (const Plot& plot : plots) {
    for (const PlotSeries& series : plot.series) {
      for (const double y : series.y) ASSERT_TRUE(std::isfinite(y));
    }
  }
  EXPECT_TRUE(
      std::any_of(plots[2].series.begin(), plots[2].series.end(), [](const auto& s) { return !s.dash.empty(); }));
  EXPECT_NEAR(plots[1].series[0].x.front(), 2.6, 1e-9);
  EXPECT_NEAR(plots[1].series[0].x.back(), 2.8, 1e-9);
  EXPECT_THAT(draw_plots(plots).svg(), HasSubstr("Zoom"));
}

TEST(ExperimentPage, tells_captions_and_numbers_and_is_safe) {
  Figure one = {parse_experiment(ball, "ball.xml"), {}};
  one.experiment.values.clear();
  one.experiment.title = "<b> | *bold*";
  PublishedValue value;
  value.what = "a & b";
  value.value = 1.25;
  one.run.comparisons = {{value, 1.5, false}};
  const std::string page = figures_html({one}), text = figures_markdown({one});
  EXPECT_THAT(page, HasSubstr("&lt;b&gt;"));
  EXPECT_THAT(page, HasSubstr("a &amp; b"));
  EXPECT_THAT(page, HasSubstr("1.25 N"));
  EXPECT_THAT(page, HasSubstr("differs"));
  EXPECT_THAT(text, HasSubstr("\\<b\\> \\| \\*bold\\*"));
  EXPECT_THAT(text, HasSubstr("(ball.svg)"));
}

// docs/models/published is what `bodkin figures docs/models/published` writes.
TEST(ExperimentPage, the_documentation_shows_what_the_experiments_say_today) {
  const fs::path folder = fs::path(BODKIN_REPOSITORY) / "docs" / "models" / "published";
  std::ifstream stream(folder / "index.md");
  std::stringstream text;
  text << stream.rdbuf();
  EXPECT_EQ(text.str(), figures_markdown(figures())) << "run: bodkin figures docs/models/published";
  for (const Figure& played : figures()) EXPECT_TRUE(fs::exists(folder / (played.experiment.name + ".svg")));
}

}  // namespace
}  // namespace bodkin
