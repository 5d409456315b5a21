// An attempt ends automatically when its needle is withdrawn: always in acupuncture, elsewhere after its target.
#include "training/needle_withdrawal.h"

#include <QLabel>
#include <filesystem>

#include "tests/app/window_fixture.h"
#include "views/language.h"

#include "io/case_folder.h"
#include "io/resources.h"

namespace bodkin::app {
namespace {

class NeedleTakenOut : public WindowFixture {
 protected:
  // The patient that comes with Bodkin for a procedure with a target 16 mm deep, in the muscle beside the spine.
  void begin(const char* procedure) {
    ASSERT_TRUE(start()) << practice().failure();
    const std::filesystem::path from = practice().patient()->folder;
    const std::filesystem::path folder = from.parent_path() / procedure;
    std::filesystem::remove_all(folder);
    std::filesystem::copy(from, folder, std::filesystem::copy_options::recursive);
    anatomy::CaseDescription description = io::load_case(folder).description;
    anatomy::NeedlePath& path = *description.procedure.path;
    const Vec3 along = path.direction();
    path.entry.x() += 18.0;
    const std::optional<SkinPoint> skin =
        skin_on_ray(practice().patient()->patient.tissues, path.entry - 30.0 * along, along, 60.0);
    ASSERT_TRUE(skin.has_value());
    path = {skin->point, skin->point + 16.0 * along};
    description.procedure.name = procedure;
    description.procedure.target_tissue.clear();
    description.procedure.target_tolerance = 3.0;
    io::write_case_description(description, folder);
    practice().leave();
    window_->open(folder);
    const auto decided = [&] { return practice().state() == State::ready || !practice().failure().empty(); };
    ASSERT_TRUE(wait(decided, 120));
    ASSERT_EQ(practice().failure(), "");
  }
  Practice& practice() { return window_->practice(); }
  // By holding the key, as a user does.
  void push_to(double depth) {
    QWidget* const focus = window_->focusWidget() != nullptr ? window_->focusWidget() : window_.get();
    QTest::keyPress(focus, Qt::Key_PageDown);
    EXPECT_TRUE(wait([&] { return frame().depth >= depth; }, 60)) << frame().depth;
    QTest::keyRelease(focus, Qt::Key_PageDown);
    ASSERT_TRUE(settle());
  }
  void take_out() {
    key(Qt::Key_W);
    ASSERT_TRUE(wait([&] { return practice().state() == State::ready || practice().state() == State::aiming; }, 60));
  }
  bool counts_down() { return frame().hint.starts_with("The needle is out. The attempt ends in "); }
  void expect_end() {
    EXPECT_EQ(practice().state(), State::ended);
    EXPECT_EQ(practice().completion(), "The needle was taken out: the attempt is complete.");
    ASSERT_TRUE(wait([&] { return practice().result().has_value() && find("results")->isVisible(); }, 60));
    const auto is_told = [&] {
      const QList<QLabel*> labels = window_->findChildren<QLabel*>();
      return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->isVisible() && label->text().contains(QStringLiteral("The needle was taken out"));
      });
    };
    EXPECT_TRUE(wait(is_told, 60));
  }
};

TEST_F(NeedleTakenOut, ends_an_acupuncture_with_its_results_and_again_practises_the_same_point) {
  ASSERT_NO_FATAL_FAILURE(begin("acupuncture"));
  ASSERT_NO_FATAL_FAILURE(push_to(8.0));  // not as deep as the point
  ASSERT_NO_FATAL_FAILURE(take_out());
  ASSERT_TRUE(wait([&] { return counts_down(); }, 10)) << frame().hint;
  const double since = frame().clock;
  EXPECT_NE(frame().hint.find("5 s"), std::string::npos) << frame().hint;
  ASSERT_TRUE(wait(State::ended, 30));
  EXPECT_NEAR(frame().clock - since, training::NeedleWithdrawal::patience, 0.5);
  ASSERT_NO_FATAL_FAILURE(expect_end());
  const std::shared_ptr<const OpenCase> patient = practice().patient();
  key(Qt::Key_A);
  ASSERT_TRUE(wait(State::ready, 60)) << practice().failure();
  EXPECT_EQ(practice().patient(), patient);
  EXPECT_TRUE(practice().completion().empty());
  QTest::qWait(200);
  EXPECT_FALSE(counts_down()) << "this needle has not been in";
}

TEST_F(NeedleTakenOut, of_another_procedure_ends_it_after_the_target_alone_and_going_in_again_stops_that) {
  ASSERT_NO_FATAL_FAILURE(begin("needle_insertion"));
  ASSERT_NO_FATAL_FAILURE(push_to(8.0));
  ASSERT_NO_FATAL_FAILURE(take_out());
  EXPECT_FALSE(wait([&] { return counts_down() || practice().state() == State::ended; },
                    static_cast<int>(training::NeedleWithdrawal::patience) + 2))
      << "it has missed, and may go in again";
  ASSERT_NO_FATAL_FAILURE(push_to(15.0));
  EXPECT_EQ(practice().state(), State::reached) << frame().target_distance << " mm from the target";
  ASSERT_NO_FATAL_FAILURE(take_out());
  ASSERT_TRUE(wait([&] { return counts_down(); }, 10)) << frame().hint;
  ASSERT_NO_FATAL_FAILURE(push_to(4.0));
  EXPECT_FALSE(counts_down());
  EXPECT_TRUE(needle_is_down(practice().state()));
  ASSERT_NO_FATAL_FAILURE(take_out());
  ASSERT_TRUE(wait(State::ended, 30));
  ASSERT_NO_FATAL_FAILURE(expect_end());
}

TEST(NeedleTakenOutWords, are_german_too) {
  const Language german(QStringLiteral("de"), io::shared_file("translations/window_de.ts").parent_path());
  const auto said = [&german](const char* text) {
    return german.translate("Words", text, nullptr, -1).toStdString();
  };
  EXPECT_EQ(said("The needle is out. The attempt ends in 3 s, unless it goes in again."),
            "Die Nadel ist draußen. Der Versuch endet in 3 s, außer sie geht wieder hinein.");
  EXPECT_EQ(said("The needle was taken out: the attempt is complete."),
            "Die Nadel wurde herausgezogen: der Versuch ist vollständig.");
}

}  // namespace
}  // namespace bodkin::app
