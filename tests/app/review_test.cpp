// The review page in a window: it shows the contents of the session file.
#include "app/pages/review.h"

#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <filesystem>

#include "app/main_window.h"
#include "app/models/data_folder.h"
#include "app/models/kept_sessions.h"
#include "session/session_file.h"
#include "tests/session/slab_case.h"
#include <gtest/gtest.h>

#include "imaging/ultrasound/probe.h"
#include "io/probe_library_file.h"
#include "io/tissue_library_file.h"

namespace bodkin::app {
namespace {

namespace fs = std::filesystem;

// A tick every millisecond that goes 20 mm/s into the body after half a second; the skin gives at 3 mm.
session::SessionHeader header_of(const fs::path& folder) {
  session::SessionHeader header;
  header.bodkin_version = "test";
  header.case_folder = folder.string();
  header.case_digest = "2:0123456789abcdef";
  header.case_xml = "<case/>";
  header.operator_name = "by hand";
  header.operator_settings = "{}";
  header.started_at = "2026-11-23T12:00:00Z";
  header.path = {Vec3::Zero(), Vec3(0, -50, 0)};
  const anatomy::TissueLibrary library = io::default_tissue_library();
  for (const anatomy::TissueProperties& each : library.tissues())
    header.tissues.push_back({each.id, each.name, each.title});
  return header;
}

double depth_at(int tick, double speed) {
  return tick < 500 ? 0.0 : 0.001 * speed * (tick - 500);
}

fs::path write_session(const fs::path& file, double speed, int ticks, bool finished) {
  session::SessionWriter writer(file, header_of("/no/such/patient"), true);
  for (int i = 0; i < ticks; ++i) {
    simulation::TickRecord record;
    record.tick = static_cast<std::uint64_t>(i);
    const double depth = depth_at(i, speed);
    record.input.needle = needle_pose(Vec3(0.0, -depth, 0.1 * depth), -Vec3::UnitY());
    record.output.depth = depth;
    record.output.in_contact = depth > 0.0;
    record.output.tissue = depth > 6.0 ? anatomy::tissue::muscle : anatomy::tissue::skin;
    record.output.resistance = 0.1 * depth;
    record.output.requested.force = Vec3(0.0, 0.1 * depth, 0.0);
    if (i > 0 && depth_at(i - 1, speed) < 3.0 && depth >= 3.0)
      record.output.events.push({forces::EventKind::puncture, anatomy::tissue::skin, depth, 0.3});
    if (i == ticks - 100)
      record.output.events.push({forces::EventKind::bone_contact, anatomy::tissue::cortical_bone, depth, 0.0});
    writer.append(record);
  }
  writer.commit();
  if (finished) writer.finish();
  return file;
}

class Review : public testing::Test {
 protected:
  void SetUp() override {
    sessions_ = data_folder() / "sessions";
    fs::remove_all(sessions_);
    fs::create_directories(sessions_);
  }
  void show() {
    window_ = std::make_unique<MainWindow>(data_folder());
    window_->resize(1280, 720);
    window_->show();
    window_->show_page(PageId::review);
    page_ = window_->findChild<ReviewPage*>(QStringLiteral("review"));
    ASSERT_NE(page_, nullptr);
  }
  bool wait_until_read() {
    return QTest::qWaitFor([&] { return !page_->is_busy(); }, 60000);
  }
  // Waits until the requested moment is shown.
  void settle() {
    QTest::qWait(40);
    if (page_->recording() == nullptr) return;
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(page_->frame().time - page_->time()) < 0.0011; }, 60000));
  }
  void key(int code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWidget* const focus = window_->focusWidget();
    ASSERT_NE(focus, nullptr);
    QTest::keyClick(focus, static_cast<Qt::Key>(code), modifiers);
    settle();
  }
  QString text(const char* name) { return window_->findChild<QLabel*>(QLatin1String(name))->text(); }

  fs::path sessions_;
  std::unique_ptr<MainWindow> window_;
  ReviewPage* page_ = nullptr;
};

