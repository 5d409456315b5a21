// Every key that F1 shows is pressed in the real window, and has the effect stated in the table.
#include <QApplication>
#include <QCheckBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTest>
#include <QTimer>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/key_table.h"
#include "app/main_window.h"
#include "app/models/stored_measures.h"
#include "app/pages/models.h"
#include "app/pages/plan.h"
#include "app/pages/practise.h"
#include "app/pages/scan.h"
#include "app/pages/segment.h"
#include "app/pages/volume.h"
#include "tests/app/window_fixture.h"
#include "views/scan_viewer.h"
#include "views/theme.h"
#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

class EveryKey : public WindowFixture {
 protected:
  // Presses a key of the table in the focused widget, and waits for its effect.
  void expect(KeyScope scope, const char* keys, const std::function<bool()>& done) {
    pressed_[scope].insert(keys);
    const int code = QKeySequence(QLatin1String(keys))[0];
    key(code & ~static_cast<int>(Qt::KeyboardModifierMask),
        Qt::KeyboardModifiers(code & static_cast<int>(Qt::KeyboardModifierMask)));
    EXPECT_TRUE(wait(done, 60)) << keys << " of " << name_of(scope).toStdString();
  }
  // Marks a key that another test has covered.
  void elsewhere(KeyScope scope, const char* keys) { pressed_[scope].insert(keys); }
  void expect_all_pressed(std::initializer_list<KeyScope> scopes) {
    for (const KeyScope scope : scopes) {
      for (const KeyBinding& binding : key_table()) {
        if (binding.scope != scope) continue;
        EXPECT_TRUE(pressed_[scope].contains(binding.keys))
            << "press " << binding.keys << " of " << name_of(scope).toStdString() << " here, too";
      }
    }
  }
  // A value that changes in the expected direction.
  template <typename Value>
  std::function<bool()> rises(Value value) {
    return [value, before = value()] { return value() > before; };
  }
  template <typename Value>
  std::function<bool()> falls(Value value) {
    return [value, before = value()] { return value() < before; };
  }
  template <typename Value>
  std::function<bool()> changes(Value value) {
    return [value, before = value()] { return value() != before; };
  }
  bool shows(const char* name) { return find(name)->isVisible(); }
  PractisePage& page() { return window_->practise_page(); }
  template <typename AnyPage>
  AnyPage* go(PageId id) {
    window_->show_page(id);
    auto* const shown = find<AnyPage>(name_of(id));
    EXPECT_TRUE(wait([&] { return shown->isVisible(); }, 60)) << name_of(id);
    return shown;
  }
  // The six standard views by 0 to 6; each differs from the previous one.
  template <typename AnyView>
  void expect_standard_views(KeyScope scope, AnyView& view) {
    const auto direction = [&view] { return Vec3((view.camera().focus - view.camera().eye).normalized()); };
    const std::vector<std::pair<const char*, Vec3>> views = {{"1", -Vec3::UnitY()}, {"2", Vec3::UnitY()},
                                                             {"3", -Vec3::UnitX()}, {"4", Vec3::UnitX()},
                                                             {"5", -Vec3::UnitZ()}, {"6", Vec3::UnitZ()}};
    const Vec3 first = direction();
    for (const auto& [keys, towards] : views)
      expect(scope, keys, [&, towards = towards] { return (direction() - towards).norm() < 0.05; });
    expect(scope, "0", [&] { return (direction() - first).norm() < 0.2; });
    const auto distance = [&view] { return (view.camera().focus - view.camera().eye).norm(); };
    for (const char* keys : {"Left", "Right", "Up", "Down"})
      expect(scope, keys, [&, before = direction()] { return (direction() - before).norm() > 0.02; });
    expect(scope, "+", falls(distance));
    expect(scope, "-", rises(distance));
  }

  void press_keys_of_the_start_page();
  void press_keys_of_the_window();
  void press_keys_of_the_pages();
  void press_keys_of_the_needle_and_its_views();
  void press_keys_that_leave();

  std::map<KeyScope, std::set<std::string>> pressed_;
};

// A patient's preparation begun by a key is not waited for.
void EveryKey::press_keys_of_the_start_page() {
  for (const char* keys : {"T", "Return", "Enter"}) {
    ASSERT_TRUE(wait([&] { return shows("start.begin"); }, 60));
    expect(KeyScope::start, keys, [&] { return window_->practice().state() == State::preparing; });
    window_->practice().cancel();
    if (shows("tour.leave")) click("tour.leave");
    ASSERT_TRUE(wait(State::no_case, 60));
  }
}

