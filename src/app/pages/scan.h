#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/models/scan_model.h"
#include "app/page.h"
#include "views/frame.h"
#include "views/scan_viewer.h"
#include "views/scout_view.h"

class QButtonGroup;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace bodkin::app {

using namespace views;

// The console of a CT scanner: scout with the range, protocol, slices that arrive one by one, the previous scans. A
// scan shows the needle at its present position.
class ScanPage : public Page {
  Q_OBJECT
 public:
  // `frame`: the newest frame of the practice.
  explicit ScanPage(std::function<const Frame&()> frame, QWidget* parent = nullptr);

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void enter() override;
  void advance(double clock) override;
  bool press(const QKeySequence& keys) override;

  const std::vector<std::shared_ptr<imaging::CtScan>>& scans() const { return scans_; }
  const imaging::ScanProtocol& protocol() const { return protocol_; }
  bool is_scanning() const { return scanner_.running(); }

 private:
  QWidget* make_left();
  QWidget* make_right();
  void make_protocol(QVBoxLayout* rows);
  void start_or_cancel();
  void show_scan(std::size_t index);
  void add_to_list();
  void show_protocol();
  void use_target();
  void show_message(const QString& sentence, bool trouble);

  std::function<const Frame&()> frame_;
  std::shared_ptr<const OpenCase> patient_;
  imaging::ScanProtocol protocol_;
  Scanner scanner_;
  std::vector<std::shared_ptr<imaging::CtScan>> scans_;
  std::size_t shown_ = 0;
  ScoutWidget* scout_;
  ScanViewer* viewer_;
  QDoubleSpinBox *thickness_ = nullptr, *spacing_ = nullptr;
  QButtonGroup* kernels_ = nullptr;
  QButtonGroup* list_buttons_ = nullptr;
  QLabel *range_ = nullptr, *message_ = nullptr;
  QPushButton *scan_ = nullptr, *cine_ = nullptr, *target_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QHBoxLayout* list_ = nullptr;
};

}  // namespace bodkin::app