TEST_F(Review, seeking_shows_the_needle_and_the_time_that_the_file_holds) {
  const fs::path file = write_session(sessions_ / "one.bodkin", 20.0, 3000, true);
  const session::Session saved = session::read_session(file);
  show();
  page_->open(file);
  ASSERT_TRUE(wait_until_read());
  ASSERT_NE(page_->recording(), nullptr);
  for (const std::size_t tick : {std::size_t{0}, std::size_t{777}, std::size_t{2999}, std::size_t{1234}}) {
    page_->seek(0.001 * static_cast<double>(tick));
    settle();
    EXPECT_NEAR(page_->frame().time, 0.001 * static_cast<double>(tick), 1e-9);
    EXPECT_EQ((page_->frame().needle.translation() - saved.ticks[tick].input.needle.translation()).norm(), 0.0);
    EXPECT_EQ(page_->frame().resistance, saved.ticks[tick].output.resistance);
  }
  EXPECT_EQ(page_->frame().place, "muscle");
}

// The on-screen probe is replayed: its recomputed image and its border; and a left needle, in the image and beside
// the other needle.
TEST_F(Review, shows_the_recorded_probe_and_its_picture) {
  auto patient = std::make_shared<OpenCase>();
  patient->patient = slab_case({{anatomy::tissue::skin, 2.0}, {anatomy::tissue::muscle, 60.0}});
  patient->folder = sessions_ / "slabs";
  const fs::path file = sessions_ / "scanned.bodkin";
  session::SessionHeader header = header_of(patient->folder);
  header.ultrasound = io::find_probe("L14-5");
  const anatomy::NeedlePath left{Vec3(12.0, 0.0, 0.0), Vec3(-6.0, -18.0, 0.0)};
  header.left_needles = {left};
  {
    session::SessionWriter writer(file, header, true);
    for (int i = 0; i < 2000; ++i) {
      simulation::TickRecord record;
      record.tick = static_cast<std::uint64_t>(i);
      record.input.needle = needle_pose(Vec3(0.0, 10.0, 0.0), -Vec3::UnitY());
      writer.append(record);
    }
    session::ScanSample sample;
    sample.settings.depth = 40.0;
    sample.probe = imaging::probe_pose(Vec3::Zero(), -Vec3::UnitY(), Vec3::UnitX());
    writer.append(sample);
    sample.time = 1.0;
    sample.probe.translation().y() = 30.0;  // lifted off
    writer.append(sample);
    writer.finish();
  }
  show();
  page_->set_case(patient);
  page_->open(file);
  ASSERT_TRUE(wait_until_read());
  ASSERT_NE(page_->recording(), nullptr);
  ASSERT_NE(page_->recording()->scan(), nullptr) << page_->recording()->note();
  auto* const view = window_->findChild<UltrasoundView*>(QStringLiteral("review.ultrasound"));
  ASSERT_NE(view, nullptr);
  page_->seek(0.5);
  settle();
  EXPECT_TRUE(view->isVisible());
  ASSERT_NE(view->scan(), nullptr);
  const imaging::ScanState& shown = view->scan()->screen().moment();
  EXPECT_EQ(shown.frame.why, imaging::NoImage::none);
  EXPECT_EQ(shown.settings.depth, 40.0);
  EXPECT_EQ(shown.pose.translation(), Vec3::Zero());
  ASSERT_EQ(page_->frame().left_needles.size(), 1U);
  EXPECT_LT((page_->frame().left_needles[0].pose.translation() - left.target).norm(), 1e-12);
  session::Session without = page_->recording()->session();
  without.header.left_needles.clear();
  ScanReplay empty(without, patient->patient, {});
  EXPECT_NE(empty.picture(0, page_->frame().needle).frame.pixels, shown.frame.pixels) << "it throws an echo";
  page_->seek(1.5);
  settle();
  EXPECT_EQ(shown.frame.why, imaging::NoImage::no_contact);
  EXPECT_EQ(shown.pose.translation(), Vec3(0.0, 30.0, 0.0));
  const std::vector<Vec3> border = scan_border(page_->recording()->session(), 1);
  ASSERT_EQ(border.size(), 5U) << "a linear probe sees a rectangle";
  EXPECT_NEAR(border[2].y(), 30.0 - 40.0, 1e-9);
  // A session without ultrasound shows none.
  page_->open(write_session(sessions_ / "one.bodkin", 20.0, 3000, true));
  ASSERT_TRUE(wait_until_read());
  settle();
  EXPECT_FALSE(view->isVisible());
}

