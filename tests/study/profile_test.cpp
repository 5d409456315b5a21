#include "study/profile.h"

#include <cmath>
#include <sstream>

#include "patient/synthetic/lumbar.h"
#include "report/crossings.h"
#include "report/force_plot.h"
#include "tests/session/slab_case.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/run_program.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::io;
using namespace bodkin::patient;
using namespace bodkin::report;
using namespace bodkin::simulation;
using namespace bodkin::study;
namespace {

std::string sentence_of(const Case& patient, const ProfileOptions& options) {
  try {
    insert_at_constant_speed(patient, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

ProfileOptions along(const Vec3& entry, const Vec3& target) {
  ProfileOptions options;
  options.entry = entry;
  options.target = target;
  return options;
}

// Resistance at the first tick at this depth or deeper.
double resistance_at(const Profile& profile, double depth) {
  for (const TickRecord& record : profile.ticks) {
    if (record.output.in_contact && record.output.depth >= depth - 1e-9) return record.output.resistance;
  }
  return std::nan("");
}

TEST(Profile, depth_counts_from_the_skin_and_grows_at_the_speed_asked_for) {
  const Profile profile = insert_at_constant_speed(slab_case(lumbar_slabs()), {});
  const TickRecord& first = profile.ticks.front();
  EXPECT_NEAR(first.input.needle.translation().y(), 10.0, 0.2);  // 10 mm behind the skin at y = 0
  EXPECT_FALSE(first.output.in_contact);
  for (const TickRecord& record : profile.ticks) {
    if (!record.output.in_contact) continue;
    EXPECT_NEAR(record.output.depth, -record.input.needle.translation().y(), 0.011);
  }
  EXPECT_NEAR(profile.ticks.back().output.depth, 52.0, 0.011);
  EXPECT_NEAR(static_cast<double>(profile.ticks.size()) * profile.dt, (52.0 + 10.0) / 10.0, 0.02);
}

TEST(Profile, the_tissues_begin_and_end_where_the_slabs_do) {
  const Slabs slabs = lumbar_slabs();
  const Profile profile = insert_at_constant_speed(slab_case(slabs), {});
  const std::vector<TissueCrossing> crossings = tissues_crossed(profile.ticks, profile.dt);
  ASSERT_EQ(crossings.size(), slabs.size());
  double depth = 0.0;
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    EXPECT_EQ(crossings[i].tissue, slabs[i].first);
    EXPECT_NEAR(crossings[i].from, depth, 0.011);  // one tick at 10 mm/s is 0.01 mm
    depth += slabs[i].second;
    if (i + 1 == slabs.size()) break;
    EXPECT_NEAR(crossings[i].time, slabs[i].second / 10.0, 0.002);
  }
}

TEST(Profile, skin_pushes_back_with_the_printed_polynomial_until_it_breaks) {
  Case patient = slab_case({{tissue::skin, 20.0}});
  const LayeredTissue skin = patient.library.find(tissue::skin)->layered;
  const Profile profile = insert_at_constant_speed(patient, {});
  for (const double depth : {1.0, 2.0, 3.0}) {
    // Heng 2004 eq. 2: k dx a (a + 1) (a + 2) / 6 + a rho v, a = x / dx.
    const double a = depth / skin.element_spacing;
    const double expected =
        skin.stiffness * skin.element_spacing * a * (a + 1) * (a + 2) / 6 + a * skin.viscosity * 10.0;
    ASSERT_LT(expected, skin.break_force);
    EXPECT_NEAR(resistance_at(profile, depth), expected, 0.02 * expected + 0.005) << depth;
  }
}

TEST(Profile, fat_drags_in_proportion_to_speed_and_length) {
  const Case patient = slab_case({{tissue::fat, 40.0}});
  const double drag = patient.library.find(tissue::fat)->layered.drag;
  ASSERT_GT(drag, 0.0);
  for (const double speed : {5.0, 20.0}) {
    ProfileOptions options;
    options.speed = speed;
    const Profile profile = insert_at_constant_speed(patient, options);
    for (const double depth : {5.0, 15.0}) {
      EXPECT_NEAR(resistance_at(profile, depth), drag * speed * depth, 0.03 * drag * speed * depth) << speed << depth;
    }
  }
}

TEST(Profile, bone_ends_the_insertion_at_the_force_the_device_can_show) {
  const Case patient = slab_case({{tissue::fat, 10.0}, {tissue::cortical_bone, 30.0}});
  const Profile profile = insert_at_constant_speed(patient, {});
  ASSERT_TRUE(profile.stopped_by_bone.has_value());
  const double stiffness = std::min(patient.library.find(tissue::cortical_bone)->layered.contact_stiffness,
                                    patient.description.device.stiffness);
  EXPECT_NEAR(*profile.stopped_by_bone, 10.0 + patient.description.device.peak_force / stiffness, 0.6);
  EXPECT_EQ(profile.ticks.back().output.tissue, tissue::cortical_bone);
  EXPECT_EQ(profile.outcome.find("stopped by cortical bone at "), 0U) << profile.outcome;
}

TEST(Profile, a_short_needle_stops_with_its_hub_on_the_skin) {
  Case patient = slab_case(lumbar_slabs());
  patient.description.needle.length = 30.0;
  const Profile profile = insert_at_constant_speed(patient, {});
  double deepest = 0.0;
  for (const TickRecord& record : profile.ticks) deepest = std::max(deepest, record.output.depth);
  EXPECT_NEAR(deepest, 30.0, 0.011);
  EXPECT_EQ(profile.outcome, "the hub met the skin at 30.0 mm");
  ASSERT_FALSE(profile.notes.empty());
  EXPECT_EQ(profile.notes.back(),
            "the needle is 30 mm long: its hub meets the skin 22.0 mm before the end of the path");
}

TEST(Profile, a_needle_that_is_withdrawn_ends_outside_after_its_rest) {
  ProfileOptions options;
  options.pause = 0.5;
  options.withdraw = true;
  const Profile profile = insert_at_constant_speed(slab_case(lumbar_slabs()), options);
  EXPECT_FALSE(profile.ticks.back().output.in_contact);
  const auto events = events_of(profile.ticks);
  EXPECT_TRUE(
      std::any_of(events.begin(), events.end(), [](const auto& e) { return e.event.kind == EventKind::withdrawn; }));
  const auto resting = std::count_if(profile.ticks.begin(), profile.ticks.end(), [&](const TickRecord& r) {
    return (r.input.needle.translation() - profile.path.target).norm() < 1e-9;
  });
  EXPECT_NEAR(static_cast<double>(resting), 501, 1);
}

TEST(Profile, an_entry_off_the_skin_is_brought_to_it_with_a_remark) {
  const Case patient = slab_case(lumbar_slabs());
  const Profile below = insert_at_constant_speed(patient, along(Vec3(0, -6, 0), Vec3(0, -40, 0)));
  EXPECT_NEAR(below.ticks.back().output.depth, 40.0, 0.02);
  ASSERT_EQ(below.notes.size(), 1U);
  EXPECT_NE(below.notes[0].find("6.0 mm below the skin"), std::string::npos) << below.notes[0];
  const Profile before = insert_at_constant_speed(patient, along(Vec3(0, 8, 0), Vec3(0, -40, 0)));
  EXPECT_NEAR(before.ticks.back().output.depth, 40.0, 0.02);
  ASSERT_EQ(before.notes.size(), 1U);
}

TEST(Profile, a_crop_without_skin_starts_at_the_entry_and_says_so) {
  Case patient = slab_case({{tissue::muscle, 40.0}});
  std::fill(patient.tissues.voxels.begin(), patient.tissues.voxels.end(), tissue::muscle);
  const Profile profile = insert_at_constant_speed(patient, along(Vec3(0, -5, 0), Vec3(0, -25, 0)));
  EXPECT_NEAR(profile.ticks.back().output.depth, 20.0, 0.02);
  ASSERT_EQ(profile.notes.size(), 1U);
  EXPECT_NE(profile.notes[0].find("no skin"), std::string::npos) << profile.notes[0];
}

TEST(Profile, a_path_that_misses_the_body_says_by_how_much) {
  // Parallel to the skin, 12 mm outside it; the nearest voxel centres lie 0.25 mm below the skin.
  const std::string sentence = sentence_of(slab_case(lumbar_slabs()), along(Vec3(-10, 12, 0), Vec3(10, 12, 0)));
  EXPECT_NE(sentence.find("misses the body by 12.2 mm"), std::string::npos) << sentence;
}

TEST(Profile, what_is_no_path_is_refused_with_a_sentence) {
  Case patient = slab_case(lumbar_slabs());
  const Vec3 skin(0, 0, 0), deep(0, -30, 0);
  const double nan = std::nan("");
  EXPECT_NE(sentence_of(patient, along(skin, skin)).find("apart"), std::string::npos);
  EXPECT_NE(
      sentence_of(patient, along(Vec3(0, 500, 0), deep)).find("the entry (0.0, 500.0, 0.0) lies outside the volume"),
      std::string::npos);
  EXPECT_NE(sentence_of(patient, along(skin, Vec3(0, -500, 0))).find("the target"), std::string::npos);
  EXPECT_NE(sentence_of(patient, along(Vec3(nan, 0, 0), deep)).find("finite"), std::string::npos);
  for (const double speed : {0.0, -3.0, 1e6, nan, 1.0 / 0.0}) {
    ProfileOptions options;
    options.speed = speed;
    EXPECT_NE(sentence_of(patient, options).find("--speed"), std::string::npos) << speed;
  }
  ProfileOptions beyond;
  beyond.beyond = 150.0;
  EXPECT_NE(sentence_of(patient, beyond).find("--beyond"), std::string::npos);
  patient.description.procedure.path.reset();
  EXPECT_NE(sentence_of(patient, {}).find("no planned path"), std::string::npos);
  std::fill(patient.tissues.voxels.begin(), patient.tissues.voxels.end(), tissue::air);
  EXPECT_NE(sentence_of(patient, along(skin, deep)).find("nothing but air"), std::string::npos);
}

TEST(Profile, its_table_reads_back) {
  Case patient = slab_case(lumbar_slabs());
  patient.ct = CtVolume(patient.tissues.grid);
  patient.structures = LabelVolume(patient.tissues.grid);
  patient.description.structures = {{7, "liver, left", "organ", true}};
  for (std::size_t n = 0; n < patient.ct.voxels.size(); ++n) {
    patient.ct.voxels[n] = static_cast<std::int16_t>(100 * patient.tissues.voxels[n]);
    patient.structures.voxels[n] = patient.tissues.voxels[n] == tissue::fat ? 7 : 0;
  }
  const Profile profile = insert_at_constant_speed(patient, {});
  std::istringstream table(profile_csv(profile, patient));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line.substr(0, line.find(',')), "time_s");
  EXPECT_TRUE(line.ends_with(",tissue,ct_HU,structure,tip_N,shaft_N")) << line;
  std::size_t row = 0;
  for (; std::getline(table, line); ++row) {
    const Vec3 tip = profile.ticks[row].input.needle.translation();
    const bool labelled = nearest(patient.structures, tip, std::uint16_t{0}) == 7;
    const auto quoted = line.find("\"liver, left\"");
    EXPECT_EQ(quoted != std::string::npos, labelled) << line;
    if (labelled) line.replace(quoted, std::string("\"liver, left\"").size(), "liver");
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    ASSERT_EQ(cells.size(), 15U);
    const TickOutput& output = profile.ticks[row].output;
    EXPECT_NEAR(std::stod(cells[0]), static_cast<double>(row) * 0.001, 1e-9);
    EXPECT_NEAR(std::stod(cells[1]), output.depth, 1e-6);
    EXPECT_NEAR(std::stod(cells[3]), output.resistance, 1e-6);
    EXPECT_NEAR(std::stod(cells[8]), output.applied.force.y(), 1e-6);
    EXPECT_EQ(cells[10], patient.library.find(output.tissue)->name);
    const double hounsfield = linear(patient.ct, tip, 1e6);
    EXPECT_EQ(cells[11].empty(), hounsfield == 1e6);
    if (!cells[11].empty()) {
      EXPECT_NEAR(std::stod(cells[11]), hounsfield, 0.051);
    }
    EXPECT_EQ(cells[12], labelled ? "liver" : "");
    EXPECT_NEAR(std::stod(cells[13]) + std::stod(cells[14]), output.resistance, 2e-6);
  }
  EXPECT_EQ(row, profile.ticks.size());
}

TEST(Profile, its_plot_names_every_tissue_and_what_gave_way) {
  const Case patient = slab_case(lumbar_slabs());
  const Profile profile = insert_at_constant_speed(patient, {});
  const std::string svg =
      draw_plot(force_against_depth(profile.ticks, events_of(profile.ticks), profile.dt, patient)).svg();
  EXPECT_EQ(run_program({"xmllint", "--noout", "-"}, svg, "libxml2-utils").exit_code, 0);
  for (const auto& [id, thickness] : lumbar_slabs()) {
    EXPECT_NE(svg.find(patient.library.title(id)), std::string::npos) << patient.library.title(id);
  }
  EXPECT_NE(svg.find("skin gives way"), std::string::npos);
  EXPECT_NE(svg.find("loss of resistance"), std::string::npos);
}

TEST(Profile, a_synthetic_lumbar_puncture_meets_its_tissues_in_the_order_of_anatomy) {
  LumbarParameters parameters;
  parameters.spacing = 1.5;
  Case patient;
  patient.library = default_tissue_library();
  const SyntheticPatient made = synthesize_lumbar(parameters, patient.library);
  patient.tissues = made.tissues;
  patient.description.procedure.path = made.path;
  const Profile profile = insert_at_constant_speed(patient, {});
  const std::vector<TissueCrossing> crossings = tissues_crossed(profile.ticks, profile.dt);
  std::vector<TissueId> order;
  for (const TissueCrossing& crossing : crossings) order.push_back(crossing.tissue);
  const auto place = [&](TissueId id) { return std::find(order.begin(), order.end(), id) - order.begin(); };
  EXPECT_EQ(order.front(), tissue::skin);
  EXPECT_LT(place(tissue::fat), place(tissue::interspinous_ligament));
  EXPECT_LT(place(tissue::interspinous_ligament), place(tissue::ligamentum_flavum));
  EXPECT_LT(place(tissue::ligamentum_flavum), place(tissue::epidural_fat));
  EXPECT_LT(place(tissue::epidural_fat), place(tissue::cerebrospinal_fluid));
  EXPECT_LT(place(tissue::cerebrospinal_fluid), static_cast<std::ptrdiff_t>(order.size()));
  const auto events = events_of(profile.ticks);
  EXPECT_TRUE(std::any_of(events.begin(), events.end(),
                          [](const auto& e) { return e.event.kind == EventKind::loss_of_resistance; }));
}

}  // namespace
}  // namespace bodkin
