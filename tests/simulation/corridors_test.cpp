// A needle that goes from one corridor of a deformable body to another.
#include "simulation/corridors.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "tests/fem/dense_body.h"
#include "tests/simulation/real_time_guard.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/tissue_library_file.h"
#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::io;
using namespace bodkin::simulation;
namespace {

constexpr double apart = 10.0;  // mm between the two lines

// Three by three lines of nodes about (x, 0), with the numbers of a mesh in which both corridors lie: those at x = 5
// belong to both.
PreparedCorridor corridor_at(double x, std::optional<std::uint64_t> aimed_at = {}) {
  auto body = std::make_shared<CondensedBody>(checks::kelvin_body(3, 12, 2.5, 0.2));
  for (std::size_t node = 0; node < body->nodes.size(); ++node) {
    Vec3& place = body->nodes[node];
    place.x() = place.x() * 2.0 + x;
    body->mesh_nodes[node] = static_cast<std::uint32_t>(std::lround(place.x() + 100.0) * 10000 +
                                                        std::lround(place.y() + 50.0) * 100 + std::lround(place.z()));
  }
  std::vector<std::size_t> order(body->nodes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t one, std::size_t other) { return body->mesh_nodes[one] < body->mesh_nodes[other]; });
  CondensedBody sorted = *body;
  for (std::size_t to = 0; to < order.size(); ++to) {
    sorted.nodes[to] = body->nodes[order[to]];
    sorted.mesh_nodes[to] = body->mesh_nodes[order[to]];
    sorted.tissues[to] = sorted.nodes[to].z() < 2.0 ? tissue::skin : tissue::muscle;
    for (std::size_t column = 0; column < order.size(); ++column) {
      sorted.compliance.block<3, 3>(3 * static_cast<Eigen::Index>(to), 3 * static_cast<Eigen::Index>(column)) =
          body->compliance.block<3, 3>(3 * static_cast<Eigen::Index>(order[to]),
                                       3 * static_cast<Eigen::Index>(order[column]));
    }
  }
  return {std::make_shared<const CondensedBody>(std::move(sorted)), NeedlePath{Vec3(x, 0.0, 0.0), Vec3(x, 0.0, 20.0)},
          aimed_at};
}

Case patient_of_corridors(const ResistanceSettings& settings) {
  Case patient;
  // Firmer than it comes, so that skin gives way to `closest_node` before the tip is at the next node.
  std::vector<TissueProperties> tissues = default_tissue_library().tissues();
  for (TissueProperties& tissue : tissues) tissue.deformable.stiffness = 2.0;
  patient.library = TissueLibrary(tissues);
  Grid grid;
  grid.size = {60, 30, 60};
  grid.origin = Vec3(-20.0, -14.5, -19.5);
  patient.tissues = TissueVolume(grid, tissue::air);
  for (int k = 20; k < 60; ++k)
    for (int j = 0; j < 30; ++j)
      for (int i = 0; i < 60; ++i) patient.tissues.at(i, j, k) = k < 22 ? tissue::skin : tissue::muscle;
  patient.ct = CtVolume(grid, 40);
  patient.corridor = corridor_at(0.0);
  patient.description.device = {"strong", 100.0, 50.0, 1e6, 100.0, 0.0};
  patient.description.haptics.resistance = settings;
  patient.description.haptics.constraint = NoConstraint{};
  return patient;
}

struct Insertion {
  double greatest = 0.0, before_greatest_rise = 0.0, largest_jump = 0.0;
  std::vector<Event> events;
  int count(EventKind kind) const {
    return static_cast<int>(
        std::count_if(events.begin(), events.end(), [kind](const Event& event) { return event.kind == kind; }));
  }
  double value(EventKind kind) const {
    const auto found = std::find_if(events.begin(), events.end(), [kind](const Event& e) { return e.kind == kind; });
    return found == events.end() ? -99.0 : found->value;
  }
};