TEST_F(Review, keys_step_by_pictures_and_events_and_a_click_on_a_flag_goes_to_its_moment) {
  show();
  page_->open(write_session(sessions_ / "one.bodkin", 20.0, 3000, true));
  ASSERT_TRUE(wait_until_read());
  settle();
  key(Qt::Key_Right);
  EXPECT_NEAR(page_->time(), 0.04, 1e-9);
  key(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NEAR(page_->time(), 0.65, 1e-9);  // 3 mm at 20 mm/s after half a second
  key(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NEAR(page_->time(), 2.9, 1e-9);
  key(Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_NEAR(page_->time(), 0.65, 1e-9);
  auto* timeline = window_->findChild<Timeline*>(QStringLiteral("review.timeline"));
  QTest::mouseClick(timeline, Qt::LeftButton, {}, timeline->place_of_event(0, 1));
  settle();
  EXPECT_NEAR(page_->time(), 2.9, 1e-9);
  // Elsewhere a click goes to the moment at that place.
  const double somewhere = 1.5;
  QTest::mouseClick(timeline, Qt::LeftButton, {}, QPoint(static_cast<int>(timeline->x_of(somewhere)), 30));
  EXPECT_NEAR(page_->time(), somewhere, 3.0 / timeline->width() * 2.0);
}

TEST_F(Review, plays_at_the_speed_that_was_chosen_and_stops_at_the_end) {
  show();
  page_->open(write_session(sessions_ / "one.bodkin", 20.0, 3000, true));
  ASSERT_TRUE(wait_until_read());
  QTest::mouseClick(window_->findChild<QPushButton*>(QStringLiteral("review.speed.0.25")), Qt::LeftButton);
  EXPECT_EQ(page_->speed(), 0.25);
  key(Qt::Key_Period);
  EXPECT_EQ(page_->speed(), 0.5);
  page_->set_speed(4.0);
  key(Qt::Key_Space);
  EXPECT_TRUE(page_->is_playing());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page_->is_playing(); }, 60000));
  EXPECT_NEAR(page_->time(), 2.999, 1e-9);
}

TEST_F(Review, a_second_session_lies_over_the_first_from_the_contact_with_the_skin_on) {
  const fs::path slow = write_session(sessions_ / "slow.bodkin", 10.0, 4000, true);
  show();
  page_->open(write_session(sessions_ / "one.bodkin", 20.0, 3000, true));
  ASSERT_TRUE(wait_until_read());
  page_->compare_with(slow);
  ASSERT_TRUE(wait_until_read());
  ASSERT_NE(page_->other(), nullptr);
  // Both touch the skin after the same time, so the timeline reaches to the end of the longer one.
  auto* timeline = window_->findChild<Timeline*>(QStringLiteral("review.timeline"));
  EXPECT_NEAR(timeline->x_of(page_->other()->end()), timeline->width() - 12.0, 1.0);
  page_->stop_comparing();
  EXPECT_EQ(page_->other(), nullptr);
  EXPECT_NEAR(timeline->x_of(page_->recording()->end()), timeline->width() - 12.0, 1.0);
}

TEST_F(Review, a_missing_patient_is_one_sentence_and_the_path_is_still_there) {
  show();
  page_->open(write_session(sessions_ / "one.bodkin", 20.0, 3000, true));
  ASSERT_TRUE(wait_until_read());
  settle();
  EXPECT_TRUE(text("review.note").contains(QStringLiteral("/no/such/patient"))) << text("review.note").toStdString();
  auto* picture = window_->findChild<QWidget*>(QStringLiteral("review.path"));
  EXPECT_TRUE(picture->isVisible());
  // The path, drawn in the colours of skin and muscle.
  const QImage image = picture->grab().toImage();
  int muscle = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) muscle += image.pixel(x, y) == 0xFFA64E56 ? 1 : 0;
  }
  EXPECT_GT(muscle, 20);
}

