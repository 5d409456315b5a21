#include "report/material_depth.h"

#include <algorithm>

#include "report/crossings.h"
#include "report/force_plot.h"
#include "study/profile.h"
#include "tests/session/slab_case.h"
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::report;
using namespace bodkin::session;
namespace {

// Of the slabs, driven in at 10 mm/s.
study::Profile profile_with(Mechanics mechanics, Case& patient) {
  patient = slab_case(lumbar_slabs());
  patient.description.haptics.mechanics = mechanics;
  return study::insert_at_constant_speed(patient, {});
}

std::vector<RecordedDiagnostic> recorded(const study::Profile& profile) {
  std::vector<RecordedDiagnostic> found;
  for (const forces::DiagnosticName& one : profile.diagnostics)
    found.push_back({std::string(one.name), std::string(one.title)});
  return found;
}

TEST(MaterialDepth, stays_where_a_tissue_is_pushed_and_has_not_given_way) {
  Case patient;
  const study::Profile profile = profile_with(Mechanics::physical, patient);
  const std::vector<SessionEvent> events = events_of(profile.ticks);
  const MaterialDepths inside = in_material(profile.ticks, events, recorded(profile));
  ASSERT_EQ(inside.ticks.size(), profile.ticks.size());
  double most = 0.0;
  for (std::size_t tick = 0; tick < inside.ticks.size(); ++tick) {
    const double behind = profile.ticks[tick].output.depth - inside.ticks[tick].output.depth;
    EXPECT_GE(behind, -1e-9);
    most = std::max(most, behind);
  }
  EXPECT_GT(most, 2.0) << "a ligament is pushed before it gives way";
  ASSERT_EQ(inside.events.size(), events.size());
  for (std::size_t i = 0; i < events.size(); ++i)
    EXPECT_LE(inside.events[i].event.depth, events[i].event.depth + 1e-9);
  const Plot plot = force_against_depth(inside.ticks, inside.events, profile.dt, patient);
  ASSERT_FALSE(plot.series.empty());
  EXPECT_FALSE(plot.bands.empty());
}

TEST(MaterialDepth, is_refused_where_the_models_do_not_know_it) {
  Case patient;
  const study::Profile profile = profile_with(Mechanics::tables, patient);
  EXPECT_FALSE(material_diagnostic(recorded(profile)));
  EXPECT_THROW(in_material(profile.ticks, {}, recorded(profile)), InputError);
}

TEST(MaterialDepth, is_asked_for_by_its_name) {
  EXPECT_EQ(parse_plotted_depth("hand", "--depth"), PlottedDepth::hand);
  EXPECT_EQ(parse_plotted_depth("material", "--depth"), PlottedDepth::material);
  EXPECT_THROW(parse_plotted_depth("deep", "--depth"), InputError);
  EXPECT_NE(depth_label(PlottedDepth::hand), depth_label(PlottedDepth::material));
}

// The remainder of a puncture's force in the next tissue belongs to the punctured one.
TEST(MaterialDepth, the_fall_after_a_puncture_is_no_peak_of_the_next_tissue) {
  std::vector<simulation::TickRecord> ticks;
  const auto add = [&](double depth, double force, TissueId tissue) -> simulation::TickOutput& {
    simulation::TickRecord& record = ticks.emplace_back();
    record.tick = ticks.size();
    record.output.depth = depth;
    record.output.resistance = force;
    record.output.tissue = tissue;
    record.output.in_contact = true;
    return record.output;
  };
  for (int i = 0; i <= 15; ++i) add(0.1 * i, 0.1 * i, tissue::skin);
  add(1.6, 1.5, tissue::fat).events.push({forces::EventKind::puncture, tissue::skin, 1.6, 1.5, 1.5});
  for (int i = 0; i < 15; ++i) add(1.6 + 0.1 * i, 1.4 - 0.1 * i, tissue::fat);
  for (int i = 0; i < 20; ++i) add(3.2 + 0.1 * i, 0.01 * i, tissue::fat);
  const std::vector<TissueCrossing> crossings = tissues_crossed(ticks, 1e-3);
  ASSERT_EQ(crossings.size(), 2U);
  EXPECT_NEAR(crossings[0].peak_force, 1.5, 1e-9);
  EXPECT_NEAR(crossings[1].peak_force, 0.19, 1e-9);
}

}  // namespace
}  // namespace bodkin