// In along z by `depth` mm at (x, 0), and out again.
Insertion put_in(HapticTick& tick, double x, double depth) {
  Insertion found;
  double before = 0.0;
  const int ticks = static_cast<int>((depth + 3.0) / 0.02);
  for (int i = 0; i <= 2 * ticks; ++i) {
    const double place = -3.0 + 0.02 * (i <= ticks ? i : 2 * ticks - i);
    const TickOutput output = tick.step({needle_pose(Vec3(x, 0.0, place), Vec3::UnitZ())});
    found.greatest = std::max(found.greatest, output.resistance);
    if (output.events.size() == 0) found.largest_jump = std::max(found.largest_jump, output.resistance - before);
    before = output.resistance;
    found.events.insert(found.events.end(), output.events.begin(), output.events.end());
  }
  return found;
}

EmbeddedNeedleSettings shaft_settings() {
  EmbeddedNeedleSettings settings;
  settings.spacing = 2.0;
  return settings;
}

TEST(Corridors, the_needle_takes_the_one_about_the_nearest_line_and_says_so) {
  const Case patient = patient_of_corridors(shaft_settings());
  HapticTick tick(patient);
  const Insertion beside = put_in(tick, apart, 15.0);
  EXPECT_EQ(beside.count(EventKind::corridor_left), 1);
  EXPECT_EQ(beside.count(EventKind::corridor_taken), 0);
  EXPECT_EQ(beside.greatest, 0.0);
  ASSERT_TRUE(tick.body()->add_corridor(corridor_at(apart, 1234)));
  const Insertion there = put_in(tick, apart, 15.0);
  EXPECT_EQ(there.count(EventKind::corridor_left), 0);
  EXPECT_EQ(there.count(EventKind::corridor_taken), 1);
  EXPECT_EQ(there.value(EventKind::corridor_taken), 1234.0);
  EXPECT_GT(there.greatest, 1.4);
  EXPECT_EQ(put_in(tick, apart, 15.0).count(EventKind::corridor_taken), 0);  // the same as before
  const Insertion back = put_in(tick, 0.0, 15.0);
  EXPECT_EQ(back.value(EventKind::corridor_taken), -1.0);
  EXPECT_GT(back.greatest, 1.4);
}

TEST(Corridors, a_corridor_feels_the_same_whenever_it_was_prepared) {
  Case later = patient_of_corridors(shaft_settings());
  Case first = later;
  first.corridor = corridor_at(apart);
  HapticTick of_later(later), of_first(first);
  of_later.body()->add_corridor(corridor_at(apart, 7));
  for (double place = -2.0; place < 20.0; place += 0.03) {
    const TickInput input{needle_pose(Vec3(apart + 0.01 * place, 0.0, place), Vec3(0.01, 0.0, 1.0).normalized())};
    ASSERT_EQ(of_later.step(input).resistance, of_first.step(input).resistance) << place;
  }
}

TEST(Corridors, what_gave_way_in_one_has_given_way_in_the_next) {
  for (const ResistanceSettings& settings :
       {ResistanceSettings(shaft_settings()), ResistanceSettings(ClosestNodeSettings{.capture_radius = 2.0})}) {
    const Case patient = patient_of_corridors(settings);
    HapticTick tick(patient);
    const auto skin_gives_way = [&](HapticTick& by, double x) {
      const Insertion found = put_in(by, x, 1.8);
      return std::any_of(found.events.begin(), found.events.end(), [](const Event& event) {
        return event.kind == EventKind::puncture && event.tissue == tissue::skin;
      });
    };
    EXPECT_TRUE(skin_gives_way(tick, 5.0)) << name_of(settings);  // along the nodes that both corridors have
    tick.body()->add_corridor(corridor_at(apart, 3));
    HapticTick fresh(patient);
    fresh.body()->add_corridor(corridor_at(apart, 3));
    EXPECT_FALSE(skin_gives_way(tick, 5.1)) << name_of(settings);
    EXPECT_TRUE(skin_gives_way(fresh, 5.1)) << name_of(settings);
  }
}

TEST(Corridors, there_is_room_for_some_and_reset_goes_back_to_the_first) {
  const Case patient = patient_of_corridors(shaft_settings());
  HapticTick tick(patient);
  for (std::size_t i = 1; i < BodyPort::most_corridors; ++i)
    EXPECT_TRUE(tick.body()->add_corridor(corridor_at(apart, i))) << i;
  EXPECT_FALSE(tick.body()->add_corridor(corridor_at(apart, 99)));
  put_in(tick, apart, 15.0);
  tick.reset();
  const Insertion again = put_in(tick, 0.0, 15.0);
  EXPECT_EQ(again.count(EventKind::corridor_taken), 0);
  EXPECT_EQ(again.count(EventKind::puncture), put_in(tick, apart, 15.0).count(EventKind::puncture));

  Case rigid = patient;
  rigid.description.haptics.resistance = LayeredSettings{};
  HapticTick other(rigid);
  EXPECT_EQ(other.body(), nullptr);
}

