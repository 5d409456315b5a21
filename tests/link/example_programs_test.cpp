// The programs of the documentation (docs/openigtlink-client) against our server.
#include <array>
#include <cstdio>
#include <string>

#include "link/command.h"
#include "link/contents.h"
#include "tests/link/raw_client.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace bodkin::link {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

// What the program prints, which is to end after five poses of the needle.
std::string five_poses_by(const std::string& program) {
  Server server(any_port());
  const std::jthread session([&](const std::stop_token& stop) {
    Pose pose = Pose::Identity();
    pose.translation() = Vec3(-10.5, 20.25, 30.0);
    while (!stop.stop_requested()) {
      server.publish({"STRING", "Event", time_now(), string_content("something else")}, false);
      server.publish({"TRANSFORM", "ProbeToReference", time_now(), transform_content(Pose::Identity())}, true);
      server.publish({"TRANSFORM", "NeedleTipToReference", time_now(), transform_content(pose)}, true);
      std::this_thread::sleep_for(5ms);
    }
  });
  const std::string command = fmt::format("timeout 60 {} 127.0.0.1 {} 5 2>&1", program, server.port());
  FILE* const pipe = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 256> block{};
  while (fgets(block.data(), block.size(), pipe) != nullptr) text += block.data();
  EXPECT_EQ(pclose(pipe), 0) << text;
  return text;
}

const std::string five =
    "10.50 -20.25 30.00\n10.50 -20.25 30.00\n10.50 -20.25 30.00\n10.50 -20.25 30.00\n10.50 -20.25 30.00\n";

TEST(ExamplePrograms, the_one_in_python_prints_where_the_needle_is) {
  if (std::system("python3 --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "python3 is not installed here";
  EXPECT_EQ(five_poses_by("python3 '" BODKIN_REPOSITORY "/docs/openigtlink-client/needle.py'"), five);
}

TEST(ExamplePrograms, the_one_that_sends_a_command_prints_the_answer) {
  if (std::system("python3 --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "python3 is not installed here";
  Server server(any_port());
  const std::jthread session([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      for (const Received& received : server.take()) {
        const auto command = command_of(received.message);
        if (command) server.send(received.client, reply_to(received.message, true, "did " + command->name, 0.0));
      }
      std::this_thread::sleep_for(5ms);
    }
  });
  const std::string command = fmt::format("timeout 60 python3 '" BODKIN_REPOSITORY
                                          "/docs/openigtlink-client/command.py' 127.0.0.1 {} "
                                          "'<Command Name=\"Freeze\" On=\"true\"/>' 2>&1",
                                          server.port());
  FILE* const pipe = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 256> block{};
  while (fgets(block.data(), block.size(), pipe) != nullptr) text += block.data();
  EXPECT_EQ(pclose(pipe), 0) << text;
  EXPECT_THAT(text, HasSubstr("Status=\"SUCCESS\" Message=\"did Freeze\""));
}

TEST(ExamplePrograms, the_one_in_cpp_prints_where_the_needle_is) {
  EXPECT_EQ(five_poses_by("'" BODKIN_LINK_EXAMPLE "'"), five);
}

}  // namespace
}  // namespace bodkin::link
