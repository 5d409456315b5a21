#pragma once

#include <QObject>
#include <QPixmap>
#include <QProcess>
#include <QString>
#include <functional>
#include <memory>

namespace bodkin::app {

// Writes a course of moments as numbered pictures, or as a video through ffmpeg, picture by picture between the
// window's frames, so that the window stays alive and can cancel.
class PictureSeries : public QObject {
  Q_OBJECT
 public:
  struct Order {
    QString target;  // a folder for pictures, a file for a video
    bool is_video = false;
    int count = 0;       // pictures
    double rate = 25.0;  // of the video, pictures a second
  };
  // Shows the moment of a picture, 0 to count - 1, and gives what is seen then.
  using Look = std::function<QPixmap(int index)>;

  PictureSeries(Order order, Look look, QObject* parent);
  ~PictureSeries() override;

  // Where ffmpeg is; empty: it is not installed.
  static QString encoder();

  // False, with finished() emitted, when it cannot begin.
  bool start();
  // One more picture; to be called once a frame.
  void advance();
  void cancel();
  bool is_running() const { return running_; }
  double fraction() const { return order_.count == 0 ? 1.0 : static_cast<double>(next_) / order_.count; }

 signals:
  // `trouble`: what went wrong, one sentence; empty: all is written.
  void finished(const QString& trouble);

 private:
  void end(const QString& trouble);

  Order order_;
  Look look_;
  std::unique_ptr<QProcess> process_;
  int next_ = 0;
  bool running_ = false, cancelled_ = false;
};

}  // namespace bodkin::app
