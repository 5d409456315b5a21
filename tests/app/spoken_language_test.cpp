#include "app/spoken_language.h"

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "app/models/parameter_model.h"
#include "app/models/practice_patients.h"
#include "app/pages/start.h"
#include "patient/acupuncture/point_table.h"
#include "views/language.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "haptics/guard_event.h"
#include "io/resources.h"
#include "io/tissue_library_file.h"
#include "training/metric.h"
#include "training/procedure_file.h"

namespace bodkin::app {
namespace {

namespace fs = std::filesystem;

class SpokenLanguage : public testing::Test {
 protected:
  void TearDown() override {
    speak(QStringLiteral("en"));
    QSettings().remove(QStringLiteral("language"));
  }
};

TEST_F(SpokenLanguage, german_has_what_procedures_tissues_metrics_and_the_guard_say) {
  std::set<std::string> texts;
  const anatomy::TissueLibrary library = io::default_tissue_library();
  for (const anatomy::TissueProperties& tissue : library.tissues()) texts.insert(tissue.title);
  for (const training::Metric& metric : training::all_metrics()) texts.insert(std::string(metric.title));
  for (const auto& file : fs::directory_iterator(fs::path(BODKIN_REPOSITORY) / "share" / "bodkin" / "procedures")) {
    const training::Procedure procedure = training::read_procedure(file.path());
    texts.insert({procedure.title, procedure.description});
    for (const training::Step& step : procedure.steps) texts.insert({step.title, step.text});
    for (const training::Forbidden& each : procedure.forbidden) texts.insert({each.title, each.consequence});
    for (const training::Rule& rule : procedure.rules) texts.insert(rule.advice);
  }
  for (const PracticePatient& patient : practice_patients()) texts.insert(patient.words);
  for (int reason = 1; reason < static_cast<int>(haptics::GuardReason::count_of_reasons); ++reason)
    texts.insert(std::string(haptics::text_of(static_cast<haptics::GuardReason>(reason))));
  texts.erase("");
  EXPECT_GT(texts.size(), 150U);
  speak(QStringLiteral("de"));
  for (const std::string& text : texts) {
    EXPECT_TRUE(views::in_words(text) != QString::fromStdString(text) || text == "Plan" || text.size() < 8)
        << "add \"" << text << "\" to share/bodkin/translations/words_de.ts";
  }
}

// What the page of model settings can show: of every model, every constraint and every tissue.
std::set<std::string> texts_of_parameters() {
  std::set<std::string> texts;
  const auto add = [&texts](const auto& owner) {
    for_each_parameter(
        [&texts](const auto& parameter, const auto& value) {
          if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(value)>, double>) return;
          texts.insert(std::string(parameter.description));
          texts.insert(parameter_words(parameter.name, parameter.unit));
        },
        owner);
  };
  const auto add_tissues_of = [&add](ModelSettings settings) {
    settings.tissues.resize(1);
    forces::visit_part(settings, forces::ModelPart::tissue, settings.tissues.front().id, add);
  };
  ModelSettings settings;
  settings.tissues = io::default_tissue_library().tissues();
  for (const anatomy::TissueProperties& tissue : settings.tissues) texts.insert(tissue.source);
  forces::visit_part(settings, forces::ModelPart::weight, 0, add);
  const auto each_of = [&](auto& choice, forces::ModelPart part, auto&& then) {
    using Choice = std::remove_cvref_t<decltype(choice)>;
    const auto one = [&]<std::size_t index>() {
      choice.template emplace<index>();
      forces::visit_part(settings, part, 0, add);
      then();
    };
    [&]<std::size_t... index>(std::index_sequence<index...>) {
      (one.template operator()<index>(), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Choice>>{});
  };
  anatomy::ForceParts& parts = settings.haptics.parts;
  parts.relaxation.resize(1);
  parts.shaft_friction.emplace();
  parts.needle_grasp.emplace();
  parts.bevel_tip.emplace();
  parts.csf_flow.emplace();
  parts.syringe.emplace();
  parts.fingertip.emplace();
  for (const forces::ModelPart part : forces::added_parts) forces::visit_part(settings, part, 0, add);
  texts.insert({"Shaft friction", "Winding up", "Bevel", "Fluid", "Syringe"});
  each_of(settings.haptics.constraint, forces::ModelPart::constraint, [] {});
  each_of(settings.haptics.resistance, forces::ModelPart::resistance, [&] { add_tissues_of(settings); });
  texts.erase("");
  return texts;
}

// "K_f", "l_2 / L": the name that a paper gives it is the same in every language.
bool is_formula(const std::string& text) {
  static const QRegularExpression word(QStringLiteral("[A-Za-z]{3}"));
  return !QString::fromStdString(text).contains(word);
}

TEST_F(SpokenLanguage, german_has_every_number_of_the_models) {
  const std::set<std::string> texts = texts_of_parameters();
  EXPECT_GT(texts.size(), 200U);
  const views::Language german(QStringLiteral("de"), io::shared_file("translations/window_de.ts").parent_path());
  for (const std::string& text : texts) {
    EXPECT_TRUE(german.has_entry(QString::fromStdString(text)) || is_formula(text))
        << "add \"" << text << "\" to share/bodkin/translations/words_de.ts";
  }
}

TEST_F(SpokenLanguage, german_has_what_the_card_of_an_acupuncture_point_says) {
  const patient::PointTable table = patient::read_point_table();
  std::set<std::string> texts;
  for (const patient::PointRow& point : table.points) {
    std::string region = point.region;
    std::replace(region.begin(), region.end(), '_', ' ');
    texts.insert({point.meridian, region});
  }
  for (const auto& [code, how] : table.needling) texts.insert({how.direction, how.caution});
  texts.erase("");
  EXPECT_GT(texts.size(), 60U);
  const views::Language german(QStringLiteral("de"), io::shared_file("translations/window_de.ts").parent_path());
  for (const std::string& text : texts) {
    EXPECT_TRUE(german.has_entry(QString::fromStdString(text)))
        << "add \"" << text << "\" to share/bodkin/translations/words_de.ts";
  }
}

TEST_F(SpokenLanguage, the_start_page_speaks_it_and_offers_the_others) {
  speak(QStringLiteral("de"));
  const StartPage german;
  EXPECT_EQ(german.findChild<QPushButton*>(QStringLiteral("start.practise"))->text(), QStringLiteral("Üben"));
  EXPECT_EQ(german.findChild<QPushButton*>(QStringLiteral("start.language.de")), nullptr);
  EXPECT_EQ(german.findChild<QPushButton*>(QStringLiteral("start.language.en"))->text(), QStringLiteral("English"));
  speak(QStringLiteral("en"));
  StartPage english;
  EXPECT_EQ(english.findChild<QPushButton*>(QStringLiteral("start.practise"))->text(), QStringLiteral("Practise"));
  QString wanted;
  QObject::connect(&english, &StartPage::language_requested, [&wanted](const QString& code) { wanted = code; });
  auto* const button = english.findChild<QPushButton*>(QStringLiteral("start.language.de"));
  ASSERT_NE(button, nullptr);
  EXPECT_EQ(button->text(), QStringLiteral("Deutsch"));
  button->click();
  EXPECT_EQ(wanted, QStringLiteral("de"));
}

TEST_F(SpokenLanguage, what_was_chosen_is_kept_and_what_there_is_not_is_named) {
  choose_language(QStringLiteral("de"));
  EXPECT_EQ(usual_language(), QStringLiteral("de"));
  choose_language(QStringLiteral("xx"));
  EXPECT_TRUE(languages().contains(usual_language()));
  EXPECT_EQ(spoken_language(), QStringLiteral("en"));
  try {
    speak(QStringLiteral("xx"));
    ADD_FAILURE() << "it spoke xx";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "there is no language xx, expected one of en, de");
  }
}

}  // namespace
}  // namespace bodkin::app