TEST(Corridors, forces_on_nodes_are_told_while_the_needle_is_in_and_not_after) {
  const Case patient = patient_of_corridors(shaft_settings());
  HapticTick tick(patient);
  for (double place = -1.0; place < 12.0; place += 0.05) tick.step({needle_pose(Vec3(0, 0, place), Vec3::UnitZ())});
  double along = 0.0;
  for (std::size_t i = 0; i < tick.body()->node_forces().count; ++i)
    along += static_cast<double>(tick.body()->node_forces().nodes[i].force[2]);
  const TickOutput now = tick.step({needle_pose(Vec3(0, 0, 12.0), Vec3::UnitZ())});
  EXPECT_GT(now.resistance, 0.1);
  EXPECT_NEAR(along, now.resistance, 0.1 * now.resistance);
  put_in(tick, 0.0, 0.0);
  EXPECT_EQ(tick.body()->node_forces().count, 0U);
}

TEST(Corridors, one_is_added_beside_the_tick) {
  const Case patient = patient_of_corridors(shaft_settings());
  HapticTick tick(patient);
  std::atomic<bool> taken{false};
  std::jthread hand([&](const std::stop_token& stop) {
    while (!stop.stop_requested() && !taken.load()) {
      if (put_in(tick, apart, 2.0).count(EventKind::corridor_taken) > 0) taken.store(true);
    }
  });
  EXPECT_TRUE(tick.body()->add_corridor(corridor_at(2.0 * apart, 2)));
  EXPECT_TRUE(tick.body()->add_corridor(corridor_at(apart, 3)));
  for (int tries = 0; tries < 3000 && !taken.load(); ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(taken.load());
}

// The first corridor as a probe would press it: `sunk` mm deeper.
PreparedCorridor pressed_corridor(double sunk, std::uint32_t state) {
  PreparedCorridor corridor = corridor_at(0.0);
  CondensedBody body = *corridor.body;
  for (Vec3& node : body.nodes) node.z() += sunk;
  corridor.body = std::make_shared<const CondensedBody>(std::move(body));
  corridor.state = state;
  return corridor;
}

TEST(Corridors, a_pressed_body_is_met_where_it_is_by_a_needle_that_begins) {
  const Case patient = patient_of_corridors(shaft_settings());
  HapticTick tick(patient), at_rest(patient);
  const auto step = [](HapticTick& by, double place) {
    return by.step({needle_pose(Vec3(0.1, 0.0, place), Vec3::UnitZ())});
  };
  ASSERT_TRUE(tick.body()->refresh_corridor(pressed_corridor(9.0, 1)));  // never taken
  ASSERT_TRUE(tick.body()->refresh_corridor(pressed_corridor(3.0, 2)));
  int told = 0;
  std::vector<double> sunk, rest;
  for (int i = 0; i < 700; ++i) {
    const TickOutput output = step(tick, -0.5 + 0.02 * i);
    for (const Event& event : output.events) {
      told += event.kind == EventKind::corridor_refreshed ? 1 : 0;
      const bool as_the_voxels_count = std::abs(event.depth - (-0.5 + 0.02 * i)) < 0.05;
      EXPECT_TRUE(event.kind != EventKind::corridor_refreshed || event.value == 2.0);
      EXPECT_TRUE(event.kind != EventKind::puncture || as_the_voxels_count) << event.depth;
    }
    sunk.push_back(output.resistance);
    rest.push_back(step(at_rest, -3.5 + 0.02 * i).resistance);
  }
  EXPECT_EQ(told, 1);
  EXPECT_GT(*std::max_element(rest.begin(), rest.end()), 1.4);
  // But for the tick in which the body at rest was met, 0.02 mm, and the tick by which skin gives way earlier for it.
  int apart_by_more = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) apart_by_more += std::abs(sunk[i] - rest[i]) > 0.12 ? 1 : 0;
  EXPECT_LE(apart_by_more, 5);

  tick.body()->stay_at_rest();
  ASSERT_TRUE(tick.body()->refresh_corridor(pressed_corridor(3.0, 3)));
  const Insertion after = put_in(tick, 0.0, 15.0);
  EXPECT_EQ(after.count(EventKind::corridor_refreshed), 0);
  EXPECT_EQ(after.value(EventKind::corridor_taken), -1.0);
}

