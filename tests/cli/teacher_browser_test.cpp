#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

// The teacher's page as a real browser shows it: Chromium without a window (Debian's chromium-headless-shell). Its
// PDF shows what a person would see, without hidden or clipped text.

namespace bodkin_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

bool is_installed(const std::string& program) {
  return std::system(("command -v " + program + " > /dev/null 2>&1").c_str()) == 0;
}

class TeacherInBrowser : public PatientCommand {
 protected:
  static void SetUpTestSuite() {
    PatientCommand::SetUpTestSuite();
    setenv("XDG_DATA_HOME", (folder_ / "data").c_str(), 1);
    if (made_.exit_code != 0) return;
    bodkin("-q run patient --operator expert --seed 4 --output good.bodkin");
    bodkin("-q run patient --operator novice --seed 2 --output other.bodkin");
    bodkin("-q results add good.bodkin --trainee trainee-07 --store results.sqlite");
    bodkin("-q results add other.bodkin --trainee trainee-08 --store results.sqlite");
  }
  static void TearDownTestSuite() {
    unsetenv("XDG_DATA_HOME");
    PatientCommand::TearDownTestSuite();
  }

  void SetUp() override {
    for (const char* program : {"chromium-headless-shell", "pdftotext"})
      if (!is_installed(program)) GTEST_SKIP() << program << " is not installed here";
    PatientCommand::SetUp();
    const std::string command = "cd '" + folder_.string() +
                                "' && echo $$ && exec '" BODKIN_BUILD
                                "/bin/bodkin' -q teacher --port 0 --store results.sqlite";
    server_ = popen(command.c_str(), "r");
    std::array<char, 512> line{};
    ASSERT_NE(fgets(line.data(), line.size(), server_), nullptr);
    process_ = std::stoi(line.data());
    ASSERT_NE(fgets(line.data(), line.size(), server_), nullptr);
    const std::string said = line.data();
    url_ = said.substr(0, said.find(' '));
    while (!url_.empty() && (url_.back() == '/' || url_.back() == '\n')) url_.pop_back();
  }
  void TearDown() override {
    if (process_ > 0) kill(process_, SIGTERM);
    if (server_ != nullptr) pclose(server_);
  }

  std::string browse(const std::string& what, const std::string& path) const {
    const std::string line = "cd '" + folder_.string() +
                             "' && HOME=\"$PWD\" timeout 120 chromium-headless-shell --no-sandbox --disable-gpu "
                             "--disable-dev-shm-usage "
                             "--user-data-dir=\"$PWD/browser\" " +
                             what + " '" + url_ + path + "' 2> browser.log";
    EXPECT_EQ(std::system(line.c_str()), 0) << text_of("browser.log");
    return line;
  }
  // The page as its reader sees it.
  std::string seen(const std::string& path) const {
    browse("--print-to-pdf=page.pdf", path);
    EXPECT_EQ(std::system(("cd '" + folder_.string() + "' && pdftotext -layout page.pdf page.txt").c_str()), 0);
    return text_of("page.txt");
  }
  // The page's elements in the browser.
  std::string elements(const std::string& path) const {
    browse("--dump-dom > dom.html", path);
    return text_of("dom.html");
  }

  FILE* server_ = nullptr;
  int process_ = 0;
  std::string url_;
};

TEST_F(TeacherInBrowser, cohort_curves_and_report_are_seen) {
  const std::string cohort = seen("/");
  EXPECT_THAT(cohort, HasSubstr("trainee-07"));
  EXPECT_THAT(cohort, HasSubstr("trainee-08"));
  const std::string made = elements("/");
  EXPECT_THAT(made, Not(HasSubstr("<script")));
  // Each trainee's row leads to a page with the curve, drawn by the browser, and from there to the attempt's report.
  const auto link_after = [](const std::string& html, const std::string& start) {
    const std::size_t at = html.find("href=\"" + start);
    if (at == std::string::npos) return std::string();
    const std::size_t from = at + 6;
    return html.substr(from, html.find('"', from) - from);
  };
  const std::string trainee = link_after(made, "/trainee/trainee-07");
  ASSERT_FALSE(trainee.empty()) << made;
  const std::string curves = elements(trainee);
  EXPECT_THAT(curves, HasSubstr("<svg"));
  EXPECT_THAT(seen(trainee), HasSubstr("trainee-07"));
  const std::string attempt = link_after(curves, "/attempt/");
  ASSERT_FALSE(attempt.empty()) << curves;
  EXPECT_THAT(seen(attempt), HasSubstr("Passed: the tip came to rest"));
  browse("--window-size=1200,900 --screenshot=page.png", trainee);
  EXPECT_GT(std::filesystem::file_size(folder_ / "page.png"), 5000U);  // not a blank sheet
}

}  // namespace
}  // namespace bodkin_test
