#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class ReportCommand : public PatientCommand {
 protected:
  static const std::string& session() {
    static const std::string file = [] {
      const std::string made = (folder_ / "session.bodkin").string();
      bodkin("-q run " + patient() + " --operator expert --output " + made + " --overwrite");
      return made;
    }();
    return file;
  }
};

TEST_F(ReportCommand, writes_one_page_next_to_the_session) {
  const Outcome said = bodkin("-q report " + session());
  ASSERT_EQ(said.exit_code, 0) << said.errors;
  const fs::path page = fs::path(session()).replace_extension(".html");
  EXPECT_THAT(said.output, HasSubstr(page.string()));
  EXPECT_THAT(said.output, HasSubstr("from the planned target"));
  const std::string html = content_of(page);
  EXPECT_THAT(html, HasSubstr("<!DOCTYPE html>"));
  EXPECT_EQ(html.find("http://"), std::string::npos);
  EXPECT_THAT(html, HasSubstr("interspinous ligament"));
}

TEST_F(ReportCommand, gives_every_measure_in_json) {
  const Outcome said = bodkin("-q --json report " + session() + " -o " + (folder_ / "r.html").string());
  ASSERT_EQ(said.exit_code, 0) << said.errors;
  const auto result = nlohmann::json::parse(said.output);
  const auto& score = result.at("score");
  EXPECT_EQ(score.at("version"), 1);
  EXPECT_GT(score.at("metrics").size(), 30U);
  EXPECT_GT(score.at("tissues").size(), 4U);
}

TEST_F(ReportCommand, writes_pages_of_a4_by_the_ending_pdf) {
  const fs::path file = folder_ / "r.pdf";
  const Outcome said = bodkin("-q report " + session() + " -o " + file.string());
  ASSERT_EQ(said.exit_code, 0) << said.errors;
  const std::string bytes = content_of(file);
  EXPECT_EQ(bytes.substr(0, 5), "%PDF-");
  const Outcome again = bodkin("-q report " + session() + " -o " + (folder_ / "again.pdf").string());
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_TRUE(content_of(folder_ / "again.pdf") == bytes) << "the same report is not the same bytes";
}

TEST_F(ReportCommand, refuses_another_ending) {
  const Outcome said = bodkin("-q report " + session() + " -o " + (folder_ / "r.docx").string());
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_THAT(said.errors, HasSubstr(".html or .pdf"));
}

TEST_F(ReportCommand, finds_a_case_that_has_moved_only_when_it_is_named) {
  const fs::path moved = folder_ / "moved";
  fs::copy(patient(), moved, fs::copy_options::recursive);
  const fs::path away = folder_ / "away";
  const std::string recorded = session();
  fs::rename(patient(), away);
  const Outcome lost = bodkin("-q report " + recorded);
  const Outcome found = bodkin("-q report " + recorded + " --case " + moved.string());
  fs::rename(away, patient());
  EXPECT_EQ(lost.exit_code, 2);
  EXPECT_THAT(lost.errors, HasSubstr("--case"));
  EXPECT_EQ(found.exit_code, 0) << found.errors;
}

TEST_F(ReportCommand, refuses_what_is_no_session) {
  const fs::path wrong = folder_ / "wrong.bodkin";
  std::ofstream(wrong) << "not a session";
  EXPECT_EQ(bodkin("-q report " + wrong.string()).exit_code, 2);
  EXPECT_FALSE(fs::exists(folder_ / "wrong.html"));
}

}  // namespace
}  // namespace bodkin_test
