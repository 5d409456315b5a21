// Draws the plot of each model's page, docs/models/NAME.svg, from the models themselves:
//
//   model_plots docs/models
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "report/plot.h"

#include "core/files.h"
#include "core/random.h"
#include "fem/embedded_needle.h"
#include "forces/beam.h"
#include "forces/bevel_tip.h"
#include "forces/csf_flow.h"
#include "forces/depth_profile.h"
#include "forces/fracture.h"
#include "forces/gravity_compensation.h"
#include "forces/line_spring.h"
#include "forces/needle_grasp.h"
#include "forces/pivot.h"
#include "forces/prony_relaxation.h"
#include "forces/rail.h"
#include "forces/shaft_friction.h"
#include "forces/spring_damper_wall.h"
#include "forces/syringe.h"
#include "forces/three_component.h"
#include "forces/tracking_wall.h"
#include "io/tissue_library_file.h"

namespace {

using namespace bodkin;
using namespace bodkin::anatomy;
using namespace bodkin::fem;
using namespace bodkin::forces;
using namespace bodkin::io;
using namespace bodkin::report;

constexpr double dt = 1e-3;
constexpr std::uint32_t blue = 0x12385C, orange = 0xC8641E, green = 0x2E7D5B, grey = 0x8A8F98;

PlotSeries line(const std::string& name, std::uint32_t colour) {
  PlotSeries series;
  series.name = name;
  series.colour = colour;
  return series;
}

void add(PlotSeries& series, double x, double y) {
  series.x.push_back(x);
  series.y.push_back(y);
}

Plot plot(const std::string& title, const std::string& x, const std::string& y, std::vector<PlotSeries> series) {
  Plot one;
  one.title = title;
  one.x_label = x;
  one.y_label = y;
  one.series = std::move(series);
  return one;
}

// Depths of a needle that goes from `start` to the given depths one after the other, at a speed; a repeated depth is
// a rest of one second.
std::vector<AxialMotion> motion(double start, const std::vector<double>& depths, double speed) {
  std::vector<AxialMotion> ticks;
  double depth = start;
  for (const double to : depths) {
    const double sense = to > depth ? 1.0 : (to < depth ? -1.0 : 0.0);
    const int count = sense == 0.0 ? 1000 : static_cast<int>(std::lround(std::abs(to - depth) / (speed * dt)));
    for (int i = 0; i < count; ++i) {
      depth += sense * speed * dt;
      ticks.push_back({depth, sense * speed, static_cast<int>(sense), sense == 0.0});
    }
    depth = to;
  }
  return ticks;
}

using AxialStep = std::function<double(const AxialMotion&)>;

PlotSeries over_depth(const std::string& name, std::uint32_t colour, const std::vector<AxialMotion>& ticks,
                      const AxialStep& step) {
  PlotSeries series = line(name, colour);
  for (const AxialMotion& tick : ticks) {
    const double force = step(tick);
    add(series, tick.depth, force);
  }
  return series;
}

PlotSeries over_time(const std::string& name, std::uint32_t colour, const std::vector<AxialMotion>& ticks,
                     const AxialStep& step) {
  PlotSeries series = line(name, colour);
  for (std::size_t i = 0; i < ticks.size(); ++i) add(series, static_cast<double>(i) * dt, step(ticks[i]));
  return series;
}

Plot spring_damper_wall() {
  std::vector<PlotSeries> series;
  for (const auto& [speed, colour] : {std::pair{10.0, blue}, std::pair{100.0, orange}}) {
    SpringDamperWall wall({.stiffness = 0.5, .damping = 0.002});
    TickEvents events;
    series.push_back(over_depth("in and out at " + std::to_string(static_cast<int>(speed)) + " mm/s", colour,
                                motion(-2.0, {8.0, -2.0}, speed),
                                [&](const AxialMotion& m) { return wall.step(m, tissue::muscle, events); }));
  }
  return plot("A fixed wall of 0.5 N/mm and 0.002 N s/mm", "depth, mm", "resistance, N", std::move(series));
}

Plot tracking_wall(const TissueLibrary& library) {
  TrackingWallSettings settings;
  settings.layers = {{0.0, {0.5, 1.0}}};
  const auto ticks = motion(-2.0, {12.0, 12.0, 20.0, 8.0, 24.0}, 10.0);
  TrackingWall wall(library, settings, dt);
  wall.begin(Vec3::Zero(), Vec3::UnitZ());
  TickEvents events;
  PlotSeries force = over_time("resistance", blue, ticks, [&](const AxialMotion& m) {
    events.clear();
    return wall.step(m, tissue::muscle, events);
  });
  PlotSeries depth = over_time("depth (right)", grey, ticks, [](const AxialMotion& m) { return m.depth; });
  depth.right_axis = true;
  depth.width = 1.2;
  Plot one = plot("In, a stop of one second, on, back 12 mm and in again", "time, s", "resistance, N",
                  {std::move(depth), std::move(force)});
  one.right_label = "depth, mm";
  return one;
}

Plot depth_profile(const TissueLibrary& library) {
  const auto tissue_at = [](double depth) {
    return depth < 0.0    ? tissue::air
           : depth < 2.0  ? tissue::skin
           : depth < 30.0 ? tissue::muscle
                          : tissue::cortical_bone;
  };
  DepthProfile model(library, {}, dt);
  model.begin(Vec3::Zero(), Vec3::UnitZ());
  TickEvents events;
  Plot one = plot("Skin, soft tissue and bone, in and out at 10 mm/s", "depth, mm", "resistance, N",
                  {over_depth("resistance", blue, motion(-2.0, {35.0, 5.0}, 10.0), [&](const AxialMotion& m) {
                    events.clear();
                    return model.step(m, tissue_at(m.depth), events);
                  })});
  one.bands = {{0.0, 2.0, 0xE6B08F, "skin"}, {2.0, 30.0, 0xA6453B, "muscle"}, {30.0, 35.0, 0xF6EEDC, "bone"}};
  return one;
}

Plot three_component() {
  ThreeComponent model({});
  model.begin(Vec3::Zero(), Vec3::UnitZ());
  TickEvents events;
  return plot("Bovine liver, in and out at 5 mm/s, and in again", "depth, mm", "resistance, N",
              {over_depth("resistance", blue, motion(-2.0, {30.0, 10.0, 34.0, -2.0}, 5.0), [&](const AxialMotion& m) {
                events.clear();
                return model.step(m, tissue::organ, events);
              })});
}

Plot fracture() {
  std::vector<PlotSeries> series;
  for (const auto& [toughness, colour] : {std::pair{0.5, green}, std::pair{1.0, blue}, std::pair{2.0, orange}}) {
    Fracture model({.toughness = toughness});
    model.begin(Vec3::Zero(), Vec3::UnitZ());
    TickEvents events;
    series.push_back(over_depth("J = " + std::to_string(toughness).substr(0, 3) + " N/mm", colour,
                                motion(-1.0, {8.0}, 10.0), [&](const AxialMotion& m) {
                                  events.clear();
                                  return model.step(m, tissue::skin, events);
                                }));
  }
  return plot("The tougher the membrane, the more energy before it tears", "depth, mm", "resistance, N",
              std::move(series));
}

Plot shaft_friction() {
  std::vector<PlotSeries> series;
  for (const auto& [name, fs, colour] :
       {std::tuple{"Dahl (Fs = Fc)", 0.5, blue}, std::tuple{"LuGre (Fs = 0.7)", 0.7, orange}}) {
    ShaftFriction model({});
    TickEvents events;
    const ShaftContact contact{0.5, fs, 2.0, 0.001};
    series.push_back(over_depth(name, colour, motion(0.0, {2.0, -1.0, 1.5}, 2.0),
                                [&](const AxialMotion& m) { return model.step(m, contact, events); }));
  }
  return plot("Fc = 0.5 N, sigma0 = 2 N/mm: to and fro at 2 mm/s", "displacement, mm", "friction, N",
              std::move(series));
}

Plot prony_relaxation() {
  const std::vector<PronyTerm> terms = {{0.5, 0.2}};
  PronyRelaxation relaxation(terms, dt);
  PlotSeries elastic = line("elastic force", grey), relaxed = line("relaxed, g = 0.5, tau = 0.2 s", blue);
  for (int i = 0; i < 2000; ++i) {
    const double time = i * dt;
    const double force = time < 0.2 ? time / 0.2 : (time < 1.2 ? 1.0 : std::max(0.0, 1.0 - (time - 1.2) / 0.2));
    add(elastic, time, force);
    add(relaxed, time, relaxation.step(force));
  }
  return plot("A ramp, a hold and a release", "time, s", "force, N", {std::move(elastic), std::move(relaxed)});
}

Plot bevel_tip() {
  std::vector<PlotSeries> series;
  struct Way {
    const char* name;
    double kappa, flip;
    std::uint32_t colour;
  };
  for (const Way& way : {Way{"0.002 1/mm", 0.002, 1e9, green}, Way{"0.005 1/mm", 0.005, 1e9, blue},
                         Way{"turned at 50 mm", 0.005, 50.0, orange}}) {
    BevelTip needle(way.kappa, 200.0);
    needle.begin(Pose::Identity());
    PlotSeries path = line(way.name, way.colour);
    for (int i = 0; i < 1000; ++i) {
      const bool flip = i * 0.1 >= way.flip && (i - 1) * 0.1 < way.flip;
      const Pose& tip = needle.step(0.1, flip ? std::numbers::pi : 0.0);
      add(path, tip.translation().z(), -tip.translation().y());
    }
    series.push_back(std::move(path));
  }
  return plot("Where a bevelled needle of curvature 0.002 or 0.005 1/mm goes", "along the needle, mm", "across, mm",
              std::move(series));
}

// Nodes on the z axis on springs of their own: Winkler's foundation, N/mm^2.
CondensedBody winkler_line(int count, double spacing, double foundation) {
  CondensedBody body;
  for (int i = 0; i < count; ++i) {
    body.mesh_nodes.push_back(static_cast<std::uint32_t>(i));
    body.nodes.emplace_back(0.0, 0.0, spacing * i);
    body.tissues.push_back(tissue::soft);
  }
  body.compliance = Eigen::MatrixXd::Identity(3 * count, 3 * count) / (foundation * spacing);
  return body;
}

Plot flexible_needle() {
  const CondensedBody body = winkler_line(150, 0.5, 0.5);
  ContactTissues tissues;
  tissues.fill({.friction = 0.02});
  EmbeddedNeedleSettings settings;
  settings.capture_radius = 0.45;
  std::vector<PlotSeries> series;
  struct Way {
    const char* name;
    double rigidity, flip;
    std::uint32_t colour;
  };
  for (const Way& way : {Way{"24G", 877.94, 1e9, green}, Way{"27G", 256.8, 1e9, blue},
                         Way{"27G, turned at 30 mm", 256.8, 30.0, orange}}) {
    EmbeddedNeedle needle(body, tissues, settings, dt,
                          NeedleBeam({.rigidity = way.rigidity, .length = 120.0, .cut_offset = 0.1}));
    needle.begin(Vec3::Zero(), Vec3::UnitZ());
    PlotSeries path = line(way.name, way.colour);
    for (int i = 0; i < 3000; ++i) {
      const double depth = 0.024 * i;
      Pose pose = Pose::Identity();
      pose.translation().z() = depth;
      if (depth > way.flip) pose.linear() = Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitZ()).toRotationMatrix();
      const EmbeddedNeedleForce& force = needle.step(pose);
      if (i % 20 == 0) add(path, depth, -force.tip_deflection.y());
    }
    series.push_back(std::move(path));
  }
  return plot("Where the tip of a bevelled needle goes in even tissue, pushed straight in", "depth, mm",
              "tip beside the hand's line, mm", std::move(series));
}

