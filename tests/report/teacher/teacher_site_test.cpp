#include "report/teacher/teacher_site.h"

#include <array>
#include <cstdio>
#include <string>
#include <thread>

#include "report/teacher/teacher_page.h"
#include "tests/training/store/stored_attempts.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random_id.h"
#include "training/store/result_store.h"

namespace bodkin {

using namespace bodkin::report;
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class TeacherSiteTest : public ::testing::Test {
 protected:
  void SetUp() override {
    training::ResultStore store(place());
    store.add({attempt_record("a b", 1, training::Grade::fail), attempt_record("a b", 2)});
  }
  std::string place() const { return (folder_.path() / "results.sqlite").string(); }
  HttpReply get(const std::string& target, const std::string& token = {}) const {
    return TeacherSite(place(), token).answer({target, "127.0.0.1:8737", {}});
  }

  ScratchFolder folder_;
};

TEST(PercentEncoding, of_any_text_comes_back) {
  for (const std::string text : {"", "trainee-07", "a & <b>/ä%", "50%", "a b"})
    EXPECT_EQ(percent_decoded(percent_encoded(text)), text);
  EXPECT_EQ(percent_encoded("a/b c"), "a%2Fb%20c");
  for (const char* wrong : {"%", "%4", "%zz", "a%2"}) EXPECT_FALSE(percent_decoded(wrong)) << wrong;
}

TEST_F(TeacherSiteTest, shows_the_cohort_and_escapes_what_the_store_holds) {
  training::AttemptRecord sly = attempt_record("sly", 3);
  sly.procedure = "<script>alert(1)</script>";
  sly.headline = "\"><img src=x>";
  training::ResultStore(place()).add(sly);
  const HttpReply page = get("/");
  EXPECT_EQ(page.status, 200);
  EXPECT_THAT(page.body, HasSubstr("<table id=\"cohort\">"));
  EXPECT_THAT(page.body, HasSubstr("/trainee/sly"));
  EXPECT_THAT(page.body, Not(HasSubstr("<script")));
  EXPECT_THAT(get("/trainee/sly").body, Not(HasSubstr("<img")));
  EXPECT_THAT(get("/trainee/sly").body, Not(HasSubstr("<script")));
}

TEST_F(TeacherSiteTest, shows_stations_live_with_step_force_and_picture_and_says_which_are_lost) {
  StationCard runs{.place = "room1:18944", .runs = true, .patient = "<b>x</b>", .procedure = "epidural"};
  runs.step = "2 of 7, Through the ligament";
  runs.tissue = "fat";
  runs.force = 1.234;
  runs.forces = {{0.0, 0.0}, {0.5, 1.0}, {1.0, 1.234}};
  runs.layers = {{"Skin", "#e8b89a", 0.0}, {"<i>Fat", "#ffe08a", 2.5}};
  runs.path = 40.0;
  runs.depth = 12.0;
  runs.picture_width = 3;
  runs.picture_height = 2;
  runs.picture = {0, 50, 100, 150, 200, 250};
  const StationCard lost{.place = "room2:18944", .trouble = "no server answers at room2:18944"};
  const TeacherSite site(place(), "", [&] { return std::vector<StationCard>{runs, lost, {.place = "room3:18944"}}; });
  const std::string page = site.answer({"/stations", "127.0.0.1:8737", {}}).body;
  EXPECT_THAT(page, HasSubstr("3 stations, 2 connected"));
  EXPECT_THAT(page, HasSubstr("step: <b>2 of 7, Through the ligament</b>"));
  EXPECT_THAT(page, HasSubstr("<b>1.23 N</b>"));
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,iVBORw0KGgo"));
  EXPECT_THAT(page, HasSubstr("<polyline"));
  EXPECT_THAT(page, HasSubstr("the needle 12.0 mm deep, the target at 40 mm"));
  EXPECT_THAT(page, HasSubstr("fill=\"#ffe08a\"><title>&lt;i&gt;Fat</title>"));
  EXPECT_THAT(page, HasSubstr("not connected: no server answers at room2:18944"));
  EXPECT_THAT(page, HasSubstr("waits for a procedure"));
  EXPECT_THAT(page, Not(HasSubstr("<b>x</b>")));
  EXPECT_THAT(site.answer({"/", "127.0.0.1:8737", {}}).body, HasSubstr("href=\"/stations\""));
  EXPECT_THAT(get("/").body, Not(HasSubstr("/stations")));
  EXPECT_THAT(get("/stations").body, HasSubstr("no station was named"));
}

TEST_F(TeacherSiteTest, leads_from_a_trainee_to_the_curve_and_to_every_attempt) {
  training::AttemptRecord record = attempt_record("t", 1);
  record.digest = "00ff";
  training::ResultStore(place()).add(record);
  const HttpReply trainee = get("/trainee/t");
  EXPECT_THAT(trainee.body, HasSubstr("<svg"));
  EXPECT_THAT(trainee.body, HasSubstr("href=\"/attempt/00ff\""));
  const HttpReply attempt = get("/attempt/00ff");
  EXPECT_EQ(attempt.status, 200);
  EXPECT_THAT(attempt.body, HasSubstr("You needed 3 passes."));
  EXPECT_THAT(attempt.body, HasSubstr("7.1"));
  EXPECT_EQ(get("/attempt/00ff/report").status, 404);  // the session is not here
}

TEST_F(TeacherSiteTest, gives_the_table_for_statistics) {
  const HttpReply table = get("/results.csv");
  EXPECT_THAT(table.type, HasSubstr("text/csv"));
  EXPECT_THAT(table.body, HasSubstr("lumbar_puncture"));
}

TEST_F(TeacherSiteTest, shows_how_far_a_trainee_is_in_a_plan) {
  training::ResultStore store(place());
  store.put_plan(
      {"p", "First week",
       "<plan version=\"1\" name=\"p\" title=\"First week\"><stage title=\"One\" case=\"x\" attempts=\"9\" "
       "passes=\"3\"/></plan>"});
  training::AttemptRecord record = attempt_record("t", 1);
  record.plan = "p";
  record.stage = 1;
  store.add(record);
  EXPECT_THAT(get("/").body, HasSubstr("stage 1 of 1, One: 1 of 3 passed in a row, attempt 2 of 9"));
}

TEST_F(TeacherSiteTest, knows_no_other_page) {
  for (const char* target : {"/other", "/trainee/", "/trainee/nobody", "/attempt/none", "/attempt/%zz",
                             "/attempt/none/report", "/../etc/passwd", "", "*"})
    EXPECT_EQ(get(target).status, 404) << target;
}

TEST_F(TeacherSiteTest, answers_to_names_of_this_computer_alone) {
  const TeacherSite site(place(), "");
  EXPECT_EQ(site.answer({"/", "localhost:1", ""}).status, 200);
  EXPECT_EQ(site.answer({"/", "[::1]:1", ""}).status, 200);
  EXPECT_EQ(site.answer({"/", "evil.example:8737", ""}).status, 403);
  EXPECT_EQ(site.answer({"/", "", ""}).status, 403);
}

TEST_F(TeacherSiteTest, with_a_token_shows_nothing_without_it) {
  const std::string token = random_id();
  EXPECT_EQ(get("/", token).status, 403);
  EXPECT_EQ(get("/?token=", token).status, 403);
  EXPECT_EQ(get("/?token=" + std::string(32, '0'), token).status, 403);
  const HttpReply opened = get("/?token=" + token, token);
  EXPECT_EQ(opened.status, 200);
  EXPECT_THAT(opened.cookie, HasSubstr("HttpOnly; SameSite=Strict"));
  const std::string cookie = opened.cookie.substr(0, opened.cookie.find(';'));
  EXPECT_EQ(TeacherSite(place(), token).answer({"/", "10.0.0.5:8737", "other=1; " + cookie}).status, 200);
}

TEST_F(TeacherSiteTest, says_why_where_the_store_is_gone) {
  const HttpReply reply = TeacherSite("/nowhere/at/all.sqlite", "").answer({"/", "localhost", ""});
  EXPECT_EQ(reply.status, 503);
  EXPECT_THAT(reply.body, HasSubstr("cannot be opened"));
}

// A real client.
std::string curl(const std::string& arguments) {
  FILE* pipe = popen(("curl -s -m 10 " + arguments + " 2>&1").c_str(), "r");
  std::string said;
  std::array<char, 4096> block{};
  for (std::size_t n = 0; (n = fread(block.data(), 1, block.size(), pipe)) > 0;) said.append(block.data(), n);
  pclose(pipe);
  return said;
}

class HttpServerTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("curl --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "curl is not installed here";
    thread_ = std::jthread([this] { server_.run(false); });
  }
  void TearDown() override { server_.stop(); }
  std::string url(const std::string& path) const {
    return fmt::format("'http://127.0.0.1:{}{}'", server_.port(), path);
  }

