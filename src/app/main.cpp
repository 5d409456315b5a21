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

// What the options ask for; the exit code.
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
      {{QStringLiteral("script"), QApplication::translate("main", "Do what FILE says, and leave"),
        QStringLiteral("FILE")},
       {QStringLiteral("shots"), QApplication::translate("main", "Folder for the script's pictures"),
        QStringLiteral("DIR"), QStringLiteral(".")},
       {QStringLiteral("size"), QApplication::translate("main", "Size of the window, 1280x720"),
        QStringLiteral("WxH")},
       {QStringLiteral("language"), QApplication::translate("main", "Language of the window, such as de"),
        QStringLiteral("CODE")},
       {QStringLiteral("allow-late"),
        QApplication::translate("main", "Give the whole force although the system may hold up the servo")},
       {QStringLiteral("benchmark"),
        QApplication::translate("main", "Measure the window's speed, print it, and leave")},
       {QStringLiteral("attempt"), QApplication::translate("main", "How to perform, as bodkin perform says it"),
        QStringLiteral("JSON")},
       {QStringLiteral("connect"),
        QApplication::translate("main", "Show the session of bodkin serve at this machine, HOST or HOST:PORT"),
        QStringLiteral("HOST")},
       {QStringLiteral("scan"),
        QApplication::translate("main", "The probe in the hand, as bodkin ultrasound --live says it"),
        QStringLiteral("JSON")},
       {QStringLiteral("output"), QApplication::translate("main", "Beginning of the pictures' names"),
        QStringLiteral("NAME")}});
  options.process(application);
  try {
    if (options.isSet(QStringLiteral("language"))) bodkin::app::speak(options.value("language"));
    if (options.isSet(QStringLiteral("allow-late"))) bodkin::app::allow_late_force();
    // A script and a benchmark hold nobody's hand, and end when they are told to.
    std::optional<bodkin::app::CloseOnSignal> closing;
    if (!options.isSet(QStringLiteral("script")) && !options.isSet(QStringLiteral("benchmark"))) closing.emplace();
    int result = open_window(options);
    while (result == bodkin::app::speak_anew) {
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
