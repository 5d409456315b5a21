// The page of augmented reality, with rendered footage whose truth is known.
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <vector>

#include "app/pages/camera.h"
#include "patient/meshing/mesh_record.h"
#include "session/session_file.h"
#include "tests/fem/lattice_body.h"
#include "tests/tracking/foreign_markers.h"
#include "tests/tracking/mirrored.h"
#include "tests/tracking/needle_ring.h"
#include "tests/views/made_up.h"
#include "tracking/footage_scene.h"
#include <gtest/gtest.h>

#include "core/files.h"
#include "imaging/png_file.h"
#include "io/case_folder.h"

namespace bodkin::app {
namespace {

using bodkin_test::layered_patient;

class CameraPageTest : public testing::Test {
 protected:
  CameraPageTest() : page_(made_.path().toStdString()) {
    QSettings().remove(QStringLiteral("camera"));
    page_.resize(1100, 640);
    page_.show();
    page_.set_case(layered_patient());
    page_.enter();
  }
  ~CameraPageTest() override { QSettings().remove(QStringLiteral("camera")); }
  template <typename Widget>
  Widget* find(const char* name) {
    auto* const found = page_.findChild<Widget*>(QLatin1String(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  std::filesystem::path folder(const char* name) const {
    return std::filesystem::path(made_.path().toStdString()) / name;
  }
  // A still scene, so that every picture has the same truth.
  tracking::Footage render(const char* name) {
    tracking::SceneOptions options;
    options.frames = 2;
    options.width = 640;
    options.height = 480;
    options.still = true;
    options.look.samples = 3;
    options.look.shot_noise = options.look.read_noise = 0.0;
    return tracking::render_scene(folder(name), options);
  }
  bool wait(const std::function<bool()>& until) {
    return QTest::qWaitFor(
        [&] {
          page_.advance(clock_ += 0.02);
          return until();
        },
        60000);
  }
  void start(const std::filesystem::path& source) {
    find<QComboBox>("camera.source")->setEditText(QString::fromStdString(source.string()));
    QTest::mouseClick(find<QPushButton>("camera.start"), Qt::LeftButton);
  }
  std::string line() { return find<QLabel>("camera.line")->text().toStdString(); }

  QTemporaryDir made_;
  CameraPage page_;
  double clock_ = 0.0;
};

TEST_F(CameraPageTest, shows_the_needle_and_the_probe_where_they_are_in_the_patient) {
  const tracking::Footage footage = render("footage");
  start(footage.folder);
  ASSERT_TRUE(wait([&] { return page_.camera_status().number > 1; })) << line();
  // The truth of the footage, through the same place of the patient.
  const auto patient = layered_patient();
  const tracking::Similarity place = tracking::placed_at(patient->patient, tracking::scene_skin());
  const std::vector<tracking::MarkerBody> bodies = tracking::station_bodies();
  const auto index = [&](const char* name) {
    return static_cast<std::size_t>(std::find(footage.bodies.begin(), footage.bodies.end(), name) -
                                    footage.bodies.begin());
  };
  const std::vector<Pose>& truth = footage.frames.front().camera_from_body;
  const Pose needle =
      tracking::tool_in_patient(bodies[index("needle")], truth[index("needle")], truth[index("mannequin")], place);
  ASSERT_TRUE(page_.camera_status().needle.has_value());
  EXPECT_LT((page_.camera_status().needle->translation() - needle.translation()).norm(), 2.0);
  EXPECT_GT(page_.camera_status().needle->linear().col(2).dot(needle.linear().col(2)), 0.9995);
  // The slices show that needle, with the crosshair at its tip.
  EXPECT_EQ(page_.frame().needle.matrix(), page_.camera_status().needle->matrix());
  EXPECT_EQ(page_.frame().crosshair, page_.camera_status().needle->translation());
  // A row for each body, in the words of the tracker.
  auto* const table = find<QTableWidget>("camera.bodies.table");
  ASSERT_EQ(table->rowCount(), static_cast<int>(footage.bodies.size()));
  for (int row = 0; row < table->rowCount(); ++row) {
    EXPECT_EQ(table->item(row, 1)->text().toStdString(),
              tracking::name_of(page_.camera_status().bodies[static_cast<std::size_t>(row)].status));
  }
  // The tracked probe holds the ultrasound.
  if (page_.camera_status().probe) {
    EXPECT_TRUE(wait([&] { return find<UltrasoundView>("camera.ultrasound")->scan() != nullptr; }));
    EXPECT_TRUE(wait([&] { return find<CameraPicture>("camera.ct")->picture() != nullptr; }))
        << "the CT in its plane";
  }
  EXPECT_NE(line().find("pictures/s"), std::string::npos) << line();
  // The patient is drawn over the camera's picture, and outside the oval only needle and path.
  const imaging::ImageRgb raw = tracking::read_picture(footage.folder / footage.frames.front().file);
  const imaging::ImageRgb& shown = *page_.camera_status().picture;
  std::size_t changed = 0;
  for (std::size_t i = 0; i < raw.pixels.size(); ++i) changed += raw.pixels[i] == shown.pixels[i] ? 0 : 1;
  EXPECT_GT(changed, 2000U);
  EXPECT_NEAR(raw.at(2, raw.height - 3).green, shown.at(2, shown.height - 3).green, 3);
  QTest::mouseClick(find<QPushButton>("camera.start"), Qt::LeftButton);
  EXPECT_EQ(page_.camera_status().number, 0U);
  EXPECT_EQ(table->rowCount(), 0) << "what is not seen now is not shown as if it were";
}

// A block of muscle whose skin lies at y = 0; the mannequin's skin, to which the dummy comes, lies at the entry of
// the planned path, `deep` mm below.
std::shared_ptr<const OpenCase> block_of_muscle(const std::filesystem::path& folder,
                                                const anatomy::ResistanceSettings& resistance, double deep) {
  auto patient = std::make_shared<OpenCase>(*layered_patient());
  patient->folder = folder;
  anatomy::Case& made = patient->patient;
  anatomy::Grid grid;
  grid.size = {60, 30, 60};
  grid.spacing = Vec3::Constant(4.0);
  grid.origin = Vec3(-118.0, -98.0, -118.0);
  made.ct = anatomy::CtVolume(grid, -1000);
  made.tissues = anatomy::TissueVolume(grid, anatomy::tissue::air);
  for (int k = 0; k < 60; ++k) {
    for (int j = 0; j < 25; ++j) {
      for (int i = 0; i < 60; ++i) {
        made.ct.at(i, j, k) = 50;
        made.tissues.at(i, j, k) = anatomy::tissue::muscle;
      }
    }
  }
  made.description.procedure.path = anatomy::NeedlePath{Vec3(0.0, -deep, 0.0), Vec3(0.0, -deep - 42.0, 0.0)};
  made.description.haptics.resistance = resistance;
  io::write_case(made.description, made.ct, made.tissues, {}, &made.library, patient->folder);
  anatomy::TetrahedralMesh mesh = kuhn_box({13, 6, 13}, Vec3(240.0, 100.0, 240.0));
  for (Vec3& node : mesh.nodes) node -= Vec3(120.0, 100.0, 120.0);
  std::fill(mesh.tissues.begin(), mesh.tissues.end(), anatomy::tissue::muscle);
  patient::write_case_mesh(mesh, {}, patient->folder);
  return patient;
}

TEST_F(CameraPageTest, slices_show_the_tissue_that_the_probe_has_pressed) {
  page_.set_case(block_of_muscle(folder("block"), layered_patient()->description().haptics.resistance, 8.0));
  page_.enter();
  start(render("pressing").folder);
  ASSERT_TRUE(wait([&] { return page_.frame().moved_tissue != nullptr; })) << line();
  const auto pressed = [&] {
    if (page_.frame().moved_tissue == nullptr || !page_.camera_status().probe) return 0.0;
    Vec3 skin = page_.camera_status().probe->translation();
    skin.y() = -1.0;
    return -page_.frame().moved_tissue->of(skin).y();
  };
  EXPECT_TRUE(wait([&] { return pressed() > 4.0; })) << pressed();
  EXPECT_LT(pressed(), 12.0);
}

// The probe only touches: only the session's needle moves the tissue.
TEST_F(CameraPageTest, slices_show_the_tissue_that_the_needle_of_a_session_pushes) {
  anatomy::EmbeddedNeedleSettings settings;
  settings.body.stiffness_scale = 0.3;
  page_.set_case(block_of_muscle(folder("block"), settings, 0.0));
  page_.enter();
  tracking::SceneOptions options;
  options.width = 640;
  options.height = 360;
  options.rate = 10.0;
  options.path = 42.0;
  options.frames = static_cast<int>(std::ceil(tracking::motion_duration(options) * options.rate));
  options.look.samples = 3;
  const tracking::Footage footage = tracking::render_scene(folder("attempt"), options);
  qputenv("XDG_DATA_HOME", made_.path().toUtf8());
  start(footage.folder);
  ASSERT_TRUE(wait([&] { return page_.camera_status().number > 0; })) << line();
  QTest::mouseClick(find<QPushButton>("camera.record"), Qt::LeftButton);
  double most = 0.0;
  ASSERT_TRUE(wait([&] {
    const auto& moved = page_.frame().moved_tissue;
    if (moved != nullptr) most = std::max(most, -moved->of(Vec3(0.0, -1.0, 0.0)).y());
    return most > 0.3 || !page_.is_recording();
  })) << line();
  EXPECT_GT(most, 0.3) << line();
  EXPECT_LT(most, 40.0);
  page_.stop();
  qunsetenv("XDG_DATA_HOME");
}

// Every painted image counts once, from before its decoding.
TEST_F(CameraPageTest, knows_how_long_a_picture_takes_from_its_arrival_until_it_is_painted) {
  const tracking::Footage footage = render("latency");
  double decoding = 1e9;  // s; the minimum of several, as others use the machine, too
  for (int i = 0; i < 5; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    tracking::read_picture(footage.folder / footage.frames.front().file);
    decoding = std::min(decoding, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  start(footage.folder);
  ASSERT_TRUE(wait([&] { return page_.latencies().size() > 9; })) << line();
  EXPECT_LE(page_.latencies().size(), page_.camera_status().number);
  std::vector<double> sorted(page_.latencies().begin(), page_.latencies().end());
  std::sort(sorted.begin(), sorted.end());
  EXPECT_GT(sorted.front(), 0.3 * decoding);
  EXPECT_LT(sorted[sorted.size() / 2], 60.0);
  std::printf("from arrival to painted: median %.0f ms, %.0f ms at most\n", 1000.0 * sorted[sorted.size() / 2],
              1000.0 * sorted.back());
  // A repaint, as when the window is uncovered, is not a new image.
  page_.stop();
  const std::size_t count = page_.latencies().size();
  find<CameraPicture>("camera.picture")->repaint();
  EXPECT_EQ(page_.latencies().size(), count);
  page_.forget_latencies();
  EXPECT_TRUE(page_.latencies().empty());
}

// The images continue during the recording; the session ends with the footage and is scored.
TEST_F(CameraPageTest, records_a_session_with_the_needle_that_it_shows) {
  // A session keeps the description of its case, so there must be one on the disk.
  auto patient = std::make_shared<OpenCase>(*layered_patient());
  patient->folder = folder("patient");
  anatomy::Case& made = patient->patient;
  io::write_case(made.description, made.ct, made.tissues, {}, &made.library, patient->folder);
  page_.set_case(patient);
  page_.enter();
  tracking::SceneOptions options;
  options.width = 640;
  options.height = 360;
  options.rate = 10.0;
  options.path = layered_patient()->description().procedure.path->length();
  options.frames = static_cast<int>(std::ceil(tracking::motion_duration(options) * options.rate));
  options.look.samples = 3;
  const tracking::Footage footage = tracking::render_scene(folder("attempt"), options);
  qputenv("XDG_DATA_HOME", made_.path().toUtf8());
  start(footage.folder);
  ASSERT_TRUE(wait([&] { return page_.camera_status().number > 0; })) << line();
  auto* const record = find<QPushButton>("camera.record");
  auto* const review = find<QPushButton>("camera.review");
  EXPECT_FALSE(review->isEnabled());
  QTest::mouseClick(record, Qt::LeftButton);
  ASSERT_TRUE(page_.is_recording());
  ASSERT_TRUE(wait([&] { return line().starts_with("Recording") || !page_.is_recording(); })) << line();
  const auto shown = page_.camera_status().number;
  ASSERT_TRUE(wait([&] { return !page_.is_recording(); })) << line();
  EXPECT_NE(page_.camera_status().number, shown) << "the pictures went on";
  ASSERT_TRUE(page_.result().has_value()) << line();
  EXPECT_TRUE(review->isEnabled());
  const session::Session session = session::read_session(page_.result()->session);
  EXPECT_TRUE(session.finished);
  // It moved along the path to its end.
  const anatomy::NeedlePath path = session.header.path;
  double deepest = -1e9, aside = 0.0;
  for (const auto& tick : session.ticks) {
    const Vec3 from_entry = tick.input.needle.translation() - path.entry;
    const double along = from_entry.dot(path.direction());
    deepest = std::max(deepest, along);
    aside = std::max(aside, (from_entry - along * path.direction()).norm());
  }
  EXPECT_NEAR(deepest, path.length(), 1.0);
  EXPECT_LT(aside, 2.0);
  EXPECT_FALSE(page_.result()->headline.empty());
  qunsetenv("XDG_DATA_HOME");
}

TEST_F(CameraPageTest, oval_and_path_follow_their_controls) {
  start(render("footage").folder);
  ASSERT_TRUE(wait([&] { return page_.camera_status().number > 0; })) << line();
  const auto drawn = [&] {
    const std::uint64_t before = page_.camera_status().number;
    EXPECT_TRUE(wait([&] { return page_.camera_status().number > before + 1; }));
    return page_.camera_status().picture;
  };
  const auto first = drawn();
  for (int i = 0; i < 6; ++i) page_.press(QKeySequence(Qt::Key_Minus));  // less than the patient is wide
  EXPECT_NE(drawn()->pixels, first->pixels);
  const auto small = drawn();
  find<QCheckBox>("camera.plan")->setChecked(false);
  EXPECT_NE(drawn()->pixels, small->pixels);
  page_.press(QKeySequence(Qt::Key_Space));
  EXPECT_TRUE(find<QPushButton>("camera.pause")->isChecked());
  QTest::qWait(200);
  page_.advance(clock_ += 0.02);
  const std::uint64_t held = page_.camera_status().number;
  QTest::qWait(300);
  page_.advance(clock_ += 0.02);
  EXPECT_LE(page_.camera_status().number, held + 1);
  page_.press(QKeySequence(Qt::Key_Space));
  EXPECT_TRUE(wait([&] { return page_.camera_status().number > held + 2; }));
}

TEST_F(CameraPageTest, every_picture_of_a_moving_needle_is_drawn_with_its_own_pose) {
  tracking::SceneOptions options;
  options.frames = 5;
  options.rate = 1.0;
  options.width = 640;
  options.height = 480;
  options.look.samples = 3;
  const tracking::Footage footage = tracking::render_scene(folder("moving"), options);
  const tracking::CameraModel camera = tracking::read_camera(footage.folder / "camera.json");
  std::vector<Eigen::Vector2d> tips;
  for (const tracking::FootageFrame& frame : footage.frames)
    tips.push_back(camera.project(frame.camera_from_body[1] * tracking::station_bodies()[1].tip));
  find<QSlider>("camera.oval")->setValue(0);  // as small as it can be
  find<QCheckBox>("camera.plan")->setChecked(false);
  start(footage.folder);
  std::vector<bool> seen(tips.size(), false);
  std::uint64_t number = 0;
  EXPECT_TRUE(wait([&] {
    const CameraStatus& status = page_.camera_status();
    if (status.number == number || status.picture == nullptr || !status.needle) return false;
    number = status.number;
    const auto at = static_cast<std::size_t>(std::lround(status.time * options.rate));
    const auto raw = tracking::read_picture(footage.folder / footage.frames[at].file);
    const double own = (tracking::needle_ring(*status.picture, raw, tips[at]) - tips[at]).norm();
    EXPECT_LT(own, 2.5) << at;
    seen[at] = true;
    return std::count(seen.begin(), seen.end(), true) == static_cast<std::ptrdiff_t>(seen.size());
  })) << line();
  int far = 0;
  for (std::size_t n = 1; n < tips.size(); ++n) far += (tips[n] - tips[n - 1]).norm() > 6.0 ? 1 : 0;
  EXPECT_GE(far, 3) << "the needle moves";
}

TEST_F(CameraPageTest, a_large_oval_is_drawn_coarser_and_the_line_says_so) {
  start(render("footage").folder);
  ASSERT_TRUE(wait([&] { return page_.camera_status().number > 0; })) << line();
  const auto says_so = [&] { return line().find("Large oval: drawn at half the resolution.") != std::string::npos; };
  EXPECT_FALSE(says_so()) << line();
  for (int i = 0; i < 10; ++i) page_.press(QKeySequence(Qt::Key_Plus));  // twice as wide and as high
  EXPECT_TRUE(wait(says_so)) << line();
  EXPECT_NE(line().find("pictures/s"), std::string::npos) << line();
  for (int i = 0; i < 10; ++i) page_.press(QKeySequence(Qt::Key_Minus));
  EXPECT_TRUE(wait([&] { return !says_so(); })) << line();
}

TEST_F(CameraPageTest, a_video_whose_rate_varies_is_shown_and_the_line_says_so) {
  const tracking::Footage footage = render("still");
  const std::filesystem::path video = folder("uneven.mkv");
  // Each of the two pictures twice, the last one late.
  const std::string command = "ffmpeg -v error -framerate 20 -i '" + footage.folder.string() +
                              "/frame_%05d.png' -vf \"loop=1:2:0,setpts='if(lt(N,3),N,6)*0.05/TB'\" -vsync "
                              "passthrough -c:v ffv1 -pix_fmt gray '" +
                              video.string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);  // NOLINT: a fixed command
  find<QLineEdit>("camera.calibration")->setText(QString::fromStdString((footage.folder / "camera.json").string()));
  start(video);
  ASSERT_TRUE(wait([&] { return page_.camera_status().number > 1; })) << line();
  page_.advance(clock_ += 0.02);
  EXPECT_NE(line().find("pictures/s"), std::string::npos) << line();
  EXPECT_NE(line().find("uneven.mkv: the time between pictures varies from 50 to 200 ms"), std::string::npos)
      << line();
  find<QLineEdit>("camera.calibration")->clear();
}

TEST_F(CameraPageTest, pictures_that_are_mirrored_are_named_and_nothing_is_drawn_into_them) {
  const tracking::Footage footage = render("turned");
  const auto turned = tracking::mirrored(tracking::read_picture(footage.folder / footage.frames.front().file));
  for (const tracking::FootageFrame& frame : footage.frames)
    write_file(footage.folder / frame.file, imaging::encode_png(turned));
  start(footage.folder);
  EXPECT_TRUE(wait([&] { return line().find("mirrored left to right; switch mirroring off") != std::string::npos; }))
      << line();
  EXPECT_FALSE(page_.camera_status().needle.has_value());
  EXPECT_EQ(page_.camera_status().picture->pixels, turned.pixels);
}

// As if a different sheet of markers had been printed.
TEST_F(CameraPageTest, markers_that_are_on_no_body_and_those_of_another_dictionary_are_named) {
  tracking::Footage footage = render("others");
  std::vector<tracking::MarkerBody> bodies = tracking::station_bodies();
  for (tracking::MarkerBody& body : bodies) {
    for (tracking::MarkerFace& face : body.faces) face.id += face.id < 0 ? 0 : 25;
  }
  write_file(footage.folder / "bodies.json", tracking::bodies_json(bodies));
  start(footage.folder);
  EXPECT_TRUE(wait([&] { return line().find("markers are seen that are on no body (") != std::string::npos; }))
      << line();
  page_.stop();
  footage = render("dictionary");
  for (const tracking::FootageFrame& frame : footage.frames)
    write_file(footage.folder / frame.file,
               imaging::encode_png(tracking::colour_of(tracking::foreign_markers(6, 640, 480))));
  start(footage.folder);
  EXPECT_TRUE(wait([&] { return line().find("no marker of the dictionary 4x4_50") != std::string::npos; })) << line();
}

TEST_F(CameraPageTest, pictures_without_a_calibration_are_shown_alone_and_that_is_said) {
  const tracking::Footage footage = render("footage");
  std::filesystem::remove(footage.folder / "camera.json");
  start(footage.folder);
  ASSERT_TRUE(wait([&] { return page_.camera_status().number > 0; })) << line();
  // The first one, or a later one if the page continued before the test looked.
  const auto& shown = page_.camera_status().picture->pixels;
  EXPECT_TRUE(std::any_of(footage.frames.begin(), footage.frames.end(), [&](const auto& frame) {
    return tracking::read_picture(footage.folder / frame.file).pixels == shown;
  }));
  EXPECT_NE(line().find("not calibrated"), std::string::npos) << line();
  EXPECT_FALSE(page_.camera_status().needle.has_value());
}

TEST_F(CameraPageTest, what_cannot_be_opened_is_one_sentence_and_the_page_goes_on) {
  start("/dev/video97");
  ASSERT_TRUE(wait([&] { return find<QPushButton>("camera.start")->text() == QStringLiteral("Start"); }));
  EXPECT_NE(line().find("/dev/video97"), std::string::npos) << line();
  const tracking::Footage footage = render("footage");
  find<QLineEdit>("camera.registration")->setText(QStringLiteral("/no/registration.json"));
  start(footage.folder);
  ASSERT_TRUE(wait([&] { return find<QPushButton>("camera.start")->text() == QStringLiteral("Start"); }));
  EXPECT_NE(line().find("/no/registration.json"), std::string::npos) << line();
  find<QLineEdit>("camera.registration")->clear();
  start(footage.folder);
  EXPECT_TRUE(wait([&] { return page_.camera_status().number > 0; })) << line();
  page_.leave();
  EXPECT_EQ(page_.camera_status().number, 0U);
}

}  // namespace
}  // namespace bodkin::app
