#pragma once

#include <filesystem>
#include <memory>

#include "app/models/case_model.h"
#include "app/models/probe_machine.h"
#include "app/page.h"
#include "station/ultrasound_request.h"
#include "views/ultrasound_view.h"

class QLabel;

namespace bodkin::app {

using namespace views;

// Ultrasound without an attempt: the machine's screen and next to it the CT of the same plane. On the patient of the
// window, on a given one, or on the built-in one.
class UltrasoundPage : public Page {
  Q_OBJECT
 public:
  // `folder`: of generated patients.
  explicit UltrasoundPage(const std::filesystem::path& folder, QWidget* parent = nullptr);

  // Another patient, probe and machine; images are saved as `output`-1.png and so on (empty: in the user's folder of
  // pictures).
  void scan(const std::filesystem::path& patient, const station::UltrasoundRequest& request,
            const std::filesystem::path& output);

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void enter() override;
  void leave() override;
  void advance(double clock) override;
  bool press(const QKeySequence& keys) override;

  const UltrasoundView& view() const { return *view_; }

 private:
  void begin(std::shared_ptr<const OpenCase> patient);
  void save_picture();
  void show_message(const QString& sentence, bool is_trouble);

  CaseModel cases_;
  station::UltrasoundRequest request_;
  std::filesystem::path output_;
  std::shared_ptr<const OpenCase> of_window_, patient_;
  bool is_own_ = false;  // on a given patient; the window's is not shown
  std::unique_ptr<ProbeMachine> machine_;
  std::shared_ptr<const station::LiveImage> picture_;
  std::optional<Pose> shown_needle_;
  bool has_shown_ = false;
  UltrasoundView* view_;
  QLabel* title_;
  QLabel* line_;
};

}  // namespace bodkin::app
