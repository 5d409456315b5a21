#include "app/models/parameter_model.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "app/models/live_profile.h"
#include <gmock/gmock.h>

#include "core/error.h"
#include "io/tissue_library_file.h"

namespace bodkin::app {
namespace {

using ::testing::HasSubstr;

// Skin, fat and muscle in layers, entered straight from above.
std::shared_ptr<const OpenCase> layered_patient() {
  auto patient = std::make_shared<OpenCase>();
  anatomy::Case& made = patient->patient;
  made.library = io::default_tissue_library();
  anatomy::Grid grid;
  grid.size = {30, 60, 30};
  made.tissues = anatomy::TissueVolume(grid, anatomy::tissue::air);
  for (int z = 0; z < 30; ++z) {
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 30; ++x) {
        made.tissues.at(x, y, z) = y >= 37   ? anatomy::tissue::skin
                                   : y >= 30 ? anatomy::tissue::fat
                                             : anatomy::tissue::muscle;
      }
    }
  }
  made.description.haptics.resistance = anatomy::LayeredSettings{};
  made.description.haptics.constraint = anatomy::LineSpringSettings{};
  made.description.procedure.path = anatomy::NeedlePath{Vec3(15.0, 39.5, 15.0), Vec3(15.0, 15.0, 15.0)};
  return patient;
}

std::size_t step_called(const ParameterModel& model, const std::string& title) {
  const auto found = std::find_if(model.steps().begin(), model.steps().end(),
                                  [&](const SettingStep& step) { return step.title == title; });
  EXPECT_NE(found, model.steps().end()) << title;
  return static_cast<std::size_t>(found - model.steps().begin());
}

TEST(ParameterModel, the_acupuncture_model_has_eleven_steps_with_the_declared_ranges) {
  const ParameterModel model(layered_patient());
  ASSERT_EQ(model.steps().size(), 11U);
  const SettingStep& give = model.steps()[step_called(model, "Skin: break force")];
  EXPECT_EQ(give.unit, "N");
  EXPECT_EQ(give.range.high, 100.0);
  EXPECT_FALSE(give.range.includes_low);
  EXPECT_THAT(give.source, HasSubstr("van Gerwen"));
  EXPECT_NEAR(model.value(step_called(model, "Skin: break force")), 1.3, 1e-12);
  for (std::size_t i = 0; i < model.steps().size(); ++i) {
    const SettingStep& step = model.steps()[i];
    EXPECT_FALSE(step.question.empty());
    EXPECT_LE(step.low, model.value(i)) << step.title;
    EXPECT_GE(step.high, model.value(i)) << step.title;
    EXPECT_TRUE(step.range.contains(step.low) || step.range.low == step.low) << step.title;
  }
}

TEST(ParameterModel, every_model_has_a_step_for_each_number_that_it_declares) {
  ParameterModel model(layered_patient());
  for (const std::string_view name : model.models()) {
    model.choose_model(name);
    EXPECT_EQ(model.model(), name);
    EXPECT_GE(model.steps().size(), 3U) << name;
  }
  model.choose_model("tracking_wall");
  const auto in_skin = step_called(model, "Skin: stiffness");
  EXPECT_EQ(model.steps()[in_skin].name, "stiffness_N_per_mm");
  step_called(model, "Muscle: force");
  step_called(model, "Model: catch up");
  EXPECT_THROW(model.choose_model("soft_wall"), InputError);
}

TEST(ParameterModel, all_numbers_of_the_tissues_on_the_path_are_there_when_asked_for) {
  ParameterModel model(layered_patient());
  model.show_all(true);
  EXPECT_GT(model.steps().size(), 20U);
  step_called(model, "Muscle: shaft stiffness");
  step_called(model, "Fat: drag");
  for (const SettingStep& step : model.steps()) EXPECT_NE(step.tissue, anatomy::tissue::cortical_bone) << step.title;
}

TEST(ParameterModel, a_change_is_undone_and_redone_and_a_drag_is_one_change) {
  ParameterModel model(layered_patient());
  const std::size_t give = step_called(model, "Skin: break force");
  EXPECT_FALSE(model.is_changed());
  EXPECT_EQ(model.set(give, 1.5), "");
  EXPECT_EQ(model.set(give, 1.6, false), "");
  EXPECT_EQ(model.set(give, 1.7, true), "");
  EXPECT_EQ(model.set(give, 1.8, true), "");
  EXPECT_TRUE(model.is_changed());
  model.undo();
  EXPECT_EQ(model.value(give), 1.5);
  model.undo();
  EXPECT_NEAR(model.value(give), 1.3, 1e-12);
  EXPECT_FALSE(model.is_changed());
  EXPECT_FALSE(model.can_undo());
  model.redo();
  model.redo();
  EXPECT_EQ(model.value(give), 1.8);
  EXPECT_FALSE(model.can_redo());
  model.reset(give);
  EXPECT_NEAR(model.value(give), 1.3, 1e-12);
  model.choose_model("tracking_wall");
  EXPECT_TRUE(model.is_changed());
  model.undo();
  EXPECT_EQ(model.model(), "layered");
}

