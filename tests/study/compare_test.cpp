#include "study/compare.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <sstream>

#include "report/compare_plot.h"
#include "study/profile.h"
#include "tests/session/slab_case.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "io/run_program.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::io;
using namespace bodkin::report;
using namespace bodkin::simulation;
using namespace bodkin::study;
namespace {

constexpr std::size_t in = 0, stop = 1, out = 2, again = 3;

CompareOptions options_of(const std::vector<std::string>& names, const ResistanceSettings& own = {}) {
  CompareOptions options;
  options.models = models_of(names, own);
  return options;
}

// Options that compare all models.
CompareOptions options_of_all(double speed, double pause) {
  CompareOptions options = options_of({});
  options.speed = speed;
  options.pause = pause;
  return options;
}

// The patient with `change` applied to every tissue.
Case with_tissues(Case patient, const std::function<void(TissueProperties&)>& change) {
  std::vector<TissueProperties> tissues = patient.library.tissues();
  std::for_each(tissues.begin(), tissues.end(), change);
  patient.library = TissueLibrary(tissues);
  return patient;
}

// 40 mm of muscle, the target 20 mm deep, whose tracking wall follows at `force` N.
Case muscle_with_wall(double force) {
  return with_tissues(slab_case({{tissue::muscle, 40.0}}), [&](TissueProperties& tissue) {
    tissue.tracking_wall = {0.5, tissue.id == tissue::muscle ? force : 0.0};
  });
}

// A plain spring from the skin inwards.
const ResistanceSettings plain_spring =
    SpringDamperWallSettings{.stiffness = 0.25, .damping = 0.0, .wall = 0.0, .limit = 100.0};

const ModelRun& run_of(const Comparison& comparison, const std::string& name) {
  const auto found = std::find_if(comparison.models.begin(), comparison.models.end(),
                                  [&](const ModelRun& run) { return run.name == name; });
  if (found == comparison.models.end()) throw std::runtime_error(name + " did not run");
  return *found;
}

// The message that refuses `layered` with changed options.
std::string comparison_refused(const Case& patient, const std::function<void(CompareOptions&)>& change) {
  try {
    CompareOptions options = options_of({"layered"});
    change(options);
    compare_models(patient, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Compare, a_tracking_wall_rests_on_its_plateau_until_the_needle_does) {
  const Comparison comparison = compare_models(muscle_with_wall(2.0), options_of({"tracking_wall"}));
  const ModelRun& run = comparison.models[0];
  EXPECT_NEAR(run.peak, 2.0, 1e-9);  // f_R
  for (std::size_t tick = 0; tick < comparison.first[stop]; ++tick) {
    // Alamilla 2018 eq. 3 and 7: the spring as far as f_R / K_t = 4 mm, then f_R.
    const double expected = 0.5 * std::clamp(comparison.depth[tick], 0.0, 4.0);
    ASSERT_NEAR(run.force[tick], expected, 0.02) << comparison.depth[tick];
  }
  EXPECT_NEAR(run.end_of_stop, 0.0, 1e-9);  // the wall has caught up within 0.5 s, the needle rests for 2 s
  EXPECT_NEAR(run.work[in], 0.5 * 2.0 * 4.0 + 2.0 * 16.0, 0.1);
  // Within the cut channel the needle is free down to its old depth.
  EXPECT_NEAR(run.peak_again, 0.0, 0.05);
  EXPECT_NEAR(run.work[again], 0.0, 0.05);
}

TEST(Compare, layered_feels_what_its_profile_shows) {
  const Case patient = slab_case(lumbar_slabs());
  ProfileOptions profile_options;
  profile_options.pause = 2.0;
  profile_options.withdraw = true;
  const Profile profile = insert_at_constant_speed(patient, profile_options);
  const Comparison comparison = compare_models(patient, options_of({"layered"}));
  ASSERT_EQ(comparison.first[again], profile.ticks.size());
  double peak = 0.0;
  int punctures = 0;
  for (const TickRecord& record : profile.ticks) {
    ASSERT_EQ(comparison.models[0].force[record.tick], record.output.resistance) << record.tick;
    peak = std::max(peak, record.output.resistance);
    for (const Event& event : record.output.events) punctures += event.kind == EventKind::puncture ? 1 : 0;
    if (record.output.in_contact) {
      ASSERT_NEAR(comparison.depth[record.tick], record.output.depth, 1e-3);
    }
    ASSERT_EQ(comparison.tissue[record.tick], record.output.tissue);
  }
  EXPECT_EQ(comparison.models[0].peak, peak);
  EXPECT_GT(punctures, 2);
  EXPECT_EQ(comparison.models[0].punctures[in], punctures);
}

TEST(Compare, work_is_the_integral_of_force_over_depth) {
  const Comparison comparison =
      compare_models(muscle_with_wall(2.0), options_of({"spring_damper_wall"}, plain_spring));
  const ModelRun& run = comparison.models[0];
  const double stored = 0.5 * 0.25 * 20.0 * 20.0;  // K d^2 / 2
  EXPECT_NEAR(run.peak, 0.25 * 20.0, 0.01);
  EXPECT_NEAR(run.work[in], stored, 0.002 * stored);
  EXPECT_EQ(run.work[stop], 0.0);
  EXPECT_NEAR(run.work[out], -stored, 0.002 * stored);
  EXPECT_NEAR(run.work[again], stored, 0.002 * stored);
  EXPECT_NEAR(run.closed_work, 0.0, 1e-6 * stored);

  const Case fat = slab_case({{tissue::fat, 40.0}});
  const double drag = fat.library.find(tissue::fat)->layered.drag;
  const ModelRun dragged = compare_models(fat, options_of({"layered"})).models[0];
  EXPECT_NEAR(dragged.work[in], 0.5 * drag * 10.0 * 20.0 * 20.0, 0.03 * 0.5 * drag * 10.0 * 20.0 * 20.0);
}

TEST(Compare, no_model_gives_the_hand_energy_on_a_closed_path) {
  Random random(20260101);
  for (int round = 0; round < 3; ++round) {
    Slabs slabs = {{tissue::skin, 2.0}};
    for (const TissueId id : {tissue::fat, tissue::muscle, tissue::interspinous_ligament, tissue::ligamentum_flavum,
                              tissue::epidural_fat, tissue::dura}) {
      slabs.emplace_back(id, 0.5 * std::floor(random.uniform(1.0, 20.0)));
    }
    slabs.emplace_back(tissue::cerebrospinal_fluid, 10.0);
    const Case patient = with_tissues(slab_case(slabs), [&](TissueProperties& tissue) {
      if (tissue.id == tissue::air) return;
      const double firm = random.uniform();
      tissue.tracking_wall = {0.1 + 0.4 * firm, 3.0 * firm};
      tissue.depth_profile = {DepthProfileKind::soft, 0.5 * firm, 0.0};
      tissue.volume_proxy.properties = {2.0 * firm, firm, 0.5 * firm, 0.01 * firm};
      tissue.volume_proxy.field_value = firm;
      tissue.shaft_friction = {0.02 * firm, 0.03 * firm, 0.05, 0.001 * firm};
    });
    const double speed = random.uniform(8.0, 40.0), pause = random.uniform(0.0, 1.0);
    const Comparison comparison = compare_models(patient, options_of_all(speed, pause));
    EXPECT_GT(comparison.models.size(), 9U);
    for (const ModelRun& run : comparison.models) EXPECT_GT(run.closed_work, -1e-3) << run.name;
  }
}

TEST(Compare, a_model_does_not_differ_from_itself_and_from_others_by_a_known_amount) {
  CompareOptions options = options_of({"tracking_wall", "spring_damper_wall"}, plain_spring);
  options.pause = 0.0;
  options.reinsert = false;
  const Case patient = muscle_with_wall(0.0);
  const Comparison comparison = compare_models(patient, options);
  EXPECT_EQ(comparison.reference, 0U);  // without layered: the first named model
  EXPECT_EQ(comparison.models[0].largest_difference, 0.0);
  EXPECT_EQ(comparison.models[0].rms_difference, 0.0);
  // Compared with no force, a linear rise to 5 N and back: RMS 5 / sqrt(3).
  EXPECT_EQ(comparison.models[0].peak, 0.0);
  EXPECT_NEAR(comparison.models[1].largest_difference, 5.0, 0.01);
  EXPECT_NEAR(comparison.models[1].rms_difference, 5.0 / std::sqrt(3.0), 0.01);

  const Comparison all = compare_models(slab_case(lumbar_slabs()), options_of({"fracture", "layered"}));
  EXPECT_EQ(all.models[all.reference].name, "layered");
  EXPECT_EQ(run_of(all, "layered").largest_difference, 0.0);
  EXPECT_GT(run_of(all, "fracture").largest_difference, 0.1);
}

TEST(Compare, gives_the_same_bits_twice) {
  const Case patient = slab_case(lumbar_slabs());
  const CompareOptions options = options_of_all(30.0, 0.2);
  const Comparison one = compare_models(patient, options), two = compare_models(patient, options);
  ASSERT_EQ(one.models.size(), two.models.size());
  for (std::size_t i = 0; i < one.models.size(); ++i) {
    EXPECT_EQ(one.models[i].force, two.models[i].force) << one.models[i].name;
    EXPECT_EQ(one.models[i].work, two.models[i].work);
  }
  EXPECT_EQ(comparison_csv(one), comparison_csv(two));
}

TEST(Compare, the_motion_goes_in_rests_comes_out_and_goes_in_again) {
  CompareOptions options = options_of({"layered"});
  options.speed = 20.0;
  options.withdraw_speed = 40.0;
  options.pause = 0.5;
  const Comparison comparison = compare_models(slab_case(lumbar_slabs()), options);
  const auto duration = [&](std::size_t phase) {
    return static_cast<double>(comparison.first[phase + 1] - comparison.first[phase]) * comparison.dt;
  };
  EXPECT_NEAR(duration(in), (52.0 + 10.0) / 20.0, 0.01);  // the target is 52 mm deep
  EXPECT_NEAR(duration(stop), 0.5, 0.002);
  EXPECT_NEAR(duration(out), (52.0 + 20.0) / 40.0, 0.01);
  EXPECT_NEAR(duration(again), (52.0 + 20.0) / 20.0, 0.01);
  EXPECT_EQ(comparison.first[again + 1], comparison.depth.size());
  EXPECT_NEAR(comparison.depth.front(), -10.0, 1e-3);
  EXPECT_NEAR(comparison.depth[comparison.first[stop] - 1], 52.0, 1e-3);
  EXPECT_NEAR(comparison.depth[comparison.first[again] - 1], -20.0, 1e-3);
  EXPECT_NEAR(comparison.depth.back(), 52.0, 1e-3);
  EXPECT_EQ(comparison.phase_of(comparison.first[out] - 1), MotionPhase::stop);
  EXPECT_EQ(comparison.phase_of(comparison.first[out]), MotionPhase::withdrawal);
  options.reinsert = false;
  options.pause = 0.0;
  const Comparison shorter = compare_models(slab_case(lumbar_slabs()), options);
  EXPECT_EQ(shorter.first[again], shorter.depth.size());
  EXPECT_EQ(shorter.models[0].work[again], 0.0);
}

TEST(Compare, bone_ends_the_motion_where_the_device_has_no_more_force) {
  const Case patient = slab_case({{tissue::fat, 10.0}, {tissue::cortical_bone, 30.0}});
  const Comparison comparison = compare_models(patient, options_of({"layered", "spring_damper_wall"}));
  const DeviceLimits& device = patient.description.device;
  const double stiffness =
      std::min(patient.library.find(tissue::cortical_bone)->layered.contact_stiffness, device.stiffness);
  ASSERT_TRUE(comparison.ends_in_bone.has_value());
  EXPECT_NEAR(*comparison.ends_in_bone, 10.0 + device.peak_force / stiffness, 0.2);
  EXPECT_NEAR(comparison.depth.back(), *comparison.ends_in_bone, 1e-9);
  EXPECT_NEAR(run_of(comparison, "layered").peak, device.peak_force, 0.6);
  ASSERT_EQ(comparison.notes.size(), 1U);
  EXPECT_NE(comparison.notes[0].find("cortical"), std::string::npos) << comparison.notes[0];
}

TEST(Compare, variants_are_curves_of_their_own_and_the_cases_settings_stay) {
  TrackingWallSettings own;
  own.leash = true;
  own.limit = 1.0;  // N, below f_R
  const Comparison comparison = compare_models(muscle_with_wall(1.5), options_of({}, own));
  std::vector<std::string> names;
  for (const ModelRun& run : comparison.models) names.push_back(run.name);
  for (const ModelRefused& model : comparison.refused) names.push_back(model.name);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), compared_names().size());
  for (const std::string_view name : resistance_names) {
    if (name == "surface_proxy" || name == "registered") continue;  // no insertion; no model without its name
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
  for (const char* name : {"tracking_wall", "tracking_wall_leash"})
    EXPECT_NEAR(run_of(comparison, name).peak, 1.0, 1e-9) << name;
  EXPECT_GT(run_of(comparison, "layered_sum").largest_difference, 0.01);
}

TEST(Compare, settings_make_curves_of_one_model) {
  const std::vector<std::string> texts = {"tracking_wall catch_up_s=0.2", "tracking_wall catch_up_s=4",
                                          "tracking_wall catch_up_s=4"};
  CompareOptions options = options_of(texts);
  ASSERT_EQ(options.models.size(), 2U);
  options.pause = 1.0;
  const Comparison comparison = compare_models(muscle_with_wall(2.0), options);
  EXPECT_NEAR(comparison.models[0].end_of_stop, 0.0, 1e-9);
  // A quarter of the decay from 2 N to zero, less the tenth of a second in which a stop is detected.
  EXPECT_NEAR(comparison.models[1].end_of_stop, 1.5, 0.06);
  const std::string table = comparison_csv(comparison);
  EXPECT_EQ(table.substr(0, table.find('\n')),
            "time_s,depth_mm,tracking_wall_catch_up_s_0.2_N,tracking_wall_catch_up_s_0.2_wall_mm,"
            "tracking_wall_catch_up_s_4_N,tracking_wall_catch_up_s_4_wall_mm");
  const std::vector<Plot> plots = comparison_plots(comparison, muscle_with_wall(2.0).library, 6.0);
  EXPECT_EQ(plots[1].series[0].colour, plots[1].series[1].colour);
  EXPECT_NE(plots[1].series[0].dash, plots[1].series[1].dash);
}

TEST(Compare, a_model_that_cannot_run_is_named_and_the_others_go_on) {
  Case patient = slab_case(lumbar_slabs());
  patient.ct = CtVolume();
  const CompareOptions options = options_of({"volume_proxy", "layered"});
  const Comparison comparison = compare_models(patient, options);
  ASSERT_EQ(comparison.models.size(), 1U);
  EXPECT_EQ(comparison.models[0].name, "layered");
  ASSERT_EQ(comparison.refused.size(), 1U);
  EXPECT_EQ(comparison.refused[0].name, "volume_proxy");
  EXPECT_NE(comparison.refused[0].reason.find("no CT"), std::string::npos) << comparison.refused[0].reason;
  const std::string none = comparison_refused(patient, [](auto& o) {
    o.models = models_of({"volume_proxy", "volume_proxy_viscous"}, {});
  });
  EXPECT_NE(none.find("no CT"), std::string::npos) << none;
  EXPECT_EQ(none.find("no CT"), none.rfind("no CT")) << none;
}

TEST(Compare, parts_of_the_case_are_kept_unless_others_are_given) {
  Case patient = with_tissues(muscle_with_wall(2.0), [](TissueProperties& tissue) {
    tissue.shaft_friction = {0.02, 0.02, 0.05, 0.0};
  });
  patient.description.haptics.parts.shaft_friction.emplace();
  CompareOptions options = options_of({"spring_damper_wall", "layered"}, plain_spring);
  const Comparison rubbing = compare_models(patient, options);
  ASSERT_EQ(rubbing.refused.size(), 1U);  // layered has its own friction
  EXPECT_GT(run_of(rubbing, "spring_damper_wall").closed_work, 1.0);
  options.parts = ForceParts{};
  const Comparison bare = compare_models(patient, options);
  EXPECT_TRUE(bare.refused.empty());
  EXPECT_NEAR(run_of(bare, "spring_damper_wall").closed_work, 0.0, 1e-3);
}

TEST(Compare, what_makes_no_sense_is_refused_with_a_sentence) {
  const Case patient = slab_case(lumbar_slabs());
  const auto refused = [&](const std::function<void(CompareOptions&)>& change, const std::string& words) {
    const std::string sentence = comparison_refused(patient, change);
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
  };
  refused(
      [](auto& o) {
        o.models = models_of({"layered", "jelly"}, {});
      },
      "'jelly', expected 'all' or some of layered, layered_sum");
  refused([](auto& o) { o.models.clear(); }, "no model");
  refused([](auto& o) { o.speed = std::nan(""); }, "--speed");
  refused([](auto& o) { o.withdraw_speed = 0.0; }, "--withdraw-speed");
  refused([](auto& o) { o.pause = 61.0; }, "--pause");
  refused([](auto& o) { o.entry = Vec3(-10, 12, 0), o.target = Vec3(10, 12, 0); }, "misses the body by 12.2 mm");
  Case fast = slab_case({{tissue::fat, 400.0}});
  fast.description.haptics.rate = 4000.0;
  fast.description.needle.length = 400.0;
  fast.description.procedure.path->target = Vec3(0, -390, 0);
  EXPECT_NE(comparison_refused(fast, [](auto& o) { o.speed = 0.5; }).find("million ticks"), std::string::npos);
}

TEST(Compare, its_table_reads_back) {
  CompareOptions options = options_of({"layered", "tracking_wall_leash", "fracture"});
  options.speed = 50.0;
  const Comparison comparison = compare_models(slab_case(lumbar_slabs()), options);
  std::istringstream table(comparison_csv(comparison));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line,
            "time_s,depth_mm,layered_N,layered_tip_N,layered_shaft_N,tracking_wall_leash_N,"
            "tracking_wall_leash_wall_mm,fracture_N,fracture_stored_N_mm,fracture_wall_mm");
  std::size_t row = 0;
  for (; std::getline(table, line); ++row) {
    std::vector<double> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(std::stod(cell));
    ASSERT_EQ(cells.size(), 10U);
    ASSERT_NEAR(cells[0], static_cast<double>(row) * 0.001, 1e-9);
    ASSERT_NEAR(cells[1], comparison.depth[row], 1e-6);
    ASSERT_NEAR(cells[2], comparison.models[0].force[row], 1e-6);
    ASSERT_NEAR(cells[3] + cells[4], cells[2], 3e-6) << "tip and shaft are all of it";
    ASSERT_NEAR(cells[5], comparison.models[1].force[row], 1e-6);
    ASSERT_NEAR(cells[6], comparison.models[1].published[row], 1e-6);
    ASSERT_NEAR(cells[7], comparison.models[2].force[row], 1e-6);
  }
  EXPECT_EQ(row, comparison.depth.size());
}

TEST(Compare, its_plots_name_models_tissues_and_phases_and_tell_every_curve_apart) {
  const Case patient = slab_case(lumbar_slabs());
  Comparison comparison = compare_models(patient, options_of_all(50.0, 0.5));
  const ModelRun some = comparison.models.front();
  comparison.models.clear();
  for (const std::string_view name : compared_names()) {
    comparison.models.push_back(some);
    comparison.models.back().name = name;
  }
  const std::vector<Plot> plots = comparison_plots(comparison, patient.library, 6.0);
  std::set<std::pair<std::uint32_t, std::vector<double>>> looks;
  for (const PlotSeries& series : plots[1].series) looks.emplace(series.colour, series.dash);
  EXPECT_EQ(looks.size(), compared_names().size());
  const std::string svg = draw_plots(plots).svg();
  EXPECT_EQ(run_program({"xmllint", "--huge", "--noout", "-"}, svg, "libxml2-utils").exit_code, 0);
  for (const std::string_view name : compared_names()) EXPECT_NE(svg.find(name), std::string::npos) << name;
  for (const std::string_view name : phase_names) EXPECT_NE(svg.find(name), std::string::npos) << name;
  for (const auto& [id, thickness] : lumbar_slabs()) {
    EXPECT_NE(svg.find(patient.library.title(id)), std::string::npos) << patient.library.title(id);
  }
}

TEST(Compare, with_a_physical_description_the_models_that_know_layers_tell_the_same_in_the_same_order) {
  Case patient = slab_case({{tissue::skin, 2.0},
                            {tissue::fat, 8.0},
                            {tissue::interspinous_ligament, 12.0},
                            {tissue::ligamentum_flavum, 4.0},
                            {tissue::epidural_fat, 6.0},
                            {tissue::dura, 1.0},
                            {tissue::cerebrospinal_fluid, 24.0}});
  patient.description.haptics.mechanics = Mechanics::physical;
  const Comparison comparison =
      compare_models(std::move(patient), options_of({"layered", "layered_sum", "tracking_wall", "tracking_wall_leash",
                                                     "depth_profile", "volume_proxy"}));
  const std::vector<std::pair<EventKind, TissueId>> wanted = {{EventKind::puncture, tissue::skin},
                                                              {EventKind::puncture, tissue::interspinous_ligament},
                                                              {EventKind::puncture, tissue::ligamentum_flavum},
                                                              {EventKind::loss_of_resistance, tissue::epidural_fat},
                                                              {EventKind::puncture, tissue::dura}};
  for (const ModelRun& run : comparison.models) {
    std::vector<std::pair<EventKind, TissueId>> told;
    for (const ReportedEvent& each : run.events) told.emplace_back(each.event.kind, each.event.tissue);
    EXPECT_EQ(told, wanted) << run.name;
  }
  EXPECT_EQ(comparison.models[0].peak_tissue, tissue::ligamentum_flavum)
      << "what gave way, not what was behind the tip";
}

}  // namespace
}  // namespace bodkin