// The first corridor as it is when its body is firmer by `times`.
PreparedCorridor firmer_corridor(double times, std::uint32_t state) {
  PreparedCorridor corridor = corridor_at(0.0);
  CondensedBody body = *corridor.body;
  body.compliance /= times;
  corridor.body = std::make_shared<const CondensedBody>(std::move(body));
  corridor.state = state;
  return corridor;
}

TEST(Corridors, a_needle_that_is_in_goes_on_in_the_body_as_it_is_pressed_now) {
  const Case patient = patient_of_corridors(shaft_settings());
  HapticTick tick(patient), alone(patient);
  const auto at = [](double x, double place) { return TickInput{needle_pose(Vec3(x, 0.0, place), Vec3::UnitZ())}; };
  for (double place = -3.0; place < 13.0; place += 0.02) {
    tick.step(at(0.1, place));
    alone.step(at(0.1, place));
  }
  const auto sideways = [&](HapticTick& by) {  // N by 0.1 mm
    const double before = by.step(at(0.1, 13.0)).requested.force.x();
    const double there = by.step(at(0.2, 13.0)).requested.force.x();
    by.step(at(0.1, 13.0));
    return before - there;
  };
  const double first = sideways(tick);
  const Vec3 force = tick.step(at(0.1, 13.0)).requested.force;
  ASSERT_TRUE(tick.body()->refresh_corridor(firmer_corridor(2.0, 7)));
  int told = 0;
  for (int i = 0; i < 50; ++i) {
    const TickOutput output = tick.step(at(0.1, 13.0));
    EXPECT_LT((output.requested.force - force).norm(), 1e-9) << i;
    for (const Event& event : output.events) {
      EXPECT_EQ(event.kind, EventKind::corridor_refreshed);
      EXPECT_EQ(event.value, 7.0);
      EXPECT_NEAR(event.depth, 13.0, 0.01);
      ++told;
    }
  }
  EXPECT_EQ(told, 1);
  EXPECT_NEAR(sideways(tick), 2.0 * first, 1e-6);
  EXPECT_EQ(tick.body()->node_forces().count, alone.body()->node_forces().count);
  EXPECT_EQ(tick.body()->node_forces().nodes[0].node, alone.body()->node_forces().nodes[0].node);
  // A body that has failed is left as it is until the needle is out.
  tick.body()->stay_at_rest();
  ASSERT_TRUE(tick.body()->refresh_corridor(firmer_corridor(4.0, 8)));
  for (int i = 0; i < 50; ++i) EXPECT_EQ(tick.step(at(0.1, 13.0)).events.size(), 0U);
  EXPECT_NEAR(sideways(tick), 2.0 * first, 1e-6);
}

TEST(Corridors, a_pressed_body_has_its_corridor_where_the_needle_aims) {
  const Case patient = patient_of_corridors(shaft_settings());
  HapticTick tick(patient);
  EXPECT_EQ(put_in(tick, apart, 12.0).count(EventKind::corridor_left), 1);
  PreparedCorridor there = corridor_at(apart);
  CondensedBody body = *there.body;
  there.at_rest = body.nodes;
  for (Vec3& node : body.nodes) node.z() += 2.0;
  there.body = std::make_shared<const CondensedBody>(std::move(body));
  there.state = 1;
  ASSERT_TRUE(tick.body()->refresh_corridor(there));
  const Insertion found = put_in(tick, apart, 12.0);
  EXPECT_EQ(found.count(EventKind::corridor_left), 0);
  EXPECT_EQ(found.value(EventKind::corridor_refreshed), 1.0);
  EXPECT_GT(found.greatest, 1.0);
  for (const Event& event : found.events) {
    EXPECT_TRUE(event.kind != EventKind::puncture || event.depth > 2.0) << "it is met where it has sunk to";
  }
  there.at_rest.pop_back();
  EXPECT_THROW(tick.body()->refresh_corridor(there), InputError);
}

