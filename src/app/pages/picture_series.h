#pragma once

#include <QObject>
#include <QPixmap>
#include <QProcess>
#include <QString>
#include <functional>
#include <memory>

namespace bodkin::app {

// Writes a series of frames as numbered images, or as a video through ffmpeg, one image between two of the window's
// frames, so that the window stays responsive and can cancel.
class PictureSeries : public QObject {
  Q_OBJECT
 public:
  struct Output {
    QString target;  // a folder for images, a file for a video
    bool is_video = false;
    int count = 0;       // images
    double rate = 25.0;  // of the video, images a second
  };
  // Shows the frame of an image, 0 to count - 1, and returns the visible content.
  using Look = std::function<QPixmap(int index)>;

  PictureSeries(Output output, Look look, QObject* parent);
  ~PictureSeries() override;

  // The path of ffmpeg; empty: it is not installed.
  static QString encoder();

  // False, with finished() emitted, if it cannot begin.
  bool start();
  // Writes one more image; to be called once a frame.
  void advance();
  void cancel();
  bool is_running() const { return running_; }
  double fraction() const { return output_.count == 0 ? 1.0 : static_cast<double>(next_) / output_.count; }

 signals:
  // `trouble`: cause of a failure, one sentence; empty: all is written.
  void finished(const QString& trouble);

 private:
  void end(const QString& trouble);

  Output output_;
  Look look_;
  std::unique_ptr<QProcess> process_;
  int next_ = 0;
  bool running_ = false, cancelled_ = false;
};

}  // namespace bodkin::app
