// A CT-guided biopsy in the window: the attempt ends when the tip touches the lesion.
#include <QApplication>
#include <QLabel>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>

#include "app/main_window.h"
#include "app/models/data_folder.h"
#include <gtest/gtest.h>

#include "io/case_folder.h"
#include "io/digest.h"
#include "io/nrrd_writer.h"

namespace bodkin::app {
namespace {

// The built-in patient with a lesion of 6 mm radius in the muscle, 22 mm deep beside the planned path.
std::filesystem::path patient_with_lesion(const std::filesystem::path& from) {
  const std::filesystem::path folder = from.parent_path() / "lesion";
  std::filesystem::remove_all(folder);
  std::filesystem::copy(from, folder, std::filesystem::copy_options::recursive);
  anatomy::Case patient = io::load_case(folder);
  anatomy::NeedlePath path = *patient.description.procedure.path;
  path.entry.x() += 18.0;  // off the ligaments
  path.target = path.entry + 26.0 * path.direction();
  path.target.x() = path.entry.x();
  const anatomy::Grid& grid = patient.tissues.grid;
  std::size_t voxel = 0;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i, ++voxel) {
        if ((grid.to_patient(Vec3(i, j, k)) - path.target).norm() < 6.0)
          patient.tissues.voxels[voxel] = anatomy::tissue::mass;
      }
    }
  }
  io::write_nrrd(patient.tissues, folder / patient.description.tissues_file);
  patient.description.tissues_digest = io::volume_digest(patient.tissues);
  patient.description.procedure.name = "ct_guided_biopsy";
  patient.description.procedure.target_tissue = "mass";
  patient.description.procedure.path = path;
  io::write_case_description(patient.description, folder);
  return folder;
}

TEST(Biopsy, ends_when_the_tip_touches_the_lesion_with_a_sentence) {
  MainWindow window(data_folder());
  window.resize(1280, 720);
  window.show();
  window.run(Command::begin);
  Practice& practice = window.practice();
  ASSERT_TRUE(QTest::qWaitFor([&] { return practice.state() == State::ready; }, 180000)) << practice.failure();
  const std::filesystem::path folder = patient_with_lesion(practice.patient()->folder);
  practice.leave();
  window.open(folder);
  ASSERT_TRUE(QTest::qWaitFor([&] { return practice.state() == State::ready; }, 120000)) << practice.failure();
  double deepest = 0.0;
  auto* const slice = window.findChild<QWidget*>(QStringLiteral("practise.slice.sagittal"));
  QObject::connect(&window.clock(), &FrameClock::frame, &window,
                   [&] { deepest = std::max(deepest, practice.frame().depth); });
  static_cast<void>(QTest::qWaitFor(
      [&] {
        const QPoint at = slice->rect().center();
        QWheelEvent event(at, slice->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                          false);
        QApplication::sendEvent(slice, &event);
        return practice.state() == State::ended;
      },
      60000));
  ASSERT_EQ(practice.state(), State::ended) << deepest << " mm, " << practice.frame().place;
  EXPECT_NE(practice.completion().find("touched the lesion"), std::string::npos) << practice.completion();
  // The lesion begins 20 mm deep.
  EXPECT_GT(deepest, 17.0);
  EXPECT_LT(deepest, 27.0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return practice.result().has_value(); }, 60000));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        const QList<QLabel*> labels = window.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
          return label->isVisible() && label->text().contains(QStringLiteral("touched the lesion"));
        });
      },
      60000));
  practice.leave();
}

}  // namespace
}  // namespace bodkin::app
