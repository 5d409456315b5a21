// The curve of a patient with a deformable body, on the page of model settings: it is that of the real tick, and the
// body is prepared only when one of its inputs has changed.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "app/hand/aim.h"
#include "app/pages/models.h"
#include "app/pages/practise.h"
#include "patient/meshing/mesh_record.h"
#include "patient/prepared_body.h"
#include "study/profile.h"
#include "tests/app/window_fixture.h"
#include "tests/fem/lattice_body.h"

#include "io/case_folder.h"

namespace bodkin::app {
namespace {

class BodyCurve : public WindowFixture {
 protected:
  // The built-in patient with a deformable block of tissue around the path.
  void open_deformable() {
    ASSERT_TRUE(start());
    const std::filesystem::path from = window_->practice().patient()->folder;
    folder_ = from.parent_path() / "deforms";
    std::filesystem::remove_all(folder_);
    std::filesystem::copy(from, folder_, std::filesystem::copy_options::recursive);
    anatomy::CaseDescription description = io::read_case_description(folder_);
    anatomy::EmbeddedNeedleSettings settings;
    settings.body.fix_cut = false;
    settings.body.fix_beyond = 80.0;
    settings.body.stiffness_scale = 1.0;
    description.haptics.resistance = settings;
    io::write_case_description(description, folder_);
    const anatomy::NeedlePath path = *description.procedure.path;
    anatomy::TetrahedralMesh mesh = kuhn_box({9, 9, 13}, Vec3(70.0, 70.0, 110.0));
    Mat3 axes;
    axes.col(2) = path.direction();
    axes.col(0) = path.direction().unitOrthogonal();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    for (Vec3& node : mesh.nodes) node = path.entry + axes * (node - Vec3(35.0, 35.0, 0.0));
    std::fill(mesh.tissues.begin(), mesh.tissues.end(), anatomy::tissue::muscle);
    patient::write_case_mesh(mesh, {}, folder_);
    window_->practice().leave();
    window_->open(folder_);
    ASSERT_TRUE(wait(State::ready, 120)) << window_->practice().failure();
    window_->show_page(PageId::models);
    page_ = window_->findChild<ModelsPage*>();
    ASSERT_TRUE(wait([&] { return page_->model() != nullptr; }, 60));
  }
  std::string figures() { return find<QLabel>("models.figures")->text().toStdString(); }
  // N, the page's value for the solid line; waits for a curve other than that of `other`.
  double strongest(const std::string& other) {
    const auto is_there = [&] { return figures() != other && figures().find("strongest ") != std::string::npos; };
    EXPECT_TRUE(wait(is_there, 60)) << figures() << find<QLabel>("models.line")->text().toStdString();
    const std::size_t at = figures().find("strongest ");
    return at == std::string::npos ? 0.0 : std::stod(figures().substr(at + std::string("strongest ").size()));
  }
  // The same as in the command: read the case, prepare the body, insert the needle.
  double inserted(const std::function<void(anatomy::Case&)>& change) {
    anatomy::Case patient = io::load_case(folder_);
    change(patient);
    patient::prepare_body(patient, folder_, std::nullopt, {}, {});
    double most = 0.0;
    for (const auto& tick : study::insert_at_constant_speed(patient, {}).ticks)
      most = std::max(most, tick.output.resistance);
    return most;
  }
  void choose_step(const std::string& title) {
    const auto& steps = page_->model()->steps();
    const auto found =
        std::find_if(steps.begin(), steps.end(), [&](const auto& step) { return step.title == title; });
    ASSERT_NE(found, steps.end()) << title;
    find<QListWidget>("models.steps")->setCurrentRow(static_cast<int>(found - steps.begin()));
  }

