#pragma once

#include <array>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/models/camera_watch.h"
#include "app/models/demo_footage.h"
#include "app/models/probe_machine.h"
#include "app/models/tracked_attempt.h"
#include "app/page.h"
#include "views/camera_picture.h"
#include "views/slice_view.h"
#include "views/ultrasound_view.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSlider;
class QTableWidget;

namespace bodkin::app {

using namespace views;

// Augmented reality: a camera image with the patient drawn into the mannequin, the detection quality of each body,
// slices at the tracked needle's tip, and the ultrasound image of the dummy probe.
class CameraPage : public Page {
  Q_OBJECT
 public:
  // `folder`: of rendered footage for users without a camera.
  explicit CameraPage(const std::filesystem::path& folder, QWidget* parent = nullptr);
  ~CameraPage() override;

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void enter() override;
  void leave() override;
  void advance(double clock) override;
  bool press(const QKeySequence& keys) override;

  // Starts the images of this source.
  void start();
  void stop();
  // Starts a session with the tracked needle, or ends it; it is then saved and judged.
  void record();
  bool is_recording() const { return attempt_ != nullptr; }
  // Of the last saved session; empty: none.
  const std::optional<AttemptResult>& result() const { return result_; }
  // Of the newest image.
  const CameraStatus& camera_status() const { return camera_status_; }
  const Frame& frame() const { return shown_; }
  // s from an image's arrival, before decoding, until painting; of the last thousand since start().
  const std::deque<double>& latencies() const { return latencies_; }
  void forget_latencies() { latencies_.clear(); }
  // Switches to the images of this folder, video or camera, with the files beside them.
  void show_source(const std::filesystem::path& source);

 private:
  enum File { camera, bodies, registration, files };

  QWidget* make_panel();
  QWidget* make_side();
  QLineEdit* make_file(const char* name, const QString& text, const QString& tip);
  void choose_source();
  void choose_file(File which);
  void start_demo();
  void use_source(const QString& source);
  tracking::AugmentedLook look() const;
  void send_look();
  std::shared_ptr<const imaging::TissueDisplacement> moved_tissue() const;
  void update_camera_status();
  void show_camera_status();
  void note_latency();
  void show_bodies();
  void show_line();
  void show_buttons();
  void follow_attempt();
  tracking::FootageFiles wanted_files() const;
  std::filesystem::path path_in(File which) const;

  std::filesystem::path folder_;
  std::shared_ptr<const OpenCase> patient_;
  std::unique_ptr<CameraWatch> watch_;
  std::unique_ptr<DemoFootage> demo_;  // during rendering
  std::unique_ptr<ProbeMachine> machine_;
  std::shared_ptr<const station::LiveImage> scan_;
  std::unique_ptr<TrackedAttempt> attempt_;  // during recording
  std::string reported_;                     // last message of the present or last attempt
  std::optional<AttemptResult> result_;
  CameraStatus camera_status_;
  std::deque<double> latencies_;
  Frame shown_;
  std::string failure_;       // why the last source failed
  std::string scan_failure_;  // why there is no ultrasound
  CameraPicture* picture_;
  CameraPicture* ct_ = nullptr;  // in the plane of the tracked probe
  UltrasoundView* ultrasound_;
  std::array<SliceView*, 2> slices_{};
  QComboBox* source_ = nullptr;
  std::array<QLineEdit*, files> paths_{};
  QComboBox* preset_ = nullptr;
  QSlider *oval_ = nullptr, *threshold_ = nullptr;
  QCheckBox *plan_ = nullptr, *needle_ = nullptr;
  QPushButton *start_ = nullptr, *pause_ = nullptr, *render_ = nullptr, *record_ = nullptr, *review_ = nullptr;
  QTableWidget* table_ = nullptr;
  QLabel* line_ = nullptr;
};

}  // namespace bodkin::app
