// The parts of the patient in the window: shown, hidden, translucent, coloured, saved with the case and read from it.
#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QTreeWidget>
#include <filesystem>
#include <memory>

#include "app/main_window.h"
#include "app/models/data_folder.h"
#include "app/pages/practise.h"
#include "scene/look_file.h"
#include "tests/app/window_fixture.h"
#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

class PartsWindow : public WindowFixture {
 protected:
  void SetUp() override {
    WindowFixture::SetUp();
    click("start.begin");
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().is_ready(); }, 120000)) << window_->practice().failure();
    folder_ = window_->practice().patient()->folder;
    std::filesystem::remove(folder_ / "looks.xml");
  }
  void TearDown() override { std::filesystem::remove(folder_ / "looks.xml"); }
  View3d& view() { return window_->practise_page().view3d(); }
  // A row of the list, chosen by a click on its name.
  QTreeWidgetItem* choose(const QString& name) {
    auto* const list = find<QTreeWidget>("practise.parts.list");
    const auto found = list->findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
    EXPECT_EQ(found.size(), 1) << name.toStdString();
    if (found.isEmpty()) return nullptr;
    list->scrollToItem(found.front());
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(found.front()).center());
    EXPECT_EQ(list->currentItem(), found.front());
    return found.front();
  }
  scene::Appearance of(const char* surface, const char* section = "") {
    for (const scene::PatientSurface& part : view().scene()->surfaces().parts) {
      if (part.name == surface) return scene::appearance(view().look(), part, section);
    }
    ADD_FAILURE() << surface;
    return {};
  }

  std::filesystem::path folder_;
};

TEST_F(PartsWindow, a_tick_a_slider_and_a_colour_change_what_is_drawn) {
  QWidget* const list = find("practise.parts.list");
  EXPECT_FALSE(list->isVisible());
  click("practise.parts");
  EXPECT_TRUE(list->isVisible());
  ASSERT_TRUE(of("bone", "vertebrae_L3").drawn());
  choose("bone")->setExpanded(true);
  choose("vertebra L3");
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Space);  // the tick of the row that is chosen
  EXPECT_FALSE(of("bone", "vertebrae_L3").drawn());
  EXPECT_TRUE(of("bone", "vertebrae_L4").drawn());
  EXPECT_EQ(find<QTreeWidget>("practise.parts.list")->findItems("bone", Qt::MatchExactly).front()->checkState(0),
            Qt::PartiallyChecked);
  choose("vessel");
  auto* const slider = find<QSlider>("practise.parts.opacity");
  EXPECT_EQ(slider->value(), 100);
  slider->setFocus();
  for (int i = 0; i < 6; ++i) QTest::keyClick(slider, Qt::Key_PageDown);  // ten percent each
  EXPECT_NEAR(of("vessel").opacity, 0.4, 1e-6);
  click("practise.parts.colour.56b4e9");
  EXPECT_EQ(of("vessel").colour, 0x56B4E9u);
  // A preset restores its visible parts; Escape closes the list.
  click("practise.preset.cut_away");
  EXPECT_TRUE(of("bone", "vertebrae_L3").drawn());
  EXPECT_EQ(of("vessel").colour, 0x56B4E9u);
  list->setFocus();
  QTest::keyClick(window_->focusWidget(), Qt::Key_Escape);
  EXPECT_FALSE(list->isVisible());
  EXPECT_NE(window_->practice().state(), State::paused) << "Escape was the list's";
}

TEST_F(PartsWindow, a_look_is_saved_with_the_case_which_opens_with_it) {
  click("practise.parts");
  choose("skin");
  auto* const slider = find<QSlider>("practise.parts.opacity");
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_Home);
  choose("organ");
  click("practise.parts.colour.399283");
  view().set_camera(scene::turned(view().camera(), 0.4, 0.1));
  const scene::Camera camera = view().camera();
  auto* const name = find<QLineEdit>("practise.parts.name");
  name->setFocus();
  QTest::keyClicks(name, "Aorta, Oldani");  // letters are letters here: A, O, E and Space are no commands
  EXPECT_TRUE(name->isVisible());
  find<QCheckBox>("practise.parts.with_view")->setChecked(true);
  find<QCheckBox>("practise.parts.opens_with")->setChecked(true);
  click("practise.parts.save");
  const scene::CaseLooks saved = scene::read_looks(folder_);
  ASSERT_EQ(saved.looks.size(), 1u);
  EXPECT_EQ(saved.opens_with, "Aorta, Oldani");
  const scene::Look look = view().look();
  EXPECT_EQ(saved.looks.front().look, look);
  EXPECT_EQ(find<QComboBox>("practise.parts.saved")->count(), 1);

  open_window();
  window_->open(folder_);
  ASSERT_TRUE(QTest::qWaitFor([&] { return view().is_ready(); }, 120000)) << window_->practice().failure();
  EXPECT_EQ(view().look(), look);
  EXPECT_LT((view().camera().eye - camera.eye).norm(), 1e-6);
  EXPECT_FALSE(of("skin").drawn());
  click("practise.parts");
  click("practise.parts.remove");
  EXPECT_TRUE(scene::read_looks(folder_).looks.empty());
}

}  // namespace
}  // namespace bodkin::app
