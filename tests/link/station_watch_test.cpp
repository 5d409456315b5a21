// A teacher's view of a station, from the messages of a session's server.
#include "link/station_watch.h"

#include "link/command.h"
#include "link/contents.h"
#include "link/step_watch.h"
#include "tests/link/raw_client.h"
#include <gmock/gmock.h>

#include "io/tissue_library_file.h"

namespace bodkin::link {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

TEST(StationWatch, shows_step_force_and_picture_and_brings_commands_there) {
  Server server(any_port());
  ClientSettings settings;
  settings.host = "127.0.0.1";
  settings.port = server.port();
  StationWatch watch(settings);
  ASSERT_TRUE(within(10s, [&] { return server.counts().clients == 1; }));
  server.publish({"STRING", "Case", 0.0,
                  string_content(R"({"case":"Back","procedure":"epidural","path_mm":42.5,)"
                                 R"("layers":[["Skin","#e8b89a",0],["Fat","#ffe08a",2.5]]})")},
                 false);
  server.publish({"STRING", "State", 0.0,
                  string_content(R"({"guard":"active","tissue":"fat","step":"Skin","step_number":1,"steps":4})")},
                 true);
  server.publish({"STRING", "Event", 0.0, string_content(R"({"event":"contact","tissue":"skin"})")}, false);
  std::vector<double> rows;
  for (int tick = 0; tick < 3000; ++tick)
    rows.insert(rows.end(), {0.01 * tick, 0.1 * tick, 0.001 * tick, 0.0, 0.0, 2.0});
  server.publish({"NDARRAY", "Force", 0.0, array_content(rows, 6)}, false);
  const std::vector<std::uint8_t> pixels = {1, 2, 3, 4, 5, 6};
  server.publish({"IMAGE", "Image_Reference", 0.0, image_content(pixels, 3, 2, 0.5, Pose::Identity())}, true);
  // Other or damaged messages change nothing.
  server.publish({"STRING", "State", 0.0, string_content("{not json")}, false);
  server.publish({"NDARRAY", "Force", 0.0, Bytes{11, 2, 0}}, false);
  server.publish({"STRING", "Last", 0.0, string_content("x")}, false);
  ASSERT_TRUE(within(10s, [&] { return watch.view().status.received >= 8; }));
  const StationView view = watch.view();
  EXPECT_TRUE(view.runs);
  EXPECT_EQ(view.patient, "Back");
  EXPECT_EQ(view.procedure, "epidural");
  ASSERT_EQ(view.layers.size(), 2U);
  EXPECT_EQ(view.layers[1].tissue, "Fat");
  EXPECT_EQ(view.layers[1].colour, "#ffe08a");
  EXPECT_EQ(view.layers[1].from, 2.5);
  EXPECT_EQ(view.path, 42.5);
  EXPECT_EQ(view.step, "Skin");
  EXPECT_EQ(view.step_number, 1U);
  EXPECT_EQ(view.steps, 4U);
  EXPECT_EQ(view.event, "contact (skin)");
  EXPECT_EQ(view.picture, pixels);
  EXPECT_EQ(view.picture_width, 3);
  ASSERT_FALSE(view.moments.empty());
  EXPECT_NEAR(view.moments.back().time, 29.95, 0.11);
  EXPECT_LE(view.moments.back().time - view.moments.front().time, 20.0) << "older ones are let go";
  EXPECT_LE(view.moments.size(), 202U);

  watch.command("StartProcedure", {{"Case", "a \"b\" <c>"}});
  std::vector<Received> received;
  ASSERT_TRUE(within(10s, [&] {
    for (Received& each : server.take()) received.push_back(std::move(each));
    return !received.empty();
  }));
  const Command command = command_of(received[0].message).value();
  EXPECT_EQ(command.name, "StartProcedure");
  EXPECT_EQ(command.values.at("Case"), "a \"b\" <c>");
  server.send(received[0].client, reply_to(received[0].message, false, "this station has no case", 0.0));
  EXPECT_TRUE(within(10s, [&] { return watch.view().reply == "this station has no case"; }));
}

TEST(StationWatch, takes_no_layers_that_are_none) {
  Server server(any_port());
  ClientSettings settings;
  settings.host = "127.0.0.1";
  settings.port = server.port();
  const StationWatch watch(settings);
  ASSERT_TRUE(within(10s, [&] { return server.counts().clients == 1; }));
  int sent = 0;
  for (const char* layers : {"7", "[7]", R"([["a","#e8b89a"]])", R"([["a","red\"/>",0]])", R"([[1,"#e8b89a",0]])"}) {
    server.publish({"STRING", "Case", 0.0, string_content(std::string(R"({"layers":)") + layers + "}")}, false);
    ++sent;
    ASSERT_TRUE(within(10s, [&] { return watch.view().status.received >= static_cast<std::uint64_t>(sent); }));
    EXPECT_TRUE(watch.view().layers.empty()) << layers;
  }
}

TEST(StepWatch, follows_the_stages_in_their_order) {
  const anatomy::TissueLibrary library = io::default_tissue_library();
  StepWatch watch({{"Prepare", "", ""}, {"Touch", "", "contact"}, {"Fat", "fat", ""}, {"Out", "", "withdrawn"}});
  EXPECT_EQ(watch.count(), 4U);
  EXPECT_EQ(watch.number(), 0U);
  const auto sample = [](anatomy::TissueId id) {
    station::HandSample one;
    one.tissue = id;
    return std::vector{one};
  };
  const auto event = [](forces::EventKind kind) {
    session::SessionEvent one;
    one.event.kind = kind;
    return std::vector{one};
  };
  watch.update(sample(anatomy::tissue::fat), {}, library);
  EXPECT_EQ(watch.title(), "") << "not before the touch";
  watch.update(sample(anatomy::tissue::skin), event(forces::EventKind::contact), library);
  EXPECT_EQ(watch.title(), "Touch");
  EXPECT_EQ(watch.number(), 2U);
  watch.update({}, event(forces::EventKind::withdrawn), library);
  EXPECT_EQ(watch.title(), "Touch") << "a needle that only touched was not withdrawn";
  watch.update(sample(anatomy::tissue::fat), event(forces::EventKind::withdrawn), library);
  EXPECT_EQ(watch.title(), "Out");
}

TEST(StepWatch, does_not_wait_for_a_second_hand_and_counts_an_event_once) {
  const anatomy::TissueLibrary library = io::default_tissue_library();
  const std::vector<WatchedStep> steps = {{"Feel", "", "palpated"},       {"Touch", "", "contact"},
                                          {"Open", "", "pressure_read"},  {"Collect", "", "fluid_collected"},
                                          {"Close", "", "pressure_read"}, {"Out", "", "withdrawn"}};
  const auto titles = [&](const std::vector<forces::EventKind>& kinds, bool at_once) {
    StepWatch watch(steps);
    std::vector<session::SessionEvent> all;
    std::string seen;
    for (const forces::EventKind kind : kinds) {
      session::SessionEvent one;
      one.event.kind = kind;
      all.push_back(one);
      if (at_once) continue;
      watch.update({}, std::vector{one}, library);
      seen += watch.title() + " ";
    }
    if (at_once) watch.update({}, all, library);
    return at_once ? watch.title() : seen;
  };
  using enum forces::EventKind;
  EXPECT_EQ(titles({contact, withdrawn}, false), "Touch Out ");
  EXPECT_EQ(titles({palpated, contact, pressure_read, fluid_collected, pressure_read}, false),
            "Feel Touch Open Collect Close ");
  EXPECT_EQ(titles({contact, pressure_read}, true), "Open") << "not the second reading too";
  EXPECT_EQ(titles({palpated, contact, pressure_read, fluid_collected, pressure_read, withdrawn}, true), "Out");
}

}  // namespace
}  // namespace bodkin::link
