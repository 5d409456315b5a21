// The window as the screen of a station that runs elsewhere.
#include "app/models/remote_station.h"

#include <fstream>
#include <thread>

#include "app/models/station_patient.h"
#include "link/contents.h"
#include "link/skin_sheet.h"
#include "session/session_file.h"
#include "tests/app/window_fixture.h"
#include "tests/link/served_session.h"
#include <gmock/gmock.h>
#include <unistd.h>

#include "core/error.h"
#include "io/case_folder.h"
#include "io/digest.h"

namespace bodkin::app {
namespace {

using ::testing::HasSubstr;
constexpr int patience = 60000;  // ms

// The remote hand: it moves in, and stays for a while.
constexpr const char* slow_hand = "speed_mm_s=30 start_mm=10 depth_mm=20 wait_s=25";

class RemoteWindow : public WindowFixture {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_);
    anatomy::Case patient = link::served_slabs();
    io::write_case(patient.description, patient.ct, patient.tissues, {}, &patient.library, folder_);
    open_window();
  }
  void TearDown() override {
    window_.reset();
    std::filesystem::remove_all(folder_);
  }
  const Frame& frame() { return window_->practice().frame(); }
  bool wait_until(const std::function<bool()>& done) { return QTest::qWaitFor(done, patience); }
  void follow(std::uint16_t port) { window_->follow("127.0.0.1:" + std::to_string(port), folder_); }

  // The station's own files are in a folder of theirs, as on another machine.
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("bodkin_remote_" + std::to_string(getpid()));
};

TEST_F(RemoteWindow, shows_the_needle_force_and_events_of_the_station_and_ends_its_session) {
  link::ServedSession station(slow_hand);
  station.start();
  follow(station.port());
  bool has_contact = false;
  ASSERT_TRUE(wait_until([&] {
    for (const session::SessionEvent& event : frame().events)
      has_contact = has_contact || event.event.kind == forces::EventKind::contact;
    return frame().has_needle && frame().depth > 15.0 && frame().force > 0.1;
  })) << window_->practice().failure();
  EXPECT_TRUE(window_->practice().state() == State::in_tissue || window_->practice().state() == State::reached);
  EXPECT_NEAR(-frame().needle.translation().y(), frame().depth, 2.0) << "the back is the plane y = 0";
  EXPECT_EQ(frame().tissue, anatomy::tissue::muscle);
  EXPECT_EQ(frame().guard, haptics::GuardState::active);
  EXPECT_FALSE(frame().diagnostic_names.empty());

  window_->run(Command::hold);
  ASSERT_TRUE(wait_until([&] { return window_->practice().state() == State::held; }));
  window_->run(Command::hold);
  window_->run(Command::end);
  ASSERT_TRUE(wait_until([&] { return station.finished(); })) << "E reaches the station";
  station.join();
  EXPECT_TRUE(session::read_session(station.file()).finished);
  station.server().publish({"STRING", "Score", 0.0,
                            link::string_content(R"({"verdict":"borderline","headline":"Near it","deepest_mm":20})")},
                           false);
  ASSERT_TRUE(wait_until([&] { return window_->practice().result().has_value(); }));
  EXPECT_EQ(window_->practice().state(), State::ended);
  EXPECT_EQ(window_->practice().result()->headline, "Near it");
  EXPECT_EQ(window_->practice().result()->verdict, training::Grade::borderline);
}

TEST_F(RemoteWindow, shows_no_needle_while_the_station_is_gone_and_goes_on_when_it_is_back) {
  auto station = std::make_unique<link::ServedSession>(slow_hand);
  const std::uint16_t port = station->port();
  station->start();
  follow(port);
  ASSERT_TRUE(wait_until([&] { return frame().has_needle && frame().depth > 5.0; }));
  station.reset();
  ASSERT_TRUE(wait_until([&] { return !frame().has_needle; })) << "a pose that is not current is not shown";
  EXPECT_THAT(frame().hint, HasSubstr("Not connected"));
  EXPECT_TRUE(is_attempt(window_->practice().state())) << "nothing has to be done by hand";
  station = std::make_unique<link::ServedSession>(slow_hand, link::served_slabs(), port);
  station->start();
  ASSERT_TRUE(wait_until([&] { return frame().has_needle && frame().depth > 5.0; })) << frame().hint;
  window_->practice().leave();
  QTest::qWait(300);
  EXPECT_FALSE(station->finished()) << "who only looked away ends nobody's session";
}

TEST_F(RemoteWindow, refuses_a_station_with_another_patient) {
  anatomy::Case other = link::served_slabs();
  other.tissues.voxels.front() = anatomy::tissue::fat;
  link::ServedSession station(slow_hand, other);
  station.start();
  follow(station.port());
  ASSERT_TRUE(wait_until([&] { return !window_->practice().failure().empty(); }));
  EXPECT_THAT(window_->practice().failure(), HasSubstr("has another patient"));
}