TEST(Corridors, only_the_body_that_the_session_began_with_is_refreshed) {
  Case patient = patient_of_corridors(shaft_settings());
  HapticTick tick(patient);
  PreparedCorridor other = corridor_at(apart);
  other.state = 1;
  EXPECT_THROW(tick.body()->refresh_corridor(other), InputError);
  patient.description.haptics.resistance = ClosestNodeSettings{.capture_radius = 2.0};
  HapticTick closest(patient);
  EXPECT_FALSE(closest.body()->refresh_corridor(pressed_corridor(1.0, 1)));
  closest.body()->stay_at_rest();
}

TEST(Corridors, beside_a_thread_that_refreshes_them_no_force_jumps) {
  const Case patient = patient_of_corridors(shaft_settings());
  HapticTick tick(patient);
  std::jthread maker([&](const std::stop_token& stop) {
    for (std::uint32_t state = 1; !stop.stop_requested(); ++state) {
      tick.body()->refresh_corridor(state % 2 == 0 ? firmer_corridor(1.0 + 0.2 * (state % 5), state)
                                                   : pressed_corridor(0.1 * (state % 3), state));
    }
  });
  int taken = 0;
  double largest = 0.0;
  Vec3 before = Vec3::Zero();
  bool gave_way = false;
  for (int i = 0; i < 6000 || (taken < 5 && i < 1000000); ++i) {
    const Vec3 tip(0.1 * std::sin(0.003 * i), 0.0, 5.0 - 8.0 * std::cos(EIGEN_PI * i / 1500.0));
    const TickOutput output = tick.step({needle_pose(tip, Vec3::UnitZ())});
    if (!gave_way) largest = std::max(largest, (output.requested.force - before).norm());
    gave_way = false;
    before = output.requested.force;
    for (const Event& event : output.events) {
      taken += event.kind == EventKind::corridor_refreshed ? 1 : 0;
      gave_way = gave_way || event.kind == EventKind::puncture;
    }
  }
  EXPECT_GE(taken, 5);
  EXPECT_LT(largest, 0.1);
}

TEST(Corridors, taking_a_refreshed_one_allocates_and_locks_nothing) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer owns malloc and the locks in this build";
  const Case patient = patient_of_corridors(shaft_settings());
  HapticTick tick(patient);
  int taken = 0;
  for (std::uint32_t state = 1; state <= 6; ++state) {
    tick.body()->refresh_corridor(pressed_corridor(0.2 * state, state));
    if (state % 3 == 0) tick.body()->refresh_corridor(pressed_corridor(0.1 * state, state));
    const RealTimeGuard guard;
    for (int i = 0; i < 1000; ++i) {
      const double place = 8.0 * std::sin(EIGEN_PI * i / 500.0 - 0.5 * EIGEN_PI);
      const TickOutput output = tick.step({needle_pose(Vec3(0.0, 0.0, place), Vec3::UnitZ())});
      for (const Event& event : output.events) taken += event.kind == EventKind::corridor_refreshed ? 1 : 0;
    }
    EXPECT_EQ(RealTimeGuard::heap_calls(), 0U);
    EXPECT_EQ(RealTimeGuard::lock_calls(), 0U);
  }
  EXPECT_EQ(taken, 6);
}

TEST(Corridors, taking_another_one_allocates_and_locks_nothing) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer owns malloc and the locks in this build";
  const Case patient = patient_of_corridors(shaft_settings());
  HapticTick tick(patient);
  tick.body()->add_corridor(corridor_at(apart, 5));
  std::size_t heap = 0, locks = 0;
  int taken = 0;
  {
    const RealTimeGuard guard;
    for (int i = 0; i < 4000; ++i) {
      const double place = 8.0 * std::sin(EIGEN_PI * i / 500.0);
      const double x = i / 1000 % 2 == 0 ? 0.0 : apart;
      const TickOutput output = tick.step({needle_pose(Vec3(x, 0.0, place), Vec3::UnitZ())});
      for (const Event& event : output.events) taken += event.kind == EventKind::corridor_taken ? 1 : 0;
    }
    heap = RealTimeGuard::heap_calls();
    locks = RealTimeGuard::lock_calls();
  }
  EXPECT_GE(taken, 3);
  EXPECT_EQ(heap, 0U);
  EXPECT_EQ(locks, 0U);
}

}  // namespace
}  // namespace bodkin