Plot syringe(const TissueLibrary& library) {
  std::vector<PlotSeries> series;
  for (const auto& [name, filling, colour] :
       {std::tuple{"saline", SyringeFilling::saline, blue}, std::tuple{"2 mL of air", SyringeFilling::air, orange}}) {
    Syringe one(library, {.filling = filling}, dt);
    PlotSeries force = line(name, colour);
    for (int i = 0; i < 2500; ++i) {
      const bool in_space = i >= 1500;  // the tip leaves ligamentum flavum
      // The thumb pushes until it feels 11 N, holds, and follows when the resistance is lost.
      const double speed =
          in_space ? 5.0 : (one.state().force < 11.0 ? (filling == SyringeFilling::air ? 12.0 : 0.05) : 0.0);
      add(force, i * dt, one.step(speed, in_space ? tissue::epidural_fat : tissue::ligamentum_flavum).force);
    }
    series.push_back(std::move(force));
  }
  return plot("Loss of resistance at 1.5 s, when the tip enters the epidural space", "time, s",
              "force on the thumb, N", std::move(series));
}

Plot csf_flow() {
  std::vector<PlotSeries> series;
  for (const auto& [name, bore, colour] :
       {std::tuple{"20G, bore 0.603 mm", 0.603, green}, std::tuple{"22G, bore 0.413 mm", 0.413, blue},
        std::tuple{"25G, bore 0.260 mm", 0.260, orange}}) {
    CsfFlow flow({.needle_bore = bore}, 0.05);
    PlotSeries height = line(name, colour);
    for (int i = 0; i < 1800; ++i) add(height, i * 0.05, flow.step_manometer(1.0, false).height);
    series.push_back(std::move(height));
  }
  return plot("Fluid rising in a manometer of 1.5 mm bore, opening pressure 145 mm", "time, s", "height, mm",
              std::move(series));
}

