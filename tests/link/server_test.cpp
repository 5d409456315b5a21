// The server against independent clients: one built on the OpenIGTLink library, and hostile ones.
#include "link/server.h"

#include <chrono>
#include <thread>

#include "link/contents.h"
#include "tests/link/library_client.h"
#include "tests/link/raw_client.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin::link {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

TEST(LinkServer, a_client_of_the_library_sees_the_newest_pose) {
  Server server(any_port());
  LibraryClient client(server.port());
  ASSERT_TRUE(within(2s, [&] { return server.counts().clients == 1; }));
  Pose pose = Pose::Identity();
  for (int i = 1; i <= 20; ++i) {
    pose.translation() = Vec3(10.0 * i, 5.0, -3.0);
    server.publish({"TRANSFORM", "NeedleTipToReference", time_now(), transform_content(pose)}, true);
  }
  ASSERT_TRUE(client.wait_for("TRANSFORM", 2s, [&](const Message& message) {
    return (read_transform(message.content).translation() - Vec3(200.0, 5.0, -3.0)).norm() < 1e-3;
  }));
}

TEST(LinkServer, messages_that_matter_all_arrive_in_order) {
  Server server(any_port());
  LibraryClient client(server.port());
  ASSERT_TRUE(within(2s, [&] { return server.counts().clients == 1; }));
  for (int i = 0; i < 200; ++i)
    server.publish({"STRING", "Event", time_now(), string_content(std::to_string(i))}, false);
  int next = 0;
  EXPECT_TRUE(client.wait_for("STRING", 3s, [&](const Message& message) {
    EXPECT_EQ(read_string(message.content), std::to_string(next));
    return ++next == 200;
  }));
}

TEST(LinkServer, tracking_data_comes_to_those_who_ask_and_no_oftener_than_asked) {
  Server server(any_port());
  LibraryClient asks(server.port()), silent(server.port());
  ASSERT_TRUE(within(2s, [&] { return server.counts().clients == 2; }));
  asks.start_tracking(50);
  ASSERT_TRUE(asks.wait_for("RTS_TDATA", 2s, [](const Message& message) { return message.content == Bytes{0}; }));
  const std::array<TrackedTool, 1> tools = {{{"NeedleTipToReference", Pose::Identity()}}};
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 100; ++i) {
    server.publish_tracking({"TDATA", "Bodkin", time_now(), tracking_content(tools)});
    std::this_thread::sleep_for(4ms);
  }
  const std::size_t count = asks.count("TDATA", 100ms);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_GE(count, 3U);
  EXPECT_LE(static_cast<double>(count), took / 45ms + 1.0) << "of 100 in 0.4 s and more";
  EXPECT_EQ(silent.count("TDATA", 10ms), 0U);
}

TEST(LinkServer, what_a_client_sends_is_taken_and_answered) {
  Server server(any_port());
  LibraryClient client(server.port());
  client.send_string("CMD_3", "<Command Name='Freeze'/>");
  std::vector<Received> received;
  ASSERT_TRUE(within(2s, [&] {
    for (Received& each : server.take()) received.push_back(std::move(each));
    return !received.empty();
  }));
  EXPECT_EQ(received[0].message.device, "CMD_3");
  server.send(received[0].client, {"STRING", "ACK_3", time_now(), string_content("done")});
  EXPECT_TRUE(client.wait_for("STRING", 2s, [](const Message& message) { return message.device == "ACK_3"; }));
}

TEST(LinkServer, hostile_clients_are_dropped_with_a_reason_and_others_do_not_notice) {
  ServerSettings settings = any_port();
  settings.largest_message = 1000;
  settings.most_messages = 200;
  Server server(settings);
  LibraryClient good(server.port());
  ASSERT_TRUE(within(2s, [&] { return server.counts().clients == 1; }));
  const RawClient garbage(server.port()), stalling(server.port()), large(server.port()), flooding(server.port()),
      damaged(server.port());
  const std::string http = "GET / HTTP/1.1\r\nHost: x\r\nUser-Agent: y y y y y y y y y y y y y y y y\r\n\r\n";
  garbage.send(std::span(reinterpret_cast<const std::uint8_t*>(http.data()), http.size()));
  const Bytes message = pack({"STRING", "Text", 0.0, string_content("hello")});
  stalling.send(std::span(message).first(20));
  large.send(pack({"STRING", "Text", 0.0, Bytes(2000, 1)}));
  flooding.flood(message, 3000);
  Bytes flipped = message;
  flipped.back() ^= 1;
  damaged.send(flipped);
  std::string notes;
  EXPECT_TRUE(within(3s, [&] {
    for (const std::string& note : server.take_notes()) notes += note + "\n";
    return server.counts().dropped == 5;
  })) << notes;
  EXPECT_THAT(notes, HasSubstr("another protocol"));
  EXPECT_THAT(notes, HasSubstr("did not arrive"));
  EXPECT_THAT(notes, HasSubstr("2000 bytes"));
  EXPECT_THAT(notes, HasSubstr("more than 200 messages"));
  EXPECT_THAT(notes, HasSubstr("arrived damaged"));
  EXPECT_EQ(server.counts().clients, 1U);
  server.publish({"STRING", "Event", time_now(), string_content("still here")}, false);
  EXPECT_TRUE(good.wait_for("STRING", 2s, [](const Message&) { return true; }));
}

