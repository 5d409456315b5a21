#pragma once

#include <QImage>
#include <cstdint>
#include <memory>
#include <optional>

#include "station/live_scan.h"
#include "views/slice_image.h"
#include "views/view.h"

namespace bodkin::views {

// The screen of an ultrasound machine and the hand on its probe: station::LiveScan with mouse and keys, with the CT
// of the same plane next to it if there is room. During an attempt the needle is the session's, and the attempt's
// keys (space, page up, page down, N) are left to the page.
class UltrasoundView : public View {
  Q_OBJECT
 public:
  explicit UltrasoundView(QWidget* parent = nullptr);

  // Without a scan (null case or no choice) the view says so.
  void set_case(std::shared_ptr<const OpenCase> patient) override;
  // The probe and machine of the next session, placed according to the choice. Throws InputError when there is no
  // such place on the patient. After set_case(). `needle`: in the patient from the start, if there is no attempt.
  void set_scan(const std::optional<station::UltrasoundChoice>& choice,
                const std::optional<imaging::NeedleInUltrasound>& needle = std::nullopt);
  // Shows a sentence below the image, until the next change of a setting.
  void show_message(const std::string& sentence);
  // Closes the list of keys; false: it was not open.
  bool close_help();
  void show_frame(const Frame& frame, const Changes& changes) override;

  // Null: there is none.
  const station::LiveScan* scan() const { return scan_ ? &*scan_ : nullptr; }
  // Whether the CT of the plane is shown next to the machine: the view is wide enough.
  bool shows_ct() const;
  // Allows or forbids it.
  void allow_ct(bool allowed);

 signals:
  // The probe's pose or the machine's settings have changed; the station follows by set_scan_setup().
  void scan_setup_changed(const bodkin::station::ScanSetup& setup);
  // The person wants to save the image.
  void save_requested(const QImage& picture);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  std::optional<station::ScreenKey> key_of(int key) const;
  bool press(QKeyEvent* event, bool down);
  void pass_on(const station::ScreenEvent& event);
  void report_setup();
  void count(const station::LiveImage& picture, double clock);
  QRectF machine_box() const;
  QRectF ct_box() const;

  void draw_machine(QPainter& painter);
  void draw_ct(QPainter& painter);
  void draw_sliders(QPainter& painter) const;
  void draw_help(QPainter& painter) const;
  void draw_words(QPainter& painter) const;

  std::shared_ptr<const OpenCase> patient_;
  std::optional<station::UltrasoundChoice> choice_;
  std::optional<station::LiveScan> scan_;
  SliceImage ct_;
  QImage machine_;  // composed
  bool stale_ = true;
  station::ScanSetup reported_;
  bool ct_allowed_ = true, in_attempt_ = false, has_needle_ = false;
  Vec3 needle_tip_ = Vec3::Zero(), needle_axis_ = Vec3::UnitY();
  std::optional<anatomy::NeedlePath> plan_;
  double clock_ = -1.0;  // s of the last frame; negative: none yet
  std::uint64_t made_ = 0, counted_ = 0;
  double counting_since_ = -1.0, rate_ = 0.0, left_out_ = 0.0;
};

}  // namespace bodkin::views