Plot needle_grasp() {
  PlotSeries one_way = line("one way", blue), two_way = line("one turn forth, one back", orange);
  NeedleGrasp winding({}), rocking({});
  for (int i = 0; i <= 800; ++i) {
    const double turns = i * 0.01, phase = std::fmod(turns, 2.0);
    add(one_way, turns, winding.step(turns * 2.0 * std::numbers::pi));
    add(two_way, turns, rocking.step((phase < 1.0 ? phase : 2.0 - phase) * 2.0 * std::numbers::pi));
  }
  return plot("How much more firmly the tissue holds", "turns of the needle in all", "factor on the friction",
              {std::move(one_way), std::move(two_way)});
}

Plot line_spring() {
  LineSpring spring({}, 1.0, dt);
  spring.begin(Vec3::Zero(), Vec3::UnitZ());
  PlotSeries force = line("0.5 N/mm, at most 3 N", blue);
  for (double x = -10.0; x <= 10.0; x += 0.05) add(force, x, spring.step(Vec3(x, 0.0, 30.0)).x());
  return plot("Force that leads the tip back to its line", "tip beside the line, mm", "force on the hand, N",
              {std::move(force)});
}

Plot pivot() {
  std::vector<PlotSeries> series;
  for (const auto& [depth, colour] : {std::pair{20.0, green}, std::pair{50.0, blue}, std::pair{100.0, orange}}) {
    Pivot model({}, 150.0);
    model.begin(Vec3::Zero(), Vec3::UnitZ());
    PlotSeries force = line(std::to_string(static_cast<int>(depth)) + " mm deep", colour);
    for (double degrees = 0.0; degrees <= 15.0; degrees += 0.1) {
      const double angle = degrees * std::numbers::pi / 180.0;
      const Vec3 axis(0.0, std::sin(angle), std::cos(angle));
      add(force, degrees, model.step(depth * axis, axis).norm());
    }
    series.push_back(std::move(force));
  }
  return plot("A needle of 150 mm, turned about the puncture", "angle, degrees", "force at the hub, N",
              std::move(series));
}