void EveryKey::press_keys_of_the_window() {
  using enum KeyScope;
  qputenv("HOME", data_folder().string().c_str());  // pictures are saved below it
  expect(window, "F1", [&] { return shows("keys"); });
  expect(window, "Esc", [&] { return !shows("keys"); });
  expect(window, "?", [&] { return shows("keys"); });
  key(Qt::Key_Escape);
  expect(window, "Ctrl+K", [&] { return shows("palette"); });
  key(Qt::Key_Escape);
  page().view3d().setFocus();
  expect(window, "F6", [&] { return window_->focusWidget() == find("practise.slice.sagittal"); });
  expect(window, "Shift+F6", [&] { return window_->focusWidget() == &page().view3d(); });
  expect(window, "Ctrl+T", changes([] { return Theme::now().is_dark; }));
  key(Qt::Key_T, Qt::ControlModifier);
  expect(window, "Ctrl+M", changes([&] { return window_->sounds().is_on(); }));
  key(Qt::Key_M, Qt::ControlModifier);
  expect(window, "F11", [&] { return window_->isFullScreen(); });
  key(Qt::Key_F11);
  const QDir pictures(QStandardPaths::writableLocation(QStandardPaths::PicturesLocation));
  const auto count = [&] { return pictures.entryList({QStringLiteral("bodkin *.png")}, QDir::Files).size(); };
  expect(window, "Ctrl+S", [&, before = count()] {
    return count() > before && frame().hint.find(".png") != std::string::npos;  // and says so
  });
}

