// Whole sessions of bodkin serve driven only by external programs on the OpenIGTLink library: one tracks the needle,
// like PLUS, and one commands, watches and receives the score, like 3D Slicer.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "link/contents.h"
#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include "tests/cli/serve_process.h"
#include "tests/link/library_client.h"
#include "tests/link/library_server.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "io/case_folder.h"

namespace bodkin_test {
namespace {

using namespace std::chrono_literals;
using ::bodkin::Vec3;
using ::bodkin::link::LibraryClient;
using ::bodkin::link::LibraryServer;
using ::bodkin::link::Message;
using ::testing::Contains;
using ::testing::HasSubstr;

using ::bodkin::link::Bytes;
using ::bodkin::link::ByteWriter;

// A message with an extended header and metadata, as 3D Slicer sends all of them; the library of Debian has none.
Bytes message_of_slicer(const std::string& type, const Bytes& content) {
  ByteWriter body;
  const std::string metadata = "keyvalue";
  body.u16(12);
  body.u16(10);
  body.u32(static_cast<std::uint32_t>(metadata.size()));
  body.u32(1);
  body.raw(content);
  body.u16(1);  // one pair: sizes of its key, character set and size of its value
  body.u16(3);
  body.u16(3);
  body.u32(5);
  body.field(metadata, metadata.size());
  Bytes all = ::bodkin::link::pack({type, "Slicer", 0.0, body.take()});
  all[1] = 2;
  return all;
}

Bytes command_content(std::uint32_t number, const std::string& text) {
  ByteWriter content;
  content.u32(number);
  content.field("Bodkin", 128);
  content.u16(3);
  content.u32(static_cast<std::uint32_t>(text.size()));
  content.field(text, text.size());
  return content.take();
}

class WholeSession : public PatientCommand {
 protected:
  void SetUp() override {
    PatientCommand::SetUp();
    path_ = ::bodkin::io::read_case_description(folder_ / "patient").procedure.path.value();
    tracker_ = std::make_unique<LibraryServer>("NeedleTipToReference");
    put_needle(-20.0);
    station_ = std::make_unique<ServeProcess>(
        folder_, "serve patient openigtlink:127.0.0.1:" + std::to_string(tracker_->port()) +
                     "/NeedleTipToReference --port 0 --wait --max-time 120");
    const std::uint16_t port = station_->port();
    ASSERT_NE(port, 0) << station_->notes();
    client_ = std::make_unique<LibraryClient>(port);
  }
  void TearDown() override {
    client_.reset();
    station_.reset();
    tracker_.reset();
  }

  // The tracked place of the needle: on the planned path, so many mm below the skin.
  void put_needle(double depth) {
    const Vec3 along = path_.direction(), tip = path_.entry + depth * along;
    const Vec3 across = along.unitOrthogonal(), other = along.cross(across);
    const auto row = [](double sign, double x, double y, double z, double place) {
      return std::array<float, 4>{static_cast<float>(sign * x), static_cast<float>(sign * y),
                                  static_cast<float>(sign * z), static_cast<float>(sign * place)};
    };
    std::array<float, 12> rows{};
    for (int i = 0; i < 3; ++i) {  // LPS to RAS
      const std::array<float, 4> numbers = row(i < 2 ? -1.0 : 1.0, across[i], other[i], along[i], tip[i]);
      std::copy(numbers.begin(), numbers.end(), rows.begin() + 4 * i);
    }
    tracker_->set_matrix(rows);
  }
  // Goes there at 50 mm/s.
  void push_needle(double from, double to) {
    const double step = to > from ? 0.5 : -0.5;
    for (double depth = from; std::abs(to - depth) > 0.5; depth += step) {
      put_needle(depth);
      client_->wait_for("STRING", 10ms, [this](const Message& message) { return hear(message), false; });
    }
    put_needle(to);
  }