TEST(LinkServer, a_client_that_takes_nothing_costs_bounded_memory_and_then_its_connection) {
  ServerSettings settings = any_port();
  settings.largest_queue = 1 << 20;
  Server server(settings);
  const RawClient lazy(server.port());
  ASSERT_TRUE(within(2s, [&] { return server.counts().clients == 1; }));
  const std::vector<std::uint8_t> picture(300 * 300, 1);
  const Message image{"IMAGE", "Image_Reference", 0.0, image_content(picture, 300, 300, 1.0, Pose::Identity())};
  // Pictures replace each other: however many there are, the client only has the newest waiting.
  for (int i = 0; i < 500; ++i) server.publish(image, true);
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(server.counts().clients, 1U);
  const Message text{"STRING", "Event", 0.0, string_content(std::string(60000, 'x'))};
  for (int i = 0; i < 500; ++i) server.publish(text, false);
  EXPECT_TRUE(within(2s, [&] { return server.counts().clients == 0; }));
  EXPECT_EQ(server.counts().dropped, 1U);
}

TEST(LinkServer, what_a_client_sends_and_nobody_takes_costs_bounded_memory_and_then_its_connection) {
  ServerSettings settings = any_port();
  settings.largest_queue = 1 << 20;
  Server server(settings);
  LibraryClient good(server.port());
  const RawClient greedy(server.port());
  ASSERT_TRUE(within(2s, [&] { return server.counts().clients == 2; }));
  greedy.flood(pack({"POLYDATA", "Organ", 0.0, Bytes(200000, 1)}), 20);
  EXPECT_TRUE(within(5s, [&] { return server.counts().dropped == 1; }));
  good.send_string("CMD_3", "<Command Name='Freeze'/>");
  std::size_t bytes = 0;
  EXPECT_TRUE(within(5s, [&] {
    bool has_command = false;
    for (const Received& each : server.take()) {
      bytes += each.message.content.size();
      has_command = has_command || each.message.device == "CMD_3";
    }
    return has_command;
  })) << "the others are heard";
  EXPECT_LE(bytes, std::size_t{1 << 20} + 100);
  EXPECT_THAT(server.take_notes(), ::testing::ElementsAre(HasSubstr("sends more than is accepted")));
}

TEST(LinkServer, a_client_that_is_dropped_is_told_why) {
  Server server(any_port());
  LibraryClient client(server.port());
  ASSERT_TRUE(within(2s, [&] { return server.counts().clients == 1; }));
  Bytes future = pack({"STRING", "Text", 0.0, string_content("hello")});
  future[0] = 9;  // the version, which is then above 255
  client.send_bytes(future);
  EXPECT_TRUE(client.wait_for("STATUS", 5s, [](const Message& message) {
    const StatusText told = read_status(message.content);
    return told.code == status_error && told.message.find("version") != std::string::npos;
  }));
  EXPECT_TRUE(within(2s, [&] { return server.counts().clients == 0; }));
}

TEST(LinkServer, clients_come_and_go_two_hundred_times) {
  Server server(any_port());
  for (int i = 0; i < 200; ++i) {
    const RawClient client(server.port());
    server.publish({"STRING", "Event", 0.0, string_content("x")}, false);
    if (i % 3 == 0) client.send(Bytes(17, 1));
  }
  // Those that wait to be accepted are no clients yet.
  EXPECT_TRUE(within(10s, [&] { return server.counts().accepted >= 190 && server.counts().clients == 0; }))
      << server.counts().accepted << " accepted";
}

TEST(LinkServer, a_port_in_use_and_a_foreign_address_are_refused_with_a_sentence) {
  const Server first(any_port());
  ServerSettings same = any_port();
  same.port = first.port();
  const auto sentence = [](const ServerSettings& settings) -> std::string {
    try {
      const Server server(settings);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(sentence(same), HasSubstr("is in use"));
  ServerSettings elsewhere = any_port();
  elsewhere.address = "192.0.2.7";  // set aside for examples
  EXPECT_THAT(sentence(elsewhere), HasSubstr("192.0.2.7"));
  elsewhere.address = "somewhere";
  EXPECT_THAT(sentence(elsewhere), HasSubstr("not an address"));
  EXPECT_FALSE(first.is_exposed());
  ServerSettings all = any_port();
  all.address = "0.0.0.0";
  EXPECT_TRUE(Server(all).is_exposed());
}

}  // namespace
}  // namespace bodkin::link