TEST_F(RemoteWindow, finds_the_copy_of_the_stations_case_by_name_and_tissues) {
  // Among the cases here are one of the same name with other tissues, and one that cannot be read.
  anatomy::Case other = link::served_slabs();
  other.tissues.voxels.front() = anatomy::tissue::fat;
  const std::filesystem::path patients = folder_ / "patients";
  for (const char* name : {"a", "b", "damaged"}) std::filesystem::create_directories(patients / name);
  io::write_case(other.description, other.ct, other.tissues, {}, &other.library, patients / "a");
  anatomy::Case same = link::served_slabs();
  io::write_case(same.description, same.ct, same.tissues, {}, &same.library, patients / "b");
  std::ofstream(patients / "damaged/case.xml") << "<case";
  link::ServedSession station(slow_hand);
  station.start();
  link::ClientSettings server;
  server.host = "127.0.0.1";
  server.port = station.port();
  const std::vector<std::filesystem::path> here = {folder_ / "nowhere", patients};
  EXPECT_EQ(patient_of_station(server, here), patients / "b");
  std::filesystem::remove_all(patients / "b");
  try {
    patient_of_station(server, here);
    FAIL() << "expected a refusal";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("whose case is not on this computer"));
  }
}

TEST(StationPatient, a_waiting_station_tells_its_name_and_one_that_is_not_there_is_a_sentence) {
  link::ServerSettings any;
  any.port = 0;
  link::ClientSettings place;
  place.host = "127.0.0.1";
  const std::filesystem::path patients =
      std::filesystem::temp_directory_path() / ("bodkin_waiting_" + std::to_string(getpid()));
  {
    link::Server server(any);
    place.port = server.port();
    anatomy::Case same = link::served_slabs();
    std::filesystem::create_directories(patients / "copy");
    io::write_case(same.description, same.ct, same.tissues, {}, &same.library, patients / "copy");
    std::jthread telling([&server, name = same.description.name](const std::stop_token& end) {
      while (!end.stop_requested()) {
        server.publish(
            {"STRING", "State", 0.0, link::string_content(R"({"guard":"waiting","case":")" + name + "\"}")}, true);
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
      }
    });
    EXPECT_EQ(patient_of_station(place, {{patients}}), patients / "copy");
  }
  std::filesystem::remove_all(patients);
  try {
    patient_of_station(place, {{patients}});
    FAIL() << "expected a refusal";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("127.0.0.1"));
  }
}

// A body of finite elements: the window is told only the skin's present place.
TEST(RemoteStation, brings_the_displacements_of_a_deformable_body_and_none_of_a_rigid_one) {
  const auto patient = std::make_shared<OpenCase>();
  patient->patient = link::served_slabs();
  link::ServerSettings any;
  any.port = 0;
  link::Server server(any);
  link::ClientSettings place;
  place.host = "127.0.0.1";
  place.port = server.port();
  RemoteStation station(place, patient, false);
  const link::SkinSheet sheet(patient->patient);
  std::vector<Vec3> moved = sheet.rest();
  for (Vec3& point : moved) point.y() -= 1.5;
  const Vec3 entry = patient->patient.description.procedure.path->entry;
  station.follow_points({entry, entry + Vec3(4.0, 0.0, 1.0)});
  ASSERT_TRUE(QTest::qWaitFor([&] { return server.counts().clients == 1; }, patience));
  StationUpdate news;
  const auto tell = [&](bool deforms) {
    const std::string about = R"({"case":"x","deformable_body":)" + std::string(deforms ? "true" : "false") +
                              R"(,"tissues_digest":")" + io::volume_digest(patient->patient.tissues) + "\"}";
    server.publish({"STRING", "Case", 0.0, link::string_content(about)}, false);
    server.publish({"POLYDATA", "Skin", 0.0, link::surface_content(moved, sheet.triangles(), {})}, false);
    server.publish({"STRING", "State", 0.0, link::string_content(R"({"message":"told"})")}, false);
  };
  tell(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return station.poll(news), news.message == "told"; }, patience));
  ASSERT_EQ(news.displacements.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(news.displacements[i], i % 3 == 1 ? -1.5 : 0.0, 1e-4);
  tell(false);
  EXPECT_TRUE(QTest::qWaitFor([&] { return station.poll(news), news.displacements.empty(); }, patience));
}

TEST_F(RemoteWindow, refuses_a_place_that_is_none) {
  EXPECT_THROW(window_->follow("room3:not-a-port", folder_), InputError);
}

}  // namespace
}  // namespace bodkin::app
