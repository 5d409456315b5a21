#include "app/models/model_draft.h"

#include <QTemporaryDir>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/tissue_library_file.h"

namespace bodkin::app {
namespace {

std::shared_ptr<const OpenCase> patient() {
  auto made = std::make_shared<OpenCase>();
  anatomy::Case& his = made->patient;
  his.library = io::default_tissue_library();
  his.tissues = anatomy::TissueVolume({.size = {10, 10, 10}}, anatomy::tissue::skin);
  his.description.haptics.resistance = anatomy::LayeredSettings{};
  his.description.procedure.path = anatomy::NeedlePath{Vec3(5.0, 9.0, 5.0), Vec3(5.0, 1.0, 5.0)};
  return made;
}

std::size_t step_named(const ParameterModel& model, const std::string& name) {
  std::size_t step = 0;
  while (step < model.steps().size() && model.steps()[step].name != name) ++step;
  EXPECT_LT(step, model.steps().size()) << name;
  return step;
}

class ModelDraft : public testing::Test {
 protected:
  const QTemporaryDir made_;
  const std::filesystem::path folder_ = made_.path().toStdString();
  const std::filesystem::path file_ = folder_ / "models.draft.json";
};

TEST_F(ModelDraft, of_each_number_that_was_changed_the_value_comes_back_and_of_no_other) {
  ParameterModel before(patient()), after(patient());
  for (std::size_t step = 0; step < before.steps().size(); ++step) {
    const SettingStep& each = before.steps()[step];
    EXPECT_EQ(before.set(step, before.value(step) + each.grain), "") << each.title;
  }
  keep_model_draft(before, folder_);
  ASSERT_TRUE(take_model_draft(after, folder_));
  for (const bool all : {false, true}) {
    before.show_all(all);
    after.show_all(all);
    ASSERT_EQ(after.steps().size(), before.steps().size());
    for (std::size_t step = 0; step < after.steps().size(); ++step) {
      EXPECT_DOUBLE_EQ(after.value(step), before.value(step)) << after.steps()[step].title;
    }
  }
  after.undo();
  EXPECT_FALSE(after.is_changed());
  EXPECT_FALSE(after.can_undo());
}

TEST_F(ModelDraft, another_model_comes_back_with_its_numbers) {
  ParameterModel before(patient()), after(patient());
  before.choose_model("spring_damper_wall");
  ASSERT_EQ(before.set(0, 0.5 * before.value(0)), "");
  keep_model_draft(before, folder_);
  ASSERT_TRUE(take_model_draft(after, folder_));
  EXPECT_EQ(after.model(), "spring_damper_wall");
  EXPECT_DOUBLE_EQ(after.value(0), before.value(0));
  after.undo();
  EXPECT_EQ(after.model(), "layered");
}

TEST_F(ModelDraft, tissues_of_a_file_come_back_though_the_planned_path_does_not_meet_them) {
  std::vector<anatomy::TissueProperties> tissues = io::default_tissue_library().tissues();
  const auto organ = std::ranges::find(tissues, "organ", &anatomy::TissueProperties::name);
  ASSERT_NE(organ, tissues.end());
  organ->hounsfield *= 1.25;
  ParameterModel before(patient()), after(patient());
  std::ofstream(folder_ / "mine.xml") << io::tissue_library_xml(anatomy::TissueLibrary({tissues.front(), *organ}));
  before.load(folder_ / "mine.xml");
  keep_model_draft(before, folder_);
  ASSERT_TRUE(take_model_draft(after, folder_));
  EXPECT_EQ(after.changed_tissues().find("organ")->hounsfield, organ->hounsfield);
  EXPECT_EQ(after.changed_tissues().tissues().size(), 2U) << "it, and air";
  after.undo();
  EXPECT_FALSE(after.is_changed());
  EXPECT_FALSE(after.can_undo());
}

TEST_F(ModelDraft, is_gone_when_nothing_differs_any_more) {
  ParameterModel model(patient());
  model.set(step_named(model, "break_force_N"), 3.0);
  keep_model_draft(model, folder_);
  EXPECT_TRUE(std::filesystem::exists(file_));
  model.undo();
  keep_model_draft(model, folder_);
  EXPECT_FALSE(std::filesystem::exists(file_));
  EXPECT_FALSE(take_model_draft(model, folder_));
}

TEST_F(ModelDraft, a_damaged_one_or_one_of_another_version_changes_nothing) {
  for (const char* text : {"", "{", "[]", "{\"model\": 3, \"numbers\": []}", "{\"model\": \"layered\"}",
                           "{\"model\": \"layered\", \"numbers\": [3]}",
                           "{\"model\": \"layered\", \"numbers\": [{\"of\": [], \"value\": \"x\"}]}",
                           "{\"model\": \"of tomorrow\", \"numbers\": []}",
                           "{\"model\": \"layered\", \"numbers\": [], \"tissues\": \"<tissue\"}",
                           "{\"model\": \"layered\", \"numbers\": [], \"tissues\": 3}",
                           "{\"model\": \"layered\", \"numbers\": [{\"of\": [3, 9999, \"y\"], \"value\": 1}]}"}) {
    std::ofstream(file_) << text;
    ParameterModel model(patient());
    EXPECT_FALSE(take_model_draft(model, folder_)) << text;
    EXPECT_FALSE(model.is_changed()) << text;
  }
}

TEST_F(ModelDraft, a_number_that_is_not_allowed_is_left_out) {
  ParameterModel before(patient()), after(patient());
  const std::size_t force = step_named(before, "break_force_N"), weight = step_named(before, "weight_N");
  before.set(force, 3.0);
  before.set(weight, 0.5);
  keep_model_draft(before, folder_);
  std::stringstream text;
  text << std::ifstream(file_).rdbuf();
  std::string words = text.str();
  const std::size_t at = words.find(": 0.5");
  ASSERT_NE(at, std::string::npos);
  std::ofstream(file_) << words.replace(at, 5, ": -0.5");
  ASSERT_TRUE(take_model_draft(after, folder_));
  EXPECT_EQ(after.value(weight), after.before(weight));
  EXPECT_DOUBLE_EQ(after.value(force), 3.0);
}

}  // namespace
}  // namespace bodkin::app
