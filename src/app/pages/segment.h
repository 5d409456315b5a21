#pragma once

#include <QStringList>
#include <array>
#include <memory>
#include <vector>

#include "app/models/segment_model.h"
#include "app/page.h"
#include "views/segment_relief.h"
#include "views/segment_slice.h"

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace bodkin::app {

using namespace views;

// The function of the left button on the page.
enum class SegmentTool : std::uint8_t { look, paint, erase, grow };

// Manual editing of a patient's structures: slices with the structures over them, the structure in 3-D, tools and
// filters at the side. Arranges and connects widgets; the logic is in SegmentModel.
class SegmentPage : public Page {
  Q_OBJECT
 public:
  explicit SegmentPage(QWidget* parent = nullptr);
  ~SegmentPage() override;

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void enter() override;
  void leave() override;
  void advance(double clock) override;
  bool press(const QKeySequence& keys) override;

  SegmentModel* model() { return model_.get(); }              // null: no patient, or one without a CT
  SegmentSlice& slice(std::size_t i) { return *slices_[i]; }  // axial, sagittal, coronal
  SegmentRelief& relief() { return *relief_; }
  void set_crosshair(const Vec3& point);

 private:
  QWidget* make_panel();
  void make_tools(QVBoxLayout* rows);
  void make_filters(QVBoxLayout* rows);
  void make_foot(QVBoxLayout* rows);
  void connect_slice(SegmentSlice* slice);
  QPushButton* button(const char* name, const QString& text, const QString& tip);
  void choose_tool(SegmentTool tool);
  void stroke(const Vec3& from, const Vec3& to, int normal);
  void begin_stroke(const Vec3& point, int normal);
  void end_stroke();
  void run_filter(patient::SegmentFilter::Kind kind);
  void add_structure();
  void rename_structure();
  void remove_structure();
  void show_table();
  void show_active();
  void show_labels(bool also_relief);
  void show_status();
  void show_message(const QString& sentence, bool is_trouble);
  patient::Overwriting overwriting() const;

  std::shared_ptr<const OpenCase> patient_, shown_;
  std::unique_ptr<SegmentModel> model_;
  std::array<SegmentSlice*, 3> slices_{};
  SegmentRelief* relief_;
  QListWidget* list_ = nullptr;
  QLineEdit* name_ = nullptr;
  QComboBox* tissue_ = nullptr;
  QButtonGroup* tools_ = nullptr;
  QDoubleSpinBox *radius_ = nullptr, *reach_ = nullptr, *smoothness_ = nullptr;
  QSpinBox *low_ = nullptr, *high_ = nullptr;
  QCheckBox *critical_ = nullptr, *ball_ = nullptr, *keep_ = nullptr, *covered_ = nullptr;
  QPushButton *undo_ = nullptr, *redo_ = nullptr, *save_ = nullptr, *cancel_ = nullptr;
  QPushButton *rename_ = nullptr, *remove_ = nullptr;
  std::vector<QPushButton*> filters_;
  QProgressBar* progress_ = nullptr;
  QLabel *message_ = nullptr, *amount_ = nullptr;
  SegmentTool tool_ = SegmentTool::look;
  Vec3 crosshair_ = Vec3::Zero();
  std::optional<Vec3> stroke_from_;
  int stroke_normal_ = 2;
  std::vector<std::uint32_t> colours_;
};

}  // namespace bodkin::app