TEST(ParameterModel, what_cannot_be_is_refused_in_a_sentence_and_changes_nothing) {
  ParameterModel model(layered_patient());
  const std::size_t give = step_called(model, "Skin: break force");
  EXPECT_THAT(model.set(give, -1.0), HasSubstr("break_force_N is -1"));
  EXPECT_NEAR(model.value(give), 1.3, 1e-12);
  // The shaft cannot slide more heavily than it sticks.
  const std::size_t sliding = step_called(model, "Muscle: dynamic friction");
  EXPECT_THAT(model.set(sliding, 0.5), HasSubstr("static_friction_N_per_mm"));
  EXPECT_FALSE(model.can_undo());
}

TEST(ParameterModel, the_parts_of_a_case_have_their_steps_which_are_undone_as_all_others) {
  auto patient = std::make_shared<OpenCase>(*layered_patient());
  anatomy::ForceParts& parts = patient->patient.description.haptics.parts;
  parts.csf_flow.emplace();
  parts.syringe.emplace();
  parts.fingertip.emplace();
  parts.bevel_tip.emplace();
  parts.needle_grasp.emplace();
  ParameterModel model(patient);
  EXPECT_EQ(model.steps().size(), 11U) << "the eleven are the eleven";
  model.show_all(true);
  const std::size_t pressure = step_called(model, "Fluid: opening pressure");
  EXPECT_EQ(model.steps()[pressure].unit, "mm");
  EXPECT_EQ(model.steps()[pressure].range.high, 1000.0);
  EXPECT_EQ(model.value(pressure), 145.0);
  EXPECT_EQ(model.set(pressure, 220.0), "");
  EXPECT_EQ(model.now().haptics.parts.csf_flow->opening_pressure, 220.0);
  EXPECT_TRUE(model.is_changed());
  EXPECT_EQ(model.set(step_called(model, "Syringe: thumb force"), 8.0), "");
  EXPECT_EQ(model.now().haptics.parts.syringe->thumb_force, 8.0);
  step_called(model, "Finger: modulus");
  // Viscosities are a thousand millionth of their unit in the file, too small to read or set.
  const std::size_t viscosity = step_called(model, "Fluid: viscosity");
  EXPECT_EQ(model.steps()[viscosity].unit, "mPa s");
  EXPECT_NEAR(model.value(viscosity), 1.0, 1e-9);
  EXPECT_NEAR(model.steps()[viscosity].range.low, 0.1, 1e-9);
  EXPECT_EQ(model.set(viscosity, 0.7), "");
  EXPECT_NEAR(model.now().haptics.parts.csf_flow->viscosity, 0.7e-9, 1e-18);
  model.undo();
  step_called(model, "Bevel: curvature");
  step_called(model, "Winding up: turns to wind");
  EXPECT_THAT(model.set(pressure, 2000.0), HasSubstr("opening_pressure_mm is 2000"));
  model.undo();
  model.undo();
  EXPECT_FALSE(model.is_changed());
  EXPECT_EQ(model.value(pressure), 145.0);
  model.redo();
  EXPECT_EQ(model.before(pressure), 145.0);
  EXPECT_EQ(model.value(pressure), 220.0);
  // Another model keeps the parameters common to all models; returning restores all.
  model.choose_model("tracking_wall");
  step_called(model, "Fluid: opening pressure");
  EXPECT_FALSE(model.now().haptics.parts.needle_grasp.has_value());
  model.choose_model("layered");
  EXPECT_TRUE(model.now().haptics.parts.needle_grasp.has_value());
  EXPECT_EQ(model.now().haptics.parts.csf_flow->opening_pressure, 220.0);
}

TEST(ParameterModel, the_shares_of_relaxation_together_are_one_at_most) {
  auto patient = std::make_shared<OpenCase>(*layered_patient());
  patient->patient.description.haptics.resistance = anatomy::SpringDamperWallSettings{};
  patient->patient.description.haptics.parts.relaxation = {{0.4, 0.1}, {0.5, 2.0}};
  ParameterModel model(patient);
  const std::size_t second = step_called(model, "Relaxation 2: share");
  EXPECT_EQ(model.set(second, 0.6), "");
  EXPECT_EQ(model.now().haptics.parts.relaxation[1].share, 0.6);
  EXPECT_THAT(model.set(second, 0.7), HasSubstr("add up to more than 1"));
  EXPECT_EQ(model.value(second), 0.6);
}

