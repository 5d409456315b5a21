#include "app/sounds.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QSettings>
#include <QStandardPaths>
#include <vector>

namespace bodkin::app {

Sounds::Sounds() : on_(QSettings().value(QStringLiteral("sound"), true).toBool()) {
  for (const char* const player : {"pw-play", "paplay", "aplay"}) {
    player_ = QStandardPaths::findExecutable(QLatin1String(player));
    if (!player_.isEmpty()) break;
  }
}

void Sounds::toggle() {
  on_ = !on_;
  QSettings().setValue(QStringLiteral("sound"), on_);
}

void Sounds::follow(const Frame& frame) {
  const std::optional<Sound> sound = cues_.cue_for(frame);
  if (!sound || !allowed_) return;
  ++heard_;
  if (on_ && can_play()) play(*sound);
}

void Sounds::play(Sound sound) {
  QString& file = files_[static_cast<std::size_t>(sound)];
  if (file.isEmpty()) {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::CacheLocation);
    QDir().mkpath(folder);
    const QString name = QStringLiteral("%1/sound-%2.wav").arg(folder).arg(static_cast<int>(sound));
    const std::vector<char> bytes = wav_of(sound);
    QFile written(name);
    if (!written.open(QIODevice::WriteOnly)) return;
    if (written.write(bytes.data(), static_cast<qint64>(bytes.size())) != static_cast<qint64>(bytes.size())) return;
    file = name;
  }
  QProcess quiet;
  quiet.setProgram(player_);
  quiet.setArguments({file});
  quiet.setStandardOutputFile(QProcess::nullDevice());
  quiet.setStandardErrorFile(QProcess::nullDevice());
  quiet.startDetached();
}

}  // namespace bodkin::app
