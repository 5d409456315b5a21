#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "app/models/atlas_model.h"
#include "app/models/device_work.h"
#include "app/page.h"
#include "patient/acupuncture/collaterals.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace bodkin::views {
class AtlasView;
}

namespace bodkin::app {

using namespace views;

// The acupuncture atlas: the body, a search, a card for the chosen point, the transition to needling it, and the game
// of finding points.
class AtlasPage : public Page {
  Q_OBJECT
 public:
  explicit AtlasPage(const std::filesystem::path& folder, QWidget* parent = nullptr);

  void enter() override;
  void leave() override;
  void advance(double clock) override;
  bool press(const QKeySequence& keys) override;
  // The needle device for touching points; empty: the mouse pointer.
  void set_device(const std::optional<station::DeviceChoice>& device);

 signals:
  // Needle a point found on the body: the case around it, and the place indicated by the student, LPS mm.
  void needling_requested(const QString& folder, const bodkin::Vec3& place);

 private:
  QWidget* make_side();
  bool needles_found(const Vec3& place);
  void list_points();
  QString collateral_words(const patient::Collateral& collateral) const;
  void choose(const patient::AtlasPoint* point, bool look);
  void take(const Vec3& place, const patient::AtlasPoint* point);
  void ask(bool same);
  void stop_asking();
  void touch_with_device(bool on);
  void follow_device();
  void show_score();

  AtlasModel model_;
  PointQuiz quiz_;
  AtlasView* view_;
  QLineEdit* search_ = nullptr;
  QListWidget* list_ = nullptr;
  QLabel* card_ = nullptr;
  QLabel* score_ = nullptr;
  QPushButton *needle_ = nullptr, *find_ = nullptr, *again_ = nullptr, *stop_ = nullptr, *both_ = nullptr,
              *touch_ = nullptr;
  const patient::AtlasPoint* chosen_ = nullptr;
  std::shared_ptr<const patient::Atlas> atlas_;
  std::optional<station::DeviceChoice> device_;
  DeviceWork hand_;  // reads the device during touching
  bool touches_ = false;
  bool opens_ = false;            // open the device as soon as the last one is closed
  std::optional<Vec3> found_at_;  // needle it as soon as its case is ready
  QString making_;                // code of the point whose case is being created; empty: none
  bool listed_ = false;
};

}  // namespace bodkin::app
