// The newest tick on its way to a remote screen.
#include "link/needle_state.h"

#include <array>
#include <limits>

#include "link/contents.h"
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin::link {
namespace {

constexpr std::array<forces::DiagnosticName, 2> names = {
    {{"wall_mm", "position of the wall"}, {"stretch_mm", "stretch of the tissue"}}};

TEST(NeedleState, arrives_as_it_was_sent_with_forces_in_ras_between) {
  station::StationStatus status;
  simulation::TickOutput& output = status.needle.output;
  status.time = 12.5;
  output.depth = 41.25;
  output.velocity = -3.0;
  output.requested.force = Vec3(1.0, 2.0, 3.0);
  output.applied.force = Vec3(-0.5, 0.25, 4.0);
  output.resistance = 2.0;
  output.constraint = 0.75;
  output.energy = 80.0;
  output.tissue = 255;
  output.in_contact = true;
  output.diagnostics = {39.0, 1.5};
  status.servo.limits = 5;
  status.timings.ticks = 1ULL << 40U;
  status.timings.overruns = 17;
  status.timings.recent_success = 0.99;
  output.drawn_in = 0.625;
  const Bytes content = needle_state_content(needle_state(status, names.size()));
  const NumberArray row = read_array(content);
  ASSERT_EQ(row.values.size(), needle_state_columns(names).size()) << "every number has a name";
  const std::vector<std::string> columns = needle_state_columns(names);
  EXPECT_EQ(columns[3], "requested_R_N");
  EXPECT_EQ(row.values[3], -1.0) << "to the right is against LPS";
  EXPECT_EQ(row.values[5], 3.0);
  EXPECT_EQ(columns.back(), "stretch_mm");
  EXPECT_EQ(row.values.back(), 1.5);

  const NeedleState read = read_needle_state(content);
  EXPECT_EQ(read.time, 12.5);
  EXPECT_EQ(read.depth, 41.25);
  EXPECT_EQ(read.velocity, -3.0);
  EXPECT_EQ(read.requested, output.requested.force);
  EXPECT_EQ(read.applied, output.applied.force);
  EXPECT_EQ(read.resistance, 2.0);
  EXPECT_EQ(read.constraint, 0.75);
  EXPECT_EQ(read.energy, 80.0);
  EXPECT_EQ(read.tissue, 255);
  EXPECT_TRUE(read.in_contact);
  EXPECT_EQ(read.limits, 5U);
  EXPECT_EQ(read.ticks, 1ULL << 40U);
  EXPECT_EQ(read.late_ticks, 17U);
  EXPECT_EQ(read.recent_success, 0.99);
  EXPECT_EQ(read.drawn_in, 0.625);
  EXPECT_EQ(read.diagnostics, (std::vector<double>{39.0, 1.5}));
}

TEST(NeedleState, of_a_foreign_server_is_refused_or_kept_within_what_the_numbers_can_be) {
  std::vector<double> row(19, 0.0);
  EXPECT_THROW(read_needle_state(array_content(std::span(row).first(18), 18)), InputError);
  EXPECT_THROW(read_needle_state(array_content(row, 9)), InputError) << "two rows";
  row[12] = 256.0;
  row[14] = -1.0;
  row[15] = 1e300;
  const NeedleState read = read_needle_state(array_content(row, row.size()));
  EXPECT_EQ(read.tissue, 0);
  EXPECT_EQ(read.limits, 0U);
  EXPECT_EQ(read.ticks, 0U);
  row[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(read_needle_state(array_content(row, row.size())), InputError);
}

}  // namespace
}  // namespace bodkin::link