TEST_F(Review, a_session_that_was_cut_off_is_complete_as_far_as_it_was_saved) {
  const fs::path file = write_session(sessions_ / "cut off.bodkin", 20.0, 2000, false);
  const std::vector<KeptSession> kept = kept_sessions(sessions_);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(cut_off_session(kept, {}), file);
  EXPECT_EQ(cut_off_session(kept, {file}), fs::path());
  show();
  window_->show_page(PageId::start);
  window_->open(file);  // as 'bodkin app FILE.bodkin' does, and a file that is dropped on the start page
  ASSERT_TRUE(wait_until_read());
  settle();
  ASSERT_NE(page_->recording(), nullptr);
  EXPECT_EQ(page_->recording()->size(), 2000U);
  EXPECT_TRUE(text("review.note").contains(QStringLiteral("cut off")));
}

TEST_F(Review, the_start_page_offers_a_session_that_was_cut_off_until_it_is_forgotten) {
  write_session(sessions_ / "cut off.bodkin", 20.0, 2000, false);
  show();
  window_->show_page(PageId::start);
  settle();
  auto* review = window_->findChild<QPushButton*>(QStringLiteral("start.recovered.review"));
  ASSERT_TRUE(review->isVisible());
  QTest::mouseClick(review, Qt::LeftButton);
  ASSERT_TRUE(wait_until_read());
  EXPECT_NE(page_->recording(), nullptr);
  window_->show_page(PageId::start);
  QTest::mouseClick(window_->findChild<QPushButton*>(QStringLiteral("start.recovered.forget")), Qt::LeftButton);
  EXPECT_FALSE(review->isVisible());
  window_.reset();
  show();
  window_->show_page(PageId::start);
  EXPECT_FALSE(window_->findChild<QPushButton*>(QStringLiteral("start.recovered.review"))->isVisible());
  EXPECT_TRUE(fs::exists(sessions_ / "cut off.bodkin"));
}

TEST_F(Review, a_damaged_file_is_one_sentence_and_what_was_shown_stays) {
  const fs::path good = write_session(sessions_ / "one.bodkin", 20.0, 3000, true), bad = sessions_ / "half.bodkin";
  fs::copy_file(good, bad);
  fs::resize_file(bad, fs::file_size(bad) / 2);
  show();
  page_->open(bad);
  ASSERT_TRUE(wait_until_read());
  EXPECT_TRUE(text("review.line").contains(QStringLiteral("half.bodkin"))) << text("review.line").toStdString();
  page_->open(good);
  ASSERT_TRUE(wait_until_read());
  page_->open(bad);
  ASSERT_TRUE(wait_until_read());
  ASSERT_NE(page_->recording(), nullptr);
  EXPECT_EQ(page_->recording()->file(), good);
  EXPECT_TRUE(text("review.said").contains(QStringLiteral("half.bodkin")));
}

TEST_F(Review, pictures_are_written_for_the_whole_session) {
  show();
  page_->open(write_session(sessions_ / "one.bodkin", 20.0, 3000, true));
  ASSERT_TRUE(wait_until_read());
  const QTemporaryDir folder;
  page_->save_series(folder.filePath(QStringLiteral("out")), false, 2.0);
  ASSERT_TRUE(wait_until_read());
  const QDir out(folder.filePath(QStringLiteral("out")));
  EXPECT_EQ(out.entryList({QStringLiteral("*.png")}).size(), 6);
  EXPECT_NE(QImage(out.filePath(QStringLiteral("00000.png"))), QImage(out.filePath(QStringLiteral("00005.png"))));
  EXPECT_FALSE(text("review.said").isEmpty());
}

}  // namespace
}  // namespace bodkin::app
