#include "app/spoken_language.h"

#include <QApplication>
#include <QLocale>
#include <QSettings>
#include <filesystem>

#include "views/language.h"
#include <fmt/format.h>

#include "core/error.h"
#include "io/resources.h"

namespace bodkin::app {

namespace {

constexpr const char* property_name = "language";
const QString english = QStringLiteral("en");
const QString setting = QStringLiteral("language");

// Empty if the files are not installed.
std::filesystem::path folder() {
  try {
    return io::shared_file("translations/window_de.ts").parent_path();
  } catch (const SystemError&) {
    return {};
  }
}

}  // namespace

QStringList languages() {
  return views::languages_in(folder());
}

QString usual_language() {
  const QStringList known = languages();
  QString chosen = QSettings().value(setting).toString();
  if (known.contains(chosen)) return chosen;
  const QString of_system = QLocale::system().name().section(QLatin1Char('_'), 0, 0);
  return known.contains(of_system) ? of_system : english;
}

void choose_language(const QString& code) {
  QSettings().setValue(setting, code);
}

void speak(const QString& code) {
  if (!languages().contains(code)) {
    throw InputError(fmt::format("there is no language {}, expected one of {}", code.toStdString(),
                                 languages().join(QStringLiteral(", ")).toStdString()));
  }
  for (auto* spoken : qApp->findChildren<QTranslator*>(property_name)) delete spoken;  // which takes it away
  if (code != english) {
    auto* language = new views::Language(code, folder());
    language->setParent(qApp);
    language->setObjectName(property_name);
    QApplication::installTranslator(language);
  }
  qApp->setProperty(property_name, code);
}

QString spoken_language() {
  const QVariant code = qApp->property(property_name);
  return code.isValid() ? code.toString() : english;
}

}  // namespace bodkin::app