Plot rail() {
  std::vector<PlotSeries> series;
  for (const auto& [degrees, colour] : {std::pair{2.0, green}, std::pair{5.0, blue}, std::pair{10.0, orange}}) {
    Rail model({});
    model.begin(Vec3::Zero(), Vec3::UnitZ());
    const double angle = degrees * std::numbers::pi / 180.0;
    const Vec3 axis(0.0, std::sin(angle), std::cos(angle));
    PlotSeries torque = line(std::to_string(static_cast<int>(degrees)) + " degrees off", colour);
    for (double depth = 0.0; depth <= 60.0; depth += 0.2) add(torque, depth, model.torque(axis, depth).norm());
    series.push_back(std::move(torque));
  }
  return plot("The torque that turns the needle back grows with depth", "depth, mm", "torque, N mm",
              std::move(series));
}

Plot beam() {
  std::vector<PlotSeries> series;
  for (const auto& [gauge, colour] : {std::pair{25, green}, std::pair{24, blue}, std::pair{22, orange}}) {
    const GaugeSize size = *gauge_size(gauge);
    const Beam model(BeamSettings{}, {gauge, size.outer_diameter, size.inner_diameter, 90.0}, dt);
    PlotSeries stiffness = line(std::to_string(gauge) + "G", colour);
    for (double length = 8.0; length <= 60.0; length += 0.2) add(stiffness, length, model.stiffness(length));
    series.push_back(std::move(stiffness));
  }
  return plot("Stiffness of the hub of a needle clamped in the skin, at most the device's 1 N/mm",
              "length outside, mm", "stiffness, N/mm", std::move(series));
}

