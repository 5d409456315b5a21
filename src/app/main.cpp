// bodkin-app: the trainer in a window.
#include <QApplication>
#include <QCommandLineParser>
#include <iostream>
#include <optional>

#include "app/benchmark.h"
#include "app/close_on_signal.h"
#include "app/main_window.h"
#include "app/models/data_folder.h"
#include "app/models/late_force.h"
#include "app/script.h"
#include "app/spoken_language.h"

namespace {

int run_application() {
  QApplication::setQuitOnLastWindowClosed(true);
  return QApplication::exec();
}

// Executes the command-line options; returns the exit code.
int open_window(const QCommandLineParser& options) {
  bodkin::app::MainWindow window(bodkin::app::data_folder());
  if (options.isSet(QStringLiteral("size"))) window.resize(bodkin::app::parse_size(options.value("size")));
  window.show();
  const QStringList given = options.positionalArguments();
  const std::filesystem::path patient = given.isEmpty() ? std::string() : given.front().toStdString();
  if (options.isSet(QStringLiteral("benchmark"))) {
    const double seconds = 5.0;  // for each row
    std::cout << bodkin::app::benchmark_table(bodkin::app::measure_window(window, seconds), window);
    return 0;
  }
  if (options.isSet(QStringLiteral("attempt"))) {
    window.perform(patient, bodkin::app::read_attempt_options(options.value("attempt").toStdString()));
  } else if (options.isSet(QStringLiteral("scan"))) {
    window.scan(patient, bodkin::station::ultrasound_request(options.value("scan").toStdString()),
                options.value("output").toStdString());
  } else if (options.isSet(QStringLiteral("connect"))) {
    window.follow(options.value("connect").toStdString(), patient);
  } else if (!patient.empty()) {
    window.open(patient);
  }
  if (!options.isSet(QStringLiteral("script"))) return run_application();
  bodkin::app::Script script(window, options.value("shots"));
  return script.run(options.value("script")) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("bodkin"));
  QApplication::setApplicationName(QStringLiteral("bodkin-app"));
  QApplication::setApplicationVersion(QStringLiteral(BODKIN_VERSION));
  bodkin::app::speak(bodkin::app::usual_language());
  QCommandLineParser options;
  options.setApplicationDescription(
      QApplication::translate("main", "Bodkin: put needles into patients, and feel it."));
  options.addHelpOption();
  options.addVersionOption();
  options.addPositionalArgument(QStringLiteral("CASE"),
                                QApplication::translate("main", "A case, a DICOM folder or an image to begin with"));
  options.addOptions(
      {{QStringLiteral("script"), QApplication::translate("main", "Run the commands in FILE, then quit"),
        QStringLiteral("FILE")},
       {QStringLiteral("shots"), QApplication::translate("main", "Folder for the script's screenshots"),
        QStringLiteral("DIR"), QStringLiteral(".")},
       {QStringLiteral("size"), QApplication::translate("main", "Size of the window, 1280x720"),
        QStringLiteral("WxH")},
       {QStringLiteral("language"), QApplication::translate("main", "Language of the window, such as de"),
        QStringLiteral("CODE")},
       {QStringLiteral("allow-late"),
        QApplication::translate("main", "Allow the full force, although the system may delay the servo")},
       {QStringLiteral("benchmark"),
        QApplication::translate("main", "Measure the window's speed, print it, then quit")},
       {QStringLiteral("attempt"),
        QApplication::translate("main", "Options of the attempt, as bodkin perform passes them"),
        QStringLiteral("JSON")},
       {QStringLiteral("connect"),
        QApplication::translate("main", "Show the session of the bodkin serve at HOST or HOST:PORT"),
        QStringLiteral("HOST")},
       {QStringLiteral("scan"),
        QApplication::translate("main", "Settings of the live probe, as bodkin ultrasound --live passes them"),
        QStringLiteral("JSON")},
       {QStringLiteral("output"), QApplication::translate("main", "Beginning of the names of saved images"),
        QStringLiteral("NAME")}});
  options.process(application);
  try {
    if (options.isSet(QStringLiteral("language"))) bodkin::app::speak(options.value("language"));
    if (options.isSet(QStringLiteral("allow-late"))) bodkin::app::allow_late_force();
    // Scripts and benchmarks run without a user, and end on request.
    std::optional<bodkin::app::CloseOnSignal> closing;
    if (!options.isSet(QStringLiteral("script")) && !options.isSet(QStringLiteral("benchmark"))) closing.emplace();
    int result = open_window(options);
    while (result == bodkin::app::retranslate) {
      bodkin::app::speak(bodkin::app::usual_language());
      bodkin::app::MainWindow window(bodkin::app::data_folder());
      window.show();
      result = run_application();
    }
    return result;
  } catch (const std::exception& error) {
    std::cerr << "bodkin-app: " << error.what() << '\n';
    return 2;
  }
}
