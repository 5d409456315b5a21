#include "app/pages/picture_series.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QStandardPaths>
#include <utility>

namespace bodkin::app {

namespace {

constexpr int patience = 20000;                    // ms for the encoder to finish
constexpr qint64 most_waiting = qint64{64} << 20;  // bytes that the encoder has not taken yet

}  // namespace

PictureSeries::PictureSeries(Output output, Look look, QObject* parent)
    : QObject(parent), output_(std::move(output)), look_(std::move(look)) {}

PictureSeries::~PictureSeries() {
  if (running_) cancel();
}

QString PictureSeries::encoder() {
  return QStandardPaths::findExecutable(QStringLiteral("ffmpeg"));
}

bool PictureSeries::start() {
  running_ = true;
  if (!output_.is_video) {
    if (QDir().mkpath(output_.target)) return true;
    end(tr("%1 cannot be made: choose another folder.").arg(output_.target));
    return false;
  }
  if (encoder().isEmpty()) {
    end(tr(
        "A video needs ffmpeg, which is not installed: sudo apt-get install ffmpeg. Pictures can be saved without."));
    return false;
  }
  process_ = std::make_unique<QProcess>();
  process_->setStandardOutputFile(QProcess::nullDevice());
  // Encoders want an even width and height.
  process_->start(encoder(),
                  {QStringLiteral("-y"), QStringLiteral("-loglevel"), QStringLiteral("error"), QStringLiteral("-f"),
                   QStringLiteral("image2pipe"), QStringLiteral("-framerate"), QString::number(output_.rate),
                   QStringLiteral("-c:v"), QStringLiteral("bmp"), QStringLiteral("-i"), QStringLiteral("-"),
                   QStringLiteral("-vf"), QStringLiteral("crop=trunc(iw/2)*2:trunc(ih/2)*2"),
                   QStringLiteral("-pix_fmt"), QStringLiteral("yuv420p"), output_.target});
  if (process_->waitForStarted()) return true;
  end(tr("ffmpeg cannot be started: %1.").arg(process_->errorString()));
  return false;
}

void PictureSeries::advance() {
  if (!running_) return;
  if (process_ != nullptr && process_->state() != QProcess::Running) {
    const QString why = QString::fromUtf8(process_->readAllStandardError()).trimmed();
    return end(tr("The video could not be written: %1").arg(why.isEmpty() ? tr("ffmpeg ended early.") : why));
  }
  if (process_ != nullptr && process_->bytesToWrite() > most_waiting) return;
  if (next_ < output_.count) {
    const QPixmap picture = look_(next_);
    if (process_ != nullptr) {
      picture.toImage().convertToFormat(QImage::Format_RGB32).save(process_.get(), "BMP");
    } else {
      const QString file =
          QDir(output_.target).filePath(QStringLiteral("%1.png").arg(next_, 5, 10, QLatin1Char('0')));
      if (!picture.save(file))
        return end(tr("%1 cannot be written: free space there, or choose another folder.").arg(file));
    }
    ++next_;
    return;
  }
  if (process_ == nullptr) return end({});
  process_->closeWriteChannel();
  const bool done = process_->waitForFinished(patience) && process_->exitCode() == 0;
  const QString why = QString::fromUtf8(process_->readAllStandardError()).trimmed();
  end(done ? QString() : tr("The video could not be written: %1").arg(why));
}

void PictureSeries::cancel() {
  cancelled_ = true;
  end(tr("Cancelled."));
}

void PictureSeries::end(const QString& trouble) {
  if (!std::exchange(running_, false)) return;
  if (process_ != nullptr && process_->state() != QProcess::NotRunning) {
    process_->kill();
    process_->waitForFinished(patience);
  }
  // Half a video is useless; images already written are not.
  if (output_.is_video && !trouble.isEmpty() && process_ != nullptr) QFile::remove(output_.target);
  process_.reset();
  emit finished(trouble);
}

}  // namespace bodkin::app