void EveryKey::press_keys_of_the_needle_and_its_views() {
  using enum KeyScope;
  page().view3d().setFocus();
  // The body, while the needle is outside.
  expect(practise, "G", [&] { return page().view3d().workspace().has_value(); });
  elsewhere(practise, "Ctrl+Z");     // MovingWindow
  elsewhere(practise, "Ctrl+Home");  // MovingWindow
  key(Qt::Key_G);
  expect(practise, "F2", [&] { return !shows("practise.numbers"); });
  expect(practise, "F3", [&] { return !page().findChild<DepthLadder*>()->isVisible(); });
  expect(practise, "F4", [&] { return shows("practise.dock"); });
  key(Qt::Key_F4);
  for (const char* keys : {"Return", "Enter"}) {
    expect(practise, keys, [&] { return !shows("practise.chart"); });
    key(QKeySequence(QLatin1String(keys))[0]);
    ASSERT_TRUE(wait([&] { return shows("practise.chart"); }, 60));
  }
  expect(practise, "H", [&] { return frame().other_hand.finger; });
  key(Qt::Key_H);
  ASSERT_TRUE(wait([&] { return !frame().other_hand.finger; }, 60));
  elsewhere(practise, "S");  // WholeProcedure
  elsewhere(practise, "R");  // WholeProcedure
  elsewhere(practise, "B");  // WholeProcedure
  elsewhere(practise, "Z");  // BreathingPatient
  elsewhere(practise, "V");  // needs a fault of the guard, which a mouse cannot have
  // The views.
  expect_standard_views(view3d, page().view3d());
  expect(view3d, "P", changes([&] { return page().view3d().preset(); }));
  expect(view3d, "O", [&] { return shows("practise.parts.rows"); });
  page().view3d().show_parts(false);
  page().view3d().setFocus();
  expect(view3d, "Y", [&] { return page().view3d().stereo() != scene::Stereo::off; });
  page().view3d().set_stereo(scene::Stereo::off);
  auto* const axial = find<SliceView>("practise.slice.axial");
  axial->setFocus();
  const auto height = [&] { return frame().crosshair.z(); };
  expect(KeyScope::slice, "Up", changes(height));
  expect(KeyScope::slice, "Down", changes(height));
  expect(KeyScope::slice, "F", [&, before = frame().follows_tip] { return frame().follows_tip != before; });
  const auto level = [&] { return axial->look().level; };
  expect(KeyScope::slice, "]", changes(level));
  expect(KeyScope::slice, "[", changes(level));
  expect(KeyScope::slice, "T", changes([&] { return axial->look().slab.thickness; }));
  axial->zoom(2.0);
  expect(KeyScope::slice, "Home", changes([&] { return axial->field(); }));
  expect(KeyScope::slice, "M", [&] { return axial->is_measuring(); });
  const QPoint middle = axial->rect().center();
  for (const QPoint& at : {middle, middle + QPoint(30, 0)}) QTest::mouseClick(axial, Qt::LeftButton, {}, at);
  EXPECT_FALSE(axial->is_measuring());
  EXPECT_FALSE(stored_measures(window_->practice().patient()->folder).empty()) << "it stays with the patient";
  expect(KeyScope::slice, "Q", [&] { return axial->is_measuring(); });
  for (const QPoint& at : {middle, middle + QPoint(0, 30), middle + QPoint(30, 30)})
    QTest::mouseClick(axial, Qt::LeftButton, {}, at);
  elsewhere(KeyScope::slice, "X");  // SliceView
  expect(KeyScope::slice, "N", [&] { return axial->kind() == SliceKind::along_needle; });
  key(Qt::Key_N);
  EXPECT_EQ(axial->kind(), SliceKind::axial);
  const QImage still = axial->grab().toImage();
  expect(KeyScope::slice, "C", [&] { return axial->grab().toImage() != still; });
  key(Qt::Key_C);
  // The volume beside them.
  expect(practise, "I", [&] { return shows("practise.volume.view"); });
  ASSERT_TRUE(wait([&] { return page().volume().picture().base() != nullptr; }, 60));
  EXPECT_EQ(window_->focusWidget(), &page().volume());
  key(Qt::Key_M);
  EXPECT_EQ(page().volume().look().mode, imaging::VolumeMode::grey);
  key(Qt::Key_Return);
  EXPECT_TRUE(wait([&] { return !shows("practise.view3d") && page().volume().width() > window_->width() / 2; }, 60));
  key(Qt::Key_Return);
  EXPECT_TRUE(wait([&] { return shows("practise.view3d") && shows("practise.slice.sagittal"); }, 60));
  click("practise.volume");
  EXPECT_FALSE(shows("practise.volume.view"));
  // The needle.
  page().view3d().setFocus();
  const auto depth = [&] { return frame().depth; };
  const auto held = [&](const char* keys, const std::function<bool()>& done) {
    pressed_[practise].insert(keys);
    const int code = QKeySequence(QLatin1String(keys))[0];
    const Qt::KeyboardModifiers modifiers(code & static_cast<int>(Qt::KeyboardModifierMask));
    const auto plain = static_cast<Qt::Key>(code & ~static_cast<int>(Qt::KeyboardModifierMask));
    QTest::keyPress(window_->focusWidget(), plain, modifiers);
    EXPECT_TRUE(wait(done, 60)) << keys;
    QTest::keyRelease(window_->focusWidget(), plain, modifiers);
  };
  held("PgDown", [&] { return frame().depth > 6.0; });
  held("Shift+PgDown", rises(depth));
  held("Shift+PgUp", falls(depth));
  held("PgUp", falls(depth));
  for (const char* keys : {",", "."}) {
    held(keys, [&, before = Pose(frame().needle)] {
      const Eigen::AngleAxisd turn(Mat3(before.linear().transpose() * frame().needle.linear()));
      return turn.angle() > 0.3 && std::abs(turn.axis().z()) > 0.99;
    });
  }
  expect(practise, "Space", [&] { return window_->practice().state() == State::held; });
  key(Qt::Key_Space);
  ASSERT_TRUE(wait(State::in_tissue, 60));
  expect(practise, "W", [&] { return frame().depth <= 0.0; });
  held("PgDown", [&] { return frame().depth > 6.0; });
  expect(practise, "Shift+Space", [&] { return window_->practice().left_needles().size() == 1; });
  ASSERT_TRUE(wait(State::ready, 60));
  expect(practise, "Shift+W", [&] { return window_->practice().left_needles().empty(); });
  held("PgDown", [&] { return frame().depth > 3.0; });
  expect(practise, "A", [&] { return window_->practice().state() == State::ready && frame().depth <= 0.0; });
  expect(practise, "U", [&] { return shows("practise.ultrasound"); });
  ASSERT_TRUE(wait(State::ready, 60));
  EXPECT_TRUE(wait([&] { return page().view3d().trails() != nullptr; }, 60)) << "probe and picture in 3-D";
  held("PgDown", [&] { return frame().depth > 3.0; });
  expect(practise, "E", [&] { return window_->practice().state() == State::ended; });
}

