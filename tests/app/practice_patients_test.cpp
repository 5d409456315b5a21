// Every supplied procedure has its own patient, offered on the start page.
#include "app/models/practice_patients.h"

#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <algorithm>
#include <set>
#include <stdexcept>

#include "tests/app/window_fixture.h"
#include "views/language.h"

#include "io/case_folder.h"
#include "training/procedure_file.h"

namespace bodkin::app {
namespace {

TEST(PracticePatients, are_one_for_each_procedure_that_comes_with_bodkin) {
  std::set<std::string> offered, folders;
  for (const PracticePatient& patient : practice_patients()) {
    EXPECT_TRUE(offered.insert(std::string(patient.procedure)).second) << patient.procedure;
    EXPECT_TRUE(folders.insert(std::string(patient.folder)).second) << patient.folder;
    EXPECT_EQ(find_practice_patient(patient.procedure), &patient);
  }
  const std::vector<std::string> shipped = training::shipped_procedures();
  EXPECT_EQ(offered, std::set<std::string>(shipped.begin(), shipped.end()));
  EXPECT_EQ(find_practice_patient("dentistry"), nullptr);
}

// The others are tested with the commands that make them.
TEST(PracticePatients, epidural_and_biopsy_are_planned_to_where_they_want_the_tip) {
  const QTemporaryDir made;
  for (const char* name : {"epidural", "ct_guided_biopsy"}) {
    SCOPED_TRACE(name);
    const std::filesystem::path place = std::filesystem::path(made.path().toStdString()) / name;
    make_practice_patient(*find_practice_patient(name), place, {});
    const anatomy::Case patient = io::load_case(place);
    const anatomy::Procedure& procedure = patient.description.procedure;
    EXPECT_EQ(procedure.name, name);
    ASSERT_TRUE(procedure.path.has_value());
    const auto at = [&](const Vec3& point) {
      return anatomy::nearest<anatomy::TissueId>(patient.tissues, point, anatomy::tissue::air);
    };
    EXPECT_EQ(at(procedure.path->target),
              name == std::string("epidural") ? anatomy::tissue::epidural_fat : anatomy::tissue::mass);
    EXPECT_LT(procedure.path->length(), patient.description.needle.length);
    for (double depth = 0.0; depth < procedure.path->length(); depth += 0.5) {
      const anatomy::TissueId met = at(procedure.path->entry + depth * procedure.path->direction());
      EXPECT_NE(met, anatomy::tissue::cortical_bone) << depth;
      EXPECT_NE(met, anatomy::tissue::organ) << depth;
      EXPECT_NE(met, anatomy::tissue::vessel) << depth;
    }
  }
}

TEST(PracticePatients, one_that_is_cancelled_leaves_nothing) {
  const QTemporaryDir made;
  const std::filesystem::path folder = made.path().toStdString();
  const auto cancel = [](std::string_view, double) { throw std::runtime_error("cancelled"); };
  for (const char* name : {"epidural", "joint_injection", "needle_insertion"}) {
    const PracticePatient& wanted = *find_practice_patient(name);
    EXPECT_THROW(make_practice_patient(wanted, folder / name, cancel), std::exception) << name;
    EXPECT_FALSE(std::filesystem::exists(folder / name)) << name;
  }
}

class StartWindow : public WindowFixture {};

TEST_F(StartWindow, offers_every_procedure_by_name_with_a_line_and_begins_it) {
  for (const PracticePatient& patient : practice_patients()) {
    auto* const card = find<QPushButton>(("start.procedure." + std::string(patient.procedure)).c_str());
    const training::Procedure procedure = training::find_shipped_procedure(std::string(patient.procedure));
    EXPECT_EQ(card->accessibleName(), views::in_words(procedure.title));
    EXPECT_EQ(card->toolTip(), views::in_words(procedure.description));
    const QList<QLabel*> words = card->findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(words.begin(), words.end(), [&](const QLabel* label) {
      return label->text() == views::in_words(patient.words);
    })) << patient.words;
  }
  click("start.procedure.needle_insertion");
  Practice& practice = window_->practice();
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return practice.state() == State::ready || !practice.failure().empty(); }, 120000));
  ASSERT_EQ(practice.failure(), "");
  EXPECT_EQ(practice.patient()->folder, practice.cases().folder_of(*find_practice_patient("needle_insertion")));
  practice.leave();
  // Those patients are listed among the procedures, not among those opened by the user.
  const auto known = practice.cases().known();
  EXPECT_EQ(std::count(known.begin(), known.end(), practice.cases().folder_of(built_in_patient())), 0);
}

}  // namespace
}  // namespace bodkin::app