  bool hear(const Message& message) {
    if (message.type == "STRING" && message.device == "Event")
      events_.push_back(::bodkin::link::read_string(message.content));
    if (message.type == "STRING" && message.device == "State") state_ = ::bodkin::link::read_string(message.content);
    if (message.type == "STRING" && message.device == "Case") case_ = ::bodkin::link::read_string(message.content);
    if (message.type == "STRING" && message.device == "Score") score_ = ::bodkin::link::read_string(message.content);
    return true;
  }
  bool wait_until(const std::function<bool(const Message&)>& is_so) {
    return client_->wait_for("", 30s, [&](const Message& message) { return hear(message), is_so(message); });
  }
  bool state_says(const std::string& words) {
    return wait_until([&](const Message&) { return state_.find(words) != std::string::npos; });
  }
  // Waits until the station reports the tip so many mm below the skin.
  bool needle_comes_to(double depth) {
    const Vec3 tip = path_.entry + depth * path_.direction();
    return wait_until([&](const Message& message) {
      return message.type == "TRANSFORM" && message.device == "NeedleTipToReference" &&
             (::bodkin::link::read_transform(message.content).translation() - tip).norm() < 1.0;
    });
  }
  // The reply to a command as sent by PLUS's clients.
  std::string answer(const std::string& text) {
    const std::string number = std::to_string(++commands_);
    client_->send_string("CMD_" + number, text);
    std::string reply;
    EXPECT_TRUE(wait_until([&](const Message& message) {
      if (message.device != "ACK_" + number) return false;
      reply = ::bodkin::link::read_string(message.content);
      return true;
    })) << text;
    return reply;
  }
  std::string answer_to_slicer(const std::string& text) {
    client_->send_bytes(message_of_slicer("COMMAND", command_content(++commands_, text)));
    std::string reply;
    EXPECT_TRUE(wait_until([&](const Message& message) {
      if (message.type != "RTS_COMMAND") return false;
      ::bodkin::link::ByteReader reader(message.content);
      EXPECT_EQ(reader.u32(), commands_);
      reply.assign(message.content.begin() + 138, message.content.end());
      return true;
    })) << text;
    return reply;
  }

