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

// The probe in the hand, without an attempt: the machine's screen and next to it the CT of the same plane. On the
// patient of the window, on one that is given, or on the built-in one.
class UltrasoundPage : public Page {
  Q_OBJECT
 public:
  // `folder`: where patients that are made here are kept.
  explicit UltrasoundPage(const std::filesystem::path& folder, QWidget* parent = nullptr);

  // Another patient, probe and machine; pictures are saved as `output`-1.png and so on (empty: in the person's folder
  // of pictures).
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
  void say(const QString& sentence, bool is_trouble);

  CaseModel cases_;
  station::UltrasoundRequest request_;
  std::filesystem::path output_;
  std::shared_ptr<const OpenCase> of_window_, patient_;
  bool is_own_ = false;  // the patient was given, and the window's is not shown
  std::unique_ptr<ProbeMachine> machine_;
  std::shared_ptr<const station::LivePicture> picture_;
  std::optional<Pose> shown_needle_;
  bool has_shown_ = false;
  UltrasoundView* view_;
  QLabel* title_;
  QLabel* line_;
};

}  // namespace bodkin::app
