#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/models/device_finder.h"
#include "app/models/device_work.h"
#include "app/page.h"

class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;

namespace bodkin::views {
class WorkspacePicture;
}

namespace bodkin::app {

using namespace views;

// The devices that can hold the needle: which are available, what the others lack, a check without force,
// step-by-step calibration, and the choice of the device for practice.
class DevicesPage : public Page {
  Q_OBJECT
 public:
  explicit DevicesPage(QWidget* parent = nullptr);
  ~DevicesPage() override;

  void enter() override;
  void leave() override;
  void advance(double clock) override;

  // The device in use, as Practice names it: "driver:identity"; empty: the mouse.
  void set_used(const QString& device);
  void look_for_devices();
  void select(int row);
  const std::vector<DeviceRow>& rows() const { return rows_; }
  bool is_looking() const { return finder_.is_busy(); }
  DeviceWork& work() { return work_; }

 signals:
  // Empty: the mouse.
  void use_requested(const QString& driver, const QString& identity);

 private:
  QWidget* make_side();
  QWidget* make_detail();
  QPushButton* button(const QString& text, const char* name, const QString& tip);
  void show_rows();
  void show_row();
  void show_status();
  void show_profile();
  void begin(bool calibration);
  const DeviceRow* selected() const;

  DeviceFinder finder_;
  DeviceWork work_;
  std::vector<DeviceRow> rows_;
  std::size_t version_ = 0;
  int worked_on_ = -1;  // the row
  bool has_looked_ = false, was_busy_ = false;
  QString used_;

  QListWidget* list_ = nullptr;
  QLabel* looking_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* state_ = nullptr;
  QLabel* sentence_ = nullptr;
  QLabel* steps_ = nullptr;
  QLabel* task_ = nullptr;
  QLabel* verdict_ = nullptr;
  QLabel* profile_ = nullptr;
  WorkspacePicture* picture_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton* use_ = nullptr;
  QPushButton* check_ = nullptr;
  QPushButton* calibrate_ = nullptr;
  QPushButton* go_on_ = nullptr;
  QPushButton* cancel_ = nullptr;
};

}  // namespace bodkin::app