  ::bodkin::anatomy::NeedlePath path_;
  std::unique_ptr<LibraryServer> tracker_;
  std::unique_ptr<ServeProcess> station_;
  std::unique_ptr<LibraryClient> client_;
  std::vector<std::string> events_;
  std::string state_, case_, score_;
  std::uint32_t commands_ = 0;
};

TEST_F(WholeSession, is_driven_from_the_start_to_the_score_by_clients_that_are_not_ours) {
  ASSERT_TRUE(state_says(R"("guard":"waiting")")) << station_->notes();
  // 3D Slicer's first messages; and one without meaning here.
  client_->send_bytes(message_of_slicer("STATUS", ::bodkin::link::status_content(1, "", "")));
  client_->send_bytes(message_of_slicer("VIDEOMETA", Bytes(100, 7)));
  EXPECT_THAT(answer("<Command Name='Freeze' On='true'/>"), HasSubstr("no session runs here"));
  EXPECT_THAT(answer("<Command Name='StartRecording' OutputFilename='slicer'/>"), HasSubstr("SUCCESS"));
  ASSERT_TRUE(state_says(R"("guard":"active")")) << station_->notes();
  ASSERT_TRUE(wait_until([&](const Message&) { return !case_.empty(); }));
  EXPECT_EQ(nlohmann::json::parse(case_).at("procedure"), "lumbar_puncture");

  push_needle(-20.0, 25.0);
  ASSERT_TRUE(needle_comes_to(25.0)) << state_;
  EXPECT_THAT(events_, Contains(HasSubstr("\"contact\"")));
  EXPECT_THAT(events_, Contains(HasSubstr("\"puncture\"")));
  client_->start_tracking(20);
  EXPECT_TRUE(wait_until([](const Message& message) { return message.type == "TDATA"; }));

  EXPECT_THAT(answer_to_slicer("<Command Name=\"Freeze\" On=\"true\"/>"), HasSubstr("SUCCESS"));
  EXPECT_TRUE(state_says("\"held\":true"));
  push_needle(25.0, 15.0);
  EXPECT_TRUE(needle_comes_to(25.0)) << "the hand moves, the needle is held";
  push_needle(15.0, 25.0);
  EXPECT_THAT(answer("<Command Name='Freeze' On='false'/>"), HasSubstr("SUCCESS"));
  EXPECT_TRUE(state_says("\"held\":false"));

  EXPECT_THAT(answer("<Command Name='SetModelParameter' Part='skin' Parameter='break_force_N' Value='0.625'/>"),
              HasSubstr("SUCCESS"));
  EXPECT_THAT(answer("<Command Name='SetModelParameter' Part='skin' Parameter='break_force_N' Value='-1'/>"),
              HasSubstr("FAIL"));
  push_needle(25.0, -20.0);

  EXPECT_THAT(answer("<Command Name='Reset'/>"), HasSubstr("SUCCESS"));
  ASSERT_TRUE(wait_until([&](const Message&) { return !score_.empty(); })) << station_->notes();
  EXPECT_FALSE(nlohmann::json::parse(score_).at("reached").get<bool>());
  ASSERT_TRUE(wait_until([&](const Message& message) { return message.device == "Case"; })) << station_->notes();
  score_.clear();
  push_needle(-20.0, path_.length());
  ASSERT_TRUE(needle_comes_to(path_.length())) << state_;
  client_->wait_for("STRING", 1000ms, [this](const Message& message) { return hear(message), false; });  // it rests
  EXPECT_THAT(answer("<Command Name='StopRecording'/>"), HasSubstr("SUCCESS"));
  ASSERT_TRUE(wait_until([&](const Message&) { return !score_.empty(); })) << station_->notes();
  const auto score = nlohmann::json::parse(score_);
  EXPECT_TRUE(score.at("reached").get<bool>()) << score.at("headline");
  EXPECT_FALSE(score.at("verdict").get<std::string>().empty());
  EXPECT_FALSE(score.at("headline").get<std::string>().empty());
  EXPECT_NEAR(score.at("deepest_mm").get<double>(), path_.length(), 1.5);
  EXPECT_TRUE(state_says(R"("guard":"waiting")")) << "and it waits for the next one";

  for (const char* file : {"slicer.bodkin", "slicer-2.bodkin"})
    EXPECT_TRUE(::bodkin::session::read_session(folder_ / file).finished) << file;
  EXPECT_FALSE(::bodkin::session::read_session(folder_ / "slicer.bodkin").changes.empty());
  EXPECT_EQ(station_->end(), 0) << station_->notes();
}

TEST_F(WholeSession, sets_the_ultrasound_as_plus_does) {
  station_ = std::make_unique<ServeProcess>(
      folder_, "serve patient simulated --settings 'depth_mm=10 wait_s=60' --port 0 --ultrasound C5-2 -o us.bodkin");
  client_ = std::make_unique<LibraryClient>(station_->port());
  double pixel = 0.0;  // mm, of the newest picture: the deeper it reaches, the larger
  const auto comes = [this, &pixel](const std::function<bool()>& as_wanted) {
    return wait_until([&](const Message& message) {
      if (message.type != "IMAGE" || message.device != "Image_Reference") return false;
      pixel = ::bodkin::link::read_image(message.content).pixel;
      return as_wanted();
    });
  };
  ASSERT_TRUE(wait_until([](const Message& message) { return message.device == "ProbeToReference"; }))
      << station_->notes();
  ASSERT_TRUE(comes([] { return true; }));
  const double first = pixel;
  EXPECT_THAT(
      answer("<Command Name='SetUsParameter' UsDeviceId='VideoDevice'><Parameter Name='DepthMm' Value='50'/>"
             "<Parameter Name='GainPercent' Value='75'/><Parameter Name='FrequencyMhz' Value='3'/></Command>"),
      HasSubstr("SUCCESS"));
  EXPECT_TRUE(comes([&] { return pixel < 0.8 * first; })) << pixel << " mm, first " << first;
  EXPECT_THAT(answer_to_slicer("<Command Name='SetUsParameter' DepthMm='180'/>"), HasSubstr("SUCCESS"));
  EXPECT_TRUE(comes([&] { return pixel > 1.2 * first; })) << pixel << " mm, first " << first;
  EXPECT_THAT(answer("<Command Name='GetUsParameter'><Parameter Name='DepthMm'/></Command>"),
              HasSubstr("DepthMm=180,GainDb=20,GainPercent=75,FrequencyMhz=3,"));
  EXPECT_THAT(answer("<Command Name='SetUsParameter'><Parameter Name='GainPercent' Value='101'/></Command>"),
              HasSubstr("gain_dB is 40.8"));
  EXPECT_THAT(answer("<Command Name='SetUsParameter'><Parameter Name='DepthMm'/></Command>"), HasSubstr("FAIL"));
  EXPECT_THAT(answer("<Command Name='RequestDeviceIds'/>"), HasSubstr("Image_Reference"));
  EXPECT_THAT(answer("<Command Name='RequestChannelIds'/>"), HasSubstr("Message=\"Bodkin\""));
  EXPECT_THAT(answer("<Command Name='StopRecording'/>"), HasSubstr("SUCCESS"));
  EXPECT_EQ(station_->wait(), 0) << station_->notes();
}

}  // namespace
}  // namespace bodkin_test