  std::filesystem::path folder_;
  ModelsPage* page_ = nullptr;
};

TEST_F(BodyCurve, is_drawn_in_the_window_and_follows_the_numbers) {
  const QImage empty = find<ProfileChart>("models.chart")->grab().toImage();
  open_deformable();
  EXPECT_NEAR(strongest({}), inserted([](auto&) {}), 0.006) << "printed to a hundredth";
  EXPECT_NE(find<ProfileChart>("models.chart")->grab().toImage(), empty);

  // Friction acts with the same body.
  std::string before = figures();
  choose_step("Fat: friction");
  find<QDoubleSpinBox>("models.value")->setValue(0.2);
  EXPECT_NEAR(strongest(before), inserted([](anatomy::Case& patient) {
                std::vector<anatomy::TissueProperties> tissues = patient.library.tissues();
                for (auto& tissue : tissues)  // by the description that the case has
                  if (tissue.id == anatomy::tissue::fat)
                    tissue.physical.friction = 0.2 / (std::numbers::pi * patient.description.needle.outer_diameter);
                patient.library = anatomy::TissueLibrary(tissues);
              }),
              0.006);

  // A stiffer body is a new one.
  before = figures();
  choose_step("Fat: friction");
  key(Qt::Key_Z, Qt::ControlModifier);
  strongest(before);
  before = figures();
  choose_step("Model: stiffness scale");
  find<QDoubleSpinBox>("models.value")->setValue(2.0);
  EXPECT_NEAR(
      strongest(before), inserted([](anatomy::Case& patient) {
        std::get<anatomy::EmbeddedNeedleSettings>(patient.description.haptics.resistance).body.stiffness_scale = 2.0;
      }),
      0.006);
}

// For the same push, the slices' lattice agrees with the 3-D picture's skin points.
TEST_F(BodyCurve, slices_of_the_attempt_show_the_tissue_that_the_needle_pushes) {
  open_deformable();
  window_->show_page(PageId::practise);
  auto& view = window_->findChild<PractisePage*>()->view3d();
  ASSERT_TRUE(wait([&] { return view.is_ready() && window_->practice().state() == State::ready; }, 60));
  // The points of the 3-D picture are requested from the next attempt on.
  key(Qt::Key_A);
  ASSERT_TRUE(
      wait([&] { return window_->practice().state() == State::ready && frame().displacements.size() > 3; }, 60));
  EXPECT_EQ(frame().moved_tissue, nullptr);
  const anatomy::NeedlePath path = *frame().plan;
  double in_slices = 0.0, of_skin = 0.0;
  const auto connection = QObject::connect(&window_->clock(), &FrameClock::frame, window_.get(), [&] {
    if (frame().moved_tissue == nullptr || frame().displacements.empty()) return;
    const std::vector<Vec3> points = view.scene()->deformable_points();
    double nearest = 1e9;
    for (std::size_t i = 0; i < points.size() && 3 * i + 2 < frame().displacements.size(); ++i) {
      const double away = (points[i] - path.entry).norm();
      if (away >= nearest) continue;
      nearest = away;
      of_skin = Eigen::Map<const Eigen::Vector3f>(frame().displacements.data() + 3 * i)
                    .cast<double>()
                    .dot(path.direction());
    }
    in_slices = frame().moved_tissue->of(path.entry).dot(path.direction());
  });
  EXPECT_TRUE(wait(
      [&] {
        if (of_skin < 1.0) window_->practice().push(1.0, false);
        return of_skin >= 1.0;
      },
      60))
      << of_skin;
  EXPECT_TRUE(wait([&] { return std::abs(in_slices - of_skin) < 0.3 + 0.3 * of_skin; }, 60))
      << in_slices << " and " << of_skin;
  QObject::disconnect(connection);
}

// More than 15 mm from the requested place, other points are requested while the needle is in.
TEST_F(BodyCurve, the_picture_in_3d_goes_with_a_needle_that_enters_elsewhere) {
  open_deformable();
  window_->show_page(PageId::practise);
  auto& view = window_->findChild<PractisePage*>()->view3d();
  ASSERT_TRUE(wait([&] { return view.is_ready() && window_->practice().state() == State::ready; }, 60));
  key(Qt::Key_A);
  ASSERT_TRUE(
      wait([&] { return window_->practice().state() == State::ready && frame().displacements.size() > 3; }, 60));
  const anatomy::NeedlePath path = *frame().plan;
  const Vec3 inwards = path.direction();
  const Vec3 aside = (Vec3::UnitZ() - inwards.z() * inwards).normalized();
  const auto skin = skin_on_ray(window_->practice().patient()->patient.tissues,
                                path.entry + 22.0 * aside - 40.0 * inwards, inwards, 80.0);
  ASSERT_TRUE(skin.has_value());
  window_->practice().aim(*skin);
  window_->practice().put_down();
  ASSERT_TRUE(wait(State::touching, 60));
  double moved = 0.0, nearest = 1e9, in_slices = 0.0;
  const auto connection = QObject::connect(&window_->clock(), &FrameClock::frame, window_.get(), [&] {
    const std::vector<Vec3> points = view.deformable_points();
    if (frame().displacements.size() != 3 * points.size()) return;
    nearest = 1e9;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double away = (points[i] - skin->point).norm();
      if (away >= nearest) continue;
      nearest = away;
      moved = Eigen::Map<const Eigen::Vector3f>(frame().displacements.data() + 3 * i).cast<double>().dot(inwards);
    }
    if (frame().moved_tissue != nullptr) in_slices = frame().moved_tissue->of(skin->point).dot(inwards);
  });
  EXPECT_TRUE(wait(
      [&] {
        if (moved < 1.0) window_->practice().push(1.0, false);
        return moved >= 1.0;
      },
      60))
      << moved << " mm where points are " << nearest << " mm away";
  EXPECT_LT(nearest, 3.0);
  EXPECT_TRUE(wait([&] { return std::abs(in_slices - moved) < 0.3 + 0.3 * moved; }, 60))
      << in_slices << " and " << moved;
  QObject::disconnect(connection);
}

// The message is shown only during the preparation of the body.
TEST_F(BodyCurve, prepares_the_body_anew_only_when_it_is_another) {
  open_deformable();
  const std::shared_ptr<const OpenCase> patient = window_->practice().patient();
  ParameterModel model(patient);
  LiveProfile profile(patient);
  const auto is_prepared = [&] {
    bool prepared = false;
    profile.set(model.now());
    while (profile.is_busy()) prepared = prepared || profile.preparation().has_value();
    EXPECT_EQ(profile.curve()->trouble, "");
    return prepared;
  };
  const auto change = [&](const std::string& title, double value) {
    const auto found = std::find_if(model.steps().begin(), model.steps().end(),
                                    [&](const SettingStep& step) { return step.title == title; });
    ASSERT_NE(found, model.steps().end()) << title;
    EXPECT_EQ(model.set(static_cast<std::size_t>(found - model.steps().begin()), value), "");
  };
  EXPECT_TRUE(is_prepared());
  change("Fat: friction", 0.2);
  EXPECT_FALSE(is_prepared());
  change("Model: stiffness scale", 2.0);
  EXPECT_TRUE(is_prepared());
  model.choose_model("layered");
  EXPECT_FALSE(is_prepared());
}

TEST_F(BodyCurve, without_a_mesh_is_one_sentence) {
  auto patient = std::make_shared<OpenCase>();
  ASSERT_TRUE(start());
  *patient = *window_->practice().patient();
  patient->folder = "/nowhere";
  patient->patient.description.haptics.resistance = anatomy::EmbeddedNeedleSettings{};
  ParameterModel model(patient);
  LiveProfile profile(patient);
  profile.set(model.now());
  ASSERT_TRUE(wait([&] { return !profile.is_busy(); }, 60));
  ASSERT_NE(profile.curve(), nullptr);
  EXPECT_NE(profile.curve()->trouble.find("has no mesh"), std::string::npos) << profile.curve()->trouble;
  EXPECT_FALSE(profile.preparation().has_value());
}

}  // namespace
}  // namespace bodkin::app