Plot gravity_compensation() {
  PlotSeries constant = line("constant", grey), fitted = line("with its slope", blue);
  const GravityCompensation plain({.weight = 0.8}), sloped({.weight = 0.8, .slope = Vec3(0.002, 0.0, 0.0)});
  for (double x = -150.0; x <= 150.0; x += 1.0) {
    add(constant, x, plain.step(Vec3(x, 0.0, 0.0)).norm());
    add(fitted, x, sloped.step(Vec3(x, 0.0, 0.0)).norm());
  }
  return plot("A device whose weight at the hub is 0.8 N in the middle and grows by 2 mN/mm",
              "position from the centre, mm", "force upwards, N", {std::move(constant), std::move(fitted)});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "model_plots FOLDER: draws NAME.svg of every model into the folder\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const TissueLibrary library = default_tissue_library();
  const std::vector<std::pair<std::string, Plot>> plots = {{"spring_damper_wall", spring_damper_wall()},
                                                           {"tracking_wall", tracking_wall(library)},
                                                           {"depth_profile", depth_profile(library)},
                                                           {"three_component", three_component()},
                                                           {"fracture", fracture()},
                                                           {"shaft_friction", shaft_friction()},
                                                           {"prony_relaxation", prony_relaxation()},
                                                           {"bevel_tip", bevel_tip()},
                                                           {"flexible_needle", flexible_needle()},
                                                           {"syringe", syringe(library)},
                                                           {"csf_flow", csf_flow()},
                                                           {"needle_grasp", needle_grasp()},
                                                           {"line_spring", line_spring()},
                                                           {"pivot", pivot()},
                                                           {"rail", rail()},
                                                           {"beam", beam()},
                                                           {"gravity_compensation", gravity_compensation()}};
  for (const auto& [name, one] : plots) {
    const std::filesystem::path file = folder / (name + ".svg");
    write_file(file.string(), draw_plot(one).svg());
    std::cout << file.string() << '\n';
  }
}
