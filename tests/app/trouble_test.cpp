// Errors are a sentence in the window, everything else continues, and no session is lost.
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>

#include "app/pages/practise.h"
#include "session/session_file.h"
#include "tests/app/window_fixture.h"
#include <gmock/gmock.h>
#include <sys/resource.h>

namespace bodkin::app {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Trouble : public WindowFixture {
 protected:
  std::string text(const char* name) { return find<QLabel>(name)->text().toStdString(); }
  bool push_to(double depth) {
    return wait(
        [&] {
          if (frame().depth < depth) window_->practice().push(1.0, false);
          return frame().depth >= depth;
        },
        60);
  }
};

// The limit simulates a full disk: writes beyond it fail.
class FullDisk {
 public:
  explicit FullDisk(std::uintmax_t room) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit now = before_;
    now.rlim_cur = room;
    setrlimit(RLIMIT_FSIZE, &now);
  }
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

TEST_F(Trouble, a_disk_that_fills_ends_the_attempt_with_a_sentence_and_keeps_what_was_recorded) {
  const std::set<fs::path> before = sessions();
  ASSERT_TRUE(start()) << window_->practice().failure();
  ASSERT_TRUE(push_to(8.0));
  {
    const FullDisk full(300'000);
    ASSERT_TRUE(wait(State::ended, 120)) << name_of(window_->practice().state());
    ASSERT_TRUE(wait([&] { return find("results")->isVisible() && window_->practice().result().has_value(); }, 60));
  }
  EXPECT_THAT(window_->practice().failure(), HasSubstr("cannot write the session"));
  EXPECT_THAT(window_->practice().failure(), HasSubstr("free space"));
  EXPECT_TRUE(wait([&] { return text("results.headline") == window_->practice().result()->headline; }, 60));
  EXPECT_TRUE(find("results.review")->isEnabled());
  std::set<fs::path> made;
  for (const fs::path& file : sessions())
    if (!before.contains(file)) made.insert(file);
  ASSERT_EQ(made.size(), 1U);
  const session::Session kept = session::read_session(*made.begin());
  EXPECT_FALSE(kept.finished);
  EXPECT_GT(kept.ticks.size(), 100U);
  // With free space again the window continues.
  click("results.again");
  ASSERT_TRUE(wait(State::ready, 60)) << window_->practice().failure();
  EXPECT_TRUE(push_to(3.0));
  fs::remove(*made.begin());  // or the next window would offer it
}

TEST_F(Trouble, a_disk_that_is_full_from_the_beginning_is_a_sentence_and_leaves_no_file) {
  ASSERT_TRUE(start()) << window_->practice().failure();
  const std::set<fs::path> before = sessions();
  {
    const FullDisk full(0);
    window_->run(Command::again);
    ASSERT_TRUE(wait([&] { return !window_->practice().failure().empty(); }, 60));
  }
  EXPECT_THAT(window_->practice().failure(), HasSubstr("cannot create the session file"));
  EXPECT_TRUE(wait([&] { return text("start.line").find("free space") != std::string::npos; }, 60))
      << text("start.line");
  ASSERT_TRUE(start()) << window_->practice().failure();
  EXPECT_EQ(sessions().size(), before.size() + 1) << "of the attempt that runs";
}

TEST_F(Trouble, a_patient_who_fails_the_check_is_a_sentence_and_another_one_opens) {
  ASSERT_TRUE(start()) << window_->practice().failure();
  const fs::path whole = window_->practice().patient()->folder, broken = data_folder() / "broken";
  window_->practice().leave();
  fs::remove_all(broken);
  fs::copy(whole, broken, fs::copy_options::recursive);
  fs::resize_file(broken / "tissues.nrrd", fs::file_size(broken / "tissues.nrrd") / 2);
  window_->open(broken);
  ASSERT_TRUE(wait([&] { return !window_->practice().failure().empty(); }, 60));
  EXPECT_TRUE(wait([&] { return text("start.line").find("tissues.nrrd") != std::string::npos; }, 60))
      << text("start.line");
  std::ofstream(broken / "case.xml") << "<case version=";
  window_->open(broken);
  EXPECT_TRUE(wait([&] { return text("start.line").find("case.xml") != std::string::npos; }, 60))
      << text("start.line");
  EXPECT_TRUE(start()) << window_->practice().failure();
}

// The ultrasound's preparation reports its steps; cancelling ends it, without a file or a message.
TEST_F(Trouble, what_the_station_prepares_is_told_and_can_be_cancelled) {
  ASSERT_TRUE(start()) << window_->practice().failure();
  std::set<std::string> told;
  QObject::connect(&window_->clock(), &FrameClock::frame, window_.get(), [&] {
    if (window_->practice().state() == State::preparing) told.insert(text("preparing.what"));
  });
  window_->run(Command::toggle_ultrasound);
  ASSERT_TRUE(wait([&] { return told.contains("preparing the ultrasound"); }, 60));
  EXPECT_LT(window_->practice().preparation().seconds, 60.0) << "since it began, not since the patient was opened";
  const std::set<fs::path> before = sessions();
  click("preparing.cancel");
  ASSERT_EQ(window_->practice().state(), State::no_case);
  window_->practice().finish();
  EXPECT_EQ(sessions(), before);
  EXPECT_EQ(window_->practice().failure(), "");
  EXPECT_TRUE(start()) << window_->practice().failure();
}

// During any action: nothing hangs, and the recording is complete.
TEST_F(Trouble, the_window_closes_at_any_moment) {
  const std::set<fs::path> others = sessions();
  click("start.begin");
  window_->close();
  window_.reset();
  open_window();
  ASSERT_TRUE(start()) << window_->practice().failure();
  ASSERT_TRUE(push_to(5.0));
  window_->close();
  window_.reset();
  for (const fs::path& file : sessions()) {
    if (others.contains(file)) continue;
    EXPECT_TRUE(session::read_session(file).finished) << file;
  }
}

}  // namespace
}  // namespace bodkin::app
