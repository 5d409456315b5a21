// The window is painted into memory: no display is needed. Its files go into a separate folder, not the user's.
#include <QApplication>
#include <QStandardPaths>
#include <filesystem>
#include <memory>

#include <gtest/gtest.h>
#include <unistd.h>

namespace {

class ApplicationWithoutDisplay : public testing::Environment {
 public:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("bodkin-app-test-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    qputenv("QT_QPA_PLATFORM", "offscreen");
    for (const char* variable : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
      qputenv(variable, folder_.string().c_str());
    qputenv("BODKIN_IMAGES_WORKER", BODKIN_BUILD "/bin/bodkin-images");
    qputenv("BODKIN_PROGRAM", BODKIN_BUILD "/bin/bodkin");  // which asks drivers what they find
    application_ = std::make_unique<QApplication>(arguments_, names_);
    QApplication::setOrganizationName(QStringLiteral("bodkin"));
    QApplication::setApplicationName(QStringLiteral("app-tests"));
  }
  void TearDown() override {
    application_.reset();
    std::filesystem::remove_all(folder_);
  }

 private:
  std::filesystem::path folder_;
  int arguments_ = 1;
  char name_[10] = "app_tests";
  char* names_[2] = {name_, nullptr};
  std::unique_ptr<QApplication> application_;
};

testing::Environment* const without_display =
    testing::AddGlobalTestEnvironment(new ApplicationWithoutDisplay);  // owned by GoogleTest

}  // namespace