TEST(ParameterModel, a_model_of_a_deformable_body_has_its_steps_and_is_come_back_to) {
  auto patient = std::make_shared<OpenCase>(*layered_patient());
  anatomy::EmbeddedNeedleSettings settings;
  settings.capture_radius = 1.2;
  patient->patient.description.haptics.resistance = settings;
  ParameterModel model(patient);
  EXPECT_EQ(model.model(), "embedded_needle");
  EXPECT_EQ(model.models().back(), "embedded_needle");
  EXPECT_EQ(ParameterModel(layered_patient()).models().back(), "shaft_friction")
      << "without a body none of its models";
  EXPECT_EQ(model.set(step_called(model, "Model: puncture time"), 0.1), "");
  EXPECT_EQ(model.set(step_called(model, "Muscle: friction"), 0.07), "");
  const auto muscle = std::find_if(model.now().tissues.begin(), model.now().tissues.end(),
                                   [](const auto& one) { return one.id == anatomy::tissue::muscle; });
  EXPECT_EQ(muscle->deformable.friction, 0.07);
  model.choose_model("layered");
  model.choose_model("embedded_needle");
  EXPECT_EQ(model.value(step_called(model, "Model: capture radius")), 1.2);
}

TEST(ParameterModel, saved_tissues_come_back_from_their_file) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "bodkin-parameter-model.xml";
  ParameterModel model(layered_patient());
  const std::size_t give = step_called(model, "Skin: break force");
  model.set(give, 2.25);
  model.save(file);
  ParameterModel other(layered_patient());
  other.load(file);
  EXPECT_EQ(other.value(give), 2.25);
  EXPECT_EQ(io::tissue_library_xml(anatomy::TissueLibrary(other.now().tissues)),
            io::tissue_library_xml(anatomy::TissueLibrary(model.now().tissues)));
  other.undo();
  EXPECT_NEAR(other.value(give), 1.3, 1e-12);
  std::filesystem::remove(file);
  EXPECT_THROW(other.load(file), InputError);
}

// If the forces follow from the needle, the steps begin with the needle's values, and take effect.
TEST(ParameterModel, of_a_described_patient_has_the_numbers_of_his_needle) {
  const auto patient = std::make_shared<OpenCase>(*layered_patient());
  patient->patient.description.haptics.mechanics = anatomy::Mechanics::physical;
  patient->patient.description.needle.outer_diameter = 1.27;
  ParameterModel model(patient);
  const std::size_t give = step_called(model, "Skin: break force");
  const double force = model.value(give);
  const anatomy::TissueProperties& skin = *patient->patient.library.find(anatomy::tissue::skin);
  EXPECT_NEAR(force, skin.physical.puncture_force * 1.27 / skin.physical.reference_diameter, 1e-9);
  anatomy::Case part = patient->patient;
  for (const double wanted : {force, 0.5 * force}) {
    model.set(give, wanted);
    EXPECT_NEAR(force_curve(part, model.now()).first_puncture_force.value_or(0.0), wanted, 0.1);
  }
  model.take(io::default_tissue_library(), false);
  EXPECT_NEAR(model.value(give), force, 1e-12) << "the library describes tissues, not this needle";
  EXPECT_FALSE(model.is_changed());
}

TEST(ForceCurve, gives_way_at_the_break_force_that_was_set) {
  const std::shared_ptr<const OpenCase> patient = layered_patient();
  anatomy::Case part = patient->patient;
  ParameterModel model(patient);
  const std::size_t give = step_called(model, "Skin: break force");
  for (const double force : {0.8, 1.6}) {
    model.set(give, force);
    const ForceCurve curve = force_curve(part, model.now());
    ASSERT_EQ(curve.trouble, "");
    ASSERT_TRUE(curve.first_puncture_force.has_value());
    EXPECT_NEAR(*curve.first_puncture_force, force, 0.1) << "at 10 mm/s, by at most one sample";
    EXPECT_EQ(curve.bands.front().tissue, anatomy::tissue::skin);
    EXPECT_GE(curve.bands.size(), 3U);
  }
}

TEST(LiveProfile, the_newest_settings_win_and_a_patient_without_a_path_is_one_sentence) {
  const std::shared_ptr<const OpenCase> patient = layered_patient();
  ParameterModel model(patient);
  LiveProfile profile(patient);
  const auto settle = [&] {
    while (profile.is_busy()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  };
  for (const double force : {0.5, 0.9, 2.0}) {
    model.set(step_called(model, "Skin: break force"), force);
    profile.set(model.now());
  }
  settle();
  ASSERT_NE(profile.curve(), nullptr);
  anatomy::Case whole = patient->patient;
  const ForceCurve expected = force_curve(whole, model.now());
  EXPECT_EQ(profile.curve()->strongest, expected.strongest) << "the part about the path feels as the whole does";
  EXPECT_EQ(profile.curve()->points.size(), expected.points.size());
  auto unplanned = std::make_shared<OpenCase>(*patient);
  unplanned->patient.description.procedure.path.reset();
  LiveProfile none(unplanned);
  none.set(model.now());
  while (none.is_busy()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  EXPECT_THAT(none.curve()->trouble, HasSubstr("no planned path"));
}

}  // namespace
}  // namespace bodkin::app
