#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/frame_maker.h"
#include "app/models/recording.h"
#include "app/models/recording_job.h"
#include "app/page.h"
#include "app/pages/picture_series.h"
#include "views/force_chart.h"
#include "views/path_picture.h"
#include "views/slice_view.h"
#include "views/timeline.h"
#include "views/ultrasound_view.h"
#include "views/view3d.h"

class QHBoxLayout;
class QLabel;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace bodkin::app {

using namespace views;

class SessionList;
class VerdictPanel;

// A finished session, tick by tick: the needle and its path in 3-D and in slices, the force, the events, and the
// verdict. Seeking shows recorded values; nothing is recomputed. A second session can be overlaid in a second colour,
// shifted so that both touch the skin at the same time.
class ReviewPage : public Page {
  Q_OBJECT
 public:
  // `sessions`: the folder of the sessions in the list.
  explicit ReviewPage(std::filesystem::path sessions, QWidget* parent = nullptr);
  ~ReviewPage() override;

  // Reads a session and shows it when ready.
  void open(const std::filesystem::path& file);
  void compare_with(const std::filesystem::path& file);
  void stop_comparing();

  void set_case(std::shared_ptr<const OpenCase> patient) override;
  void enter() override;
  void leave() override;
  void advance(double clock) override;
  bool press(const QKeySequence& keys) override;

  void play(bool on);
  void set_speed(double times);
  void seek(double time);  // s of the session
  // By an image of 1/25 s, and to the next event.
  void step(int pictures);
  void step_event(int direction);
  // Writes the HTML page beside the session and opens it in the system's browser.
  void write_report(bool shown = true);
  // Numbered images of the whole session in a folder, or a video in a file; `rate`: images for each second of the
  // session.
  void save_series(const QString& target, bool is_video, double rate = 25.0);

  const std::shared_ptr<const Recording>& recording() const { return recording_; }
  const std::shared_ptr<const Recording>& other() const { return other_; }
  double time() const { return time_; }
  double speed() const { return speed_; }
  bool is_playing() const { return playing_; }
  bool is_busy() const { return job_ != nullptr || other_job_ != nullptr || series_ != nullptr; }
  const Frame& frame() const { return frame_; }

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void build();
  QWidget* make_player();
  QWidget* make_pictures();
  QWidget* make_transport();
  QWidget* make_buttons();
  QPushButton* button(const QString& text, const char* name, const QString& tip);
  void show_list();
  void take_jobs();
  void show_recording();
  void show_trails();
  void show_scan(Frame& frame);
  void arrange_slices(bool has_ultrasound);
  void show_lanes();
  void show_moment(double clock);
  void show_busy();
  void choose_file(bool second);
  void choose_target(bool is_video);
  double shift() const;  // s, shift of the second session
  QString status_words() const;

  std::filesystem::path folder_;
  QStackedWidget* stack_;
  SessionList* list_;
  VerdictPanel* verdict_ = nullptr;
  QWidget* pictures_ = nullptr;
  QStackedWidget* body_ = nullptr;  // 3-D, or the path without anatomy
  View3d* view3d_ = nullptr;
  PathPicture* path_ = nullptr;
  QWidget* slice_column_ = nullptr;
  QVBoxLayout* slice_rows_ = nullptr;
  QHBoxLayout* small_slices_ = nullptr;
  std::vector<SliceView*> slices_;
  UltrasoundView* ultrasound_ = nullptr;
  ForceChart* chart_ = nullptr;
  Timeline* timeline_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* clock_label_ = nullptr;
  QLabel* place_ = nullptr;
  QPushButton* play_ = nullptr;
  QPushButton* compare_ = nullptr;
  QPushButton* cancel_ = nullptr;
  std::vector<QPushButton*> speeds_;
  QLabel* busy_ = nullptr;

  std::shared_ptr<const OpenCase> at_hand_;
  std::unique_ptr<RecordingJob> job_, other_job_;
  std::shared_ptr<const Recording> recording_, other_;
  std::unique_ptr<PictureSeries> series_;
  FrameMaker differences_;  // finds the changes of a frame
  Frame frame_;
  std::vector<LeftNeedle> left_needles_;  // of frame_
  ForceChart::Cursor shown_cursor_;
  double time_ = 0.0, speed_ = 1.0, clock_ = 0.0;
  bool playing_ = false, curves_stale_ = false;
  std::optional<Vec3> crosshair_;    // empty: it follows the tip
  std::optional<std::size_t> scan_;  // the displayed sample of the ultrasound machine
};

}  // namespace bodkin::app