  HttpServer server_{"127.0.0.1", 0, [](const HttpRequest& request) -> HttpReply {
                       if (request.target == "/throws") throw InputError("a secret");
                       return {.body = "asked for " + request.target};
                     }};
  std::jthread thread_;
};

TEST_F(HttpServerTest, answers_a_browser_with_headers_that_forbid_scripts) {
  const std::string said = curl("-i " + url("/a?b=1"));
  EXPECT_THAT(said, HasSubstr("HTTP/1.1 200 OK"));
  EXPECT_THAT(said, HasSubstr("asked for /a?b=1"));
  EXPECT_THAT(said, HasSubstr("Content-Security-Policy: default-src 'none'"));
  EXPECT_THAT(said, HasSubstr("Cache-Control: no-store"));
  EXPECT_THAT(curl("-I " + url("/a")), HasSubstr("Content-Length: 12"));
  EXPECT_THAT(curl(url("/one") + " " + url("/two")), HasSubstr("asked for /oneasked for /two"));
}

TEST_F(HttpServerTest, changes_nothing_and_tells_nothing) {
  for (const char* method : {"POST", "PUT", "DELETE", "PATCH"})
    EXPECT_THAT(curl(fmt::format("-o /dev/null -w '%{{http_code}}' -X {} -d x {}", method, url("/"))), "405")
        << method;
  const std::string said = curl("-i " + url("/throws"));
  EXPECT_THAT(said, HasSubstr("500"));
  EXPECT_THAT(said, Not(HasSubstr("secret")));
}

TEST_F(HttpServerTest, refuses_what_is_too_long) {
  EXPECT_THAT(curl("-o /dev/null -w '%{http_code}' -H 'X: " + std::string(20000, 'x') + "' " + url("/")), "413");
  EXPECT_THAT(curl("-o /dev/null -w '%{http_code}' -d '" + std::string(5000, 'x') + "' " + url("/")), "413");
  EXPECT_THAT(curl(url("/still")), HasSubstr("asked for /still"));
}

TEST(HttpServerPlace, that_is_taken_or_none_is_refused) {
  const auto handler = [](const HttpRequest&) { return HttpReply{}; };
  const HttpServer first("127.0.0.1", 0, handler);
  EXPECT_THROW(HttpServer("127.0.0.1", first.port(), handler), SystemError);
  EXPECT_THROW(HttpServer("nowhere", 0, handler), InputError);
  EXPECT_TRUE(is_loopback("127.0.0.1"));
  EXPECT_TRUE(is_loopback("::1"));
  EXPECT_FALSE(is_loopback("0.0.0.0"));
  EXPECT_FALSE(is_loopback("localhost"));
}

}  // namespace
}  // namespace bodkin
