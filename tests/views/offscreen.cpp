// The views are painted into memory: no display needed.
#include <QApplication>
#include <memory>

#include "views/theme.h"
#include <gtest/gtest.h>

namespace {

class Offscreen : public testing::Environment {
 public:
  void SetUp() override {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    application_ = std::make_unique<QApplication>(arguments_, names_);
    application_->setStyleSheet(bodkin::views::Theme::now().style_sheet());
  }
  void TearDown() override { application_.reset(); }

 private:
  int arguments_ = 1;
  char name_[12] = "views_tests";
  char* names_[2] = {name_, nullptr};
  std::unique_ptr<QApplication> application_;
};

testing::Environment* const offscreen = testing::AddGlobalTestEnvironment(new Offscreen);  // owned by GoogleTest

}  // namespace