void EveryKey::press_keys_of_the_pages() {
  using enum KeyScope;
  auto* const inside = go<VolumePage>(PageId::volume);
  ASSERT_TRUE(wait([&] { return inside->view().picture().base() != nullptr; }, 60));
  expect_standard_views(volume, inside->view());
  expect(volume, "M", [&] { return inside->view().look().mode == imaging::VolumeMode::grey; });
  expect(volume, "P", [&] { return find<QPushButton>("volume.preset.soft_tissue")->isChecked(); });

  auto* const settings = go<ModelsPage>(PageId::models);
  settings->setFocus();
  const auto number = [&] { return find<QDoubleSpinBox>("models.value")->value(); };
  const auto question = [&] { return find<QLabel>("models.question")->text(); };
  const QString first = question();
  expect(models, "Right", [&] { return question() != first; });
  expect(models, "Left", [&] { return question() == first; });
  expect(models, "Up", rises(number));
  expect(models, "Down", falls(number));
  expect(models, "Shift+Up", rises(number));
  expect(models, "Shift+Down", falls(number));
  key(Qt::Key_Up);
  expect(models, "Ctrl+Z", falls(number));
  expect(models, "Ctrl+Shift+Z", rises(number));

  auto* const scanner = go<ScanPage>(PageId::scan);
  auto* const viewer = find<ScanViewer>("scan.viewer");
  expect(scan, "S", [&] { return !scanner->scans().empty() && !scanner->is_scanning() && viewer->slice() > 0; });
  viewer->setFocus();
  expect(scan, "C", [&] { return viewer->cine(); });
  key(Qt::Key_C);
  const auto slice_number = [&] { return viewer->slice(); };
  expect(scan, "Home", [&] { return viewer->slice() == 0; });
  expect(scan, "Up", rises(slice_number));
  expect(scan, "Down", falls(slice_number));
  expect(scan, "End", rises(slice_number));

  auto* const structures = go<SegmentPage>(PageId::segment);
  ASSERT_TRUE(wait([&] { return structures->model() != nullptr; }, 60));
  structures->setFocus();
  const auto checked = [&](const char* name) {
    return [this, name] { return find<QPushButton>(name)->isChecked(); };
  };
  expect(segment, "P", checked("segment.tool.paint"));
  expect(segment, "E", checked("segment.tool.erase"));
  expect(segment, "G", checked("segment.tool.grow"));
  expect(segment, "L", checked("segment.tool.look"));
  const auto radius = [&] { return find<QDoubleSpinBox>("segment.radius")->value(); };
  expect(segment, "]", rises(radius));
  expect(segment, "[", falls(radius));
  expect(segment, "V", changes([&] { return find<QCheckBox>("segment.covered")->isChecked(); }));
  key(Qt::Key_V);
  elsewhere(segment, "Ctrl+Z");        // SegmentWindow
  elsewhere(segment, "Ctrl+Shift+Z");  // SegmentWindow
  structures->slice(0).setFocus();
  const auto picture = [&] { return structures->slice(0).grab().toImage(); };
  expect(segment, "Up", changes(picture));
  expect(segment, "Down", changes(picture));

  auto* const planning = go<PlanPage>(PageId::plan);
  ASSERT_TRUE(wait([&] { return !planning->model()->result().proposals.empty(); }, 60));
  const auto entry = [&] { return planning->model()->points().entry.value_or(Vec3::Zero()); };
  const Vec3 as_it_was = entry();
  expect(plan, "Tab", [&] { return entry() != as_it_was; });
  const Vec3 proposed = entry();
  expect(plan, "Ctrl+Z", [&] { return entry() == as_it_was; });
  expect(plan, "Ctrl+Shift+Z", [&] { return entry() == proposed; });
  expect(plan, "Del", [&] { return !planning->model()->path(); });
  while (planning->model()->can_undo()) key(Qt::Key_Z, Qt::ControlModifier);
  for (const char* keys : {"Return", "Enter"}) {
    expect(plan, keys, [&] { return page().isVisible(); });
    if (std::string(keys) == "Enter") break;
    window_->show_page(PageId::plan);
    ASSERT_TRUE(wait([&] { return planning->isVisible(); }, 60));
  }
  ASSERT_TRUE(wait(State::ready, 60));
}

void EveryKey::press_keys_that_leave() {
  window_->practice().leave();
  ASSERT_TRUE(wait([&] { return shows("start.begin"); }, 60));
  bool asked = false;
  QTimer::singleShot(100, window_.get(), [&] {
    QWidget* const menu = QApplication::activePopupWidget();
    asked = menu != nullptr && menu->objectName() == QStringLiteral("open.menu");
    if (menu != nullptr) menu->close();
  });
  expect(KeyScope::window, "Ctrl+O", [&] { return asked; });
  expect(KeyScope::window, "Ctrl+Q", [&] { return !window_->isVisible(); });
}

TEST_F(EveryKey, does_what_the_table_says) {
  using enum KeyScope;
  press_keys_of_the_start_page();
  ASSERT_TRUE(this->start()) << window_->practice().failure();
  ASSERT_TRUE(wait([&] { return page().view3d().is_ready(); }, 60));
  press_keys_of_the_window();
  press_keys_of_the_pages();
  press_keys_of_the_needle_and_its_views();
  press_keys_that_leave();
  expect_all_pressed({window, KeyScope::start, practise, view3d, slice, volume, models, scan, segment, plan});
}

}  // namespace
}  // namespace bodkin::app
